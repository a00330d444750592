#include "io/exports/convert/fe_conversion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/fe/fe_reader.h"
#include "tests/io/exports/convert/mixed_result.h"
#include "tests/io/fe/formats/collapse_digest.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::vector<std::string> namesIn(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

struct Conversions {
    std::string name;
    std::string file;
};

void PrintTo(const Conversions& conversion, std::ostream* out) {
    *out << conversion.name;
}

class ConvertedFixture : public testing::TestWithParam<Conversions> {};

// Places: the copy and the grids keep every bit; the Exodus file keeps places as displacements, which rounds once: 30 cm at 1e-16.
TEST_P(ConvertedFixture, IsTheSameCollapseInAllThree) {
    const TemporaryFolder folder;
    const auto original = openFe(fixture(GetParam().file), {}, {}, Execution{});
    const CollapseDigest expected(*original);
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        const Conversion made = convertFe(*original, {}, folder / "converted" + ending, false, Execution{});
        EXPECT_EQ(made.states, original->stateCount());
        const auto back = openFe(made.files.front(), {}, {}, Execution{});
        const CollapseDigest found(*back);
        EXPECT_EQ(found.elements(), expected.elements()) << ending;
        ASSERT_EQ(back->times(), original->times()) << ending;
        for (std::size_t k = 0; k < original->stateCount(); ++k) {
            EXPECT_EQ(found.dead(k), expected.dead(k)) << ending << " state " << k;
            EXPECT_LE(found.distance(k, expected, k), ending == ".exo" ? 1e-14 : 0.0) << ending << " state " << k;
        }
        const auto masses = found.masses(), theirs = expected.masses();
        for (const auto& [number, mass] : theirs) {
            ASSERT_TRUE(mass == masses.at(number) || (std::isnan(mass) && std::isnan(masses.at(number))))
                << ending << " " << number;
        }
        EXPECT_EQ(back->contents().hasVelocity, original->contents().hasVelocity) << ending;
        EXPECT_EQ(back->contents().deathTime.empty(), original->contents().deathTime.empty()) << ending;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Formats, ConvertedFixture,
    testing::Values(
        Conversions{"VtuFlagged", "vtu-status/series.pvd"}, Conversions{"VtuRemoved", "vtu-cells-removed/s.vtu.series"},
        Conversions{"VtkHdf", "vtkhdf/transient20.vtkhdf"}, Conversions{"Xdmf", "xdmf/proj.xdmf"},
        Conversions{"ExodusZeroIsAlive", "exodus/elem_status0alive.exo"},
        Conversions{"ExodusOneIsAlive", "exodus/status1alive.exo"}, Conversions{"ExodusSequence", "exodus/seq.e"},
        Conversions{"AbaqusAscii", "abaqus-fil/proj_ascii.fil"}, Conversions{"AbaqusBinary", "abaqus-fil/proj_binle.fil"},
        Conversions{"MarcRemoved", "marc/proj_removed.t19"}, Conversions{"MarcKept", "marc/proj_kept.t19"},
        Conversions{"AnsysDatabases", "ansys-cdb/proj_00.cdb"}, Conversions{"D3plotBe64Single", "d3plot/be64-single/d3plot"},
        Conversions{"D3plotLe32Multi", "d3plot/le32-multi/d3plot"},
        Conversions{"D3plotLe64Rootstates", "d3plot/le64-rootstates/d3plot"},
        Conversions{"D3plotLe32Extra64", "d3plot/le32-extra64/d3plot"}, Conversions{"D3plotLe32Split", "d3plot/le32-split/d3plot"},
        Conversions{"D3plotLe32MattypNdim5", "d3plot/le32-mattyp-ndim5/d3plot"},
        Conversions{"D3plotLe32Mdlopt0", "d3plot/le32-mdlopt0/d3plot"}, Conversions{"RadiossAnimation", "radioss-anim/PROJA001"},
        Conversions{"VtkLegacy", "vtk-legacy-anim_to_vtk/PROJ_001.vtk"}),
    [](const testing::TestParamInfo<Conversions>& each) { return each.param.name; });

class FeConversion : public testing::Test {
protected:
    TemporaryFolder m_folder;
    MixedResult m_fe;
};

TEST_F(FeConversion, GridsKeepAllThatTheyAreGiven) {
    convertFe(*m_fe, {}, m_folder / "mixed.pvd", false, Execution{});
    expectSameResult(*m_fe, *openFe(m_folder / "mixed.pvd", {}, {}, Execution{}));
}

