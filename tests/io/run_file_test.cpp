#include "io/run/run_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "core/simulation/run/acknowledgement.h"
#include "io/base/files.h"
#include "io/base/hdf5_handle.h"
#include "io/run/acknowledgements.h"
#include "io/run/run_columns.h"
#include "io/run/run_json.h"
#include "io/run/run_tables.h"
#include "tests/io/sample_run.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

template <class T>
void expectSameRows(const std::vector<T>& a, const std::vector<T>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(packRows(std::span(a)), packRows(std::span(b)));
}

void expectSameTrajectory(const SampleRun& run, const RunReader& reader, std::size_t frames) {
    ASSERT_EQ(reader.frameCount(), frames);
    for (std::size_t i = 0; i < frames; ++i) {
        EXPECT_EQ(reader.frameTime(i), run.frames[i].time);
        EXPECT_TRUE(sameFrame(*reader.frame(i), run.frames[i])) << i;
    }
}

// Waits for the writing thread; there is no limit on how long it may take other than the test's own.
template <class Condition>
bool eventually(const Condition& condition) {
    for (int i = 0; i < 2000; ++i) {
        if (condition()) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

TEST(RunFile, GivesBackEverythingThatWasWritten) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.run.h5";
    const SampleRun run = makeSampleRun(1, 200, 30);
    run.feed(*createRun(path, run.origin));
    const auto reader = openRun(path);
    EXPECT_TRUE(reader->complete());
    expectSameTrajectory(run, *reader, 30);
    EXPECT_EQ(originJson(reader->origin()), originJson(run.origin));
    EXPECT_EQ(reader->origin().scenario, run.origin.scenario);
    EXPECT_EQ(reader->origin().frame, run.origin.frame);
    expectSameRows(reader->bodies(), run.bodies);
    expectSameRows(reader->carriers(), run.carriers);
    expectSameRows(reader->ledger(), run.ledger);
    ASSERT_EQ(reader->islands().size(), run.islands.size());
    for (std::size_t i = 0; i < run.islands.size(); ++i) {
        EXPECT_EQ(reader->islands()[i].body, run.islands[i].body);
        EXPECT_EQ(reader->islands()[i].elements, run.islands[i].elements);
        EXPECT_EQ(reader->islands()[i].state, run.islands[i].state);
        EXPECT_EQ(reader->islands()[i].inFe.position, run.islands[i].inFe.position);
        EXPECT_EQ(reader->islands()[i].inFe.orientation.coeffs(), run.islands[i].inFe.orientation.coeffs());
    }
    expectSameRows(reader->islandLedger(), {run.islandLedger});
    expectSameRows(reader->islandLosses(), run.islandLosses);
    EXPECT_THAT(reader->componentNames(), testing::ElementsAre("deck 1", "arch ring 1, failing strip", "pfeiler \xC3\xBC"));
    const auto fragments = reader->fragments();
    expectSameRows(fragments->list, run.description.fragments->list);
    EXPECT_EQ(fragments->vertexOffsets, run.description.fragments->vertexOffsets);
    EXPECT_EQ(fragments->vertices, run.description.fragments->vertices);
    EXPECT_EQ(fragments->solid, run.description.fragments->solid);
    EXPECT_EQ(findingsJson(fragments->findings), findingsJson(run.description.fragments->findings));
    ASSERT_EQ(reader->elementIds().size(), fragments->size());
    EXPECT_EQ(reader->elementIds()[5], 6);
    const auto clustering = reader->clustering();
    expectSameRows(clustering->list, run.description.clustering->list);
    EXPECT_EQ(clustering->members, run.description.clustering->members);
    EXPECT_EQ(clustering->of, run.description.clustering->of);
    EXPECT_EQ(clusteringJson(*clustering), clusteringJson(*run.description.clustering));
    EXPECT_EQ(sizingJson(*reader->sizing()), sizingJson(*run.description.sizing));
    EXPECT_TRUE(std::isinf(reader->sizing()->axis[1].accuracyMax));
    const auto result = reader->result();
    expectSameRows(result->fragments, run.result.fragments);
    EXPECT_EQ(resultJson(*result), resultJson(run.result));
    EXPECT_EQ(result->penetrationMax, run.result.penetrationMax);
    EXPECT_EQ(result->carried.bornAtRestMass, 1e4);
    EXPECT_EQ(result->carried.bornSofterMass, 2e3);
    EXPECT_EQ(result->carried.losses.bodyAngularMomentum, 9e-15);
    EXPECT_EQ(result->effects.size(), effectCount);
    EXPECT_EQ(result->effects[1].decision.asked, EffectSwitch::On);
    EXPECT_EQ(result->health.breaches[2].body, idAt<BodyId>(2));
    EXPECT_EQ(breachesDigest(*result), breachesDigest(run.result));
    EXPECT_TRUE(std::isnan(result->bulkingFactor));
    EXPECT_EQ(reader->findings().count("test.simulation"), 3);
    EXPECT_EQ(reader->findings().list().size(), 3u);
    EXPECT_NO_THROW(checkRunDigest(path, Execution()));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

// What a run that is not complete says of its health: the last word on each breach, in the order in which they began.
TEST(RunFile, TellsOfBreachesBeforeTheRunIsComplete) {
    const TemporaryFolder folder;
    const std::string path = folder / "growing.run.h5";
    const SampleRun run = makeSampleRun(8, 50, 40);
    const auto sink = createRun(path, run.origin);
    const auto reader = openRun(path);
    EXPECT_TRUE(reader->breaches().empty());
    run.feed(*sink, 30);
    // One flush more than two seconds later hands everything to the readers.
    ASSERT_TRUE(eventually([&] {
        TrajectoryFrame again = run.frames[29];
        sink->commit(again);
        reader->refresh();
        return reader->breaches().size() == 3 && reader->frameCount() >= 30;
    }));
    EXPECT_FALSE(reader->complete());
    const std::vector<HealthBreach> known = reader->breaches();
    EXPECT_TRUE(
        std::is_sorted(known.begin(), known.end(), [](const HealthBreach& a, const HealthBreach& b) { return a.from < b.from; }));
    for (const HealthBreach& breach : known) {
        HealthBreach whole = run.result.health.breaches[static_cast<std::size_t>(breach.check)];
        whole.to += breach.check == HealthCheck::Speed ? run.frames[29].time : 0.0;
        EXPECT_EQ(breachJson(breach), breachJson(whole));
    }
    EXPECT_EQ(taintOf(*reader).limits, 3u);
    EXPECT_FALSE(taintOf(*reader).complete);
}

TEST(RunFile, AResultThatDoesNotSayWhenItWasWorstIsRead) {
    const SampleRun run = makeSampleRun(9, 3, 1);
    nlohmann::json text = resultJson(run.result);
    for (nlohmann::json& breach : text["health"]["breaches"]) {
        breach.erase("worst_at");
    }
    text["step_times"].erase("health_ms");
    const SimulationResult older = resultFromJson(JsonCursor(text, "older", ""));
    EXPECT_TRUE(std::isnan(older.health.breaches[0].worstAt));
    EXPECT_EQ(older.stepTimes.healthMs, 0.0);
    // An acknowledgement of then holds on.
    EXPECT_EQ(breachesDigest(older), breachesDigest(run.result));
}

TEST(RunFile, HoldsARunWithoutAnyBody) {
    const TemporaryFolder folder;
    const SampleRun run = makeSampleRun(2, 0, 2);
    run.feed(*createRun(folder / "empty.run.h5", run.origin));
    const auto reader = openRun(folder / "empty.run.h5");
    expectSameTrajectory(run, *reader, 2);
    EXPECT_EQ(reader->fragments()->size(), 0u);
    EXPECT_TRUE(reader->result()->fragments.empty());
    EXPECT_NO_THROW(checkRunDigest(folder / "empty.run.h5", Execution()));
}

TEST(RunFile, IsReadInTheSameProcessWhileItGrows) {
    const TemporaryFolder folder;
    const std::string path = folder / "grows.run.h5";
    const SampleRun run = makeSampleRun(3, 300, 40);
    auto sink = createRun(path, run.origin);
    const auto reader = openRun(path);
    EXPECT_EQ(reader->frameCount(), 0u);
    EXPECT_EQ(reader->fragments(), nullptr);
    EXPECT_EQ(reader->result(), nullptr);
    EXPECT_TRUE(frameAtTime(*reader, 1.0).positions.empty());
    sink->begin(run.description);
    EXPECT_EQ(reader->fragments()->size(), run.description.fragments->size());
    sink->addBodies(run.bodies, run.carriers);
    for (std::size_t i = 0; i < run.frames.size(); ++i) {
        sink->commit(run.frames[i]);
        ASSERT_TRUE(eventually([&] {
            reader->refresh();
            return reader->frameCount() == i + 1;
        }));
        EXPECT_TRUE(sameFrame(*reader->frame(i), run.frames[i])) << i;
        EXPECT_TRUE(sameFrame(*reader->frame(i / 2), run.frames[i / 2])) << i;
        EXPECT_EQ(reader->bodies().size(), run.bodies.size());
        EXPECT_FALSE(reader->complete());
    }
    sink->finish(run.result);
    reader->refresh();
    EXPECT_TRUE(reader->complete());
    EXPECT_EQ(resultJson(*reader->result()), resultJson(run.result));
    sink.reset();
    expectSameTrajectory(run, *openRun(path), run.frames.size());
    checkRunDigest(path, Execution());
}

TEST(RunFile, IsReadBySeveralThreadsWhileItGrows) {
    const TemporaryFolder folder;
    const std::string path = folder / "threads.run.h5";
    const SampleRun run = makeSampleRun(4, 300, 60);
    auto sink = createRun(path, run.origin);
    const auto reader = openRun(path, 100000);
    std::atomic<int> wrong{0};
    std::atomic<bool> done{false};
    std::vector<std::thread> readers;
    for (int t = 0; t < 2; ++t) {
        readers.emplace_back([&, t] {
            std::size_t i = static_cast<std::size_t>(t);
            while (!done) {
                reader->refresh();
                if (const std::size_t count = reader->frameCount(); count > 0) {
                    i = (i * 7 + 3) % count;
                    wrong += sameFrame(*reader->frame(i), run.frames[i]) ? 0 : 1;
                }
            }
        });
    }
    run.feed(*sink);
    done = true;
    for (std::thread& thread : readers) {
        thread.join();
    }
    EXPECT_EQ(wrong, 0);
    reader->refresh();
    expectSameTrajectory(run, *reader, run.frames.size());
}

/// A process of its own that writes a run and then does as told.
class Writer {
public:
    template <class Work>
    explicit Writer(const Work& work) {
        m_pid = ::fork();
        if (m_pid == 0) {
            try {
                work();
            } catch (const std::exception& error) {
                std::fprintf(stderr, "writer: %s\n", error.what());
                ::_exit(1);
            }
            ::_exit(0);
        }
    }
    void kill() const { ::kill(m_pid, SIGKILL); }
    int wait() const {
        int status = 0;
        ::waitpid(m_pid, &status, 0);
        return status;
    }

private:
    pid_t m_pid = -1;
};

TEST(RunFile, IsReadByAnotherProcessAndSurvivesTheDeathOfItsWriter) {
    const TemporaryFolder folder;
    const std::string path = folder / "killed.run.h5";
    const SampleRun run = makeSampleRun(5, 500, 400);
    const Writer writer([&] {
        auto sink = createRun(path, run.origin);
        sink->begin(run.description);
        sink->addBodies(run.bodies, run.carriers);
        for (;;) {
            for (const TrajectoryFrame& frame : run.frames) {
                if (frame.time > 8.0) {
                    break;
                }
                sink->commit(frame);
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            }
            ::pause();
        }
    });
    ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path); }));
    const auto live = openRun(path);
    ASSERT_TRUE(eventually([&] {
        live->refresh();
        return live->frameCount() > 30;
    }));
    const std::size_t seen = live->frameCount();
    ASSERT_TRUE(eventually([&] {
        live->refresh();
        return live->frameCount() > seen + 20;
    }));
    writer.kill();
    ASSERT_TRUE(WIFSIGNALED(writer.wait()));
    expectSameTrajectory(run, *live, live->frameCount());
    const auto reopened = openRun(path);
    EXPECT_GE(reopened->frameCount(), live->frameCount());
    EXPECT_LT(reopened->frameCount(), run.frames.size());
    EXPECT_FALSE(reopened->complete());
    EXPECT_EQ(reopened->result(), nullptr);
    expectSameTrajectory(run, *reopened, reopened->frameCount());
    expectSameRows(reopened->bodies(), run.bodies);
    EXPECT_EQ(reopened->fragments()->size(), run.description.fragments->size());
    EXPECT_THROW(checkRunDigest(path, Execution()), ParseError);
}

