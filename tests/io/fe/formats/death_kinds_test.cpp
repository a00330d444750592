#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <tuple>
#include <variant>

#include "core/base/error.h"
#include "io/fe/abaqus/input_deck.h"
#include "io/fe/fe_reader.h"
#include "tests/io/fe/formats/small_results.h"
#include "tests/support/exodus_builder.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Files that say in different ways which elements are dead, and files that do not.
class DeathKindsTest : public testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const std::string& name, const ImportSettings& settings = {}) {
        return openFe(m_folder / name, settings, {}, Execution{});
    }

    static std::vector<std::size_t> dead(const FeResult& fe) {
        std::vector<std::size_t> counts;
        for (std::size_t k = 0; k < fe.stateCount(); ++k) {
            counts.push_back(fe.mesh().elementCount() - fe.activity().activeCount(k));
        }
        return counts;
    }

    TemporaryFolder m_folder;
};

std::string deckWith(const std::string& change) {
    return "*HEADING\n*ELEMENT,TYPE=C3D8,ELSET=EALL\n1,1,2,4,3,5,6,8,7\n2,5,6,8,7,9,10,12,11\n*ELSET,ELSET=TOP\n2\n"
           "*STEP\n*STATIC\n*END STEP\n*STEP\n" +
           change + "\n*END STEP\n*STEP\n*END STEP\n";
}

// Whether the deck takes elements out, or only touches other things; the nodes that a state leaves out tell then.
TEST_F(DeathKindsTest, OnlyRemovalsOfElementsOfADeckAreDeaths) {
    writeContent(m_folder / "small.frd", smallFrd());
    const std::vector<std::size_t> byNodes = dead(*open("small.frd")), byDeck{0, 1, 1};
    EXPECT_EQ(byNodes, (std::vector<std::size_t>{0, 0, 1}));
    for (const char* change :
         {"*MODEL CHANGE,TYPE=ELEMENT,MECHSTRAINTORESIDUAL\n1,2", "*MODEL CHANGE,TYPE=CONTACT PAIR,REMOVE\nS1,S2",
          "*MODEL CHANGE,ACTIVATE", "*MODEL CHANGE,TYPE=ELEMENT,REMOVE\n77", "*MODEL CHANGE, TYPE=ELEMENT, ADD=STRAINFREE\n77"}) {
        writeContent(m_folder / "small.inp", deckWith(change));
        EXPECT_EQ(dead(*open("small.frd")), byNodes) << change;
    }
    for (const char* change :
         {"*MODEL CHANGE,TYPE=ELEMENT,REMOVE\n2", "*Model  change, remove, type=element\nTop", "*MODEL CHANGE, REMOVE\nTOP",
          "*MODELCHANGE,TYPE=ELEMENT,REMOVE\n2", "* modelChange , TYPE = ELEMENT , REMOVE\nTOP"}) {
        writeContent(m_folder / "small.inp", deckWith(change));
        EXPECT_EQ(dead(*open("small.frd")), byDeck) << change;
    }
    writeContent(m_folder / "small.inp", deckWith("*MODEL CHANGE,TYPE=ELEMENT,REMOVE\n2\nNOSUCH"));
    EXPECT_EQ(open("small.frd")->contents().findings.count("deck.change_unknown"), 1);
}

// The deck tells the deaths, so a change of it must be noticed.
TEST_F(DeathKindsTest, AFileOpenedByItselfKeepsItsDeckAndItsList) {
    writeContent(m_folder / "small.frd", smallFrd());
    writeContent(m_folder / "small.inp", deckWith("*MODEL CHANGE,TYPE=ELEMENT,REMOVE\n2"));
    ImportSettings alone;
    alone.onlyThisFile = true;
    const auto fe = open("small.frd", alone);
    EXPECT_THAT(fe->contents().files, ElementsAre(m_folder / "small.frd", m_folder / "small.inp"));
    EXPECT_THAT(dead(*fe), ElementsAre(0, 1, 1));
    EXPECT_FALSE(hasGrown(*fe));
    writeContent(m_folder / "small.inp", deckWith("*MODEL CHANGE,TYPE=ELEMENT,REMOVE\n1,2"));
    EXPECT_NE(open("small.frd", alone)->contents().fingerprint, fe->contents().fingerprint);
}

