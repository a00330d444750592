#include "io/fe/pieces/elements_twice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "io/fe/fe_reader.h"
#include "tests/support/exodus_builder.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

/// A row of three bricks at four states, numbered 11, 12 and 13, and a block of others on its nodes, numbered from 21.
class ElementsTwice : public testing::Test {
protected:
    /// @param active  [others] at a state
    static ExodusBuilder rowAnd(const ExodusBuilder::Block& others,
                                const std::function<bool(std::size_t k, std::size_t e)>& active) {
        ExodusBuilder builder = ExodusBuilder::threeCubes();
        builder.elementNumbers = {11, 12, 13};
        for (int e = 0; e < others.elements(); ++e) {
            builder.elementNumbers.push_back(21 + e);
        }
        builder.blocks.push_back(others);
        builder.blocks.back().id = 2;
        builder.element.emplace_back("STATUS", [active](std::size_t k, std::size_t e) {
            const bool first = e == 0 && k >= 2;  // the first of the row dies at the third state
            return (e < 3 ? !first : active(k, e - 3)) ? 1.0 : 0.0;
        });
        return builder;
    }

    Findings findingsOf(const ExodusBuilder& builder) {
        const std::string path = m_folder / ("row" + std::to_string(m_written++) + ".e");
        builder.write(path);
        return openFe(path, {}, {}, Execution{})->contents().findings;
    }

    static std::vector<int> brick(std::size_t i, std::size_t turned) {
        const std::vector<int> all = ExodusBuilder::threeCubes().blocks[0].nodes;
        std::vector<int> nodes(all.begin() + static_cast<std::ptrdiff_t>(8 * i),
                               all.begin() + static_cast<std::ptrdiff_t>(8 * i + 8));
        std::rotate(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(turned), nodes.begin() + 4);
        std::rotate(nodes.begin() + 4, nodes.begin() + static_cast<std::ptrdiff_t>(4 + turned), nodes.end());
        return nodes;
    }

    TemporaryFolder m_folder;
    int m_written = 0;
};

const auto always = [](std::size_t, std::size_t) { return true; };

TEST_F(ElementsTwice, SolidsOnTheSameNodesThatLiveAtOnceAreCountedAndNamed) {
    ExodusBuilder::Block others;
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
        const std::vector<int> nodes = brick(i, i);
        others.nodes.insert(others.nodes.end(), nodes.begin(), nodes.end());
    }
    const Findings findings = findingsOf(rowAnd(others, always));
    EXPECT_EQ(findings.count("fe.elements_twice"), 2);
    EXPECT_EQ(findings.count("fe.number_twice"), 0);
    for (const Finding& finding : findings.list()) {
        EXPECT_TRUE(finding.what.id != "fe.elements_twice" || finding.example == "elements 12 and 21") << finding.example;
    }
}

// An element that takes the place of another, as where the number of a dead one is not used again.
TEST_F(ElementsTwice, SolidsThatLiveOneAfterTheOtherAreNoTwins) {
    ExodusBuilder::Block others;
    others.nodes = brick(0, 0);
    EXPECT_EQ(findingsOf(rowAnd(others, [](std::size_t k, std::size_t) { return k >= 2; })).count("fe.elements_twice"), 0);
    EXPECT_EQ(findingsOf(rowAnd(others, [](std::size_t k, std::size_t) { return k >= 1; })).count("fe.elements_twice"), 1);
}

TEST_F(ElementsTwice, ShellsBeamsAndOtherSolidsOnTheNodesAreNoTwins) {
    const std::vector<int> nodes = brick(1, 0);
    ExodusBuilder::Block shells;
    shells.topology = "SHELL4";
    shells.nodesPerElement = 4;
    shells.nodes = {nodes[0], nodes[1], nodes[2], nodes[3], nodes[0], nodes[1], nodes[2], nodes[3]};
    EXPECT_EQ(findingsOf(rowAnd(shells, always)).count("fe.elements_twice"), 0);
    ExodusBuilder::Block beams;
    beams.topology = "BEAM";
    beams.nodesPerElement = 2;
    beams.nodes = {nodes[0], nodes[1], nodes[0], nodes[1]};
    EXPECT_EQ(findingsOf(rowAnd(beams, always)).count("fe.elements_twice"), 0);
    ExodusBuilder::Block wedge;
    wedge.topology = "WEDGE6";
    wedge.nodesPerElement = 6;
    wedge.nodes = {nodes[0], nodes[1], nodes[2], nodes[4], nodes[5], nodes[6]};
    EXPECT_EQ(findingsOf(rowAnd(wedge, always)).count("fe.elements_twice"), 0);
}

}  // namespace
}  // namespace rubble::io
