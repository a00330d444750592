#include "io/fe/exodus/exodus_reader.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <cmath>
#include <thread>

#include "core/base/error.h"
#include "core/fe/components.h"
#include "io/fe/fe_reader.h"
#include "tests/support/exodus_builder.h"
#include "tests/support/finding_text.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ExodusReaderTest : public ::testing::Test {
protected:
    std::shared_ptr<const FeResult> open(const ExodusBuilder& builder, const ImportSettings& settings = {},
                                         const Frame& frame = {}) {
        const std::string path = m_folder / "fixture.exo";
        builder.write(path);
        return openFe(path, settings, frame, Execution{});
    }

    // The error of opening, as text with its remedy; fails if there is none of this kind.
    template <class E>
    std::string errorOf(const ExodusBuilder& builder, const ImportSettings& settings = {}, const Frame& frame = {}) {
        try {
            open(builder, settings, frame);
        } catch (const E& error) {
            return englishText(error.message()) + " | " + englishText(error.remedy());
        }
        ADD_FAILURE() << "no such error";
        return "";
    }

    TemporaryFolder m_folder;
};

// One line a state, one digit an element.
std::vector<std::string> activity(const FeResult& fe) {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < fe.stateCount(); ++k) {
        std::string line;
        for (std::size_t e = 0; e < fe.mesh().elementCount(); ++e) {
            line += fe.activity().active(k, idAt<ElementIndex>(e)) ? '1' : '0';
        }
        lines.push_back(line);
    }
    return lines;
}

// Element 0 lives, element 1 dies at state 2, element 2 at state 1.
bool dead(std::size_t state, std::size_t element) {
    return (element == 1 && state >= 2) || (element == 2 && state >= 1);
}

TEST_F(ExodusReaderTest, ReadsMeshTimesAndFields) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.nodal[0].second = [](std::size_t k, std::size_t n) {
        return 0.1 * static_cast<double>(k) + 0.01 * static_cast<double>(n);
    };
    builder.nodal.emplace_back("VELZ", [](std::size_t k, std::size_t) { return -9.81 * static_cast<double>(k); });
    builder.nodal.emplace_back("VELX", [](std::size_t, std::size_t) { return 1.0; });
    builder.nodal.emplace_back("VELY", [](std::size_t, std::size_t) { return 2.0; });
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return dead(k, e) ? 0.0 : 1.0; });
    builder.nodeNumbers.resize(builder.nodes.size());
    for (std::size_t n = 0; n < builder.nodes.size(); ++n) {
        builder.nodeNumbers[n] = static_cast<int>(100 + n);
    }
    builder.elementNumbers = {7, 5, 9};
    for (const bool netcdf4 : {false, true}) {
        builder.netcdf4 = netcdf4;
        const auto fe = open(builder);
        EXPECT_EQ(fe->contents().format, "Exodus II");
        EXPECT_THAT(fe->times(), ElementsAre(0.0, 0.5, 1.0, 1.5));
        EXPECT_THAT(fe->mesh().elementIds, ElementsAre(7, 5, 9));
        EXPECT_EQ(fe->mesh().nodeIds[3], 103);
        EXPECT_EQ(fe->mesh().parts[0].name, "row");
        EXPECT_THAT(activity(*fe), ElementsAre("111", "110", "100", "100"));
        const auto state = fe->state(3);
        EXPECT_EQ(state->time, 1.5);
        EXPECT_NEAR(state->positions[5].x(), builder.nodes[5].x() + 0.3 + 0.05, 1e-15);
        EXPECT_TRUE(state->velocities[2].isApprox(Vec3(1, 2, -9.81 * 3)));
        EXPECT_TRUE(fe->contents().hasVelocity);
        EXPECT_EQ(fe->contents().sha256.size(), 64u);
        EXPECT_EQ(fe->contents().findings.count("fe.units_rivals"), 1) << "a size alone tells no units";
        EXPECT_EQ(fe->contents().findings.list().size(), 1u);
        EXPECT_TRUE(fe->contents().deathTime.empty());
    }
}