TEST_F(DeathKindsTest, LayersOfACompositeShellMakeOneThicknessAndDensity) {
    writeContent(m_folder / "small.frd", smallFrd());
    writeContent(m_folder / "small.inp",
                 "*ELEMENT,TYPE=S4,ELSET=EALL\n1,1,2,3,4\n*MATERIAL,NAME=A\n*DENSITY\n1000\n*MATERIAL,NAME=B\n*DENSITY\n4000\n"
                 "*SHELL SECTION,ELSET=EALL,COMPOSITE\n0.1,3,A\n0.05,3,B\n");
    const InputDeck deck = readInputDeck(m_folder / "small.inp");
    EXPECT_NEAR(deck.sections.at(0).thickness.value(), 0.15, 1e-12);
    EXPECT_NEAR(deck.densityOf(deck.sections[0]).value(), 2000.0, 1e-9);
}

// As solvers do, keywords are read without their blanks.
TEST_F(DeathKindsTest, KeywordsOfADeckMayLackTheirBlanks) {
    writeContent(m_folder / "small.inp",
                 "*ELEMENT,TYPE=S4,ELSET=EALL\n1,1,2,3,4\n*MATERIAL,NAME=A\n*DENSITY\n1000\n"
                 "*ShellSection,ELSET=EALL,MATERIAL=A\n0.2\n*SHELL  SECTION,ELSET=OTHER,NODALTHICKNESS\n0.5\n");
    const InputDeck deck = readInputDeck(m_folder / "small.inp");
    ASSERT_EQ(deck.sections.size(), 2u);
    EXPECT_EQ(deck.sections[0].thickness, std::optional(0.2));
    EXPECT_EQ(deck.sections[0].material, "A");
    EXPECT_EQ(deck.sections[1].thickness, std::nullopt);
}

// Eigenvalues are no times: what CalculiX writes of its steps, by the number in its headers.
TEST_F(DeathKindsTest, ShapesOfCalculixAreNoStates) {
    const std::string time = smallFrd();
    const auto steps = [&time](const std::vector<std::pair<char, std::string>>& kinds) {
        constexpr std::size_t kindAt = 57, nameAt = 63;
        std::string text = time;
        std::size_t at = 0;
        for (const auto& [kind, name] : kinds) {
            at = text.find("  100C", at + 1);
            text[at + kindAt] = kind;
            text.replace(at + nameAt, name.size(), name);
        }
        return text;
    };
    for (const auto& [kind, name, says] : {std::tuple{'2', "MODAL", "a frequency analysis"},
                                           {'3', "MODAL", "a frequency analysis"},
                                           {'4', "", "a buckling analysis"}}) {
        writeContent(m_folder / "small.frd", steps({{kind, name}, {kind, name}, {kind, name}}));
        try {
            open("small.frd");
            ADD_FAILURE() << says;
        } catch (const ParseError& error) {
            EXPECT_THAT(error.what(), HasSubstr(std::string("small.frd is ") + says));
        }
    }
    writeContent(m_folder / "small.frd", steps({{'0', ""}, {'2', "MODAL"}, {'1', ""}}));
    const auto fe = open("small.frd");
    EXPECT_EQ(fe->times(), (std::vector<double>{0.0, 2.0}));
    EXPECT_EQ(fe->contents().findings.count("frd.shapes"), 1);
    std::string complex = time;
    for (std::size_t at = complex.find("  100C"); at != std::string::npos; at = complex.find("  100C", at + 40)) {
        complex[at + 57] = '3';
        const std::string mode = "    1PMODE                         1\n";
        complex.insert(at, mode);
        at += mode.size();
    }
    writeContent(m_folder / "small.frd", complex);
    EXPECT_THROW(open("small.frd"), ParseError);
}

