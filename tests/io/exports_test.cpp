#include "io/exports/exports.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "core/base/error.h"
#include "io/base/files.h"
#include "tests/io/run_over_fe.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

// A reader of RFC 4180 of its own, so that the writer is not held against itself.
std::vector<std::vector<std::string>> readCsv(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1, {""});
    bool inside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inside && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
            rows.back().back() += text[++i];
        } else if (c == '"') {
            inside = !inside;
        } else if (!inside && c == ',') {
            rows.back().emplace_back();
        } else if (!inside && c == '\n') {
            rows.push_back({""});
        } else {
            rows.back().back() += c;
        }
    }
    rows.pop_back();
    return rows;
}

vtkSmartPointer<vtkUnstructuredGrid> readGrid(const std::string& path) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
}

struct SeriesEntry {
    double time;
    int part;
    std::string file;
};

std::vector<SeriesEntry> readIndex(const std::string& path) {
    const std::string text = wholeFile(path);
    const std::regex entry("timestep=\"([^\"]*)\" part=\"([012])\" name=\"[a-z]*\" file=\"([^\"]*)\"");
    std::vector<SeriesEntry> entries;
    for (auto match = std::sregex_iterator(text.begin(), text.end(), entry); match != std::sregex_iterator(); ++match) {
        entries.push_back({std::stod((*match)[1]), std::stoi((*match)[2]), (*match)[3]});
    }
    return entries;
}

TEST(ExportFragments, WritesTheColumnsOfTheManualExactly) {
    const TemporaryFolder folder;
    std::shared_ptr<const FeResult> fe;
    const SampleRun run = runOverFe(11, 30, fe);
    run.feed(*createRun(folder / "a.run.h5", run.origin));
    const auto reader = openRun(folder / "a.run.h5");
    exportFragments(folder / "f.csv", *reader, Execution());
    const std::string text = wholeFile(folder / "f.csv");
    EXPECT_TRUE(
        text.starts_with("fragment_id,element_id,component,cluster_id,birth_time_s,birth_x_m,birth_y_m,birth_z_m,final_x_m,"
                         "final_y_m,final_z_m,birth_speed_m_s,impact_speed_m_s,mass_kg\n"));
    const auto rows = readCsv(text);
    const FragmentSet& fragments = *run.description.fragments;
    ASSERT_EQ(rows.size(), fragments.size() + 1);
    const Vec3 origin(100000, -200000, 3);
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        const std::vector<std::string>& row = rows[f + 1];
        ASSERT_EQ(row.size(), 14u);
        EXPECT_EQ(row[0], std::to_string(f));
        EXPECT_EQ(row[1], std::to_string(1000 + f));
        EXPECT_EQ(row[2], run.description.components->list[at(fragments.list[f].component)].name);
        EXPECT_EQ(row[3], std::to_string(at(run.description.clustering->of[f])));
        const FragmentOutcome& outcome = run.result.fragments[f];
        const double expected[] = {fragments.list[f].birthTime,
                                   outcome.birthPosition.x() + origin.x(),
                                   outcome.birthPosition.y() + origin.y(),
                                   outcome.birthPosition.z() + origin.z(),
                                   outcome.finalPosition.x() + origin.x(),
                                   outcome.finalPosition.y() + origin.y(),
                                   outcome.finalPosition.z() + origin.z(),
                                   outcome.birthSpeed,
                                   outcome.impactSpeed,
                                   fragments.list[f].mass};
        for (std::size_t c = 0; c < 10; ++c) {
            EXPECT_EQ(std::stod(row[c + 4]), expected[c]) << "row " << f << " column " << c + 4;
        }
    }
    const auto provenance = nlohmann::json::parse(wholeFile(folder / "f.csv.provenance.json"));
    EXPECT_EQ(provenance["inputs"][0]["sha256"], std::string(64, 'a'));
    EXPECT_EQ(provenance["settings"]["friction"], 0.7);
    EXPECT_EQ(provenance["trajectory_hash"], run.result.trajectoryHash.hex());
}