TEST(RunFile, KeepsEveryCommittedFrameOfACancelledRun) {
    const TemporaryFolder folder;
    const SampleRun run = makeSampleRun(6, 100, 20);
    run.feed(*createRun(folder / "cancelled.run.h5", run.origin), 13);
    const auto reader = openRun(folder / "cancelled.run.h5");
    EXPECT_FALSE(reader->complete());
    expectSameTrajectory(run, *reader, 13);
    EXPECT_EQ(reader->ledger().size(), 13u);
}

/// Hands a run to a sink: bodies first, then frames [from, to) with a ledger row after each.
void hand(TrajectorySink& sink, const SampleRun& run, std::size_t from, std::size_t to) {
    if (from == 0) {
        sink.addBodies(run.bodies, run.carriers);
    }
    for (std::size_t i = from; i < to; ++i) {
        // One island after the other, of different sizes.
        const std::vector<ElementIndex> elements(1 + i % 7, idAt<ElementIndex>(i));
        const IslandRecord island{idAt<BodyId>(i),
                                  static_cast<std::uint32_t>(i / 3),
                                  {Vec3(1.0 * static_cast<double>(i), 2, 3), Quat::Identity()},
                                  elements};
        sink.addIslands(std::span(&island, 1), run.islandLedger);
        sink.addIslandLoss({run.frames[i].time, static_cast<std::uint32_t>(i), {}, {}, {}});
        sink.commit(run.frames[i]);
        LedgerRow row;
        row.time = run.frames[i].time;
        sink.addLedger(row);
    }
}