TEST_F(DeathKindsTest, AListCountsBesideAnExodusResultWithoutAFlag) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("stress_xx", [](std::size_t, std::size_t) { return 1.0; });
    builder.write(m_folder / "intact.e");
    const auto without = open("intact.e");
    EXPECT_THAT(dead(*without), ElementsAre(0, 0, 0, 0));
    for (const Finding& finding : without->contents().findings.list()) {
        if (finding.what.id == "fe.no_deaths") {
            EXPECT_THAT(englishText(finding.remedy), HasSubstr("intact.e.deaths.csv"));
        }
    }
    EXPECT_EQ(without->contents().findings.count("fe.no_deaths"), 3);
    writeContent(m_folder / "intact.e.deaths.csv", "element;time\n2;0,5\n3;1,0\n");
    const auto fe = open("intact.e");
    EXPECT_THAT(dead(*fe), ElementsAre(0, 1, 2, 2));
    EXPECT_THAT(fe->contents().files, ElementsAre(m_folder / "intact.e", m_folder / "intact.e.deaths.csv"));
    EXPECT_THAT(fe->contents().activityFrom, HasSubstr("intact.e.deaths.csv"));
}

TEST_F(DeathKindsTest, AListBesideAFlagIsNamed) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return e == 1 && k > 1 ? 0.0 : 1.0; });
    builder.write(m_folder / "flagged.e");
    writeContent(m_folder / "flagged.e.deaths.csv", "3,0.5\n");
    const auto fe = open("flagged.e");
    EXPECT_THAT(dead(*fe), ElementsAre(0, 0, 1, 1));
    EXPECT_EQ(fe->contents().findings.count("fe.death_list.unused"), 1);
}

// Element 2 moves into another block in the second file.
void writeMove(const std::string& folder, const std::string& block) {
    ExodusBuilder before;
    before.addCubes(3, "wall", 1);
    before.elementNumbers = {1, 2, 3};
    before.times = {0.0, 1.0};
    before.addStillDisplacement();
    before.write(folder + "/out.e");
    ExodusBuilder after = before;
    const std::vector<int> nodes = before.blocks[0].nodes;
    const auto element = [&nodes](int e) { return std::vector<int>(nodes.begin() + 8 * e, nodes.begin() + 8 * e + 8); };
    after.blocks[0].nodes = element(0);
    for (const int node : element(2)) {
        after.blocks[0].nodes.push_back(node);
    }
    ExodusBuilder::Block moved = after.blocks[0];
    moved.id = 999;
    moved.name = block;
    moved.nodes = element(1);
    after.blocks.push_back(moved);
    after.elementNumbers = {1, 3, 2};
    after.times = {2.0, 3.0};
    after.write(folder + "/out.e-s0002");
}

TEST_F(DeathKindsTest, ElementsThatMoveIntoAPartOfTheDeadDie) {
    writeMove(m_folder.path(), "dead");
    const auto fe = open("out.e");
    EXPECT_THAT(dead(*fe), ElementsAre(0, 0, 1, 1));
    EXPECT_FALSE(fe->activity().active(2, idAt<ElementIndex>(1)));
    EXPECT_THAT(fe->contents().activityFrom, HasSubstr("dead (by their names)"));
    EXPECT_EQ(fe->contents().findings.count("fe.part_changed"), 1);
}

TEST_F(DeathKindsTest, PartsOfTheDeadCanBeNamed) {
    writeMove(m_folder.path(), "rubble heap");
    EXPECT_THAT(dead(*open("out.e")), ElementsAre(0, 0, 0, 0));
    for (const char* name : {"rubble heap", "RUBBLE HEAP", "999", "nothing; 999"}) {
        ImportSettings settings;
        settings.deadParts = name;
        if (std::string(name).starts_with("nothing")) {
            EXPECT_THROW(open("out.e", settings), UsageError);
            continue;
        }
        const auto fe = open("out.e", settings);
        EXPECT_THAT(dead(*fe), ElementsAre(0, 0, 1, 1)) << name;
        EXPECT_NE(fe->contents().fingerprint, open("out.e")->contents().fingerprint);
    }
}

