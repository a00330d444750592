#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

/// Width and height from the head of a PNG.
std::pair<unsigned, unsigned> pngSize(const std::string& path) {
    const std::string bytes = textOf(path);
    if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) {
        return {0, 0};
    }
    const auto number = [&](std::size_t at) {
        unsigned value = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
        }
        return value;
    };
    return {number(16), number(20)};
}

class Figure : public testing::Test {
protected:
    void SetUp() override {
        const Outcome outcome = cli({"run", m_path, "--out", m_run, "--set", "settle_time=0.5"});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    /// Draws without any display.
    Outcome figure(std::vector<std::string> more) {
        more.insert(more.begin(), {"figure", m_run});
        return CommandRun().with("DISPLAY", std::nullopt).cli(more);
    }

    io::TemporaryFolder m_folder;
    std::string m_path = writeSmallCollapse(m_folder / "small.exo");
    std::string m_run = m_folder / "small.run.h5";
};

TEST_F(Figure, IsDrawnWithoutADisplay) {
    for (const char* pane : {"fe", "fragments", "both"}) {
        const std::string png = m_folder / (std::string(pane) + ".png");
        const Outcome outcome = figure({"--pane", pane, "--time", "0.3", "--out", png, "--size", "640x400"});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(outcome.out, png + "\n");
        EXPECT_EQ(pngSize(png), std::make_pair(640u, 400u));
    }
    EXPECT_NE(textOf(m_folder / "fe.png"), textOf(m_folder / "fragments.png"));
}

TEST_F(Figure, EndsWithADisplayThatMissesTheFirstSignal) {
    const std::string server = m_folder / "bin/Xvfb";
    std::filesystem::create_directories(m_folder / "bin");
    std::ofstream(server) << "#!/bin/sh\nPATH=${PATH#*:}\nXvfb \"$@\" &\nmissed=0\n"
                             "trap 'if [ $missed = 1 ]; then kill $!; exit; fi; missed=1' TERM\nwhile :; do wait $!; done\n";
    std::filesystem::permissions(server, std::filesystem::perms::owner_all);
    const Outcome outcome = CommandRun()
                                .with("DISPLAY", std::nullopt)
                                .with("PATH", (m_folder / "bin") + ":" + std::getenv("PATH"))
                                .cli({"figure", m_run, "--time", "0.3", "--size", "640x400", "--out", m_folder / "a.png"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(pngSize(m_folder / "a.png"), std::make_pair(640u, 400u));
}

TEST_F(Figure, FollowsTheTime) {
    ASSERT_EQ(figure({"--time", "0.1", "--out", m_folder / "early.png"}).exitCode, 0);
    ASSERT_EQ(figure({"--time", "0.5", "--out", m_folder / "late.png"}).exitCode, 0);
    EXPECT_NE(textOf(m_folder / "early.png"), textOf(m_folder / "late.png"));
}

TEST_F(Figure, ArrangementsHaveMaterialsUnlessAStyleIsSaid) {
    const auto view = [this](std::vector<std::string> more) {
        const std::string path = m_folder / "figure.svg";
        more.insert(more.end(), {"--size", "640x400", "--out", path});
        const Outcome outcome = figure(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        const std::string svg = textOf(path);
        const std::size_t begin = svg.find("<![CDATA[") + 9;
        return nlohmann::json::parse(svg.substr(begin, svg.find("]]>", begin) - begin)).at("view");
    };
    const auto style = [&](const std::string& preset, std::vector<std::string> more) {
        more.insert(more.end(), {"--preset", preset});
        return view(more)["style"];
    };
    for (const char* preset : {"fe_against_fragments", "at_the_end", "in_its_surroundings", "stages"}) {
        EXPECT_EQ(style(preset, {}), "presentation") << preset;
        EXPECT_EQ(style(preset, {"--style", "analysis"}), "analysis") << preset;
    }
    const auto own = view({"--time", "0.3"});
    EXPECT_EQ(own["style"], "analysis");
    std::ofstream(m_folder / "saved.json") << own;
    EXPECT_EQ(style("at_the_end", {"--view", m_folder / "saved.json"}), "analysis") << "as the saved view has it";
}

TEST_F(Figure, ShowsWhatAViewSays) {
    const auto drawn = [this](const std::string& name, std::vector<std::string> more) {
        more.insert(more.end(), {"--time", "0.3", "--size", "640x400", "--out", m_folder / (name + ".png")});
        const Outcome outcome = figure(more);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return textOf(m_folder / (name + ".png"));
    };
    const std::string plain = drawn("plain", {});
    const std::vector<std::vector<std::string>> ways{{"--pane", "overlay"},       {"--pane", "four"}, {"--look", "top"},
                                                     {"--style", "presentation"}, {"--cut", "x=0.5"}, {"--cut", "-z=0.5"},
                                                     {"--shadows", "off"}};
    std::set<std::string> pictures{plain};
    for (std::size_t i = 0; i < ways.size(); ++i) {
        pictures.insert(drawn("way" + std::to_string(i), ways[i]));
    }
    EXPECT_EQ(pictures.size(), ways.size() + 1) << "each shows something else";
    std::ofstream(m_folder / "view.json") << R"({"layout": "overlay_only", "time": 0.3, "cameras": []})";
    EXPECT_EQ(figure({"--view", m_folder / "view.json", "--out", m_folder / "a.png"}).exitCode, 1) << "four cameras are wanted";
    EXPECT_EQ(figure({"--view", m_folder / "none.json", "--out", m_folder / "a.png"}).exitCode, 1);
    const Outcome unknown = figure({"--hide", "no such part", "--out", m_folder / "a.png"});
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_THAT(unknown.err, HasSubstr("no such part"));
    for (const char* wrong : {"0.5", "w=1", "x=far"}) {
        EXPECT_EQ(figure({"--cut", wrong, "--out", m_folder / "a.png"}).exitCode, 2) << wrong;
    }
    EXPECT_FALSE(std::filesystem::exists(m_folder / "a.png"));
}

TEST_F(Figure, IsAnExportToo) {
    const std::string png = m_folder / "export.png";
    const Outcome outcome =
        CommandRun().with("DISPLAY", std::nullopt).cli({"export", m_run, "--export", "figure=" + png, "--colour", "component"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(pngSize(png).first, 1600u);
    EXPECT_THAT(pngSize(png).second, testing::AllOf(testing::Gt(200u), testing::Le(2000u))) << "as high as what is shown needs";
}

TEST_F(Figure, LooseStructureIsColouredByItsIsland) {
    const std::string svg = m_folder / "island.svg";
    const Outcome outcome = figure({"--out", svg, "--pane", "fe", "--time", "0.3", "--colour", "island"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(textOf(svg), HasSubstr("in loose islands "));
    EXPECT_THAT(textOf(svg), HasSubstr("island 2"));
    const Outcome movie = cli({"movie", m_run, "--out", m_folder / "movie", "--colour", "island", "--pane", "fe", "--from", "0.2",
                               "--to", "0.3", "--fps", "20", "--size", "320x200"});
    EXPECT_EQ(movie.exitCode, 0) << movie.err;
}

TEST_F(Figure, WrongRequestsAreRefused) {
    EXPECT_EQ(figure({}).exitCode, 2);
    EXPECT_EQ(figure({"--out", m_folder / "a.png", "--time", "99"}).exitCode, 2);
    EXPECT_EQ(figure({"--out", m_folder / "a.png", "--time", "-1"}).exitCode, 2);
    EXPECT_EQ(figure({"--out", m_folder / "a.png", "--state", "6"}).exitCode, 2);
    EXPECT_EQ(figure({"--out", m_folder / "a.png", "--state", "2", "--time", "0.1"}).exitCode, 2);
    EXPECT_EQ(figure({"--out", m_folder / "a.png", "--colour", "taste"}).exitCode, 2);
    EXPECT_EQ(figure({"--out", m_run}).exitCode, 2);
    EXPECT_FALSE(std::filesystem::exists(m_folder / "a.png"));
}

TEST_F(Figure, WithoutXvfbTheRemedyIsNamed) {
    const Outcome outcome = CommandRun()
                                .with("DISPLAY", std::nullopt)
                                .with("PATH", m_folder.path())
                                .cli({"figure", m_run, "--out", m_folder / "a.png"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("package xvfb"));
}

TEST_F(Figure, ADisplayThatDoesNotAnswerIsPassedOver) {
    const std::string png = m_folder / "a.png";
    const Outcome outcome = CommandRun().with("DISPLAY", ":4711").cli({"figure", m_run, "--out", png});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(pngSize(png).first, 1600u);
}

}  // namespace

}  // namespace rubble::cli