TEST(RunFile, GoesOnAfterAMarkAndForgetsWhatCameLater) {
    const TemporaryFolder folder;
    const std::string path = folder / "run.h5";
    const std::string whole = folder / "whole.h5";
    const SampleRun run = makeSampleRun(7, 50, 40);
    {
        const auto sink = createRun(whole, run.origin);
        sink->begin(run.description);
        hand(*sink, run, 0, 40);
        sink->finish(run.result);
    }
    const std::string markFile = checkpointPathOf(path);
    const Writer writer([&] {
        const auto sink = createRun(path, run.origin);
        sink->begin(run.description);
        hand(*sink, run, 0, 17);
        const std::optional<std::string> mark = sink->mark();
        hand(*sink, run, 17, 30);
        writeIn(markFile, mark.value());
        ::raise(SIGKILL);
    });
    writer.wait();
    const std::string mark = contentOf(markFile).value();
    {
        const auto sink = continueRun(path, run.origin);
        ASSERT_TRUE(sink->resume(run.description, mark));
        EXPECT_EQ(openRun(path)->frameCount(), 17u);
        EXPECT_FALSE(std::filesystem::exists(path + ".interrupted"));
        hand(*sink, run, 17, 40);
        sink->finish(run.result);
    }
    EXPECT_NO_THROW(checkRunDigest(path, Execution()));
    const auto expected = openRun(whole);
    const auto reader = openRun(path);
    ASSERT_EQ(reader->frameCount(), 40u);
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_TRUE(sameFrame(*reader->frame(i), run.frames[i])) << i;
    }
    EXPECT_EQ(reader->ledger().size(), 40u);
    const std::vector<IslandRecord> islands = reader->islands();
    ASSERT_EQ(islands.size(), 40u) << "those after the mark came once";
    for (std::size_t i = 0; i < 40; ++i) {
        EXPECT_EQ(islands[i].body, idAt<BodyId>(i));
        EXPECT_EQ(islands[i].state, i / 3);
        EXPECT_EQ(islands[i].inFe.position.x(), 1.0 * static_cast<double>(i));
        EXPECT_EQ(islands[i].elements, std::vector<ElementIndex>(1 + i % 7, idAt<ElementIndex>(i)));
    }
    EXPECT_EQ(reader->islandLosses().size(), 40u);
    EXPECT_EQ(RunColumns(path).text(RunDataset::Digests), RunColumns(whole).text(RunDataset::Digests))
        << "every row of every dataset is the same";
}