TEST_F(ExodusReaderTest, TheThreeConventionsGiveTheSameDeaths) {
    const std::vector<std::tuple<std::string, double, double>> conventions{
        {"STATUS", 1, 0},  {"death_status", 1, 0}, {"elem_status", 0, 1}, {"Elem_Status", 0, 1},
        {"EROSION", 0, 1}, {"EROSION", 1, 0},      {"FAIL", 0, 1}};
    for (const auto& [name, alive, gone] : conventions) {
        ExodusBuilder builder = ExodusBuilder::threeCubes();
        builder.element.emplace_back("stress", [](std::size_t, std::size_t) { return 3.0; });
        builder.element.emplace_back(name, [a = alive, g = gone](std::size_t k, std::size_t e) { return dead(k, e) ? g : a; });
        const auto fe = open(builder);
        EXPECT_THAT(activity(*fe), ElementsAre("111", "110", "100", "100")) << name << " " << alive;
        EXPECT_THAT(fe->contents().activityFrom, HasSubstr(name + ", " + (alive == 1 ? "1" : "0") + " is active"));
        EXPECT_THAT(fe->contents().activityFrom, HasSubstr("3 of 3 active at the first state"));
    }
}

TEST_F(ExodusReaderTest, TheUserMayNameTheFlagAndItsValue) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.element.emplace_back("gone", [](std::size_t k, std::size_t e) { return dead(k, e) ? 1.0 : 0.0; });
    EXPECT_THAT(activity(*open(builder))[3], "111");
    EXPECT_THAT(activity(*open(builder, {.statusVariable = "gone", .activeValue = 0, .displacement = "", .deadParts = ""}))[3],
                "100");
    EXPECT_THAT(activity(*open(builder, {.statusVariable = "GONE", .activeValue = {}, .displacement = "", .deadParts = ""}))[3],
                "100")
        << "by majority";
    EXPECT_THAT(activity(*open(builder, {.statusVariable = "gone", .activeValue = 1, .displacement = "", .deadParts = ""}))[3],
                "011");
    EXPECT_THAT(errorOf<UsageError>(builder, {.statusVariable = "other", .activeValue = {}, .displacement = "", .deadParts = ""}),
                ::testing::AllOf(HasSubstr("\"other\""), HasSubstr("\"STATUS\", \"gone\"")));
}

TEST_F(ExodusReaderTest, FadingIsActiveUntilItIsDeadAndCounted) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("death_status", [](std::size_t k, std::size_t e) {
        return e == 0 ? 1.0 : std::max(0.0, 1.0 - 0.4 * static_cast<double>(k));
    });
    const auto fe = open(builder);
    EXPECT_THAT(activity(*fe), ElementsAre("111", "111", "111", "100"));
    EXPECT_EQ(fe->contents().findings.count("fe.flag_fading"), 4);
}

TEST_F(ExodusReaderTest, RigidIsNotDeadAndBrokenFlagsKeepTheStateBefore) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) {
        return e == 0 ? 255.0 : e == 1 ? (k == 1 ? unknown : k == 0) : 1.0;
    });
    const auto fe = open(builder);
    EXPECT_THAT(activity(*fe), ElementsAre("111", "111", "101", "101"));
    EXPECT_EQ(fe->contents().findings.count("fe.flag_other"), 4);
    EXPECT_EQ(fe->contents().findings.count("fe.flag_nan"), 1);
}

TEST_F(ExodusReaderTest, RevivalIsKeptAsTheFileSaysIt) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return e == 1 && (k == 1 || k == 3) ? 0.0 : 1.0; });
    EXPECT_THAT(activity(*open(builder)), ElementsAre("111", "101", "111", "101"));
}

TEST_F(ExodusReaderTest, NoDeathIsAValidResult) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    EXPECT_THAT(activity(*open(builder)), ::testing::Each(std::string("111")));
}

TEST_F(ExodusReaderTest, AFlagTheOtherWayRoundIsNoticed) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return dead(k, e) ? 1.0 : 0.0; });
    const auto fe = open(builder);
    EXPECT_EQ(fe->contents().findings.count("exodus.polarity"), 3);
    EXPECT_THAT(englishText(fe->contents().findings.list()[0].remedy), HasSubstr("active_value=0"));
}

TEST_F(ExodusReaderTest, BlocksWithoutTheFlagAreAlwaysActive) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.addCubes(2, "abutment", 7);
    builder.element.emplace_back("stress", [](std::size_t, std::size_t) { return 0.0; });
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return dead(k, e) ? 0.0 : 1.0; });
    builder.truthTable = {1, 1, 1, 0};
    for (const bool netcdf4 : {false, true}) {
        builder.netcdf4 = netcdf4;
        const auto fe = open(builder);
        EXPECT_THAT(activity(*fe), ElementsAre("11111", "11011", "10011", "10011"));
        EXPECT_EQ(fe->contents().findings.count("exodus.no_flag"), 2);
    }
}

