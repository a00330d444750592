#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/vtkhdf_builder.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A row of five bricks that the recorder vtkhdf of OpenSees wrote at six states, with removals.
class VtkHdfRecorder : public testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const VtkHdfRows& rows) {
        // The library does not write over a file that is still open here.
        const std::string path = m_folder / ("row" + std::to_string(m_written++) + ".vtkhdf");
        writeVtkHdf(path, rows);
        return openFe(path, {}, {}, Execution{});
    }

    /// Time of the first state at which each brick is dead, by place; -1: never.
    static std::vector<double> deathTimes(const FeResult& fe) {
        std::vector<double> times(fe.mesh().elementCount(), -1.0);
        for (std::size_t e = 0; e < times.size(); ++e) {
            double left = 1e9;
            for (const std::uint32_t corner : fe.mesh().cornersOf(idAt<ElementIndex>(e))) {
                left = std::min(left, fe.mesh().nodes[corner].x());
            }
            for (std::size_t k = fe.stateCount(); k-- > 0;) {
                if (!fe.activity().active(k, idAt<ElementIndex>(e))) {
                    times.at(static_cast<std::size_t>(left)) = fe.times()[k];
                }
            }
        }
        return times;
    }

    /// Bricks 3 and 4 go before the state at 2 s, with their nodes at the end; brick 1 before that at 4 s.
    static VtkHdfRows removed() {
        VtkHdfRows rows{.parts = {{.bricks = {0, 1, 2, 3, 4}}}, .states = 6};
        rows.later = {{2, {{.bricks = {0, 1, 2}}}}, {4, {{.bricks = {0, 2}}}}};
        return rows;
    }

    TemporaryFolder m_folder;
    int m_written = 0;
};

TEST_F(VtkHdfRecorder, RemovedBricksDieAtTheFirstStateWithoutThem) {
    for (const bool recorded : {false, true}) {
        VtkHdfRows rows = removed();
        rows.recorded = recorded;
        const auto fe = open(rows);
        EXPECT_EQ(fe->contents().format, "VTKHDF");
        EXPECT_EQ(fe->times(), (std::vector<double>{0, 1, 2, 3, 4, 5})) << recorded;
        EXPECT_EQ(fe->mesh().nodeCount(), 24u) << recorded;
        EXPECT_THAT(deathTimes(*fe), ElementsAre(-1, 4, -1, 2, 2)) << recorded;
        EXPECT_THAT(fe->contents().activityFrom, HasSubstr("missing elements are dead"));
        EXPECT_EQ(fe->contents().findings.count("fe.no_deaths"), 0) << recorded;
    }
}

// The model changes without a removal too, before the first state and more than once between two: such meshes are of no state.
TEST_F(VtkHdfRecorder, MeshesThatNoStateHasAreSkipped) {
    for (const std::vector<int>& changes : {std::vector<int>{0}, {2}, {4}, {0, 2, 4}, {3}, {1, 5}}) {
        VtkHdfRows rows = removed();
        rows.recorded = true;
        rows.changes = changes;
        EXPECT_THAT(deathTimes(*open(rows)), ElementsAre(-1, 4, -1, 2, 2)) << changes.front();
    }
}

// A brick in the middle leaves all nodes: the meshes are of one size but for their cells.
TEST_F(VtkHdfRecorder, RemovalsThatLeaveAllNodesAreFound) {
    for (const std::vector<int>& changes : {std::vector<int>{}, {1}, {3}}) {
        VtkHdfRows rows{.parts = {{.bricks = {0, 1, 2, 3, 4}}}, .states = 4};
        rows.later = {{1, {{.bricks = {0, 2, 3, 4}}}}, {3, {{.bricks = {0, 2, 4}}}}};
        rows.recorded = true;
        rows.changes = changes;
        const auto fe = open(rows);
        EXPECT_EQ(fe->mesh().nodeCount(), 24u);
        EXPECT_THAT(deathTimes(*fe), ElementsAre(-1, 1, -1, 3, -1));
    }
}

}  // namespace
}  // namespace rubble::io
