#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "io/run/run_file.h"
#include "io/site/input_files.h"
#include "tests/support/photographed_case.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

/// What a case shows beside its run: a photograph, a survey, an orthophoto.
class ShownEvidence : public PhotoOfCase {
protected:
    void SetUp() override {
        PhotoOfCase::SetUp();
        m_case.scenarios[0].scenario = io::openRun(m_out)->origin().scenario;
    }
    Outcome without(std::vector<std::string> words) { return CommandRun().with("DISPLAY", std::nullopt).cli(words); }
    Outcome report(const std::string& casePath) {
        return without({"report", casePath, "--run", m_out, "--self-test", "none", "--repeats", "0", "--out", m_folder / "report",
                        "--cache", m_folder / "cache"});
    }
    /// An outline of what the run itself left, as a survey of the case.
    void addSurvey() {
        const Outcome mapped = cli({"map", m_out, "--out", m_folder / "real.gpkg"});
        ASSERT_EQ(mapped.exitCode, 0) << mapped.err;
        m_case.inputs.push_back({"survey-1", InputRole::Survey, "real.gpkg", io::sha256OfFile(m_folder / "real.gpkg")});
    }
    void addOrthophoto() {
        writeGreyTiff(m_folder / "ground.tif", 60, 60);
        std::ofstream(m_folder / "ground.tfw") << "1\n0\n0\n-1\n-30\n30\n";
        const std::string path = m_folder / "ground.tif";
        // Its world file belongs to what is shown.
        m_case.inputs.push_back({"orthophoto-1", InputRole::Orthophoto, "ground.tif",
                                 io::digestOfInput(path, InputRole::Orthophoto, Execution()).sha256});
    }
};

TEST_F(ShownEvidence, TheReportHoldsPhotographAndSurveyAgainstTheDebris) {
    ASSERT_NO_FATAL_FAILURE(addSurvey());
    m_case.photographs[0].note = "Taken from the <bank>.";
    const Outcome outcome = report(save());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string page = textOf(m_folder / "report/report.html");
    EXPECT_THAT(page, HasSubstr("Taken from the &lt;bank&gt;."));
    EXPECT_THAT(page, HasSubstr("8 of 8")) << "points";
    EXPECT_THAT(page, HasSubstr("Orange: the outline of the simulated debris"));
    EXPECT_THAT(page, HasSubstr("real.gpkg: difference map."));
    const nlohmann::json survey = cli({"survey", m_out, "--survey", m_folder / "real.gpkg", "--json"}).json();
    EXPECT_GT(survey["iou"].get<double>(), 0.5) << "it is its own outline, on other cells";
    std::ostringstream iou;
    iou << std::fixed << std::setprecision(3) << survey["iou"].get<double>();
    EXPECT_THAT(page, HasSubstr(iou.str())) << "the same comparison as that of the command";
    EXPECT_THAT(page, HasSubstr(m_case.inputs.back().sha256));
    // Pairs, end, stages, map, photograph and difference map.
    std::size_t pictures = 0;
    for (std::size_t at = page.find("data:image/png"); at != std::string::npos; at = page.find("data:image/png", at + 1)) {
        ++pictures;
    }
    EXPECT_EQ(pictures, 6u);
}

TEST_F(ShownEvidence, AnAnswerThatRestsOnAPoorCameraSaysSoBesideIt) {
    // Points that no camera explains.
    double way = 1.0;
    for (PointPair& pair : m_case.photographs[0].pairs) {
        pair.picture += Eigen::Vector2d(27.0 * way, -21.0 * way);
        way = -way;
    }
    const std::string path = save();
    const nlohmann::json photo = cli({"photo", path, "--run", m_out, "--json"}).json()["photographs"][0];
    const auto poor = std::find_if(photo["cautions"].begin(), photo["cautions"].end(),
                                   [](const nlohmann::json& each) { return each["key"] == "poor_camera"; });
    ASSERT_NE(poor, photo["cautions"].end()) << photo;
    ASSERT_FALSE(photo["comparison"].is_null()) << photo;
    const Outcome outcome = report(path);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string page = textOf(m_folder / "report/report.html");
    const std::size_t asked = page.find("The evidence was asked");
    const std::size_t said = page.find((*poor)["text"].get<std::string>());
    ASSERT_NE(asked, std::string::npos);
    ASSERT_NE(said, std::string::npos);
    EXPECT_GT(said, asked);
    EXPECT_LT(said, page.find("were deactivated and became fragments", asked)) << "before the figures of the answer";
    EXPECT_NE(page.find((*poor)["text"].get<std::string>(), said + 1), std::string::npos) << "and beside the photograph";
}

TEST_F(ShownEvidence, APhotographThatIsAnotherFileNowIsStale) {
    const std::string path = save();
    std::ofstream(m_folder / "site.tif", std::ios::app) << "x";
    const Outcome stale = report(path);
    EXPECT_EQ(stale.exitCode, 2);
    EXPECT_THAT(stale.err, HasSubstr("the photograph"));
    EXPECT_THAT(stale.err, HasSubstr("site.tif has the SHA-256"));
    fs::remove(m_folder / "site.tif");
    const Outcome gone = report(path);
    EXPECT_EQ(gone.exitCode, 1);
    EXPECT_THAT(gone.err, HasSubstr("site.tif"));
    EXPECT_FALSE(fs::exists(m_folder / "report"));
}

