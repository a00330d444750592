#include "io/fe/result_frame.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "core/fe/components.h"
#include "core/fe/frame_transform.h"
#include "core/fe/unit_evidence.h"
#include "core/fragments/fragment_set.h"
#include "io/fe/fe_reader.h"
#include "tests/support/exodus_builder.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

constexpr std::size_t states = 9;
constexpr double interval = 0.1;  // s

std::size_t choice(const std::vector<std::string_view>& choices, std::string_view name) {
    const auto found = std::find(choices.begin(), choices.end(), name);
    EXPECT_NE(found, choices.end()) << name;
    return static_cast<std::size_t>(found - choices.begin());
}

ImportSettings importAs(std::string_view units, std::string_view upAxis) {
    ImportSettings settings;
    settings.units = choice(unitChoices(), units);
    settings.upAxis = choice(upAxisChoices(), upAxis);
    return settings;
}

/// Six concrete cubes of 2 m that touch nothing; cube e dies at state e + 1, moves at 1 m/s along x until then and falls after. All
/// this in SI and z up, written in other units and axes, at a place far away if asked for.
void writeCollapse(const std::string& path, const FileUnits& units, const std::string& upAxis, const Vec3& place = Vec3::Zero()) {
    Frame frame;
    frame.metresPerUnit = units.metres;
    frame.upAxis = upAxis;
    const FrameTransform transform(frame);
    const auto vectorInFile = [transform](const Vec3& local) {
        return Vec3(transform.pointInFile(local) - transform.pointInFile(Vec3::Zero()));
    };
    const auto since = [](std::size_t state, std::size_t node) {
        return std::max(0.0, interval * (static_cast<double>(state) - static_cast<double>(node / 8) - 1.0));
    };
    const auto displacement = [since](std::size_t state, std::size_t node) {
        const double t = since(state, node);
        return Vec3(interval * static_cast<double>(state), 0.0, -0.5 * standardGravity * t * t);
    };
    const auto velocity = [since](std::size_t state, std::size_t node) {
        return Vec3(1.0, 0.0, -standardGravity * since(state, node));
    };

    ExodusBuilder builder;
    builder.addCubes(1, "concrete", 1);
    const std::vector<Vec3> cube = builder.nodes;
    builder.nodes.clear();
    ExodusBuilder::Block& block = builder.blocks.front();
    const std::vector<int> corners = block.nodes;
    block.nodes.clear();
    for (int e = 0; e < 6; ++e) {
        for (const Vec3& corner : cube) {
            builder.nodes.push_back(transform.pointInFile(place + 2.0 * corner + Vec3(5.0 * e, 0.0, 30.0)));
        }
        for (const int corner : corners) {
            block.nodes.push_back(8 * e + corner);
        }
        block.attributes.push_back(2400.0 / units.density());
    }
    block.attributeNames = {"density"};
    block.attributeCount = 1;
    for (std::size_t k = 0; k < states; ++k) {
        builder.times.push_back(interval * static_cast<double>(k) / units.seconds);
    }
    for (const auto& [name, axis] : std::map<std::string, Eigen::Index>{{"x", 0}, {"y", 1}, {"z", 2}}) {
        builder.nodal.push_back(
            {"disp_" + name, [=](std::size_t k, std::size_t n) { return vectorInFile(displacement(k, n))[axis]; }});
        builder.nodal.push_back(
            {"vel_" + name, [=](std::size_t k, std::size_t n) { return vectorInFile(velocity(k, n))[axis] * units.seconds; }});
    }
    builder.element.push_back({"STATUS", [](std::size_t k, std::size_t e) { return k >= e + 1 ? 0.0 : 1.0; }});
    builder.write(path);
}

FragmentSet fragmentsOf(const FeResult& fe) {
    return makeFragments(fe, groupComponents(fe.mesh(), {}, {}, {}), {}, Execution{});
}

FileUnits unitsCalled(std::string_view id) {
    for (const UnitSystem& system : unitSystems()) {
        if (system.id == id) {
            return system.units;
        }
    }
    ADD_FAILURE() << id;
    return {};
}

/// Everything that fragments are made from agrees to the rounding of a few operations in double precision, relative to the size.
void expectSame(const FeResult& a, const FeResult& b) {
    constexpr double rounding = 1e-9;
    ASSERT_EQ(a.mesh().nodeCount(), b.mesh().nodeCount());
    ASSERT_EQ(a.stateCount(), b.stateCount());
    for (std::size_t e = 0; e < a.mesh().elementCount(); ++e) {
        EXPECT_NEAR(a.mesh().density[e], b.mesh().density[e], 2400.0 * rounding);
    }
    for (std::size_t k = 0; k < a.stateCount(); ++k) {
        EXPECT_NEAR(a.times()[k], b.times()[k], rounding);
        const auto left = a.state(k), right = b.state(k);
        EXPECT_DOUBLE_EQ(right->time, b.times()[k]) << "the source has the clock of the result";
        for (std::size_t n = 0; n < a.mesh().nodeCount(); ++n) {
            EXPECT_LT((left->positions[n] - right->positions[n]).norm(), 50.0 * rounding);
            EXPECT_LT((left->velocities[n] - right->velocities[n]).norm(), 50.0 * rounding);
        }
    }
    const FragmentSet left = fragmentsOf(a), right = fragmentsOf(b);
    ASSERT_EQ(left.list.size(), 6u);
    ASSERT_EQ(right.list.size(), 6u);
    for (std::size_t f = 0; f < 6; ++f) {
        EXPECT_EQ(left.list[f].element, right.list[f].element);
        EXPECT_NEAR(left.list[f].mass, right.list[f].mass, 19200.0 * rounding);
        EXPECT_NEAR(left.list[f].birthTime, right.list[f].birthTime, rounding);
    }
}

