#include "io/case/kept_causes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

KeptCauses someCauses(const TemporaryFolder& folder) {
    KeptCauses kept;
    kept.causes = {{folder / "pier.rubble", true}, {folder / "crown.exo", false}};
    kept.files = {{{EvidenceFile::Kind::Heights, folder / "found.tif"}, false}};
    kept.times = {{timeEvidence(3.25, {12.0, -4.5}, 5.0, 0.5), true}};
    kept.leftOutScenarios = {"scenario-2"};
    kept.leftOutEvidence = {"photograph-1", "survey-1"};
    kept.blind = true;
    return kept;
}

TEST(KeptCauses, AreReadAsTheyWereWritten) {
    const TemporaryFolder folder;
    const std::string file = folder / "case.rubble.causes.json";
    EXPECT_TRUE(readKeptCauses(file).empty()) << "there is none";
    writeKeptCauses(file, someCauses(folder));
    const KeptCauses read = readKeptCauses(file);
    ASSERT_EQ(read.causes.size(), 2u);
    EXPECT_EQ(read.causes[0].path, folder / "pier.rubble");
    EXPECT_TRUE(read.causes[0].used);
    EXPECT_FALSE(read.causes[1].used);
    ASSERT_EQ(read.files.size(), 1u);
    EXPECT_EQ(read.files[0].file, (EvidenceFile{EvidenceFile::Kind::Heights, folder / "found.tif"}));
    EXPECT_FALSE(read.files[0].used);
    ASSERT_EQ(read.times.size(), 1u);
    EXPECT_EQ(read.times[0].time.name, timeEvidence(3.25, {12.0, -4.5}, 5.0, 0.5).name);
    EXPECT_EQ(read.leftOutScenarios, someCauses(folder).leftOutScenarios);
    EXPECT_EQ(read.leftOutEvidence, someCauses(folder).leftOutEvidence);
    EXPECT_TRUE(read.blind);
}

TEST(KeptCauses, GoWithTheFolderThatTheyLieIn) {
    const TemporaryFolder folder;
    const TemporaryFolder other;
    const std::string file = folder / "case.rubble.causes.json";
    writeKeptCauses(file, someCauses(folder));
    std::filesystem::copy(file, other / "case.rubble.causes.json");
    EXPECT_EQ(readKeptCauses(other / "case.rubble.causes.json").causes[0].path, other / "pier.rubble");
}

TEST(KeptCauses, AnEmptyChoiceLeavesNoFile) {
    const TemporaryFolder folder;
    const std::string file = folder / "case.rubble.causes.json";
    writeKeptCauses(file, someCauses(folder));
    writeKeptCauses(file, {});
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(KeptCauses, OneThatIsDamagedIsNamed) {
    const TemporaryFolder folder;
    const std::string file = folder / "case.rubble.causes.json";
    writeKeptCauses(file, someCauses(folder));
    std::string text;
    {
        std::ifstream in(file);
        text.assign(std::istreambuf_iterator<char>(in), {});
    }
    text.replace(text.find("\"height\""), 8, "\"colour\"");
    std::ofstream(file) << text;
    EXPECT_THROW(readKeptCauses(file), ParseError);
}

}  // namespace
}  // namespace rubble::io