TEST(ExportFragments, OfAStoppedRunGivesThePlacesThatAreKnown) {
    const TemporaryFolder folder;
    std::shared_ptr<const FeResult> fe;
    const SampleRun run = runOverFe(12, 12, fe);
    run.feed(*createRun(folder / "a.run.h5", run.origin), 8);
    const auto reader = openRun(folder / "a.run.h5");
    exportFragments(folder / "f.csv", *reader, Execution());
    const auto rows = readCsv(wholeFile(folder / "f.csv"));
    const FragmentSet& fragments = *run.description.fragments;
    ASSERT_EQ(rows.size(), fragments.size() + 1);
    const TrajectoryFrame& last = run.frames[7];
    std::size_t known = 0;
    for (const Carrier& carrier : run.carriers) {
        const Fragment& fragment = fragments.list[at(carrier.fragment)];
        const std::vector<std::string>& row = rows[at(carrier.fragment) + 1];
        EXPECT_EQ(row[12], "");
        EXPECT_EQ(row[8].empty(), fragment.birthTime > last.time);
        if (!row[8].empty()) {
            const std::size_t b = at(carrier.body);
            const Pose body{last.positions[b].cast<double>(), last.orientations[b].cast<double>().normalized()};
            const Vec3 expected = body * (carrier.handOverToBody * fragment.centre) + Vec3(100000, -200000, 3);
            EXPECT_LT((Vec3(std::stod(row[8]), std::stod(row[9]), std::stod(row[10])) - expected).norm(), 1e-9);
            EXPECT_FALSE(row[5].empty());
            ++known;
        }
    }
    EXPECT_GT(known, 10u);
    EXPECT_LT(known, fragments.size());
}

TEST(ExportFragments, LeavesNothingWhenCancelledOrWithoutRoom) {
    const TemporaryFolder folder;
    std::shared_ptr<const FeResult> fe;
    const SampleRun run = runOverFe(13, 5, fe);
    run.feed(*createRun(folder / "a.run.h5", run.origin));
    const auto reader = openRun(folder / "a.run.h5");
    const Execution cancelled;
    cancelled.cancel();
    EXPECT_THROW(exportFragments(folder / "f.csv", *reader, cancelled), Cancelled);
    EXPECT_THROW(exportFragments(folder / "no/folder/f.csv", *reader, Execution()), WorldError);
    EXPECT_FALSE(std::filesystem::exists(folder / "f.csv"));
}

TEST(ExportSeries, ShowsFragmentsWhereTheirBodiesCarryThemAndTheStructureThatIsLeft) {
    const TemporaryFolder folder;
    std::shared_ptr<const FeResult> fe;
    const SampleRun run = runOverFe(14, 40, fe);
    run.feed(*createRun(folder / "a.run.h5", run.origin));
    const auto reader = openRun(folder / "a.run.h5");
    std::filesystem::create_directory(folder / "D");
    std::ofstream(folder / "D/fragments_99999.vtu") << "of an earlier, longer series";
    exportSeries(folder / "D.pvd", *reader, *fe, Execution());
    EXPECT_FALSE(std::filesystem::exists(folder / "D/fragments_99999.vtu"));
    EXPECT_TRUE(std::filesystem::exists(folder / "D.pvd.provenance.json"));
    const std::vector<SeriesEntry> entries = readIndex(folder / "D.pvd");
    // Seven states to 0.6 s, then frames at least 0.1 s apart up to the last, at 1.56 s.
    ASSERT_GE(entries.size(), 2u * (7 + 8));
    EXPECT_EQ(entries.back().time, 0.04 * 39);
    const std::size_t elements = fe->mesh().elementCount();
    for (std::size_t i = 0; i < entries.size(); i += 2) {
        const double time = entries[i].time;
        const std::size_t state = std::min<std::size_t>(i / 2, 6);
        EXPECT_EQ(entries[i + 1].time, time);
        EXPECT_EQ(entries[i].part, 0);
        EXPECT_EQ(entries[i + 1].part, 1);
        expectFragments(*readGrid(folder / entries[i].file), run, *reader, time);
        const auto structure = readGrid(folder / entries[i + 1].file);
        std::size_t active = 0;
        for (std::size_t e = 0; e < elements; ++e) {
            active += fe->activity().active(state, idAt<ElementIndex>(e));
        }
        ASSERT_EQ(static_cast<std::size_t>(structure->GetNumberOfCells()), active);
        const double* last = structure->GetCell(structure->GetNumberOfCells() - 1)->GetPoints()->GetPoint(0);
        EXPECT_EQ(last[2], 3.0 - 0.5 * static_cast<double>(state));
        EXPECT_EQ(structure->GetCellData()->GetArray("element_id")->GetTuple1(structure->GetNumberOfCells() - 1),
                  1000.0 + static_cast<double>(elements - 1));
    }
    const auto first = readGrid(folder / entries[0].file);
    const auto names = vtkStringArray::SafeDownCast(first->GetFieldData()->GetAbstractArray("component_names"));
    ASSERT_NE(names, nullptr);
    EXPECT_EQ(std::string(names->GetValue(1)), "arch ring 1, failing strip");
}