// Elements stand block by block in this format; all else is as it was.
TEST_F(FeConversion, ExodusKeepsPartsOfSeveralShapes) {
    convertFe(*m_fe, {}, m_folder / "mixed.exo", false, Execution{});
    const auto back = openFe(m_folder / "mixed.exo", {}, {}, Execution{});
    const Mesh &mesh = m_fe->mesh(), &found = back->mesh();
    ASSERT_EQ(found.elementCount(), mesh.elementCount());
    ASSERT_EQ(found.parts.size(), 3u);
    EXPECT_EQ(found.nodeIds, mesh.nodeIds);
    EXPECT_TRUE(back->contents().hasVelocity);
    ASSERT_EQ(back->contents().deathTime.size(), mesh.elementCount());
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const auto other = static_cast<std::size_t>(
            std::find(found.elementIds.begin(), found.elementIds.end(), mesh.elementIds[e]) - found.elementIds.begin());
        ASSERT_LT(other, found.elementCount()) << mesh.elementIds[e];
        EXPECT_EQ(found.shapes[other], mesh.shapes[e]);
        EXPECT_EQ(found.parts[found.part[other]].name, mesh.parts[mesh.part[e]].name);
        const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
        EXPECT_TRUE(same(found.density[other], mesh.density[e]));
        EXPECT_TRUE(same(found.section[other], mesh.section[e]));
        EXPECT_TRUE(same(back->contents().deathTime[other], m_fe->contents().deathTime[e]));
        for (std::size_t k = 0; k < m_fe->stateCount(); ++k) {
            EXPECT_EQ(back->activity().active(k, idAt<ElementIndex>(other)), m_fe->activity().active(k, idAt<ElementIndex>(e)));
        }
    }
    for (std::size_t k = 0; k < m_fe->stateCount(); ++k) {
        const auto expected = m_fe->state(k), state = back->state(k);
        EXPECT_EQ(state->velocities, expected->velocities);
        for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
            EXPECT_LE((state->positions[n] - expected->positions[n]).norm(), 1e-14);
        }
    }
}

TEST_F(FeConversion, EveryStateIsReadOnceAndNoneIsKept) {
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        const MixedResult fe;
        convertFe(*fe, {}, m_folder / "mixed" + ending, false, Execution{});
        EXPECT_EQ(fe.reads(), (std::vector<std::size_t>{0, 1, 2, 3, 4})) << ending;
    }
}

TEST_F(FeConversion, TheOriginOfTheFrameIsAdded) {
    Frame frame;
    frame.origin << 500'000, 5'000'000, 100;
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        convertFe(*m_fe, frame, m_folder / "far" + ending, false, Execution{});
        const auto back = openFe(m_folder / "far" + ending, {}, {}, Execution{});
        // Read again, what lies that far from the origin gets a local one.
        const Vec3 there = back->state(2)->positions[3] + back->contents().frame.origin.cast<double>();
        const Vec3 moved = there - m_fe->state(2)->positions[3];
        EXPECT_LE((moved - frame.origin.cast<double>()).norm(), 1e-8) << ending << ": a double at 5,000 km";
    }
}

TEST_F(FeConversion, WhatIsThereStaysUnlessReplacingIsAskedFor) {
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        const std::string path = m_folder / "there" + ending;
        std::ofstream(path) << "mine";
        EXPECT_THROW(convertFe(*m_fe, {}, path, false, Execution{}), UsageError) << ending;
        EXPECT_EQ(fs::file_size(path), 4u) << ending;
        convertFe(*m_fe, {}, path, true, Execution{});
        convertFe(*m_fe, {}, path, true, Execution{});
        EXPECT_EQ(openFe(path, {}, {}, Execution{})->stateCount(), 5u) << ending;
    }
    EXPECT_EQ(namesIn(m_folder.path()), (std::vector<std::string>{"there", "there.exo", "there.h5", "there.pvd"}));
    EXPECT_THROW(convertFe(*m_fe, {}, m_folder / "there.txt", false, Execution{}), UsageError);
}

TEST_F(FeConversion, AFolderOfSomebodyElseIsNeverReplaced) {
    fs::create_directory(m_folder / "thesis");
    std::ofstream(m_folder / "thesis/chapter1.tex") << "years of work";
    EXPECT_THROW(convertFe(*m_fe, {}, m_folder / "thesis.pvd", true, Execution{}), WorldError);
    EXPECT_TRUE(fs::exists(m_folder / "thesis/chapter1.tex"));
    EXPECT_EQ(namesIn(m_folder.path()), std::vector<std::string>{"thesis"});
}

