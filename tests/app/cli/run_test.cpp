#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "io/run/run_file.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

class Run : public SmallRun {
protected:
    nlohmann::json run(std::vector<std::string> more = {}) { return SmallRun::run(std::move(more), "1"); }
};

TEST_F(Run, JsonHasTheDocumentedKeysAndClosesItsLedger) {
    const nlohmann::json object = run();
    EXPECT_EQ(object["elements"], smallElements);
    EXPECT_EQ(object["fragments"], smallDead);
    EXPECT_GE(object["clusters"], 2);
    EXPECT_EQ(object["bodies_peak"], object["clusters"]);
    EXPECT_GT(object["steps"], 0);
    for (const char* stage : {"import", "components", "fragments", "sizing", "clusters", "simulation"}) {
        EXPECT_GE(object["wall_s"][stage], 0.0) << stage;
    }
    for (const char* key :
         {"real_time_factor", "energy_drift", "penetration_max_m", "asleep_at_end", "still_moving", "live_islands"}) {
        EXPECT_TRUE(object[key].is_number()) << key;
    }
    EXPECT_TRUE(object["ms_per_step"]["mean"].is_number());
    EXPECT_TRUE(object["ms_per_step"]["worst"].is_number());
    for (const char* key : {"mass_error", "momentum_error", "angular_momentum_error", "body_mass_error", "body_momentum_error",
                            "body_angular_momentum_error"}) {
        EXPECT_LT(object["ledger"][key], 1e-9) << key;
    }
    EXPECT_TRUE(object["warnings"].is_array());
    EXPECT_EQ(object["trajectory_hash"].get<std::string>().size(), 32u);
    EXPECT_EQ(object["run"], m_out);
    EXPECT_TRUE(fs::exists(m_out));
}

TEST_F(Run, RepeatsBitByBitAndSaysSo) {
    const std::string hash = run()["trajectory_hash"];
    EXPECT_EQ(run()["trajectory_hash"], hash);
    const Outcome verified = cli({"verify", m_out});
    EXPECT_EQ(verified.exitCode, 0) << verified.out << verified.err;
    EXPECT_THAT(verified.out, HasSubstr("bit-equal"));
    const nlohmann::json object = cli({"verify", m_out, "--json"}).json();
    EXPECT_EQ(object["verdict"], "bit-equal");
    EXPECT_EQ(object["ok"], true);
}

TEST_F(Run, SettingsReachTheSimulation) {
    const std::string hash = run()["trajectory_hash"];
    EXPECT_NE(run({"--set", "friction=0.1", "--set", "gravity=3.7"})["trajectory_hash"], hash);
    EXPECT_NE(run({"--set", "preset=paper"})["trajectory_hash"], hash);
}

TEST_F(Run, TellsOfLooseStructureThatTheEngineCarries) {
    const nlohmann::json without = run({"--set", "loose_structure=fe"})["carried"];
    EXPECT_EQ(without["islands"], 0);
    EXPECT_EQ(without["bodies"], 0);
    const nlohmann::json carried = run()["carried"];
    // One cube of a falling block lives on.
    EXPECT_EQ(carried["islands"], 1);
    EXPECT_EQ(carried["elements"], 1);
    EXPECT_NEAR(carried["mass_kg"], 2000.0, 1e-6);
    EXPECT_EQ(carried["refused"], 0);
    EXPECT_EQ(carried["left"], 1);
    EXPECT_NEAR(carried["left_mass_kg"], 2000.0, 1e-6);
    for (const char* ledger : {"hand_over_ledger", "loss_ledger"}) {
        for (const auto& [key, error] : carried[ledger].items()) {
            EXPECT_LE(error, 1e-9) << ledger << ' ' << key;
        }
    }
    const auto reader = io::openRun(m_out);
    EXPECT_EQ(reader->result()->carried.islands, 1);
    EXPECT_EQ(reader->result()->substeps, 12);
    ASSERT_EQ(reader->islandLedger().size(), 1u);
    EXPECT_NEAR(reader->islandLedger()[0].bodies.mass, 2000.0, 1e-6);
    const Outcome told = cli({"run", m_path, "--set", "settle_time=0.5", "--tables"});
    EXPECT_EQ(told.exitCode, 0) << told.err;
    EXPECT_THAT(told.out, HasSubstr("1 island with 1 element, 2 t"));
    EXPECT_THAT(told.out, HasSubstr("fragments alone. The engine moved loose structure beside them (loose_structure), 1 of 9"));
    EXPECT_THAT(run()["warnings"].dump(), HasSubstr("sizing.loose_beside.run"));
    EXPECT_THAT(run({"--set", "loose_structure=fe"})["warnings"].dump(), testing::Not(HasSubstr("sizing.loose_beside")));
    for (const char* part : {"1 loose island, 2 t", "loose structure, carried", "born from islands", "left of islands",
                             "islands at [s]", "islands against FE", "losses of islands"}) {
        EXPECT_THAT(told.out, HasSubstr(part));
    }
    EXPECT_THAT(cli({"run", m_path, "--set", "loose_structure=fe", "--set", "settle_time=0.5", "--tables"}).out,
                testing::Not(HasSubstr("loose structure, carried")));
}