TEST(ExportSeries, ReleasedStructureIsAPartOfItsOwnOnceTheFeResultEnds) {
    const TemporaryFolder folder;
    std::shared_ptr<const FeResult> fe;
    SampleRun run = runOverFe(17, 40, fe);
    const std::size_t first = run.description.fragments->size();
    BodyRecord& body = run.bodies.back();
    body.cluster = noCluster;
    body.from = 0.6;
    run.islands.push_back({body.body, 6, body.atBirth, {idAt<ElementIndex>(first), idAt<ElementIndex>(first + 1)}});
    run.feed(*createRun(folder / "a.run.h5", run.origin));
    const auto reader = openRun(folder / "a.run.h5");
    exportSeries(folder / "D.pvd", *reader, *fe, Execution());
    std::size_t released = 0;
    for (const SeriesEntry& entry : readIndex(folder / "D.pvd")) {
        if (entry.part == 0) {
            continue;
        }
        const auto grid = readGrid(folder / entry.file);
        const bool after = entry.time >= 0.6 - 1e-9;
        if (entry.part == 1) {
            std::size_t active = 0;
            for (std::size_t e = 0; e < fe->mesh().elementCount(); ++e) {
                const std::size_t state = std::min<std::size_t>(static_cast<std::size_t>(std::lround(entry.time / 0.1)), 6);
                active += fe->activity().active(state, idAt<ElementIndex>(e));
            }
            EXPECT_EQ(static_cast<std::size_t>(grid->GetNumberOfCells()), active - (after ? 2 : 0)) << entry.time;
            continue;
        }
        ++released;
        EXPECT_TRUE(after) << entry.time;
        ASSERT_EQ(grid->GetNumberOfCells(), 2);
        const TrajectoryFrame frame = frameAtTime(*reader, entry.time);
        const Quat turn = frame.orientations.back().cast<double>().normalized() * body.atBirth.orientation.conjugate();
        const std::uint32_t node = fe->mesh().cornersOf(idAt<ElementIndex>(first + 1))[2];
        const Vec3 last = fe->state(6)->positions[node];
        const Vec3 expected =
            frame.positions.back().cast<double>() + turn * (last - body.atBirth.position) + Vec3(100000, -200000, 3);
        const double* place = grid->GetCell(1)->GetPoints()->GetPoint(2);
        EXPECT_LT((Vec3(place[0], place[1], place[2]) - expected).norm(), 1e-4) << "poses are single precision in the file";
        EXPECT_EQ(grid->GetCellData()->GetArray("element_id")->GetTuple1(1), 1000.0 + static_cast<double>(first + 1));
    }
    EXPECT_GE(released, 9u);
}

/// Corner of an element as a place of the map, carried from where the FE result has it at a state.
Vec3 carriedCorner(const FeResult& fe, std::size_t state, ElementIndex element, std::size_t corner, const Pose& moved) {
    return moved * fe.state(state)->positions[fe.mesh().cornersOf(element)[corner]] + Vec3(100000, -200000, 3);
}

Pose poseIn(const TrajectoryFrame& frame, BodyId body) {
    return {frame.positions[at(body)].cast<double>(), frame.orientations[at(body)].cast<double>().normalized()};
}