// It opens all the same: a finding says how to tell what is dead.
TEST_F(ExodusReaderTest, WithoutAFlagAllIsActiveAndTheVariablesThatExistAreOffered) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    const auto fe = open(builder);
    EXPECT_THAT(activity(*fe), ::testing::Each(std::string("111")));
    EXPECT_EQ(fe->contents().findings.count("fe.no_deaths"), 3);
    EXPECT_THAT(remedyOf(fe->contents().findings, "fe.no_deaths"), HasSubstr(".deaths.csv"));
    builder.element.emplace_back("Damage", [](std::size_t, std::size_t) { return 0.0; });
    builder.element.emplace_back("EQPS", [](std::size_t, std::size_t) { return 0.0; });
    const auto named = open(builder);
    EXPECT_THAT(activity(*named), ::testing::Each(std::string("111")));
    EXPECT_THAT(remedyOf(named->contents().findings, "fe.no_deaths"),
                ::testing::AllOf(HasSubstr("--set status_variable=NAME"), HasSubstr("\"Damage\", \"EQPS\"")));
    EXPECT_EQ(
        named->state(1)->positions,
        open(builder, {.statusVariable = "Damage", .activeValue = 0, .displacement = "", .deadParts = ""})->state(1)->positions)
        << "the way it is read makes no difference";
}

TEST_F(ExodusReaderTest, WithoutDisplacementTheVariablesThatExistAreOffered) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    for (auto& [name, unused] : builder.nodal) {
        name.replace(0, 4, "shift");
    }
    builder.nodal[0].second = [](std::size_t, std::size_t) { return 5.0; };
    EXPECT_THAT(errorOf<ParseError>(builder), ::testing::AllOf(HasSubstr("displacement=none"), HasSubstr("\"shift_x\"")));
    EXPECT_EQ(open(builder, {.statusVariable = "", .activeValue = {}, .displacement = "shift", .deadParts = ""})
                  ->state(1)
                  ->positions[0]
                  .x(),
              5.0);
    EXPECT_EQ(open(builder, {.statusVariable = "", .activeValue = {}, .displacement = "none", .deadParts = ""})
                  ->state(1)
                  ->positions[0]
                  .x(),
              0.0);
    EXPECT_THAT(errorOf<UsageError>(builder, {.statusVariable = "", .activeValue = {}, .displacement = "move", .deadParts = ""}),
                HasSubstr("\"shift_x\""));
    builder.nodal.clear();
    EXPECT_THAT(errorOf<ParseError>(builder), HasSubstr("Nodal variables in the file: none"));
}

TEST_F(ExodusReaderTest, MaterialComesFromAttributesElseFromVariables) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.element.emplace_back(
        "density", [](std::size_t k, std::size_t e) { return 1000.0 + static_cast<double>(e) - static_cast<double>(k); });
    builder.blocks.push_back({.id = 2, .name = "slab", .topology = "SHELL4", .nodesPerElement = 4, .nodes = {1, 5, 6, 2}});
    builder.blocks.back().attributeCount = 2;
    builder.blocks.back().attributeNames = {"Thickness", "DENSITY"};
    builder.blocks.back().attributes = {0.25, 7850};
    builder.blocks.push_back({.id = 3, .name = "tie", .topology = "BEAM", .nodesPerElement = 2, .nodes = {1, 5}});
    builder.blocks.back().attributeCount = 1;
    builder.blocks.back().attributes = {0.01};
    const auto fe = open(builder);
    const Mesh& mesh = fe->mesh();
    EXPECT_THAT(mesh.density, ElementsAre(1000, 1001, 1002, 7850, 1004));
    EXPECT_TRUE(std::isnan(mesh.section[0]));
    EXPECT_EQ(mesh.section[3], 0.25);
    EXPECT_EQ(mesh.section[4], 0.01) << "the first unnamed attribute of a beam is its area";
    EXPECT_EQ(fe->contents().findings.count("exodus.unnamed_attribute"), 1);
}

TEST_F(ExodusReaderTest, ExactDeathTimesAndTheirAbsence) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return dead(k, e) ? 0.0 : 1.0; });
    builder.element.emplace_back("DEATH_TIME", [](std::size_t k, std::size_t e) { return k == 3 && e == 1 ? 0.75 : 0.0; });
    const std::vector<double> times = open(builder)->contents().deathTime;
    ASSERT_EQ(times.size(), 3u);
    EXPECT_TRUE(std::isnan(times[0]));
    EXPECT_EQ(times[1], 0.75);
    EXPECT_TRUE(std::isnan(times[2])) << "dead without a time";
}

