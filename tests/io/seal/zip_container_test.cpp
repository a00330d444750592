#include "io/seal/zip_container.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/base/files.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;

/// The first byte of a container that is not as it would be written.
std::optional<std::uint64_t> firstDifference(const std::string& path) {
    ZipReader reader(path);
    ZipLayout layout;
    for (const ZipReader::Entry& entry : reader.entries()) {
        layout.open(entry.name, entry.bytes);
        reader.read(entry, [&](const char* data, std::size_t size) { layout.write(data, size); });
        layout.close();
    }
    return layout.firstDifference(path);
}

TEST(ZipContainer, GivesBackWhatWasPutIn) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.zip";
    ZipWriter writer(path);
    writer.add("a/empty", "");
    writer.add("a/混凝土.txt", std::string(300000, 'x'));
    writer.finish();
    ZipReader reader(path);
    ASSERT_EQ(reader.entries().size(), 2u);
    EXPECT_EQ(reader.content(reader.entries()[0]), "");
    EXPECT_EQ(reader.entries()[1].name, "a/混凝土.txt");
    EXPECT_EQ(reader.content(reader.entries()[1]), std::string(300000, 'x'));
    EXPECT_EQ(firstDifference(path), std::nullopt);
}

TEST(ZipContainer, EqualFilesMakeEqualContainers) {
    const TemporaryFolder folder;
    for (const char* name : {"a.zip", "b.zip"}) {
        ZipWriter writer(folder / name);
        writer.add("a/one", "1");
        writer.finish();
    }
    EXPECT_EQ(contentOf(folder / "a.zip"), contentOf(folder / "b.zip"));
}

TEST(ZipContainer, HoldsAsManyEntriesAsItSaysAndRefusesMore) {
    const TemporaryFolder folder;
    const std::string path = folder / "many.zip";
    ZipWriter writer(path);
    for (std::size_t i = 0; i < zipEntriesMost; ++i) {
        writer.add("a/" + std::to_string(i), "x");
    }
    EXPECT_THROW(writer.add("a/more", "x"), UsageError);
    writer.finish();
    EXPECT_EQ(ZipReader(path).entries().size(), zipEntriesMost);
    EXPECT_EQ(firstDifference(path), std::nullopt);
}

// A whole entry beyond 4 GiB, and one behind it; the file is written in full, so it is for the long tests.
TEST(ZipContainer, WholeEntriesBeyondFourGigabytes) {
    const TemporaryFolder folder;
    const std::string path = folder / "large.zip";
    constexpr std::uint64_t bytes = (std::uint64_t{4} << 30) + 5;
    const std::string block(std::size_t{1} << 20, 'x');
    ZipWriter writer(path);
    writer.open("a/large", bytes);
    for (std::uint64_t at = 0; at < bytes; at += block.size()) {
        writer.write(block.data(), static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), bytes - at)));
    }
    writer.close();
    writer.add("a/behind", "y");
    writer.finish();
    ZipReader reader(path);
    EXPECT_EQ(reader.entries().at(0).bytes, bytes);
    EXPECT_EQ(reader.content(reader.entries().at(1)), "y");
    EXPECT_EQ(firstDifference(path), std::nullopt);
}

TEST(ZipContainer, AnyByteBesideTheContentsThatIsAnotherIsFound) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.zip";
    ZipWriter writer(path);
    writer.add("a/one", "1");
    writer.finish();
    const std::string bytes = contentOf(path).value();
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        std::string altered = bytes;
        altered[at] = static_cast<char>(altered[at] ^ 4);
        std::ofstream(path, std::ios::binary) << altered;
        try {
            const std::optional<std::uint64_t> found = firstDifference(path);
            const bool content = at == std::string_view(bytes).find("a/one") + 5;
            EXPECT_TRUE(found || content) << at;
        } catch (const ParseError& error) {
            EXPECT_FALSE(error.remedy().empty());
        }
    }
}

}  // namespace
}  // namespace rubble::io
