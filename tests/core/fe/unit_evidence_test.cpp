#include "core/fe/unit_evidence.h"
#include "core/base/standard_gravity.h"

#include <gtest/gtest.h>

#include <set>

#include "core/fe/frame_transform.h"
#include "tests/scenes/fe_scenes.h"

namespace rubble {
namespace {

const UnitSystem& called(std::string_view id) {
    for (const UnitSystem& system : unitSystems()) {
        if (system.id == id) {
            return system;
        }
    }
    throw std::out_of_range(std::string(id));
}

TEST(Units, SystemsAreConsistentWithWhatTextbooksPrint) {
    // Steel of 7,850 kg/m3 and standard gravity in each system, to the digits that textbooks print.
    const struct {
        std::string_view id;
        double steel, gravity, digits;
    } rows[] = {
        {"kg-m-s", 7850.0, 9.80665, 1e-9},      {"t-mm-s", 7.85e-9, 9806.65, 1e-9},   {"kg-mm-ms", 7.85e-6, 9.80665e-3, 1e-9},
        {"g-mm-ms", 7.85e-3, 9.80665e-3, 1e-9}, {"t-m-s", 7.85, 9.80665, 1e-9},       {"kg-mm-s", 7.85e-6, 9806.65, 1e-9},
        {"g-mm-s", 7.85e-3, 9806.65, 1e-9},     {"g-cm-us", 7.85, 9.80665e-10, 1e-9}, {"g-cm-s", 7.85, 980.665, 1e-9},
        {"lbf-in-s", 7.345e-4, 386.09, 1e-3},   {"kip-in-s", 7.345e-7, 386.09, 1e-3}, {"lbf-ft-s", 15.23, 32.174, 1e-3}};
    EXPECT_EQ(std::size(rows), unitSystems().size());
    for (const auto& row : rows) {
        const FileUnits& units = called(row.id).units;
        EXPECT_NEAR(7850.0 / units.density() / row.steel, 1.0, row.digits) << row.id;
        EXPECT_NEAR(standardGravity / units.acceleration() / row.gravity, 1.0, row.digits) << row.id;
        EXPECT_EQ(systemOf(units)->id, row.id);
    }
}

TEST(Units, NoTwoSystemsAreAlike) {
    std::set<std::string_view> ids;
    for (const std::string_view name : unitChoices()) {
        EXPECT_TRUE(ids.insert(name).second) << name;
    }
    EXPECT_EQ(systemOf({0.5, 1.0, 1.0}), nullptr);
}

TEST(UnitEvidence, TheProposalSaysWhyInWordsAndNumbers) {
    UnitEvidence evidence;
    evidence.densities = {{"girder", 7.85e-9}};
    evidence.size = 60000.0;
    evidence.duration = 4.0;
    const Proposal proposal = proposeUnits(evidence);
    EXPECT_EQ(proposal.choice, "t-mm-s");
    const std::string text = englishText(proposal.reason);
    for (const char* words : {"7.85e-09", "girder", "7,850 kg/m3", "steel", "60,000", "60 m"}) {
        EXPECT_NE(text.find(words), std::string::npos) << words << " in " << text;
    }
}

TEST(UnitEvidence, GravityTellsWhatDensityAndSizeCannot) {
    // kg and mm with seconds or milliseconds: density and size are the same.
    UnitEvidence evidence;
    evidence.densities = {{"slab", 2.4e-6}};
    evidence.size = 12000.0;
    evidence.duration = 2.0;
    evidence.fall = Vec3(0.0, 0.0, -9.8e-3);
    EXPECT_EQ(proposeUnits(evidence).choice, "kg-mm-ms");
    evidence.fall = Vec3(0.0, 0.0, -9800.0);
    EXPECT_EQ(proposeUnits(evidence).choice, "kg-mm-s");
}

TEST(UnitEvidence, RivalsAreNamedWhereNothingDecides) {
    UnitEvidence evidence;
    evidence.size = 20.0;
    evidence.duration = 3.0;
    const Proposal proposal = proposeUnits(evidence);
    EXPECT_TRUE(proposal.choice.empty());
    const std::string text = englishText(proposal.reason);
    EXPECT_NE(text.find("kg-m-s"), std::string::npos) << text;
    EXPECT_NE(text.find("lbf-ft-s"), std::string::npos) << text;
    evidence.densities = {{"dark matter", 1e-30}};
    EXPECT_TRUE(proposeUnits(evidence).choice.empty());
}

TEST(UnitEvidence, AFileIsReadAgainOnlyWhereItFitsClearlyBetter) {
    UnitEvidence evidence;
    evidence.densities = {{"girder", 7.85e-9}};
    evidence.size = 60000.0;
    evidence.duration = 4.0;
    const std::vector<UnitFit> fits = fitUnits(evidence);
    const UnitFit* better = betterFit(fits, systemOf({1.0, 1.0, 1.0}));
    ASSERT_NE(better, nullptr);
    EXPECT_EQ(better->system->id, "t-mm-s");
    EXPECT_EQ(betterFit(fits, better->system), nullptr) << "it is read so already";
    EXPECT_EQ(betterFit({}, nullptr), nullptr);
    evidence.densities = {{"dark matter", 1e-30}};
    EXPECT_EQ(betterFit(fitUnits(evidence), systemOf({1.0, 1.0, 1.0})), nullptr) << "nothing fits";
}

TEST(UnitEvidence, AnImpactInMicrosecondsIsAmongTheRivals) {
    // A tungsten rod of 23 cm in 70 microseconds, as its file counts: as t, m and s it would be a usual building.
    UnitEvidence evidence;
    evidence.densities = {{"rod", 18.62}, {"plate", 7.896}};
    evidence.size = 23.0;
    evidence.duration = 70.03;
    const Proposal proposal = proposeUnits(evidence);
    EXPECT_TRUE(proposal.choice.empty());
    EXPECT_NE(englishText(proposal.reason).find("g-cm-us"), std::string::npos) << englishText(proposal.reason);
}

TEST(UnitEvidence, ADeckThatNamesItsUnitsDecides) {
    UnitEvidence evidence;
    evidence.size = 20.0;
    evidence.declared = called("lbf-ft-s").units;
    EXPECT_EQ(proposeUnits(evidence).choice, "lbf-ft-s");
}

TEST(UnitEvidence, UpIsAgainstTheFallAlongAnAxisOnly) {
    UnitEvidence evidence;
    EXPECT_TRUE(proposeUpAxis(evidence).choice.empty());
    for (const char* axis : {"x", "y", "z", "-x", "-y", "-z"}) {
        Frame frame;
        frame.upAxis = axis;
        evidence.fall = FrameTransform(frame).pointInFile(Vec3(0.0, 0.0, -9.81));
        EXPECT_EQ(proposeUpAxis(evidence).choice, axis);
    }
    evidence.fall = Vec3(1.0, 0.0, -1.0);
    EXPECT_TRUE(proposeUpAxis(evidence).choice.empty());
}

TEST(UnitEvidence, FreeFallIsSeenInNodesThatNothingHoldsAndInNoOthers) {
    blocks::Block falling;
    falling.cells = {2, 2, 2};
    falling.size = Vec3(2.0, 2.0, 2.0);
    falling.gravity = standardGravity;
    falling.deathState = [](std::size_t) { return std::size_t{2}; };
    const auto fe = blocks::makeScene({falling}, 8, 0.1);
    UnitEvidence seen = evidenceOf(fe->contents());
    addSeenFall(seen, fe->contents(), Execution{});
    ASSERT_TRUE(seen.fall);
    EXPECT_TRUE(seen.freely);
    EXPECT_NEAR(seen.fall->z(), -standardGravity, 1e-6);
    EXPECT_LT(seen.fall->head<2>().norm(), 1e-6);
    EXPECT_EQ(proposeUnits(seen).choice, "kg-m-s");

    falling.deathState = [](std::size_t) { return blocks::never; };
    const auto whole = blocks::makeScene({falling}, 8, 0.1);
    UnitEvidence held = evidenceOf(whole->contents());
    addSeenFall(held, whole->contents(), Execution{});
    ASSERT_TRUE(held.fall) << "it comes down as a whole";
    EXPECT_FALSE(held.freely);
    EXPECT_NEAR(held.fall->z(), -standardGravity, 1e-6);
    EXPECT_EQ(proposeUpAxis(held).choice, "z");
}

TEST(UnitEvidence, EvidenceGoesBackIntoTheUnitsOfTheFile) {
    UnitEvidence evidence;
    evidence.densities = {{"wall", 2400.0}};
    evidence.size = 30.0;
    evidence.duration = 2.0;
    evidence.fall = Vec3(0.0, 0.0, -standardGravity);
    const FileUnits units = called("t-mm-s").units;
    Frame frame;
    frame.metresPerUnit = units.metres;
    frame.upAxis = "y";
    const UnitEvidence inFile = evidenceInFile(evidence, units, frame);
    EXPECT_NEAR(inFile.densities.front().value, 2.4e-9, 1e-20);
    EXPECT_NEAR(inFile.size, 30000.0, 1e-6);
    EXPECT_LT((*inFile.fall - Vec3(0.0, -9806.65, 0.0)).norm(), 1e-6);
    FileUnits unknownMass = units;
    unknownMass.kilograms = 0.0;
    EXPECT_TRUE(evidenceInFile(evidence, unknownMass, frame).densities.empty());
}

}  // namespace
}  // namespace rubble
