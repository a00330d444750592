#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr const char* pointColumns =
    "setting,multiple_x,multiple_y,multiple_z,grid_l_m,grid_w_m,grid_h_m,fragments,bodies,accuracy_0_1m,accuracy_0_2m,"
    "accuracy_0_3m,mass_map_difference,core_iou,footprint_iou,runout95_error_m,height_rms_m,mean_height_error_m,"
    "centroid_shift_m,wall_s,ms_per_step_mean,ms_per_step_worst,fps";

std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> all;
    std::stringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        all.push_back(line);
    }
    return all;
}

std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> all(1);
    for (const char c : line) {
        if (c == ',') {
            all.emplace_back();
        } else {
            all.back() += c;
        }
    }
    return all;
}

/// The columns that no clock decides.
std::vector<std::string> rowsWithoutTimes(const std::string& csv) {
    std::vector<std::string> rows;
    for (const std::string& line : lines(csv)) {
        std::string row;
        const std::vector<std::string> all = fields(line);
        for (std::size_t i = 0; i < 19 && i < all.size(); ++i) {
            row += all[i] + ',';
        }
        rows.push_back(row);
    }
    return rows;
}

/// The checkpoints of a folder that are written whole; beside them may lie what a program that was killed had begun to write.
std::vector<fs::path> checkpointsOf(const fs::path& folder) {
    std::vector<fs::path> paths;
    std::error_code ignored;
    for (fs::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
        if (it->path().extension() == ".checkpoint") {
            paths.push_back(it->path());
        }
    }
    return paths;
}

/// When the newest checkpoint of a folder was written; the beginning of time if there is none.
fs::file_time_type newestCheckpoint(const fs::path& folder) {
    fs::file_time_type newest = fs::file_time_type::min();
    for (const fs::path& path : checkpointsOf(folder)) {
        std::error_code gone;
        const fs::file_time_type written = fs::last_write_time(path, gone);
        newest = gone ? newest : std::max(newest, written);
    }
    return newest;
}

/// The warning with an id; null if there is none.
nlohmann::json warning(const nlohmann::json& object, const std::string& id) {
    for (const nlohmann::json& row : object["warnings"]) {
        if (row["id"] == id) {
            return row;
        }
    }
    return {};
}

class AccuracyCommand : public testing::Test {
protected:
    std::vector<std::string> words(std::vector<std::string> more) const {
        more.insert(more.begin(), {"accuracy", m_path, "--set", "settle_time=0.5", "--cache", m_folder / "cache"});
        return more;
    }
    std::size_t keptWorlds(const std::string& cache = "cache") const {
        std::error_code ignored;
        std::size_t count = 0;
        for (fs::directory_iterator it(m_folder / (cache + "/worlds"), ignored), end; it != end; it.increment(ignored)) {
            count += it->path().extension() == ".world";
        }
        return count;
    }
    io::TemporaryFolder m_folder;
    std::string m_path = writeSmallCollapse(m_folder / "small.exo");
};