TEST_F(DeathKindsTest, PartsThatKeepTheirElementsCanBeDeadFromTheStart) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.blocks[0].name = "core";
    builder.write(m_folder / "all.e");
    ImportSettings settings;
    settings.deadParts = "core";
    EXPECT_THAT(dead(*open("all.e", settings)), ElementsAre(3, 3, 3, 3));
}

TEST_F(DeathKindsTest, BlocksOfEdgesAreBeams) {
    for (const char* topology : {"BAR2", "EDGE", "EDGE2", "LINE", "SPRING", "edge3"}) {
        ExodusBuilder builder = ExodusBuilder::threeCubes();
        const bool quadratic = std::string(topology) == "edge3";
        ExodusBuilder::Block block;
        block.id = 2;
        block.topology = topology;
        block.nodesPerElement = quadratic ? 3 : 2;
        block.nodes = quadratic ? std::vector<int>{1, 3, 2} : std::vector<int>{1, 2, 2, 3};
        builder.blocks.push_back(block);
        builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
        builder.write(m_folder / "beams.e");
        const auto fe = open("beams.e");
        EXPECT_EQ(fe->mesh().elementCount(), quadratic ? 4u : 5u) << topology;
        EXPECT_EQ(fe->mesh().shapes.back(), ElementShape::Beam) << topology;
        EXPECT_EQ(fe->contents().findings.count("exodus.skipped_block"), 0) << topology;
    }
}

// A quarter of a ring of one brick of twenty nodes: radii 9 and 10, width 1.
TEST_F(DeathKindsTest, StraightEdgesOfACurvedBrickAreSaidWithWhatTheyCost) {
    constexpr double quarter = 1.5707963267948966;
    const auto place = [](double radius, double share, double y) {
        return Vec3(radius * std::cos(share * quarter), y, radius * std::sin(share * quarter));
    };
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.blocks.clear();
    builder.nodes.clear();
    const std::array<std::array<double, 2>, 4> ring{{{9, 0}, {10, 0}, {10, 1}, {9, 1}}};
    const std::array<std::array<double, 2>, 4> middles{{{9.5, 0}, {10, 0.5}, {9.5, 1}, {9, 0.5}}};
    for (const double y : {0.0, 1.0}) {
        for (const auto& [radius, share] : ring) {
            builder.nodes.push_back(place(radius, share, y));
        }
    }
    for (const double y : {0.0, 0.5, 1.0}) {
        for (const auto& [radius, share] : y == 0.5 ? ring : middles) {
            builder.nodes.push_back(place(radius, share, y));
        }
    }
    ExodusBuilder::Block block;
    block.topology = "HEX20";
    block.nodesPerElement = 20;
    for (int n = 1; n <= 20; ++n) {
        block.nodes.push_back(n);
    }
    builder.blocks.push_back(block);
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.write(m_folder / "ring.e");
    const auto fe = open("ring.e");
    EXPECT_EQ(fe->contents().findings.count("fe.straight_solids"), 1);
    for (const Finding& finding : fe->contents().findings.list()) {
        if (finding.what.id == "fe.straight_solids") {
            // Corners alone have 9.5, parabolas through the middles of the arcs 14.75.
            const double percent = std::get<double>(finding.what.arguments.at(0).value);
            EXPECT_NEAR(percent, -35.58, 0.01);
        }
    }
}

// As programs write it whose exponents have this many digits: at least twelve wide.
std::string real(double value, int digits) {
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.5E", value);
    const std::string text = buffer.data();
    const std::size_t letter = text.find('E');
    const int exponent = std::stoi(text.substr(letter + 1));
    std::snprintf(buffer.data(), buffer.size(), "%s%c%0*d", text.substr(0, letter + 1).c_str(), exponent < 0 ? '-' : '+', digits,
                  std::abs(exponent));
    const std::string number = buffer.data();
    return std::string(number.size() < 12 ? 12 - number.size() : 0, ' ') + number;
}

std::string padded(std::int64_t value, std::size_t width) {
    const std::string text = std::to_string(value);
    return std::string(width - text.size(), ' ') + text;
}

