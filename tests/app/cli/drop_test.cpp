#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "core/simulation/health/passed_limits.h"
#include "io/run/run_file.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/command_run.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

class DropRun : public testing::Test {
protected:
    std::string table(const std::string& rows) {
        std::ofstream(m_folder / "bodies.csv")
            << "id,mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,material\n"
            << rows;
        return m_folder / "bodies.csv";
    }
    std::string slope() {
        const io::AsciiGrid slope{30, 30, -10.0, -15.0};
        return slope.write(m_folder / "slope.asc", [](double x, double) { return std::max(5.5 - x, 0.0); });
    }

    io::TemporaryFolder m_folder;
};

TEST_F(DropRun, TellsWhereEachWent) {
    const std::string bodies = table("a,480,1,1,0.2,0,0,0.1,3,0,0,stone\nb,480,1,1,0.2,0,9,5.1,0,0,0,stone\n");
    const Outcome outcome = cli({"drop", bodies, "--csv", m_folder / "ends.csv", "--path", m_folder / "path.csv", "--samples", "20",
                                 "--set", "friction=0.5", "--out", m_folder / "drop.run.h5", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json made = outcome.json();
    EXPECT_EQ(made["bodies"], 2);
    EXPECT_EQ(made["endings"]["rest"], 2);
    EXPECT_EQ(made["health_breaches"], 0);
    EXPECT_EQ(made["cautions"][0]["key"], "single_run");
    EXPECT_NEAR(made["figures"]["fall_m"]["mean"].get<double>(), 2.5, 0.01);
    const std::string ends = textOf(m_folder / "ends.csv");
    EXPECT_THAT(ends, HasSubstr("id,repeat,ending,from_x_m"));
    EXPECT_THAT(ends, HasSubstr("\na,0,rest,0,0,0.1,1,0,0,0,"));
    EXPECT_THAT(textOf(m_folder / "path.csv"), HasSubstr("\nb,0,0.05,"));
    // The run file is one as of any collapse, and the table opens as any result.
    EXPECT_EQ(cli({"verify", m_folder / "drop.run.h5"}).exitCode, 0);
    const Outcome inspected = cli({"inspect", bodies, "--json"});
    EXPECT_EQ(inspected.exitCode, 0) << inspected.err;
    const Outcome again = cli({"run", bodies, "--set", "friction=0.5", "--json"});
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(again.json()["trajectory_hash"], made["trajectory_hash"]);
}

TEST_F(DropRun, RepeatsAreTurnedAndDrawnAnew) {
    const std::string bodies = table("a,480,1,1,0.2,0,0,9,3,0,0,stone\n");
    const std::vector<std::string> words{"drop",
                                         bodies,
                                         "--terrain",
                                         slope(),
                                         "--turn",
                                         "--lift",
                                         "--apart",
                                         "--repeats",
                                         "3",
                                         "--vary",
                                         "restitution=uniform:0:0.3",
                                         "--json"};
    const Outcome first = cli(words);
    ASSERT_EQ(first.exitCode, 0) << first.err;
    const nlohmann::json made = first.json();
    EXPECT_EQ(made["repeats"], 3);
    EXPECT_TRUE(made["cautions"].empty()) << "restitution is drawn anew";
    EXPECT_GT(made["figures"]["run_out_m"]["deviation"].get<double>(), 0.0);
    EXPECT_EQ(cli(words).json()["figures"], made["figures"]);
    for (const nlohmann::json& warning : made["warnings"]) {
        EXPECT_NE(warning["id"], "bodies.along_axes");
    }
}

TEST_F(DropRun, TellsBreachesOfHealthOfEveryRepeat) {
    // One block comes down on the other, hard enough for the monitor.
    const std::string bodies = table("a,500,1,1,0.2,0,0,5,1,0,0,stone\nb,300,0.5,0.5,0.5,0.2,0,6,1,0,0,concrete\n");
    const auto breaches = [&](const std::string& repeats) {
        const Outcome outcome = cli({"drop", bodies, "--repeats", repeats, "--json"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        const nlohmann::json made = outcome.json();
        std::int64_t told = 0;
        for (const nlohmann::json& warning : made["warnings"]) {
            const std::string id = warning["id"];
            told += id == "simulation.energy_gain" || id == "simulation.penetration" ? warning["count"].get<std::int64_t>() : 0;
        }
        EXPECT_EQ(told > 0, made["health_breaches"] > 0) << told;
        return made["health_breaches"].get<int>();
    };
    EXPECT_EQ(breaches("3"), 3 * breaches("1"));
}

TEST_F(DropRun, CountsALimitOnceHoweverOftenItIsPassed) {
    // Thin slabs that heavy ones come down upon pass a limit again after they have held it. Which of these do is chance.
    const std::vector<std::pair<std::string, double>> slabs{
        {"a0,5000,0.5,2,0.05,-0.21,-0.69,0.30,-2.9,0", -18.0},  {"a1,200,0.5,2,0.1,0.07,-0.45,0.60,2.0,0", -29.5},
        {"a2,20000,1,1,0.05,-0.61,-0.38,6.30,2.2,0", -1.6},     {"a3,200,2,1,0.1,0.34,0.01,1.20,-1.5,0", -28.8},
        {"a4,5000,0.5,1,0.3,0.14,0.76,12.30,-1.8,0", -23.1},    {"a5,5000,1,0.5,0.1,-0.53,-0.48,1.80,-2.5,0", -21.5},
        {"a6,20000,2,2,0.1,-0.06,-0.31,18.30,-1.8,0", -23.5},   {"a7,20000,2,1,0.05,-0.45,-0.29,21.30,0.5,0", -14.6},
        {"a8,5000,0.5,0.5,0.05,0.42,-0.45,24.30,0.7,0", -30.5}, {"a9,200,1,1,0.1,-0.95,-0.29,3.00,2.4,0", -1.8},
        {"a10,20000,1,0.5,0.3,-0.35,-0.36,3.30,1.7,0", -23.6},  {"a11,20000,0.5,1,0.3,0.24,0.79,11.30,-2.2,0", -24.7},
    };
    const std::string file = m_folder / "slabs.run.h5";
    std::size_t breaches = 0, limits = 0;
    for (int tried = 0; tried < 24 && breaches == limits; ++tried) {
        // At steps that are too long for such blows.
        const char* rate = tried % 2 == 0 ? "step_rate=140" : "step_rate=70";
        const int faster = tried / 2;
        std::string rows;
        for (const auto& [slab, speed] : slabs) {
            rows += slab + ',' + std::to_string(speed - 0.5 * faster) + ",concrete\n";
        }
        std::filesystem::remove(file);
        const Outcome outcome = cli({"drop", table(rows), "--out", file, "--set", rate, "--json"});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        const auto told = io::openRun(file)->breaches();
        breaches = told.size();
        limits = passedLimits(told).size();
        EXPECT_EQ(outcome.json()["health_breaches"], limits);
    }
    EXPECT_GT(breaches, limits) << "no limit was passed twice: this test needs harder bodies";
}

TEST_F(DropRun, RefusesWhatCannotBeMeant) {
    const auto refusal = [](std::vector<std::string> words) {
        words.insert(words.begin(), "drop");
        const Outcome outcome = cli(words);
        EXPECT_NE(outcome.exitCode, 0);
        return outcome.err;
    };
    const std::string terrain = slope();
    EXPECT_THAT(refusal({table("a,480,1,1,0.2,0,0,2,0,0,0,stone\n"), "--terrain", terrain}),
                testing::AllOf(HasSubstr("below the surface"), HasSubstr("a (line 2)"), HasSubstr("--lift")));
    EXPECT_THAT(refusal({table("a,480,1,1,0.2,0,0,9,0,0,0,stone\nb,480,1,1,0.2,500,0,9,0,0,0,stone\n"), "--terrain", terrain}),
                testing::AllOf(HasSubstr("no heights"), HasSubstr("b (line 3)")));
    EXPECT_THAT(refusal({table("a,0,1,1,0.2,0,0,2,0,0,0,stone\n")}), HasSubstr("line 2"));
    const std::string one = table("a,480,1,1,0.2,0,0,2,0,0,0,stone\n");
    EXPECT_THAT(refusal({one, "--out", m_folder / "x.h5", "--turn"}), HasSubstr("one run"));
    EXPECT_THAT(refusal({one, "--samples", "5"}), HasSubstr("--path"));
    EXPECT_THAT(refusal({one, "--vary", "gravty=uniform:1:2"}), HasSubstr("gravity"));
    std::string many;
    for (int i = 0; i < 10000; ++i) {
        many += std::to_string(i) + ",480,1,1,0.2,0,0,2,0,0,0,stone\n";
    }
    EXPECT_THAT(refusal({table(many)}), testing::AllOf(HasSubstr("more than 100 others"), HasSubstr("--apart")));
}

}  // namespace

}  // namespace rubble::cli