TEST(ResultFrame, OneCollapseInFiveSystemsGivesTheSameFragments) {
    const TemporaryFolder folder;
    writeCollapse(folder / "si.exo", {}, "z");
    const auto reference = openFe(folder / "si.exo", {}, {}, Execution{});
    EXPECT_NEAR(fragmentsOf(*reference).list.front().mass, 8.0 * 2400.0, 1e-6);
    for (const auto& [id, axis] : std::map<std::string, std::string>{
             {"t-mm-s", "z"}, {"kg-mm-ms", "y"}, {"g-cm-us", "-x"}, {"lbf-in-s", "x"}, {"g-mm-ms", "-z"}, {"lbf-ft-s", "-y"}}) {
        SCOPED_TRACE(id + ", up " + axis);
        const std::string path = folder / (id + ".exo");
        writeCollapse(path, unitsCalled(id), axis);
        expectSame(*reference, *openFe(path, importAs(id, axis), {}, Execution{}));
        const auto decided = openFe(path, importAs("auto", "auto"), {}, Execution{});
        EXPECT_EQ(systemOf(decided->contents().units)->id, id) << decided->contents().unitsFrom;
        EXPECT_EQ(decided->contents().frame.upAxis, axis);
        expectSame(*reference, *decided);
    }
}

/// One cube that neither falls nor dies at once: its size, its time and perhaps its density are all that tells its units.
void writeStill(const std::string& path, double density, double size) {
    ExodusBuilder builder;
    builder.addCubes(1, "block", 1);
    for (Vec3& node : builder.nodes) {
        node *= size;
    }
    if (density > 0.0) {
        builder.blocks.front().attributes = {density};
        builder.blocks.front().attributeNames = {"density"};
        builder.blocks.front().attributeCount = 1;
    }
    builder.times = {0.0, 1.0};
    for (const char* name : {"disp_x", "disp_y", "disp_z"}) {
        builder.nodal.push_back({name, [](std::size_t, std::size_t) { return 0.0; }});
    }
    builder.element.push_back({"STATUS", [](std::size_t k, std::size_t) { return k == 0 ? 1.0 : 0.0; }});
    builder.write(path);
}

TEST(ResultFrame, UnitsThatTheFileDoesNotDecideAreAFindingWhereverItIsOpened) {
    const TemporaryFolder folder;
    writeStill(folder / "bare.exo", 0.0, 20.0);
    const auto bare = openFe(folder / "bare.exo", {}, {}, Execution{});
    ASSERT_EQ(bare->contents().findings.count("fe.units_rivals"), 1);
    EXPECT_EQ(bare->contents().findings.count("fe.units_better"), 0);
    EXPECT_NE(unsaidUnits(bare->contents().findings).find("t-mm-s"), std::string::npos);
    // Somebody who chooses settles it; that others would fit stays a fact.
    const auto chosen = openFe(folder / "bare.exo", importAs("kg-m-s", "z"), {}, Execution{});
    EXPECT_EQ(chosen->contents().findings.count("fe.units_rivals"), 0);
    EXPECT_EQ(unsaidUnits(chosen->contents().findings), "");
    EXPECT_NE(chosen->contents().unitsFrom.find("; the file would fit t-m-s"), std::string::npos) << chosen->contents().unitsFrom;
    const auto open = openFe(folder / "bare.exo", importAs("auto", "z"), {}, Execution{});
    EXPECT_EQ(open->contents().findings.count("fe.units_open"), 1);
    EXPECT_EQ(open->contents().findings.count("fe.units_rivals"), 0) << "said already";

    // Tungsten in three systems, read in a fourth in which it weighs as air does.
    writeStill(folder / "heavy.exo", 18.62, 23.0);
    const auto heavy = openFe(folder / "heavy.exo", importAs("kg-m-s", "z"), {}, Execution{});
    ASSERT_EQ(heavy->contents().findings.count("fe.units_better"), 1);
    for (const Finding& finding : heavy->contents().findings.list()) {
        if (finding.what.id == "fe.units_better") {
            EXPECT_TRUE(englishText(finding.what)
                            .starts_with("The file was taken to count in kg-m-s; what it holds fits better: t-m-s, g-cm-s"));
        }
    }
    const auto tonnes = openFe(folder / "heavy.exo", importAs("t-m-s", "z"), {}, Execution{});
    EXPECT_EQ(tonnes->contents().findings.count("fe.units_better"), 0);
    EXPECT_EQ(tonnes->contents().findings.count("fe.units_rivals"), 0);

    writeCollapse(folder / "si.exo", {}, "z");
    const auto clear = openFe(folder / "si.exo", {}, {}, Execution{});
    EXPECT_EQ(clear->contents().findings.count("fe.units_rivals") + clear->contents().findings.count("fe.units_better"), 0)
        << "density and gravity decide";
}