TEST(RunFile, DoesNotGoOnFromAnotherFile) {
    const TemporaryFolder folder;
    const std::string path = folder / "run.h5";
    const SampleRun run = makeSampleRun(7, 50, 20);
    std::string mark;
    {
        const auto sink = createRun(path, run.origin);
        sink->begin(run.description);
        hand(*sink, run, 0, 10);
        mark = sink->mark().value();
    }
    writeIn(checkpointPathOf(path), "there");
    const auto startsAnew = [&] {
        {
            const auto sink = continueRun(path, run.origin);
            EXPECT_FALSE(sink->resume(run.description, mark));
            sink->begin(run.description);
            EXPECT_FALSE(std::filesystem::exists(path + ".interrupted"));
            hand(*sink, run, 0, 20);
            sink->finish(run.result);
        }
        EXPECT_EQ(openRun(path)->frameCount(), 20u);
        EXPECT_NO_THROW(checkRunDigest(path, Execution()));
    };
    // Gone, shorter, and of other content.
    std::filesystem::rename(path, folder / "aside.h5");
    startsAnew();
    const auto replace = [&](const SampleRun& other, std::size_t frames) {
        const auto sink = createRun(path, run.origin);
        sink->begin(other.description);
        hand(*sink, other, 0, frames);
    };
    replace(run, 5);
    startsAnew();
    SampleRun moved = makeSampleRun(7, 50, 20);
    moved.frames[3].positions[0].x() += 0.001f;
    replace(moved, 10);
    startsAnew();
    // The very file is taken again, also where a process died before it had taken it over.
    std::filesystem::rename(folder / "aside.h5", path + ".interrupted");
    const auto sink = continueRun(path, run.origin);
    EXPECT_TRUE(sink->resume(run.description, mark));
    EXPECT_EQ(openRun(path)->frameCount(), 10u);
}