TEST(ExportSeries, AnIslandIsWhereTheEngineHasItBeforeTheFeResultEnds) {
    const TemporaryFolder folder;
    std::shared_ptr<const FeResult> fe;
    SampleRun run = runOverFe(23, 40, fe);
    const ElementIndex lives = idAt<ElementIndex>(run.description.fragments->size());
    const ElementIndex dies = idAt<ElementIndex>(3);  // last active at 0.3 s, born at 0.4 s
    BodyRecord& whole = run.bodies[run.bodies.size() - 2];
    BodyRecord& rest = run.bodies.back();
    whole.cluster = rest.cluster = noCluster;
    whole.from = 0.2;
    whole.to = rest.from = 0.3;
    for (TrajectoryFrame& frame : run.frames) {
        frame.states.assign(frame.bodies(), BodyState::Awake);
    }
    run.islands.push_back({whole.body, 2, {Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX()))}, {dies, lives}});
    run.islands.push_back({rest.body, 2, {Vec3(-5, 0, 1), Quat(Eigen::AngleAxisd(-1.0, Vec3::UnitZ()))}, {lives}});
    run.feed(*createRun(folder / "a.run.h5", run.origin));
    const auto reader = openRun(folder / "a.run.h5");
    exportSeries(folder / "D.pvd", *reader, *fe, Execution());
    std::size_t seen = 0;
    for (const SeriesEntry& entry : readIndex(folder / "D.pvd")) {
        const auto state = std::min<std::size_t>(static_cast<std::size_t>(std::lround(entry.time / 0.1)), 6);
        const auto grid = readGrid(folder / entry.file);
        const std::size_t carried = state < 2 ? 0 : state < 4 ? 2 : 1;
        if (entry.part == 1) {
            std::size_t active = 0;
            for (std::size_t e = 0; e < fe->mesh().elementCount(); ++e) {
                active += fe->activity().active(state, idAt<ElementIndex>(e));
            }
            EXPECT_EQ(static_cast<std::size_t>(grid->GetNumberOfCells()), active - carried) << entry.time;
        }
        if (entry.part != 2) {
            continue;
        }
        ++seen;
        ASSERT_EQ(static_cast<std::size_t>(grid->GetNumberOfCells()), carried) << entry.time;
        const TrajectoryFrame frame = frameAtTime(*reader, entry.time);
        const IslandRecord& island = run.islands[state < 3 ? 0 : 1];
        const Vec3 expected = carriedCorner(*fe, 2, lives, 5, poseIn(frame, island.body) * island.inFe.inverse());
        const double* place = grid->GetCell(state < 3 ? 1 : 0)->GetPoints()->GetPoint(5);
        EXPECT_LT((Vec3(place[0], place[1], place[2]) - expected).norm(), 1e-4) << "poses are single precision in the file";
        if (state == 3) {
            const Carrier& carrier =
                *std::find_if(run.carriers.begin(), run.carriers.end(), [](const Carrier& c) { return at(c.fragment) == 3; });
            const Vec3 left = carriedCorner(*fe, 3, dies, 5, poseIn(frame, carrier.body) * carrier.handOverToBody);
            place = grid->GetCell(1)->GetPoints()->GetPoint(5);
            EXPECT_LT((Vec3(place[0], place[1], place[2]) - left).norm(), 1e-4) << "not where the FE result has it";
        }
    }
    EXPECT_GE(seen, 10u) << "every instant from 0.2 s on";
}

TEST(ExportSeries, KeepsWhatWasWrittenBeforeACancel) {
    const TemporaryFolder folder;
    std::shared_ptr<const FeResult> fe;
    const SampleRun run = runOverFe(15, 40, fe);
    run.feed(*createRun(folder / "a.run.h5", run.origin));
    const auto reader = openRun(folder / "a.run.h5");
    const Execution execution;
    const auto cancelling = makeFe(run, 5, 7, [&execution](std::size_t state) {
        if (state == 3) {
            execution.cancel();
        }
    });
    EXPECT_THROW(exportSeries(folder / "D.pvd", *reader, *cancelling, execution), Cancelled);
    const std::vector<SeriesEntry> entries = readIndex(folder / "D.pvd");
    ASSERT_EQ(entries.size(), 8u);
    for (const SeriesEntry& entry : entries) {
        EXPECT_TRUE(std::filesystem::exists(folder / entry.file));
    }
    EXPECT_DOUBLE_EQ(entries.back().time, 0.3);
}

TEST(ExportSeries, RefusesTheFeFileOfAnotherRun) {
    const TemporaryFolder folder;
    std::shared_ptr<const FeResult> fe;
    const SampleRun run = runOverFe(16, 4, fe);
    run.feed(*createRun(folder / "a.run.h5", run.origin));
    const SampleRun smaller = makeSampleRun(16, 2, 4);
    EXPECT_THROW(exportSeries(folder / "D.pvd", *openRun(folder / "a.run.h5"), *makeFe(smaller, 0, 7), Execution()), UsageError);
}

}  // namespace
}  // namespace rubble::io