TEST_F(ExodusReaderTest, NamesAreMadeUniqueAndOddBlocksLeftOut) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.addCubes(1, "row", 5);
    builder.addCubes(1, "", 9);
    builder.blocks.push_back({.id = 11, .name = "masses", .topology = "SPHERE", .nodesPerElement = 1, .nodes = {1, 2}});
    builder.blocks.push_back({.id = 12, .name = "nothing", .topology = "HEX8", .nodesPerElement = 8, .nodes = {}});
    builder.blocks.push_back(
        {.id = 13, .name = "after", .topology = "TETRA10", .nodesPerElement = 10, .nodes = {1, 2, 4, 5, 6, 7, 8, 9, 10, 11}});
    builder.elementNumbers = {1, 2, 3, 4, 5, 6, 7, 8};
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return k > 1 && e == 7 ? 0.0 : 1.0; });
    const auto fe = open(builder);
    std::vector<std::string> names;
    for (const Part& part : fe->mesh().parts) {
        names.push_back(part.name);
    }
    EXPECT_THAT(names, ElementsAre("row", "row (5)", "block 9", "after"));
    EXPECT_THAT(fe->mesh().elementIds, ElementsAre(1, 2, 3, 4, 5, 8)) << "numbers do not shift by the blocks left out";
    EXPECT_EQ(fe->mesh().cornersOf(idAt<ElementIndex>(5)).size(), 4u) << "corners only";
    EXPECT_EQ(fe->contents().findings.count("exodus.skipped_block"), 2);
    EXPECT_THAT(activity(*fe)[3], "111110");
}

TEST_F(ExodusReaderTest, EveryFamilyOfElementsIsRead) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.blocks.push_back({.id = 2, .name = "w", .topology = "WEDGE", .nodesPerElement = 6, .nodes = {1, 2, 4, 5, 6, 8}});
    builder.blocks.push_back({.id = 3, .name = "p", .topology = "PYRAMID", .nodesPerElement = 5, .nodes = {1, 2, 3, 4, 5}});
    builder.blocks.push_back({.id = 4, .name = "t", .topology = "TRI3", .nodesPerElement = 3, .nodes = {1, 2, 3}});
    builder.blocks.push_back({.id = 5, .name = "d", .topology = "HEX8", .nodesPerElement = 8, .nodes = {1, 2, 4, 4, 5, 6, 8, 8}});
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    const auto fe = open(builder);
    const Components components = groupComponents(fe->mesh(), {}, {}, {});
    EXPECT_THAT(std::vector<double>(components.volume.begin() + 3, components.volume.end()),
                ElementsAre(::testing::DoubleNear(0.5, 1e-12), ::testing::DoubleNear(1.0 / 3.0, 1e-12),
                            ::testing::DoubleNear(0.5 * 0.2, 1e-12), ::testing::DoubleNear(0.5, 1e-12)));
}

TEST_F(ExodusReaderTest, SolidsNumberedInsideOutAreTurned) {
    ExodusBuilder builder;
    builder.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    builder.blocks = {{.id = 1, .name = "h", .topology = "HEX8", .nodesPerElement = 8, .nodes = {5, 6, 7, 8, 1, 2, 3, 4}},
                      {.id = 2, .name = "w", .topology = "WEDGE6", .nodesPerElement = 6, .nodes = {5, 6, 8, 1, 2, 4}},
                      {.id = 3, .name = "p", .topology = "PYRAMID5", .nodesPerElement = 5, .nodes = {1, 4, 3, 2, 5}},
                      {.id = 4, .name = "t", .topology = "TETRA4", .nodesPerElement = 4, .nodes = {1, 4, 2, 5}}};
    builder.times = {0.0, 1.0};
    builder.addStillDisplacement();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    const auto fe = open(builder);
    EXPECT_EQ(fe->contents().findings.count("fe.reversed"), 4);
    for (std::size_t e = 0; e < 4; ++e) {
        std::vector<Vec3> x;
        for (const std::uint32_t node : fe->mesh().cornersOf(idAt<ElementIndex>(e))) {
            x.push_back(fe->mesh().nodes[node]);
        }
        EXPECT_GT(elementVolume(fe->mesh().shapes[e], x, 0.0), 0.1) << e;
    }
}