TEST_F(Run, ADamagedRunIsNotVerified) {
    run();
    std::fstream file(m_out, std::ios::in | std::ios::out | std::ios::binary);
    const std::streamoff middle = static_cast<std::streamoff>(fs::file_size(m_out)) / 2;
    file.seekg(middle);
    std::string bytes(256, '\0');
    file.read(bytes.data(), 256);
    for (char& byte : bytes) {
        byte = static_cast<char>(~byte);
    }
    file.seekp(middle);
    file.write(bytes.data(), 256);
    file.close();
    const Outcome outcome = cli({"verify", m_out});
    EXPECT_EQ(outcome.exitCode, 1) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("small.run.h5"));
}

TEST_F(Run, FragmentsTableHasTheDocumentedColumns) {
    const std::string csv = m_folder / "fragments.csv";
    run({"--export", "fragments=" + csv});
    const std::vector<std::string> lines = linesOf(textOf(csv));
    ASSERT_EQ(lines.size(), smallDead + 1u);
    std::string head = lines.front();
    head.erase(head.find_last_not_of("\r\n") + 1);
    EXPECT_EQ(
        head,
        "fragment_id,element_id,component,cluster_id,birth_time_s,birth_x_m,birth_y_m,birth_z_m,final_x_m,final_y_m,final_z_m,"
        "birth_speed_m_s,impact_speed_m_s,mass_kg");
    EXPECT_TRUE(fs::exists(csv + ".provenance.json") || fs::exists(m_folder / "fragments.provenance.json"));
    // The same table later, from the run file alone: the FE file is not needed.
    fs::remove(m_path);
    const std::string again = m_folder / "again.csv";
    const Outcome outcome = cli({"export", m_out, "--export", "fragments=" + again});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(textOf(again), textOf(csv));
}

TEST_F(Run, SeriesIsACollectionForParaView) {
    const std::string pvd = m_folder / "series.pvd";
    run({"--export", "series=" + pvd});
    const std::string text = textOf(pvd);
    EXPECT_THAT(text, HasSubstr("<Collection>"));
    EXPECT_THAT(text, HasSubstr("timestep="));
    std::size_t files = 0;
    for (std::size_t at = text.find("file=\""); at != std::string::npos; at = text.find("file=\"", at + 1)) {
        const std::string name = text.substr(at + 6, text.find('"', at + 6) - at - 6);
        EXPECT_TRUE(fs::exists(m_folder / name)) << name;
        ++files;
    }
    EXPECT_GE(files, 12u) << "two parts at six states";
}

TEST_F(Run, TheSameGoesIntoOneVtkHdfFile) {
    const std::string path = m_folder / "series.vtkhdf";
    run({"--export", "vtkhdf=" + path});
    EXPECT_THAT(textOf(path), testing::StartsWith("\x89HDF"));
    EXPECT_TRUE(fs::exists(path + ".provenance.json"));
}

TEST_F(Run, WithoutOutNothingIsLeftBehind) {
    const std::string temporary = m_folder / "tmp";
    fs::create_directory(temporary);
    const std::string csv = m_folder / "fragments.csv";
    const Outcome outcome = CommandRun().with("TMPDIR", temporary).cli({"run", m_path, "--export", "fragments=" + csv});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(csv));
    EXPECT_TRUE(fs::is_empty(temporary));
    EXPECT_EQ(CommandRun().with("TMPDIR", temporary).cli({"run", m_path}).exitCode, 0);
    EXPECT_TRUE(fs::is_empty(temporary));
}