TEST(RunFile, SaysThatTheDiskIsFullAndKeepsTheFramesBefore) {
    const TemporaryFolder folder;
    const std::string path = folder / "full.run.h5";
    const SampleRun run = makeSampleRun(7, 2000, 200);
    const Writer writer([&] {
        std::unique_ptr<FileSizeLimit> limit;
        auto sink = createRun(path, run.origin);
        sink->begin(run.description);
        limit = std::make_unique<FileSizeLimit>(std::filesystem::file_size(path) + 1500000);
        try {
            sink->addBodies(run.bodies, run.carriers);
            for (int i = 0; i < 200; ++i) {
                sink->commit(run.frames[static_cast<std::size_t>(i)]);
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
            }
            sink->finish(run.result);
            ::_exit(3);
        } catch (const WorldError& error) {
            const std::string text = error.what();
            if (text.find(path) == std::string::npos || text.find("File too large") == std::string::npos ||
                error.remedy().empty()) {
                std::fprintf(stderr, "%s\n", text.c_str());
                ::_exit(4);
            }
        }
        sink.reset();
        // The process itself goes on, can read what is there and can write elsewhere.
        const auto reader = openRun(path);
        if (reader->frameCount() == 0 || !sameFrame(*reader->frame(0), run.frames[0])) {
            ::_exit(5);
        }
    });
    EXPECT_EQ(writer.wait(), 0);
    const auto reader = openRun(path);
    EXPECT_GT(reader->frameCount(), 2u);
    EXPECT_LT(reader->frameCount(), run.frames.size());
    EXPECT_FALSE(reader->complete());
    expectSameTrajectory(run, *reader, reader->frameCount());
}

TEST(RunFile, LeavesTheOldFileWhenANewOneCannotBeMade) {
    const TemporaryFolder folder;
    const std::string path = folder / "old.run.h5";
    const SampleRun run = makeSampleRun(8, 10, 3);
    run.feed(*createRun(path, run.origin));
    const Writer writer([&] {
        const FileSizeLimit limit(1000);
        try {
            createRun(path, run.origin);
            ::_exit(3);
        } catch (const WorldError& error) {
            ::_exit(std::string(error.what()).find(path) == std::string::npos ? 4 : 0);
        }
    });
    EXPECT_EQ(writer.wait(), 0);
    expectSameTrajectory(run, *openRun(path), 3);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
    EXPECT_THROW(createRun(folder / "no/such/folder.run.h5", run.origin), WorldError);
    EXPECT_THROW(createRun(folder.path(), run.origin), WorldError);
}

TEST(RunFile, ANewRunTakesThePlaceOfOneThatIsBeingShown) {
    const TemporaryFolder folder;
    const std::string path = folder / "shown.run.h5";
    const SampleRun before = makeSampleRun(9, 50, 10);
    const SampleRun after = makeSampleRun(10, 60, 12);
    before.feed(*createRun(path, before.origin));
    const auto shown = openRun(path, 1);
    after.feed(*createRun(path, after.origin));
    expectSameTrajectory(before, *shown, 10);
    expectSameTrajectory(after, *openRun(path), 12);
}