// Two bricks on top of each other. Each state moves its first nodes by `moved`, as many as it says.
std::string twoBricks(int digits, const Vec3& moved, const std::vector<int>& nodesOfStates) {
    const auto blockHead = [](const char* name, int count) {
        return name + std::string(18, ' ') + padded(count, 12) + std::string(37, ' ') + "1\n";
    };
    std::string text = "    1C\n    1UUSER\n" + blockHead("    2C", 12);
    for (int n = 0; n < 12; ++n) {
        text += " -1" + padded(n + 1, 10) + real(n % 2, digits) + real(n / 2 % 2, digits) + real(n / 4, digits) + "\n";
    }
    text += " -3\n" + blockHead("    3C", 2);
    for (int e = 0; e < 2; ++e) {
        text += " -1" + padded(e + 1, 10) + padded(1, 5) + padded(0, 5) + padded(1, 5) + "\n -2";
        for (const int corner : {1, 2, 4, 3, 5, 6, 8, 7}) {
            text += padded(corner + 4 * e, 10);
        }
        text += "\n";
    }
    text += " -3\n";
    for (std::size_t k = 0; k < nodesOfStates.size(); ++k) {
        const auto number = static_cast<std::int64_t>(k);
        text += "  100CL" + padded(101 + number, 5) + " " + std::to_string(k + 1) + ".000000000" + padded(nodesOfStates[k], 12) +
                std::string(20, ' ') + padded(0, 2) + padded(number + 1, 5) + std::string(10, ' ') + " 1\n" +
                " -4  DISP        4    1\n -5  D1          1    2    1    0\n -5  D2          1    2    2    0\n" +
                " -5  D3          1    2    3    0\n -5  ALL         1    2    0    0    1ALL\n";
        for (int n = 0; n < nodesOfStates[k]; ++n) {
            text += " -1" + padded(n + 1, 10) + real(moved.x(), digits) + real(moved.y(), digits) + real(moved.z(), digits) + "\n";
        }
        text += " -3\n";
    }
    return text + " 9999\n";
}

// Exponents of three digits fill the columns of twelve, or run over them where a minus stands before the number.
TEST_F(DeathKindsTest, ExponentsOfThreeDigitsAreReadBySignAndExponent) {
    for (const Vec3& moved : {Vec3(5.28012e-3, 3.06745e-3, -7.70711e-3), Vec3(-5.28012e-3, 3.06745e-3, -7.70711e-3),
                              Vec3(5.28012e-3, -3.06745e-3, 7.70711e+2), Vec3(-5e-12, -3e-3, -7e5), Vec3(0.0, 0.0, -9.99999e-3)}) {
        for (const int digits : {2, 3}) {
            writeContent(m_folder / "bricks.frd", twoBricks(digits, moved, {12, 8}));
            const auto fe = open("bricks.frd");
            EXPECT_EQ(fe->mesh().nodes[11], Vec3(1, 1, 2)) << digits;
            EXPECT_LT((fe->state(0)->positions[11] - Vec3(1, 1, 2) - moved).norm(), 1e-12 + 1e-15 * moved.norm()) << digits;
            EXPECT_THAT(dead(*fe), ElementsAre(0, 1)) << digits;
        }
    }
}

TEST_F(DeathKindsTest, NodesThatNoStateGivesStayAtRestAndAreCounted) {
    writeContent(m_folder / "bricks.frd", twoBricks(2, Vec3(0, 0, -0.5), {8, 8}));
    const auto fe = open("bricks.frd");
    EXPECT_EQ(fe->contents().findings.count("frd.node_set"), 4);
    EXPECT_THAT(dead(*fe), ElementsAre(0, 0));
    EXPECT_EQ(fe->state(1)->positions[7], Vec3(1, 1, 0.5));
    EXPECT_EQ(fe->state(1)->positions[8], Vec3(0, 0, 2));
    writeContent(m_folder / "bricks.frd", twoBricks(2, Vec3(0, 0, -0.5), {12, 12}));
    EXPECT_EQ(open("bricks.frd")->contents().findings.count("frd.node_set"), 0);
}

}  // namespace
}  // namespace rubble::io