TEST_F(Run, LedgerTableClosesAtEveryHandOver) {
    const std::string csv = m_folder / "ledger.csv";
    run({"--csv", csv});
    const std::vector<std::string> lines = linesOf(textOf(csv));
    ASSERT_GE(lines.size(), 3u);
    EXPECT_THAT(lines.front(), testing::StartsWith("time_s,state,fe_mass_kg,"));
    EXPECT_THAT(lines.front(), HasSubstr(",dropped_kinetic_energy_j,"));
    const auto columns = std::count(lines.front().begin(), lines.front().end(), ',');
    for (const std::string& line : lines) {
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    }
}

TEST_F(Run, SummaryIsTenLinesThatAPersonReads) {
    const Outcome kept = cli({"run", m_path, "--set", "settle_time=1", "--out", m_out});
    ASSERT_EQ(kept.exitCode, 0) << kept.err;
    EXPECT_LE(linesOf(kept.out).size(), 10u) << kept.out;
    for (const std::string& said :
         {std::string("5 fragments, 10 t, in "), std::string("run-out of "), std::string(" s of wall time"),
          std::string("one set of assumptions: "), std::string("of the bodies"), std::string("health"), std::string("findings"),
          m_out, std::string("--tables prints every table")}) {
        EXPECT_THAT(kept.out, HasSubstr(said));
    }
    EXPECT_THAT(kept.out, testing::Not(HasSubstr("Basic Grid")));
    // The same is measured where no file took the run.
    const auto lies = [](const std::string& text) {
        const std::size_t at = text.find("  lies ");
        return at == std::string::npos ? std::string() : text.substr(at, text.find('\n', at) - at);
    };
    const Outcome passing = cli({"run", m_path, "--set", "settle_time=1"});
    EXPECT_NE(lies(kept.out), "");
    EXPECT_EQ(lies(passing.out), lies(kept.out));
    EXPECT_THAT(passing.out, HasSubstr("--out RUN.h5 keeps it"));
}

TEST_F(Run, TablesNameTheirParts) {
    const Outcome outcome = cli({"run", m_path, "--set", "settle_time=1", "--tables"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_LT(outcome.out.find("--tables prints every table"), outcome.out.find("Fragments: 5")) << "the summary comes first";
    for (const char* heading : {"Fragments: 5", "Basic Grid", "Clusters", "Run", "Ledger", "trajectory hash", "bulking factor"}) {
        EXPECT_THAT(outcome.out, HasSubstr(heading));
    }
}

TEST_F(Run, NobodyDeadMeansNothingMoves) {
    io::ExodusBuilder builder = smallCollapse();
    builder.element.clear();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.write(m_path);
    const Outcome outcome = cli({"run", m_path});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("there are no fragments"));
    EXPECT_EQ(run()["fragments"], 0);
}

TEST_F(Run, WrongRequestsAreRefusedBeforeTheWork) {
    const auto refused = [&](std::vector<std::string> more, int code, const std::string& says) {
        more.insert(more.begin(), {"run", m_path});
        const Outcome outcome = cli(more);
        EXPECT_EQ(outcome.exitCode, code) << says << outcome.out;
        EXPECT_THAT(outcome.err, HasSubstr(says));
        EXPECT_EQ(outcome.out, "");
    };
    refused({"--export", "movie=a.mp4"}, 2, "Kinds: fragments, series, vtkhdf, bodies, gltf");
    refused({"--export", "vtkhdf=a.h5"}, 2, "ends in .vtkhdf");
    refused({"--export", "fragments"}, 2, "no \"=\"");
    std::ofstream(m_folder / "file") << "no folder";
    refused({"--export", "fragments=" + (m_folder / "file/f.csv")}, 1, "cannot be made: Not a directory");
    refused({"--out", m_path}, 2, "is read by this command");
    refused({"--pane", "left"}, 2, "fe, fragments, both");
    refused({"--size", "3x4"}, 2, "WIDTHxHEIGHT");
    refused({"--time", "soon"}, 2, "seconds");
    std::ofstream(m_folder / "diary.txt") << "not a run";
    refused({"--out", m_folder / "diary.txt"}, 2, "is not a run");
    EXPECT_EQ(textOf(m_folder / "diary.txt"), "not a run");
}

TEST_F(Run, AFullDiskIsAnErrorThatNamesTheFile) {
    run();
    const std::size_t half = fs::file_size(m_out) / 2;
    const Outcome outcome = CommandRun().fileSizeLimit(half).cli({"run", m_path, "--out", m_out, "--set", "settle_time=1"});
    EXPECT_EQ(outcome.exitCode, 1) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("small.run.h5"));
    EXPECT_EQ(outcome.out, "");
}