TEST_F(ShownEvidence, PicturesOfARunShowTheOrthophotoOfItsCase) {
    addOrthophoto();
    const std::string path = save();
    const std::vector<std::string> words{"figure", m_out, "--pane", "fragments", "--size", "320x200", "--dpi", "60"};
    auto plain = words;
    plain.insert(plain.end(), {"--out", m_folder / "plain.png"});
    auto draped = words;
    draped.insert(draped.end(), {"--case", path, "--out", m_folder / "draped.png"});
    ASSERT_EQ(without(plain).exitCode, 0);
    const Outcome drawn = without(draped);
    ASSERT_EQ(drawn.exitCode, 0) << drawn.err;
    EXPECT_EQ(drawn.err.find("note: "), std::string::npos) << drawn.err;
    const auto inputsOf = [](const std::string& file) { return nlohmann::json::parse(io::readProvenance(file)->text)["inputs"]; };
    EXPECT_EQ(inputsOf(m_folder / "plain.png").size(), 1u);
    ASSERT_EQ(inputsOf(m_folder / "draped.png").size(), 2u);
    EXPECT_EQ(inputsOf(m_folder / "draped.png")[1]["role"], "orthophoto");
    EXPECT_EQ(inputsOf(m_folder / "draped.png")[1]["sha256"], m_case.inputs.back().sha256);
    EXPECT_EQ(io::readProvenance(m_folder / "draped.png")->casePath, path);
    const Outcome frames = without(
        {"movie", m_out, "--case", path, "--out", m_folder / "frames", "--from", "0.5", "--to", "0.6", "--size", "160x100"});
    ASSERT_EQ(frames.exitCode, 0) << frames.err;
    EXPECT_EQ(inputsOf(m_folder / "frames/frame-00001.png").size(), 2u);
    const Outcome other =
        without({"figure", m_out, "--case", sourcePath("resources/samples/stone-arch.rubble"), "--out", m_folder / "x.png"});
    EXPECT_EQ(other.exitCode, 2);
    EXPECT_THAT(other.err, HasSubstr("none of its FE results"));
    fs::remove(m_folder / "ground.tif");
    const Outcome lost = without(draped);
    EXPECT_EQ(lost.exitCode, 0) << "nothing rests on it";
    EXPECT_THAT(lost.err, HasSubstr("note: "));
    EXPECT_THAT(lost.err, HasSubstr("ground.tif"));
}

TEST_F(ShownEvidence, AMovieMovesAlongTheCameraKeysOfItsCase) {
    const std::string path = save();
    const std::vector<std::string> words{"movie", m_out,   "--pane", "fe",     "--from",  "0.4",    "--to",
                                         "0.6",   "--fps", "10",     "--size", "160x100", "--case", path};
    const auto with = [&](const char* folder, bool along) {
        auto all = words;
        all.insert(all.end(), {"--out", m_folder / folder});
        if (along) {
            all.emplace_back("--along-keys");
        }
        return without(all);
    };
    const Outcome none = with("none", true);
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_THAT(none.err, HasSubstr("there are no camera keys"));
    ASSERT_EQ(with("still", false).exitCode, 0);
    m_case.cameraKeys = {{0.4, {0.0, -30.0, 5.0}, {0.0, 0.0, 1.0}, Vec3::UnitZ(), 30.0, false, 1.0},
                         {0.6, {30.0, 0.0, 5.0}, {0.0, 0.0, 1.0}, Vec3::UnitZ(), 30.0, false, 1.0}};
    save();
    const Outcome moving = with("moving", true);
    ASSERT_EQ(moving.exitCode, 0) << moving.err;
    EXPECT_THAT(io::readProvenance(m_folder / "moving/frame-00001.png")->text, HasSubstr("\"camera_keys_s\":[0.4,0.6]"));
    EXPECT_NE(textOf(m_folder / "moving/frame-00003.png"), textOf(m_folder / "still/frame-00003.png"));
}

TEST_F(ShownEvidence, AFullDiskLeavesNoHalfOfAFigureAMovieOrAReport) {
    const std::string path = save();
    std::ofstream(m_folder / "kept.png") << "earlier";
    const auto limited = [&](std::vector<std::string> words) {
        return CommandRun().with("DISPLAY", std::nullopt).fileSizeLimit(16 << 10).cli(words);
    };
    for (const char* name : {"kept.png", "f.svg", "f.pdf"}) {
        const Outcome full = limited({"figure", m_out, "--out", m_folder / name});
        EXPECT_EQ(full.exitCode, 1) << name;
        EXPECT_THAT(full.err, HasSubstr(name));
        EXPECT_THAT(full.err, HasSubstr("File too large")) << "what the system says";
        EXPECT_THAT(full.err, HasSubstr("has room"));
    }
    EXPECT_EQ(textOf(m_folder / "kept.png"), "earlier");
    const Outcome movie = limited({"movie", m_out, "--out", m_folder / "frames"});
    EXPECT_EQ(movie.exitCode, 1);
    EXPECT_THAT(movie.err, HasSubstr("frame-00001.png"));
    const Outcome paper = limited({"report", path, "--run", m_out, "--self-test", "none", "--repeats", "0", "--out",
                                   m_folder / "report", "--cache", m_folder / "cache"});
    EXPECT_EQ(paper.exitCode, 1);
    EXPECT_THAT(paper.err, HasSubstr("report.html"));
    EXPECT_FALSE(fs::exists(m_folder / "report"));
    std::vector<std::string> left;
    for (const auto& entry : fs::recursive_directory_iterator(m_folder.path())) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file() && (name.starts_with("f.") || name.starts_with("frame-") || name.starts_with("report."))) {
            left.push_back(name);
        }
    }
    EXPECT_THAT(left, testing::IsEmpty());
}

}  // namespace

}  // namespace rubble::cli