TEST_F(FeConversion, ATableOfBodiesIsRefusedWhereItsBodiesWouldNoLongerBeKnown) {
    std::ofstream(m_folder / "boxes.csv") << "id,mass_kg,side_x_m,side_y_m,side_z_m,x_m,y_m,z_m\na,2400,1,1,1,0,0,5\n";
    std::ofstream(m_folder / "stone.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::ofstream(m_folder / "hulls.csv") << "id,mass_kg,mesh,x_m,y_m,z_m\na,400,stone.obj,0,0,5\n";
    const auto boxes = openFe(m_folder / "boxes.csv", {}, {}, Execution{});
    const auto hulls = openFe(m_folder / "hulls.csv", {}, {}, Execution{});
    const auto refused = [&](const FeResult& fe, const std::string& ending) {
        const std::string path = m_folder / "kept" + ending;
        try {
            convertFe(fe, {}, path, false, Execution{});
        } catch (const UsageError& error) {
            EXPECT_EQ(error.message().id, "convert.bodies");
            EXPECT_FALSE(error.remedy().empty());
            EXPECT_FALSE(fs::exists(path));
            return true;
        }
        return false;
    };
    for (const char* ending : {".h5", ".exo", ".pvd"}) {
        EXPECT_TRUE(refused(*hulls, ending)) << ending;
    }
    EXPECT_TRUE(refused(*boxes, ".h5"));
    // A box is one element: other programs see what it is.
    EXPECT_FALSE(refused(*boxes, ".exo"));
    EXPECT_EQ(openFe(m_folder / "kept.exo", {}, {}, Execution{})->mesh().elementCount(), 1u);
}

TEST_F(FeConversion, AResultIsNeverWrittenOverItself) {
    convertFe(*m_fe, {}, m_folder / "own.pvd", false, Execution{});
    convertFe(*m_fe, {}, m_folder / "own.h5", false, Execution{});
    const auto grids = openFe(m_folder / "own.pvd", {}, {}, Execution{});
    EXPECT_THROW(convertFe(*grids, {}, m_folder / "own.pvd", true, Execution{}), UsageError);
    const auto state = openFe(m_folder / "own/state_00002.vtu", {}, {}, Execution{});
    EXPECT_THROW(convertFe(*state, {}, m_folder / "own.pvd", true, Execution{}), UsageError);
    const auto copy = openFe(m_folder / "own.h5", {}, {}, Execution{});
    EXPECT_THROW(convertFe(*copy, {}, m_folder / "own.h5", true, Execution{}), UsageError);
    EXPECT_EQ(openFe(m_folder / "own.pvd", {}, {}, Execution{})->stateCount(), 5u);
}

TEST_F(FeConversion, ACancelledConversionLeavesNothing) {
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        const Execution execution;
        const MixedResult fe(0, [&execution](std::size_t state) {
            if (state == 2) {
                execution.cancel();
            }
        });
        EXPECT_THROW(convertFe(*fe, {}, m_folder / "cut" + ending, false, execution), Cancelled) << ending;
        EXPECT_EQ(namesIn(m_folder.path()), std::vector<std::string>{}) << ending;
    }
}

TEST_F(FeConversion, AKilledConversionLeavesNothingThatLooksFinished) {
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        const TemporaryFolder folder;
        const pid_t child = ::fork();
        if (child == 0) {
            const MixedResult fe(0, [](std::size_t state) { state == 2 ? std::raise(SIGKILL) : 0; });
            convertFe(*fe, {}, folder / "killed" + ending, false, Execution{});
            ::_exit(0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << ending << " was to be killed half-way";
        for (const std::string& name : namesIn(folder.path())) {
            EXPECT_TRUE(name.ends_with(".part")) << name;
        }
        // The next conversion does not mind what lies there.
        convertFe(*m_fe, {}, folder / "killed" + ending, false, Execution{});
        EXPECT_EQ(openFe(folder / "killed" + ending, {}, {}, Execution{})->stateCount(), 5u) << ending;
    }
}

TEST_F(FeConversion, AFullDiskIsSaidAndLeavesNothing) {
    const MixedResult large(20'000);
    for (const std::string ending : {".exo", ".pvd", ".h5"}) {
        std::string said;
        {
            const FileSizeLimit limit(200'000);
            try {
                convertFe(*large, {}, m_folder / "full" + ending, false, Execution{});
            } catch (const WorldError& error) {
                said = englishText(error.message());
            }
        }
        EXPECT_THAT(said, HasSubstr("full" + (ending == ".pvd" ? std::string() : ending))) << ending;
        EXPECT_THAT(said, HasSubstr("File too large")) << ending;
        EXPECT_EQ(namesIn(m_folder.path()), std::vector<std::string>{}) << ending;
        // The libraries go on working.
        convertFe(*m_fe, {}, m_folder / "after" + ending, true, Execution{});
        EXPECT_EQ(openFe(m_folder / "after" + ending, {}, {}, Execution{})->stateCount(), 5u) << ending;
        fs::remove_all(m_folder / "after");
        fs::remove(m_folder / "after" + ending);
    }
}

}  // namespace
}  // namespace rubble::io