/// Sends a signal once the growing run file, read from this process, has a few frames.
std::function<void(pid_t)> onceGrown(const std::string& path, int signal) {
    return [path, signal, sent = false](pid_t program) mutable {
        if (sent || !fs::exists(path)) {
            return;
        }
        try {
            sent = io::openRun(path)->frameCount() >= 5;
        } catch (const Error&) {
            // Its head is not written yet.
            return;
        }
        if (sent) {
            kill(program, signal);
        }
    };
}

TEST_F(Run, CtrlCKeepsWhatWasSimulated) {
    const std::string arch = sourcePath("resources/samples/rc-arch.exo");
    const Outcome outcome =
        CommandRun().meanwhile(onceGrown(m_out, SIGINT)).cli({"run", arch, "--out", m_out, "--json", "--set", "multiple=3"});
    EXPECT_EQ(outcome.exitCode, 3) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("cancelled"));
    const nlohmann::json object = outcome.json();
    EXPECT_EQ(object["cancelled"], true);
    EXPECT_GE(object["frames"], 5);
    // What was kept can be exported; it cannot be verified.
    const std::string csv = m_folder / "partial.csv";
    const Outcome exported = cli({"export", m_out, "--export", "fragments=" + csv});
    EXPECT_EQ(exported.exitCode, 0) << exported.err;
    EXPECT_THAT(exported.err, HasSubstr("not complete"));
    const Outcome verified = cli({"verify", m_out});
    EXPECT_EQ(verified.exitCode, 1);
    EXPECT_THAT(verified.err, HasSubstr("not complete"));
}

TEST_F(Run, AKilledRunReopensAtItsLastFrame) {
    const std::string arch = sourcePath("resources/samples/rc-arch.exo");
    const Outcome outcome =
        CommandRun().meanwhile(onceGrown(m_out, SIGKILL)).cli({"run", arch, "--out", m_out, "--set", "multiple=3"});
    EXPECT_EQ(outcome.signal, SIGKILL);
    const Outcome exported = cli({"export", m_out, "--export", "fragments=" + (m_folder / "partial.csv"), "--json"});
    ASSERT_EQ(exported.exitCode, 0) << exported.err;
    EXPECT_EQ(exported.json()["complete"], false);
    EXPECT_GE(exported.json()["frames"], 5);
}

TEST_F(Run, AKilledRunGoesOnFromItsCheckpoint) {
    const auto words = [&](const std::string& out, std::vector<std::string> more) {
        more.insert(more.begin(), {"run", m_path, "--out", out, "--json", "--set", "settle_time=3", "--set", "step_rate=10000"});
        return more;
    };
    const auto start = [] { return CommandRun().with("RUBBLE_CHECKPOINT_SECONDS", "0.02"); };
    const std::string whole = m_folder / "whole.run.h5";
    const Outcome undisturbed = cli(words(whole, {"--csv", m_folder / "whole.csv"}));
    ASSERT_EQ(undisturbed.exitCode, 0) << undisturbed.err;
    EXPECT_FALSE(fs::exists(whole + ".checkpoint"));

    const std::string checkpoint = m_out + ".checkpoint";
    // Once there is another checkpoint than before.
    const auto written = [&] {
        std::error_code missing;
        const fs::file_time_type time = fs::last_write_time(checkpoint, missing);
        return missing ? fs::file_time_type::min() : time;
    };
    const auto onceKept = [&](int signal) {
        return [&, signal, before = written(), sent = false](pid_t program) mutable {
            sent = sent || (written() > before && kill(program, signal) == 0);
        };
    };
    EXPECT_EQ(start().meanwhile(onceKept(SIGKILL)).cli(words(m_out, {})).signal, SIGKILL);
    const Outcome stopped = start().meanwhile(onceKept(SIGINT)).cli(words(m_out, {}));
    EXPECT_EQ(stopped.exitCode, 3) << stopped.err;
    EXPECT_THAT(stopped.err, HasSubstr("going on from a checkpoint at "));
    EXPECT_THAT(stopped.err, HasSubstr("--anew"));
    const Outcome last = start().cli(words(m_out, {"--csv", m_folder / "last.csv"}));
    ASSERT_EQ(last.exitCode, 0) << last.err;
    EXPECT_THAT(last.err, HasSubstr("going on from a checkpoint at "));
    EXPECT_GT(last.json()["checkpoints"]["resumed_at_s"], 0.0);
    EXPECT_TRUE(undisturbed.json()["checkpoints"]["resumed_at_s"].is_null());
    EXPECT_EQ(last.json()["trajectory_hash"], undisturbed.json()["trajectory_hash"]);
    EXPECT_EQ(last.json()["steps"], undisturbed.json()["steps"]);
    EXPECT_EQ(textOf(m_folder / "last.csv"), textOf(m_folder / "whole.csv"));
    EXPECT_EQ(io::openRun(m_out)->frameCount(), io::openRun(whole)->frameCount());
    EXPECT_FALSE(fs::exists(checkpoint));
    EXPECT_FALSE(fs::exists(m_out + ".interrupted"));
    const Outcome verified = cli({"verify", m_out});
    EXPECT_EQ(verified.exitCode, 0) << verified.err;
}