TEST(ResultFrame, WhatWasDecidedIsKnownAgainOnceItIsRecorded) {
    const TemporaryFolder folder;
    writeCollapse(folder / "mm.exo", unitsCalled("t-mm-s"), "y", {512300.0, 0.0, 0.0});
    const ImportSettings settings = importAs("auto", "auto");
    const auto first = openFe(folder / "mm.exo", settings, {}, Execution{});
    const auto again = openFe(folder / "mm.exo", settings, first->contents().frame, Execution{});
    EXPECT_EQ(first->contents().frame, again->contents().frame);
    EXPECT_EQ(first->contents().fingerprint, again->contents().fingerprint);
    EXPECT_NE(first->contents().fingerprint, openFe(folder / "mm.exo", {}, {}, Execution{})->contents().fingerprint);
}

TEST(ResultFrame, AFarStructureMovesToALocalOriginAndBack) {
    const TemporaryFolder folder;
    const Vec3 place(512345.0, 5301222.0, 250.0);
    for (const std::string axis : {"z", "y"}) {
        writeCollapse(folder / "far.exo", {}, axis, place);
        const auto fe = openFe(folder / "far.exo", importAs("kg-m-s", axis), {}, Execution{});
        EXPECT_EQ(fe->contents().findings.count("fe.local_origin"), 1);
        const FrameTransform transform(fe->contents().frame);
        Aabb bounds;
        for (const Vec3& node : fe->mesh().nodes) {
            bounds.extend(node);
        }
        EXPECT_LT(bounds.min().cwiseAbs().maxCoeff(), 400.0) << "whole hundreds of metres around the middle, heights as they are";
        Frame plain;
        plain.upAxis = axis;
        const Vec3 back = FrameTransform(plain).point(transform.pointInFile(fe->mesh().nodes.front()));
        EXPECT_LT((back - place - Vec3(0.0, 0.0, 30.0)).cwiseAbs().maxCoeff(), 2.0 + 1e-6);
        EXPECT_NEAR(bounds.min().z(), place.z() + 30.0, 1e-6);
    }
    writeCollapse(folder / "near.exo", {}, "z");
    EXPECT_TRUE(openFe(folder / "near.exo", {}, {}, Execution{})->contents().frame == Frame{});
}

TEST(ResultFrame, WrongUnitsArePointedOut) {
    const TemporaryFolder folder;
    writeCollapse(folder / "mm.exo", unitsCalled("t-mm-s"), "z");
    // 27 m in millimetres, read as metres.
    const auto wrong = openFe(folder / "mm.exo", importAs("kg-m-s", "z"), {}, Execution{});
    ASSERT_EQ(wrong->contents().findings.count("fe.units.too_large"), 1);
    for (const Finding& finding : wrong->contents().findings.list()) {
        if (finding.what.id == "fe.units.too_large") {
            EXPECT_NE(englishText(finding.what).find("27 km"), std::string::npos) << englishText(finding.what);
            EXPECT_NE(englishText(finding.remedy).find("units=t-mm-s"), std::string::npos) << englishText(finding.remedy);
        }
    }
    const Components components = groupComponents(wrong->mesh(), {}, {}, {});
    EXPECT_GT(components.findings.count("components.implausible_density"), 0) << "concrete of 2.4e-9 kg/m3 is lighter than air";
    EXPECT_EQ(openFe(folder / "mm.exo", importAs("t-mm-s", "z"), {}, Execution{})->contents().findings.list().size(), 0u);
}

TEST(ResultFrame, WhatCannotBeToldIsLeftToTheUser) {
    const TemporaryFolder folder;
    ExodusBuilder builder = ExodusBuilder::threeCubes();
    builder.addStillDisplacement();
    builder.element.push_back({"STATUS", [](std::size_t k, std::size_t e) { return k > 1 && e == 1 ? 0.0 : 1.0; }});
    builder.write(folder / "still.exo");
    const auto fe = openFe(folder / "still.exo", importAs("auto", "auto"), {}, Execution{});
    EXPECT_EQ(fe->contents().findings.count("fe.units_open"), 1);
    EXPECT_EQ(fe->contents().findings.count("fe.up_axis_open"), 1);
    EXPECT_EQ(fe->contents().units, FileUnits{});
    EXPECT_EQ(fe->contents().frame.upAxis, "z");
}

}  // namespace
}  // namespace rubble::io