TEST(RunFile, OpensRunsOfBeforeTheMonitor) {
    const TemporaryFolder folder;
    const std::string path = folder / "older.run.h5";
    std::filesystem::copy_file(sourcePath("tests/io/older/before-health.run.h5"), path);
    const auto reader = openRun(path);
    ASSERT_TRUE(reader->complete());
    const auto result = reader->result();
    EXPECT_EQ(result->trajectoryHash.hex(), "7f3ef6f43dd3934827cb9e630ccec0b6");
    EXPECT_EQ(result->bodiesPeak, 1);
    EXPECT_GT(reader->frameCount(), 0u);
    EXPECT_EQ(reader->fragments()->size(), 1u);
    EXPECT_NE(reader->frame(0), nullptr);
    EXPECT_TRUE(result->effects.empty());
    EXPECT_FALSE(result->health.tainted());
    EXPECT_TRUE(reader->islands().empty());
    EXPECT_TRUE(reader->islandLedger().empty());
    EXPECT_TRUE(reader->islandLosses().empty());
    EXPECT_EQ(result->carried.islands, 0);
    EXPECT_TRUE(reader->breaches().empty());
    EXPECT_NO_THROW(checkRunDigest(path, Execution()));
}

/// Takes datasets out of a file, as one that was written before they came up.
void unlink(const std::string& path, std::initializer_list<const char*> datasets) {
    const Hdf5Session session;
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    ASSERT_TRUE(file.valid());
    for (const char* dataset : datasets) {
        ASSERT_GE(H5Ldelete(file.get(), dataset, H5P_DEFAULT), 0) << dataset;
    }
}

TEST(RunFile, IslandsOfBeforeTheyHadPlacesWereReleasedAtTheLastState) {
    const TemporaryFolder folder;
    const std::string path = folder / "older.run.h5";
    const SampleRun run = makeSampleRun(31, 20, 8);
    run.feed(*createRun(path, run.origin));
    unlink(path, {"/islands/places", "/islands/losses"});
    const auto reader = openRun(path);
    const std::vector<IslandRecord> islands = reader->islands();
    ASSERT_EQ(islands.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const BodyRecord& body = run.bodies[at(run.islands[i].body)];
        EXPECT_EQ(islands[i].state, atLastState);
        EXPECT_EQ(islands[i].inFe.position, body.atBirth.position);
        EXPECT_EQ(islands[i].inFe.orientation.coeffs(), body.atBirth.orientation.coeffs());
        EXPECT_EQ(islands[i].elements, run.islands[i].elements);
    }
    EXPECT_TRUE(reader->islandLosses().empty());
    EXPECT_EQ(reader->islandLedger().size(), 1u);
}

TEST(RunFile, IslandsComeWithTheirPlacesWhileTheRunGrows) {
    const TemporaryFolder folder;
    const std::string path = folder / "growing.run.h5";
    const SampleRun run = makeSampleRun(32, 50, 40);
    const auto sink = createRun(path, run.origin);
    sink->begin(run.description);
    hand(*sink, run, 0, 10);
    const auto reader = openRun(path);
    const auto reached = [&](std::size_t frames) {
        return eventually([&] {
            reader->refresh();
            return reader->frameCount() == frames;
        });
    };
    ASSERT_TRUE(reached(10));
    EXPECT_EQ(reader->islands().size(), 10u);
    hand(*sink, run, 10, 25);
    ASSERT_TRUE(reached(25));
    const std::vector<IslandRecord> islands = reader->islands();
    ASSERT_EQ(islands.size(), 25u);
    for (std::size_t i = 0; i < 25; ++i) {
        EXPECT_EQ(islands[i].state, i / 3) << "not one of a run of before";
        EXPECT_EQ(islands[i].elements.size(), 1 + i % 7);
    }
    EXPECT_EQ(reader->islandLosses().size(), 25u);
}

TEST(RunFile, RefusesWhatIsNoRun) {
    const TemporaryFolder folder;
    EXPECT_THROW(openRun(folder / "missing.run.h5"), WorldError);
    EXPECT_THROW(openRun(folder.path()), WorldError);
    std::ofstream(folder / "empty").close();
    EXPECT_THROW(openRun(folder / "empty"), ParseError);
    std::ofstream(folder / "text") << std::string(5000, 'x');
    EXPECT_THROW(openRun(folder / "text"), ParseError);
    EXPECT_THROW(openRun(sourcePath("resources/samples/rc-arch.exo")), ParseError);
}

}  // namespace
}  // namespace rubble::io
