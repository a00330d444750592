#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "tests/support/photographed_case.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

TEST_F(PhotoOfCase, TellsCameraAndAgreementWithTheirUncertainty) {
    const Outcome outcome = cli({"photo", save(), "--run", m_out, "--json", "--csv", m_folder / "scores.csv"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err << outcome.out;
    const nlohmann::json photo = outcome.json()["photographs"][0];
    EXPECT_EQ(photo["photograph"], "photograph-1");
    EXPECT_TRUE(photo["unchanged"].get<bool>());
    EXPECT_EQ(photo["facts"]["width_px"], 800);
    EXPECT_TRUE(photo["time_s"].is_null());
    EXPECT_LT(photo["match"]["rms_px"].get<double>(), 2.0);
    const nlohmann::json made = photo["comparison"];
    EXPECT_GT(made["iou"]["best"].get<double>(), 0.0);
    EXPECT_LT(made["iou"]["best"].get<double>(), 1.0);
    EXPECT_GT(made["iou"]["spread"].get<double>(), 0.0);
    EXPECT_GT(made["edge_distance_m"]["best"].get<double>(), 0.0);
    EXPECT_NEAR(made["pixel_m"].get<double>(), made["distance_m"].get<double>() / 900.0, 1e-9);
    EXPECT_EQ(made["cameras"], 64);
    EXPECT_THAT(textOf(m_folder / "scores.csv"), HasSubstr("photograph-1,"));
    // It shows all at rest: what still moves is not scored without a word.
    const auto has = [](const nlohmann::json& cautions, const char* key) {
        return std::any_of(cautions.begin(), cautions.end(), [key](const nlohmann::json& each) { return each["key"] == key; });
    };
    EXPECT_EQ(has(photo["cautions"], "not_at_rest"), has(outcome.json()["cautions"], "still_moving")) << photo["cautions"];
    EXPECT_TRUE(has(outcome.json()["cautions"], "bodies"));
    // Once more the same, and as text.
    const Outcome again = cli({"photo", save(), "--run", m_out, "--photograph", "site.tif"});
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("The silhouettes overlap by"));
    EXPECT_EQ(cli({"photo", save(), "--run", m_out, "--json"}).json()["photographs"][0]["comparison"], made);
}

TEST_F(PhotoOfCase, SaysWhatKeepsItFromComparing) {
    m_case.photographs[0].pairs.resize(3);
    const Outcome few = cli({"photo", save(), "--json"});
    EXPECT_EQ(few.exitCode, 1);
    EXPECT_TRUE(few.json()["photographs"][0]["match"].is_null());
    EXPECT_EQ(few.json()["warnings"][0]["id"], "camera.too_few");
    EXPECT_EQ(cli({"photo", save(), "--photograph", "other"}).exitCode, 2);
    EXPECT_EQ(cli({"photo", save(), "--cameras", "1"}).exitCode, 2);
    m_case.photographs.clear();
    EXPECT_THAT(cli({"photo", save()}).err, HasSubstr("has no photographs"));
}

TEST_F(PhotoOfCase, AChangedFileIsPointedOut) {
    const std::string path = save();
    writeGreyTiff(m_folder / "site.tif", 801, 600);
    const Outcome outcome = cli({"photo", path});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.out, HasSubstr("is another file than the case names"));
    EXPECT_EQ(cli({"verify", path}).exitCode, 1);
}

TEST_F(PhotoOfCase, PhotographsAreAddedWithTheirFactsAndAnEntryOfTheJournal) {
    m_case.photographs.clear();
    std::erase_if(m_case.inputs, [](const CaseInput& input) { return input.role == InputRole::Photograph; });
    const std::string path = save();
    const std::size_t entries = io::loadCase(path).journal.entries.size();
    const std::string second = m_folder / "second.tif";
    writeGreyTiff(second, 640, 480);
    const Outcome outcome = cli({"photo", "add", path, m_folder / "site.tif", second, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.json()["photographs"][1]["photograph"], "photograph-2");
    EXPECT_EQ(outcome.json()["photographs"][0]["facts"]["width_px"], 800);
    EXPECT_EQ(outcome.json()["warnings"][0]["id"], "photo.no_exif");
    const Case added = io::loadCase(path);
    ASSERT_EQ(added.photographs.size(), 2u);
    EXPECT_EQ(added.photographs[1].camera.width, 640);
    EXPECT_FALSE(added.photographs[1].camera.radialTerms) << "the lens is found as far as its points tell";
    EXPECT_EQ(added.inputs.back().path, "second.tif");
    EXPECT_EQ(added.inputs.back().sha256, io::sha256OfFile(second));
    EXPECT_EQ(added.journal.entries.size(), entries + 1);
    EXPECT_EQ(cli({"verify", path}).exitCode, 0);

    EXPECT_THAT(cli({"photo", "add", path, second}).out, HasSubstr("among the photographs already"));
    EXPECT_EQ(io::loadCase(path).photographs.size(), 2u);
    // One that cannot be read leaves the case as it is.
    const std::string before = textOf(path);
    std::ofstream(m_folder / "none.heic") << "no photograph";
    writeGreyTiff(m_folder / "third.tif", 320, 240);
    EXPECT_EQ(cli({"photo", "add", path, m_folder / "third.tif", m_folder / "none.heic"}).exitCode, 1);
    EXPECT_EQ(textOf(path), before);
    EXPECT_EQ(cli({"photo", "add", path}).exitCode, 2);
    EXPECT_EQ(cli({"photo", path, second}).exitCode, 2);
}

TEST_F(PhotoOfCase, TheFactsOfAFileNeedNoCase) {
    const std::string path = m_folder / "site.tif";
    const nlohmann::json told = cli({"photo", "facts", path, "--json"}).json()["photographs"][0];
    EXPECT_EQ(told["file"], path);
    EXPECT_EQ(told["sha256"], io::sha256OfFile(path));
    EXPECT_EQ(told["facts"]["height_px"], 600);
    EXPECT_TRUE(told["facts"]["altitude_m"].is_null());
    EXPECT_EQ(told["warnings"][0]["id"], "photo.no_exif");
    EXPECT_THAT(cli({"photo", "facts", path}).out, HasSubstr("800 x 600 px"));
    EXPECT_EQ(cli({"photo", "facts", m_folder / "nowhere.jpg"}).exitCode, 1);
    EXPECT_EQ(cli({"photo", "facts"}).exitCode, 2);
    EXPECT_EQ(cli({"photo", "facts", path, "--cameras", "8"}).exitCode, 2);
}

TEST_F(PhotoOfCase, ATimeBeyondTheRunIsRefusedWithItsSpan) {
    m_case.photographs[0].time = 1e5;
    const Outcome late = cli({"photo", save(), "--run", m_out});
    EXPECT_EQ(late.exitCode, 1);
    EXPECT_THAT(late.out, HasSubstr("but the run goes from"));
    m_case.photographs[0].time = 0.4;
    m_case.photographs[0].timeUncertainty = 0.2;
    const nlohmann::json made = cli({"photo", save(), "--run", m_out, "--json"}).json()["photographs"][0]["comparison"];
    EXPECT_LE(made["iou_over_time"][0].get<double>(), made["iou"]["best"].get<double>());
    EXPECT_GE(made["iou_over_time"][1].get<double>(), made["iou"]["best"].get<double>());
}

}  // namespace

}  // namespace rubble::cli