TEST_F(Run, BeginsAnewWhereAskedOrWhereTheCheckpointIsDamaged) {
    const std::string checkpoint = m_out + ".checkpoint";
    const std::vector<std::string> words{"run",           m_path,  "--out",          m_out, "--json", "--set",
                                         "settle_time=3", "--set", "step_rate=10000"};
    const auto killed = [&] {
        const Outcome outcome = CommandRun()
                                    .with("RUBBLE_CHECKPOINT_SECONDS", "0.02")
                                    .meanwhile([&](pid_t program) { fs::exists(checkpoint) ? kill(program, SIGKILL) : 0; })
                                    .cli(words);
        EXPECT_EQ(outcome.signal, SIGKILL);
    };
    killed();
    std::vector<std::string> anew = words;
    anew.push_back("--anew");
    // Left by a start that was killed before it had taken the file over.
    fs::copy_file(m_out, m_out + ".interrupted");
    const Outcome started = cli(anew);
    ASSERT_EQ(started.exitCode, 0) << started.err;
    EXPECT_EQ(started.err, "");
    EXPECT_FALSE(fs::exists(m_out + ".interrupted"));
    killed();
    fs::resize_file(checkpoint, fs::file_size(checkpoint) / 2);
    const Outcome outcome = cli(words);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("simulation.checkpoint_damaged"));
    EXPECT_EQ(outcome.json()["trajectory_hash"], started.json()["trajectory_hash"]);
}

TEST_F(Run, ProgressShowsOnATerminalOnly) {
    const Outcome shown = CommandRun().errorsToTerminal().cli({"run", m_path, "--json"});
    ASSERT_EQ(shown.exitCode, 0) << shown.err;
    EXPECT_THAT(shown.err, HasSubstr(" %"));
    EXPECT_THAT(shown.err, HasSubstr("\x1b[K"));
    EXPECT_NO_THROW(shown.json());
    EXPECT_EQ(cli({"run", m_path, "--json"}).err, "");
}

TEST_F(Run, TheFeFileIsFoundByItsContent) {
    run();
    const std::string pvd = m_folder / "series.pvd";
    // Moved beside the run under another name: found by SHA-256.
    fs::rename(m_path, m_folder / "renamed.exo");
    EXPECT_EQ(cli({"export", m_out, "--export", "series=" + pvd}).exitCode, 0);
    // Another file in its place is not taken for it.
    fs::remove(m_folder / "renamed.exo");
    io::ExodusBuilder other = smallCollapse();
    other.nodes[0].x() += 0.01;
    other.write(m_path);
    const Outcome outcome = cli({"export", m_out, "--export", "series=" + pvd});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("--fe FILE"));
    const Outcome named = cli({"verify", m_out, "--fe", m_path});
    EXPECT_EQ(named.exitCode, 1);
    EXPECT_THAT(named.err, HasSubstr("SHA-256"));
}

TEST_F(Run, ExportAsksForSomethingToWrite) {
    run();
    EXPECT_EQ(cli({"export", m_out}).exitCode, 2);
    EXPECT_EQ(cli({"export", m_path, "--export", "fragments=" + (m_folder / "f.csv")}).exitCode, 1) << "not a run";
    EXPECT_EQ(cli({"export", m_folder / "none.h5", "--export", "fragments=" + (m_folder / "f.csv")}).exitCode, 1);
}

}  // namespace

}  // namespace rubble::cli