TEST_F(ExodusReaderTest, TheFrameTurnsScalesAndMoves) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.nodal[1].second = [](std::size_t, std::size_t) { return 100.0; };
    for (const char* name : {"vel_x", "vel_y", "vel_z"}) {
        builder.nodal.emplace_back(name, [](std::size_t, std::size_t) { return 2000.0; });
    }
    builder.blocks.push_back({.id = 2, .name = "slab", .topology = "SHELL4", .nodesPerElement = 4, .nodes = {1, 5, 6, 2}});
    builder.blocks.back().attributeCount = 2;
    builder.blocks.back().attributeNames = {"THICKNESS", "DENSITY"};
    builder.blocks.back().attributes = {250.0, 2.4e-9};
    for (Vec3& node : builder.nodes) {
        node *= 1000.0;
    }
    Frame frame;
    frame.metresPerUnit = 0.001;
    frame.upAxis = "y";
    frame.origin = {2, 0, -1};
    const auto fe = open(builder, {}, frame);
    // Node 6 of the file lies at (1000, 1000, 0) mm; y is up, so it lies 1 m high, 1 m before the origin in x and 1 m before it in
    // -z.
    EXPECT_TRUE(fe->mesh().nodes[5].isApprox(Vec3(1 - 2, 0 - 1, 1), 1e-12)) << fe->mesh().nodes[5].transpose();
    const auto state = fe->state(0);
    EXPECT_TRUE((state->positions[5] - fe->mesh().nodes[5]).isApprox(Vec3(0, 0, 0.1), 1e-12));
    EXPECT_TRUE(state->velocities[0].isApprox(Vec3(2, -2, 2), 1e-12));
    EXPECT_NEAR(fe->mesh().section[3], 0.25, 1e-15);
    EXPECT_NEAR(fe->mesh().density[3], 2400.0, 1e-9) << "t/mm3";
    EXPECT_EQ(fe->contents().findings.count("fe.density_unit"), 1);

    frame.upAxis = "w";
    EXPECT_THAT(errorOf<UsageError>(builder, {}, frame), HasSubstr("\"w\""));
    frame.upAxis = "x";
    frame.metresPerUnit = 0.0;
    errorOf<UsageError>(builder, {}, frame);
}

TEST_F(ExodusReaderTest, FingerprintsFollowContentAndSettings) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return dead(k, e) ? 0.0 : 1.0; });
    const Digest first = open(builder)->contents().fingerprint;
    EXPECT_EQ(open(builder)->contents().fingerprint, first);
    EXPECT_NE(open(builder, {.statusVariable = "", .activeValue = 0, .displacement = "", .deadParts = ""})->contents().fingerprint,
              first);
    Frame frame;
    frame.origin = {1, 0, 0};
    EXPECT_NE(open(builder, {}, frame)->contents().fingerprint, first);
    builder.times[3] = 1.75;
    EXPECT_NE(open(builder)->contents().fingerprint, first);
}

TEST_F(ExodusReaderTest, TimesMustBeNumbers) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.times = {0.0, unknown, 0.5, 1.0};
    EXPECT_THAT(errorOf<ParseError>(builder), HasSubstr("the time of state 1 is not a number"));
    builder.times = {};
    EXPECT_THAT(errorOf<ParseError>(builder), HasSubstr("no states"));
}

TEST_F(ExodusReaderTest, CoordinatesMustBeNumbersWhereTheyAreUsed) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.nodes.push_back({0, unknown, 0});
    const auto fe = open(builder);
    EXPECT_EQ(fe->contents().findings.count("fe.stray_node"), 1);
    EXPECT_TRUE(fe->mesh().nodes.back().allFinite());
    builder.nodes[4].z() = unknown;
    EXPECT_THAT(errorOf<ParseError>(builder), HasSubstr("node 5 lies at (1, 0, not a number)"));
    builder.nodes[4].z() = 1e30;
    EXPECT_THAT(errorOf<ParseError>(builder), HasSubstr("node 5"));
}

