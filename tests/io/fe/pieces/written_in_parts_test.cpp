#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/small_results.h"
#include "tests/io/fe/formats/vtkhdf_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::HasSubstr;
using Counts = std::vector<std::size_t>;

class WrittenInParts : public testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const std::string& name, const ImportSettings& settings = {}) {
        return openFe(m_folder / name, settings, {}, Execution{});
    }
    static Counts dead(const FeResult& fe) {
        Counts counts;
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            counts.push_back(fe.mesh().elementCount() - fe.activity().activeCount(k));
        }
        return counts;
    }
    /// Places along x of the elements that are dead at a state.
    static std::vector<double> deadPlaces(const FeResult& fe, std::size_t k) {
        std::vector<double> places;
        const Mesh& mesh = fe.mesh();
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            if (!fe.activity().active(k, idAt<ElementIndex>(e))) {
                double sum = 0.0;
                for (std::uint32_t c = mesh.offsets[e]; c < mesh.offsets[e + 1]; ++c) {
                    sum += mesh.nodes[mesh.corners[c]].x();
                }
                places.push_back(sum / (mesh.offsets[e + 1] - mesh.offsets[e]));
            }
        }
        return places;
    }

    TemporaryFolder m_folder;
};

/// Six bricks in three partitions, the middle one empty, that overlap by a layer of copies. Brick 2 dies at the second state, brick
/// 4 at the third.
VtkHdfRows overlapping() {
    return {.parts = {{.bricks = {0, 1, 2, 3}, .ghosts = {0, 0, 0, 1}}, {}, {.bricks = {2, 3, 4, 5}, .ghosts = {1, 0, 0, 0}}},
            .status = {{1, 1, 1, 1, 1, 1, 1, 1}, {1, 1, 0, 1, 0, 1, 1, 1}, {1, 1, 0, 1, 0, 1, 0, 1}}};
}

TEST_F(WrittenInParts, CopiesInPartitionsOfVtkHdfCountOnce) {
    for (const bool anew : {false, true}) {
        VtkHdfRows rows = overlapping();
        rows.meshAnew = anew;
        writeVtkHdf(m_folder / "wall.vtkhdf", rows);
        const auto fe = open("wall.vtkhdf");
        EXPECT_EQ(fe->mesh().elementCount(), 6u) << anew;
        EXPECT_EQ(fe->mesh().nodeCount(), 28u) << anew;
        EXPECT_EQ(dead(*fe), (Counts{0, 1, 2})) << anew;
        EXPECT_EQ(deadPlaces(*fe, 2), (std::vector<double>{2.5, 4.5})) << anew;
        EXPECT_EQ(fe->contents().findings.count("pieces.duplicates"), 2) << anew;
        EXPECT_EQ(fe->contents().findings.count("pieces.ghost_alone"), 0) << anew;
    }
}

// The table of their numbers may be left out.
TEST_F(WrittenInParts, StatesOfVtkHdfThatDoNotCountTheirPartitionsHaveAll) {
    for (const bool anew : {false, true}) {
        for (const bool placed : {false, true}) {
            VtkHdfRows rows = overlapping();
            rows.meshAnew = anew;
            rows.partsCounted = false;
            rows.partsPlaced = placed || anew;
            writeVtkHdf(m_folder / "wall.vtkhdf", rows);
            const auto fe = open("wall.vtkhdf");
            EXPECT_EQ(fe->mesh().elementCount(), 6u) << anew << placed;
            EXPECT_EQ(dead(*fe), (Counts{0, 1, 2})) << anew << placed;
        }
    }
}

// A copy whose own is in no partition is kept, and said.
TEST_F(WrittenInParts, ACopyOfAPartitionThatIsNotThereIsKept) {
    VtkHdfRows rows = overlapping();
    rows.parts[2] = {.bricks = {4, 5}, .ghosts = {}};
    for (std::vector<int>& status : rows.status) {
        status.resize(6);
    }
    writeVtkHdf(m_folder / "wall.vtkhdf", rows);
    const auto fe = open("wall.vtkhdf");
    EXPECT_EQ(fe->mesh().elementCount(), 6u);
    EXPECT_EQ(fe->contents().findings.count("pieces.ghost_alone"), 1);
}

/// The two bricks as two processes of Ansys write them: a brick each, with the four nodes between them in both.
class Processes : public WrittenInParts {
protected:
    void lay(int states, int statesOfSecond) {
        writeContent(m_folder / "wall0.rst", smallRst(states, {.bricks = {1}}));
        writeContent(m_folder / "wall1.rst", smallRst(statesOfSecond, {.bricks = {2}}));
        writeContent(m_folder / "wall0.rst.deaths.csv", "element,time\n2,2\n");
    }
};

TEST_F(Processes, AreTheResultThatAnsysWouldHaveCombined) {
    writeContent(m_folder / "whole.rst", smallRst(3));
    writeContent(m_folder / "whole.rst.deaths.csv", "element,time\n2,2\n");
    lay(3, 3);
    const auto whole = open("whole.rst");
    for (const char* name : {"wall0.rst", "wall1.rst"}) {
        const auto fe = open(name);
        EXPECT_EQ(fe->contents().files.size(), 3u) << name;
        EXPECT_EQ(fe->times(), whole->times()) << name;
        EXPECT_EQ(fe->mesh().elementIds, whole->mesh().elementIds) << name;
        EXPECT_EQ(fe->mesh().nodeCount(), 12u) << name;
        EXPECT_EQ(dead(*fe), (Counts{0, 0, 1})) << name;
        EXPECT_EQ(deadPlaces(*fe, 2), deadPlaces(*whole, 2)) << name;
        const auto state = fe->state(2), expected = whole->state(2);
        for (std::size_t e = 0; e < 2; ++e) {
            for (std::size_t c = 0; c < 8; ++c) {
                const Vec3 place = state->positions[fe->mesh().corners[8 * e + c]];
                EXPECT_EQ(place, expected->positions[whole->mesh().corners[8 * e + c]]) << name << e << c;
            }
        }
    }
}

TEST_F(Processes, AStateThatOneHasNotWrittenIsLeftOut) {
    lay(3, 2);
    const auto before = open("wall0.rst");
    EXPECT_EQ(before->stateCount(), 2u);
    EXPECT_FALSE(hasGrown(*before));
    lay(3, 3);
    EXPECT_TRUE(hasGrown(*before));
    EXPECT_EQ(growthBetween(*before, *open("wall0.rst")).deaths, 1);
}

}  // namespace
}  // namespace rubble::io