TEST_F(AccuracyCommand, WritesExactlyTheColumnsWithReferenceFloorAndPaper) {
    const std::string csv = m_folder / "a.csv";
    const std::string errors = m_folder / "errors.csv";
    const Outcome outcome = cli(words({"--multiples", "1,2.5", "--csv", csv, "--errors", errors}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::vector<std::string> table = lines(textOf(csv));
    ASSERT_EQ(table.size(), 6u);
    EXPECT_EQ(table[0], pointColumns);
    std::vector<std::string> names;
    for (std::size_t i = 1; i < table.size(); ++i) {
        const std::vector<std::string> row = fields(table[i]);
        ASSERT_EQ(row.size(), 23u);
        names.push_back(row[0]);
        EXPECT_EQ(row[7], std::to_string(smallDead));
        for (std::size_t c = 9; c < 19; ++c) {
            EXPECT_FALSE(row[c].empty()) << row[0] << ' ' << c;
        }
        // The floor is no setting: it has no grid and costs nothing. Everything else was timed and drawn.
        for (std::size_t c = 19; c < 23; ++c) {
            EXPECT_EQ(row[c].empty(), row[0] == "floor") << row[0] << ' ' << c;
        }
        EXPECT_EQ(row[1].empty(), row[0] == "floor" || row[0] == "reference");
    }
    EXPECT_THAT(names, testing::ElementsAre("reference", "floor", "multiple=1", "multiple=2.5", "paper"));
    for (const char* text : {"Table 1 of the published method", "stone arch (published)", "51,101", "Table 2", "96.53 %",
                             "floor: worst", "within 0.1 m", "Cost, one setting at a time"}) {
        EXPECT_THAT(outcome.out, HasSubstr(text));
    }
    const std::vector<std::string> rows = lines(textOf(errors));
    EXPECT_EQ(rows[0], "setting,fragment_id,element_id,error_m");
    EXPECT_EQ(rows.size(), 1u + 3 * smallDead);
}

TEST_F(AccuracyCommand, JsonHoldsPointsFloorTablesAndStandings) {
    const Outcome outcome = cli(words({"--json", "--no-fps", "--multiples", "2", "--vary", "cluster_shape=axis_box,hull",
                                       "--tolerances", "0.05,0.3", "--repeats", "3"}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json object = outcome.json();
    EXPECT_EQ(object["complete"], true);
    ASSERT_EQ(object["points"].size(), 5u);
    EXPECT_EQ(object["points"][2]["setting"], "multiple=2 cluster_shape=axis_box");
    std::string keys;
    const nlohmann::ordered_json ordered = nlohmann::ordered_json::parse(outcome.out);
    for (const auto& [key, value] : ordered["points"][2].items()) {
        keys += (keys.empty() ? "" : ",") + key;
    }
    EXPECT_EQ(keys, pointColumns) << "the keys of a point are the columns";
    EXPECT_TRUE(object["points"][2]["fps"].is_null());
    EXPECT_GT(object["points"][2]["wall_s"], 0.0);
    EXPECT_TRUE(object["points"][0]["multiple_x"].is_null());
    EXPECT_EQ(object["repeat_floor"]["repeats"].size(), 3u);
    EXPECT_EQ(object["repeat_floor"]["spread"]["pairs"], 6);
    ASSERT_EQ(object["details"].size(), 3u);
    EXPECT_EQ(object["details"][0]["difference"]["accuracy_rate"].size(), 4u) << "0.05 beside the three of the published table";
    EXPECT_EQ(object["details"][0]["predicted"]["fps"]["known"], false);
    EXPECT_EQ(object["table_1"].back()["fps_with"], 62.0);
    EXPECT_EQ(object["table_2"].size(), 5u);
    EXPECT_TRUE(object["open"].empty());
    EXPECT_TRUE(object["check"].is_null());
}

TEST_F(AccuracyCommand, RepeatsOfSettingsTellTheirOwnSpread) {
    const std::vector<std::string> asked{"--no-fps", "--no-timing", "--multiples", "2", "--repeats", "1", "--setting-repeats", "2"};
    const Outcome tables = cli(words(asked));
    ASSERT_EQ(tables.exitCode, 0) << tables.err;
    EXPECT_THAT(tables.out, HasSubstr("Spread of each setting"));
    std::vector<std::string> json = asked;
    json.push_back("--json");
    const nlohmann::json object = cli(words(json)).json();
    for (const nlohmann::json& detail : object["details"]) {
        EXPECT_EQ(detail["kept"], true);
        ASSERT_EQ(detail["repeats"].size(), 2u);
        EXPECT_TRUE(detail["repeats"][1]["mass_map_difference"].is_number());
        EXPECT_NE(detail["repeats"][0], detail["repeats"][1]);
    }
    const Outcome without = cli(words({"--no-fps", "--no-timing", "--multiples", "2", "--repeats", "1"}));
    EXPECT_THAT(without.out, testing::Not(HasSubstr("Spread of each setting")));
    EXPECT_EQ(cli(words({"--setting-repeats", "-1"})).exitCode, 2);
}

TEST_F(AccuracyCommand, NoNumberButThoseOfTimeDependsOnJobsOrInterruption) {
    const std::string csv = m_folder / "a.csv";
    const auto sweep = [&](const std::string& cache, std::vector<std::string> more) {
        more.insert(more.begin(), {"--no-fps", "--no-timing", "--csv", csv, "--cache", m_folder / cache});
        std::vector<std::string> all{"accuracy", m_path, "--set", "settle_time=0.5", "--set", "birth_window=0"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    ASSERT_EQ(cli(sweep("one", {"--jobs", "1"})).exitCode, 0);
    const std::vector<std::string> whole = rowsWithoutTimes(textOf(csv));
    ASSERT_EQ(whole.size(), 10u);
    const std::size_t worlds = keptWorlds("one");
    EXPECT_EQ(worlds, 5u) << "the reference, two repeats, the paper, and of six multiples those that make other clusters";
    ASSERT_EQ(cli(sweep("many", {"--jobs", "7"})).exitCode, 0);
    EXPECT_EQ(rowsWithoutTimes(textOf(csv)), whole);
    // Interrupted as soon as some worlds are there, and gone on with.
    bool sent = false;
    const auto interrupt = [&](pid_t program) {
        if (!sent && keptWorlds("cut") >= 2) {
            sent = kill(program, SIGINT) == 0;
        }
    };
    const Outcome cut = CommandRun().meanwhile(interrupt).cli(sweep("cut", {"--jobs", "1", "--json"}));
    const std::size_t kept = keptWorlds("cut");
    EXPECT_TRUE(cut.exitCode == 3 || kept == worlds) << cut.err;
    EXPECT_GE(kept, 2u);
    ASSERT_EQ(cli(sweep("cut", {"--jobs", "3"})).exitCode, 0);
    EXPECT_EQ(rowsWithoutTimes(textOf(csv)), whole);
    EXPECT_EQ(keptWorlds("cut"), worlds);
}

TEST_F(AccuracyCommand, GoesOnInsideAWorldThatWasKilled) {
    const std::string csv = m_folder / "a.csv";
    const auto sweep = [&](const std::string& cache) {
        return std::vector<std::string>{
            "accuracy",    m_path,      "--set",   "settle_time=2", "--set", "step_rate=10000", "--no-fps",
            "--no-timing", "--repeats", "1",       "--jobs",        "1",     "--vary",          "friction=0.4",
            "--csv",       csv,         "--cache", m_folder / cache};
    };
    ASSERT_EQ(cli(sweep("whole")).exitCode, 0);
    const std::vector<std::string> whole = rowsWithoutTimes(textOf(csv));
    const fs::path checkpoints = m_folder / "cut/checkpoints";
    // Once there is another checkpoint than before.
    const auto once = [&](int signal) {
        return [&, signal, before = newestCheckpoint(checkpoints), sent = false](pid_t program) mutable {
            sent = sent || (newestCheckpoint(checkpoints) > before && kill(program, signal) == 0);
        };
    };
    const auto start = [&] { return CommandRun().with("RUBBLE_CHECKPOINT_SECONDS", "0.02"); };
    // Killed, then stopped as by Ctrl-C: both times before the reference was done.
    EXPECT_EQ(start().meanwhile(once(SIGKILL)).cli(sweep("cut")).signal, SIGKILL);
    EXPECT_EQ(keptWorlds("cut"), 0u);
    const Outcome stopped = start().meanwhile(once(SIGINT)).cli(sweep("cut"));
    // Where it went on from is progress: a program that is stopped at once on a busy machine may never come to say it.
    EXPECT_EQ(stopped.exitCode, 3) << stopped.err;
    ASSERT_FALSE(fs::is_empty(checkpoints));
    const Outcome last = start().cli(sweep("cut"));
    ASSERT_EQ(last.exitCode, 0) << last.err;
    EXPECT_THAT(last.err, HasSubstr("1 went on from checkpoints, the latest at "));
    EXPECT_EQ(rowsWithoutTimes(textOf(csv)), whole);
    EXPECT_TRUE(fs::is_empty(checkpoints)) << "worlds that are kept need none";
    EXPECT_THAT(cli({"cache", "list", "--cache", m_folder / "cut"}).out, testing::Not(HasSubstr("checkpoints")));
}

TEST_F(AccuracyCommand, SaysThatACheckpointWasDamaged) {
    const std::vector<std::string> sweep = words({"--no-fps", "--no-timing", "--set", "step_rate=10000", "--json"});
    const fs::path checkpoints = m_folder / "cache/checkpoints";
    const auto killOnce = [&](pid_t program) {
        if (newestCheckpoint(checkpoints) > fs::file_time_type::min()) {
            kill(program, SIGKILL);
        }
    };
    EXPECT_EQ(CommandRun().with("RUBBLE_CHECKPOINT_SECONDS", "0.02").meanwhile(killOnce).cli(sweep).signal, SIGKILL);
    const std::vector<fs::path> kept = checkpointsOf(checkpoints);
    ASSERT_FALSE(kept.empty());
    for (const fs::path& path : kept) {
        fs::resize_file(path, fs::file_size(path) - 1);
    }
    const Outcome outcome = cli(sweep);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_FALSE(warning(outcome.json(), "simulation.checkpoint_damaged").is_null());
    EXPECT_THAT(outcome.err, testing::Not(HasSubstr("went on")));
}

TEST_F(AccuracyCommand, CtrlCReportsWhatIsDone) {
    bool sent = false;
    const auto interrupt = [&](pid_t program) {
        if (!sent && keptWorlds() >= 3) {
            sent = kill(program, SIGINT) == 0;
        }
    };
    // The reference freezes and is soon done; the setting has ten million steps before it.
    const Outcome outcome = CommandRun().meanwhile(interrupt).cli(words(
        {"--json", "--no-fps", "--jobs", "1", "--set", "settle_time=1000", "--set", "freeze=false", "--vary", "step_rate=10000"}));
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_EQ(outcome.json()["cancelled"], true);
    EXPECT_EQ(outcome.json()["complete"], false);
    EXPECT_EQ(outcome.json()["points"][0]["setting"], "reference");
    EXPECT_EQ(outcome.json()["open"][0]["setting"], "step_rate=10000");
    EXPECT_TRUE(outcome.json()["open"][0]["failure"].is_null());
    EXPECT_THAT(outcome.err, HasSubstr("goes on from there"));
}

TEST_F(AccuracyCommand, AForeignReferenceIsNotCompared) {
    const std::vector<std::string> sweep = words({"--no-fps", "--no-timing", "--multiples", "2", "--json"});
    const nlohmann::json before = cli(sweep).json();
    // A world of another scenario under the name of this one, as a cache that was mixed up has it.
    std::vector<fs::path> worlds;
    for (const auto& entry : fs::directory_iterator(m_folder / "cache/worlds")) {
        worlds.push_back(entry.path());
    }
    std::sort(worlds.begin(), worlds.end());
    ASSERT_EQ(worlds.size(), 5u);
    for (std::size_t i = 1; i < worlds.size(); ++i) {
        fs::copy_file(worlds[0], worlds[i], fs::copy_options::overwrite_existing);
    }
    const Outcome again = cli(sweep);
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(again.json()["points"], before["points"]);
    ASSERT_FALSE(warning(again.json(), "study.foreign").is_null());
    EXPECT_EQ(warning(again.json(), "study.foreign")["count"], 4);
}

TEST_F(AccuracyCommand, AFullDiskKeepsThePoints) {
    const Outcome outcome = CommandRun().fileSizeLimit(500).cli(words({"--no-fps", "--no-timing", "--multiples", "2", "--json"}));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.json()["points"].size(), 4u);
    EXPECT_FALSE(warning(outcome.json(), "accuracy.not_kept").is_null());
    EXPECT_EQ(keptWorlds(), 0u);
}

TEST_F(AccuracyCommand, WithoutADisplayFpsAreEmptyWithTheReason) {
    // Neither a display nor a program that makes one.
    const Outcome outcome =
        CommandRun().with("DISPLAY", std::nullopt).with("PATH", "/nowhere").cli(words({"--multiples", "2", "--json"}));
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json object = outcome.json();
    EXPECT_TRUE(object["points"][0]["fps"].is_null());
    EXPECT_GT(object["points"][0]["wall_s"], 0.0);
    ASSERT_FALSE(warning(object, "accuracy.no_fps").is_null());
    EXPECT_THAT(warning(object, "accuracy.no_fps")["remedy"].get<std::string>(), HasSubstr("xvfb"));
}

TEST_F(AccuracyCommand, PredictsFromEarlierPointsAndChecksItself) {
    ASSERT_EQ(cli(words({"--no-fps", "--no-timing"})).exitCode, 0);
    const Outcome predicted = cli(words({"--predict", "--multiples", "1.7", "--json"}));
    ASSERT_EQ(predicted.exitCode, 0) << predicted.err;
    EXPECT_TRUE(predicted.json()["points"].empty()) << "nothing is simulated";
    ASSERT_EQ(predicted.json()["details"].size(), 2u);
    EXPECT_TRUE(predicted.json()["details"][0]["predicted"]["wall_s"].contains("reason")) << "nothing was timed";
    const Outcome check = cli(words({"--check", "--json"}));
    ASSERT_EQ(check.exitCode, 0) << check.err;
    ASSERT_EQ(check.json()["check"].size(), 8u);
    EXPECT_EQ(check.json()["check"][3]["quantity"], "mass_map_difference");
    EXPECT_GE(check.json()["check"][3]["points"], 2);
    EXPECT_THAT(cli(words({"--check"})).out, HasSubstr("How well the 80 % intervals hold"));
}

TEST_F(AccuracyCommand, RefusesWhatItDoesNotKnow) {
    const std::vector<std::vector<std::string>> wrong{
        {"--multiples", "two"},   {"--multiples", "-1"},   {"--multiples", "1,1"},       {"--vary", "gravity=9,10"},
        {"--vary", "nonsense=1"}, {"--vary", "step_rate"}, {"--vary", "step_rate=60,x"}, {"--jobs", "0"},
        {"--repeats", "0"},       {"--tolerances", "0"}};
    for (const std::vector<std::string>& option : wrong) {
        const Outcome outcome = cli(words(option));
        EXPECT_EQ(outcome.exitCode, 2) << option[0] << ' ' << option[1] << outcome.err;
    }
    EXPECT_EQ(cli(words({"--csv", m_path + "/a.csv"})).exitCode, 1) << "a file is no folder";
}

TEST(CalibrateCommand, MeasuresFitsAndKeeps) {
    const io::TemporaryFolder folder;
    const std::string csv = folder / "c.csv";
    const Outcome outcome =
        cli({"calibrate", "--bodies", "8,27,64", "--no-drawing", "--cache", folder / "cache", "--csv", csv, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json object = outcome.json();
    EXPECT_EQ(object["points"].size(), 6u);
    EXPECT_GT(object["points"][0]["physics_fps"], 0.0);
    EXPECT_TRUE(object["points"][0]["live_fps"].is_null());
    EXPECT_TRUE(object["fit"]["typical"]["physics"]["bodies_max"].contains("bodies"));
    EXPECT_TRUE(object["fit"]["typical"]["live"]["bodies_max"].is_null());
    EXPECT_EQ(object["published"].size(), 5u);
    EXPECT_TRUE(fs::exists(object["kept"].get<std::string>()));
    EXPECT_EQ(lines(textOf(csv))[0], "pile,bodies,physics_fps,drawing_fps,live_fps");
    EXPECT_EQ(cli({"calibrate", "--bodies", "two"}).exitCode, 2);
    EXPECT_EQ(cli({"calibrate", "--bodies", "3"}).exitCode, 2);
    EXPECT_EQ(cli({"calibrate", "--fps", "0"}).exitCode, 2);
    EXPECT_EQ(cli({"calibrate", "--fps", "20,30"}).exitCode, 2);
}

TEST(CalibrateCommand, DrawsBothViewsOffScreen) {
    const io::TemporaryFolder folder;
    const Outcome outcome = cli({"calibrate", "--bodies", "8", "--cache", folder / "cache"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("worst"));
    EXPECT_THAT(outcome.out, HasSubstr("drawn by"));
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("nothing could be drawn")));
    EXPECT_THAT(outcome.out, HasSubstr("not known: fewer than three points"));
}

}  // namespace

}  // namespace rubble::cli
