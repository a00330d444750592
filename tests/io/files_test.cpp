#include "io/base/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;

std::size_t entriesIn(const std::string& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// The examples of FIPS 180-4.
TEST(Sha256, AgreesWithThePublishedExamples) {
    const TemporaryFolder folder;
    std::ofstream(folder / "empty").close();
    std::ofstream(folder / "abc") << "abc";
    std::ofstream(folder / "million") << std::string(1000000, 'a');
    EXPECT_EQ(sha256OfFile(folder / "empty"), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256OfFile(folder / "abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256OfFile(folder / "million"), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, SaysWhichFileCannotBeRead) {
    const TemporaryFolder folder;
    for (const std::string& path : {folder / "missing", folder.path()}) {
        try {
            sha256OfFile(path);
            FAIL() << path;
        } catch (const WorldError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(path));
            EXPECT_FALSE(error.remedy().empty());
        }
    }
}

TEST(AtomicWrite, ReplacesTheWholeFileAndKeepsItsRights) {
    const TemporaryFolder folder;
    const std::string path = folder / "case.json";
    writeAtomically(path, [](std::ostream& out) { out << std::string(200000, 'x'); });
    EXPECT_EQ(wholeFile(path).size(), 200000u);
    ::chmod(path.c_str(), 0640);
    writeAtomically(path, [](std::ostream& out) { out << 1234567.5; });
    EXPECT_EQ(wholeFile(path), "1.23457e+06");
    struct stat now{};
    ASSERT_EQ(::stat(path.c_str(), &now), 0);
    EXPECT_EQ(now.st_mode & 0777, 0640u);
    EXPECT_EQ(entriesIn(folder.path()), 1u);
}

TEST(AtomicWrite, WritesThroughALinkWithoutReplacingIt) {
    const TemporaryFolder folder;
    std::ofstream(folder / "real") << "old";
    fs::create_symlink(folder / "real", folder / "link");
    writeAtomically(folder / "link", [](std::ostream& out) { out << "new"; });
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(wholeFile(folder / "real"), "new");
}

TEST(AtomicWrite, LeavesTheOldFileAndNothingElseWhenTheWriterThrows) {
    const TemporaryFolder folder;
    std::ofstream(folder / "kept") << "old";
    EXPECT_THROW(writeAtomically(folder / "kept",
                                 [](std::ostream& out) {
                                     out << "half";
                                     throw std::runtime_error("stop");
                                 }),
                 std::runtime_error);
    EXPECT_EQ(wholeFile(folder / "kept"), "old");
    EXPECT_EQ(entriesIn(folder.path()), 1u);
}

TEST(AtomicWrite, LeavesTheOldFileWhenTheDiskIsFull) {
    const TemporaryFolder folder;
    const std::string path = folder / "kept";
    std::ofstream(path) << "old";
    const FileSizeLimit limit(100000);
    try {
        writeAtomically(path, [](std::ostream& out) { out << std::string(300000, 'x'); });
        FAIL();
    } catch (const WorldError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(path));
        EXPECT_FALSE(error.remedy().empty());
    }
    EXPECT_EQ(wholeFile(path), "old");
    EXPECT_EQ(entriesIn(folder.path()), 1u);
}

TEST(AtomicWrite, NamesAFolderThatDoesNotExist) {
    const TemporaryFolder folder;
    EXPECT_THROW(writeAtomically(folder / "no/such/file", [](std::ostream&) {}), WorldError);
    EXPECT_THROW(writeAtomically(folder.path(), [](std::ostream&) {}), WorldError);
    EXPECT_EQ(entriesIn(folder.path()), 0u);
}

TEST(FileName, EndsInCapitalsOrNot) {
    EXPECT_TRUE(hasEnding("out/map.tif", ".tif"));
    EXPECT_TRUE(hasEnding("out/MAP.TIF", ".tif"));
    EXPECT_TRUE(hasEnding(".png", ".png"));
    EXPECT_FALSE(hasEnding("png", ".png"));
    EXPECT_FALSE(hasEnding("map.tiff", ".tif"));
}

TEST(Provenance, LiesBesideTheExportedFile) {
    const TemporaryFolder folder;
    writeProvenance(folder / "fragments.csv", "{}");
    EXPECT_EQ(wholeFile(folder / "fragments.csv.provenance.json"), "{}\n");
}

}  // namespace
}  // namespace rubble::io