TEST_F(ExodusReaderTest, FieldsMustBeNumbersAtNodesOfActiveElements) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return dead(k, e) ? 0.0 : 1.0; });
    // The last four nodes belong to element 2 alone, which dies at state 1.
    builder.nodal[2].second = [](std::size_t k, std::size_t n) { return k >= 1 && n >= 12 ? unknown : 0.5; };
    const auto fe = open(builder);
    EXPECT_EQ(fe->state(0)->positions[12].z(), builder.nodes[12].z() + 0.5);
    EXPECT_EQ(fe->state(1)->positions[12], builder.nodes[12]) << "dead: stands at its first place";
    EXPECT_EQ(fe->state(1)->positions[11].z(), builder.nodes[11].z() + 0.5);
    builder.nodal[2].second = [](std::size_t k, std::size_t n) { return k == 2 && n == 3 ? unknown : 0.5; };
    const auto broken = open(builder);
    EXPECT_NO_THROW(broken->state(1));
    try {
        broken->state(2);
        ADD_FAILURE() << "no error";
    } catch (const ParseError& error) {
        EXPECT_THAT(error.what(), ::testing::AllOf(HasSubstr("fixture.exo"), HasSubstr("node 4"), HasSubstr("state 2")));
    }
}

TEST_F(ExodusReaderTest, TwoDimensionsAreRefusedInWords) {
    ExodusBuilder builder;
    builder.dimensions = 2;
    builder.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    builder.blocks = {{.id = 1, .name = "q", .topology = "QUAD4", .nodesPerElement = 4, .nodes = {1, 2, 3, 4}}};
    builder.times = {0.0, 1.0};
    for (const char* name : {"disp_x", "disp_y"}) {
        builder.nodal.emplace_back(name, [](std::size_t, std::size_t) { return 0.0; });
    }
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    EXPECT_THAT(errorOf<ParseError>(builder), HasSubstr("2 dimensions"));
}

TEST_F(ExodusReaderTest, OnlySpheresAreNoStructure) {
    ExodusBuilder builder;
    builder.nodes = {{0, 0, 0}};
    builder.blocks = {{.id = 1, .name = "s", .topology = "SPHERE", .nodesPerElement = 1, .nodes = {1}}};
    builder.times = {0.0};
    builder.addStillDisplacement();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    EXPECT_THAT(errorOf<ParseError>(builder), HasSubstr("no solids, shells or beams"));
}

TEST_F(ExodusReaderTest, NodesThatDoNotExistAreNamed) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.blocks[0].nodes[9] = 4000;
    EXPECT_THAT(errorOf<ParseError>(builder), HasSubstr("element 2 of \"row\" uses the node at place 4,000 of 16"));
    builder.blocks[0].nodes[9] = 0;
    errorOf<ParseError>(builder);
}

TEST_F(ExodusReaderTest, AllFilesOfASequenceAreRead) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    ExodusBuilder later = builder;
    const double last = builder.times.back();
    for (double& time : later.times) {
        time += last + 1.0;
    }
    later.write(m_folder / "fixture.exo-s0002");
    EXPECT_EQ(open(builder)->contents().findings.count("fe.no_deaths"), 3);
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t e) { return e == 0 ? 0.0 : 1.0; });
    const auto fe = open(builder);
    EXPECT_EQ(fe->stateCount(), builder.times.size() + later.times.size());
    EXPECT_EQ(fe->contents().files.size(), 2u);
    EXPECT_FALSE(fe->activity().active(0, idAt<ElementIndex>(0)));
    // A state that a later file has again comes from there.
    later.times.front() = last;
    later.write(m_folder / "fixture.exo-s0002");
    EXPECT_EQ(open(builder)->contents().findings.count("fe.written_twice"), 1);
}

TEST_F(ExodusReaderTest, CanBeCancelled) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.write(m_folder / "c.exo");
    const Execution execution;
    execution.cancel();
    EXPECT_THROW(openFe(m_folder / "c.exo", {}, {}, execution), Cancelled);
}

TEST_F(ExodusReaderTest, ManyThreadsMayReadManyFiles) {
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.element.emplace_back("STATUS", [](std::size_t k, std::size_t e) { return dead(k, e) ? 0.0 : 1.0; });
    builder.nodal[0].second = [](std::size_t k, std::size_t) { return static_cast<double>(k); };
    std::vector<std::string> paths;
    for (int i = 0; i < 4; ++i) {
        builder.netcdf4 = i % 2;
        paths.push_back(m_folder / ("t" + std::to_string(i) + ".exo"));
        builder.write(paths.back());
    }
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (const std::string& path : paths) {
        threads.emplace_back([&] {
            for (int round = 0; round < 5; ++round) {
                const auto fe = openFe(path, {}, {}, Execution{});
                for (std::size_t k = 0; k < 4; ++k) {
                    wrong += fe->state(k)->positions[0].x() != static_cast<double>(k);
                }
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace rubble::io
