#include "core/evidence/ensembles/cause_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/evidence/ensembles/evidence_noise.h"

namespace rubble {
namespace {

/// Debris over a square of cells, of one height.
MemberSurface patch(std::int32_t i0, std::int32_t j0, std::int32_t side, float height) {
    MemberSurface surface;
    for (std::int32_t j = j0; j < j0 + side; ++j) {
        for (std::int32_t i = i0; i < i0 + side; ++i) {
            surface.cells.push_back({j, i});
            surface.heights.push_back(height);
            surface.masses.push_back(2000.0F * height);
            surface.covered.push_back(1.0F);
        }
    }
    return surface;
}

SurfaceEvidence evidenceOf(const MemberSurface& surface, EvidenceKind kind) {
    SurfaceEvidence evidence;
    evidence.name = "survey";
    evidence.kind = kind;
    evidence.seen = surface;
    return evidence;
}

EnsembleReport ensembleOf(const std::vector<MemberSurface>& surfaces) {
    EnsembleReport report;
    report.surface.cell = 1.0;
    report.settings.members = static_cast<std::int64_t>(surfaces.size());
    for (const MemberSurface& surface : surfaces) {
        EnsembleMember& member = report.members.emplace_back();
        member.number = static_cast<std::int64_t>(report.members.size()) - 1;
        member.done = true;
        member.surface = std::make_shared<const MemberSurface>(surface);
    }
    report.complete = true;
    return report;
}

/// Members whose patch lies around a place and scatters by some cells.
Hypothesis scattering(const std::string& name, int at, int scatter, unsigned seed, int members = 12) {
    std::mt19937 random(seed);
    std::vector<MemberSurface> surfaces;
    for (int m = 0; m < members; ++m) {
        const int by = static_cast<int>(random() % static_cast<unsigned>(2 * scatter + 1)) - scatter;
        const float height = 1.0F + 0.1F * static_cast<float>(random() % 3);
        surfaces.push_back(patch(at + by, static_cast<int>(random() % 3), 10, height));
    }
    return {name, std::make_shared<const EnsembleReport>(ensembleOf(surfaces))};
}

TEST(CauseComparison, DeparturesAreThoseOfClosedForms) {
    const MemberSurface a = patch(0, 0, 10, 2.0F);
    const MemberSurface b = patch(5, 0, 10, 1.0F);
    // 50 cells in both, 150 in either.
    EXPECT_NEAR(departureFrom(evidenceOf(a, EvidenceKind::Footprint), b), 1.0 - 50.0 / 150.0, 1e-12);
    // 50 of 2 m, 50 of 1 m difference, 50 of 1 m; both hold 200 and 100.
    EXPECT_NEAR(departureFrom(evidenceOf(a, EvidenceKind::Heights), b), 200.0 / 300.0, 1e-6);
    EXPECT_EQ(departureFrom(evidenceOf(a, EvidenceKind::Heights), a), 0.0);
    EXPECT_TRUE(std::isnan(departureFrom(evidenceOf({}, EvidenceKind::Footprint), MemberSurface())));
}

TEST(CauseComparison, OnlyWhatWasLookedAtCounts) {
    SurfaceEvidence evidence = evidenceOf(patch(0, 0, 10, 1.0F), EvidenceKind::Footprint);
    evidence.everywhere = false;
    evidence.looked = patch(0, 0, 5, 1.0F).cells;
    EXPECT_EQ(departureFrom(evidence, patch(0, 0, 5, 1.0F)), 0.0);
    EXPECT_EQ(departureFrom(evidence, patch(40, 40, 5, 1.0F)), 1.0);
}

TEST(CauseComparison, AnOutlineCoversHalfOfACellOnBothSides) {
    // Debris reaches by a tenth, or by six tenths, into the cells around a square.
    for (const float part : {0.1F, 0.6F}) {
        MemberSurface debris = patch(0, 0, 10, 1.0F);
        for (std::size_t c = 0; c < debris.cells.size(); ++c) {
            const MapCell at = debris.cells[c];
            debris.covered[c] = std::min({at.i, at.j, 9 - at.i, 9 - at.j}) == 0 ? part : 1.0F;
        }
        const MemberSurface covered = part < 0.5F ? patch(1, 1, 8, 1.0F) : patch(0, 0, 10, 1.0F);
        SurfaceEvidence outline = evidenceOf(covered, EvidenceKind::Footprint);
        EXPECT_EQ(departureFrom(outline, debris), 0.0) << part;
        EXPECT_EQ(departureFrom(seenAs(debris, outline), covered), 0.0) << "the same the other way";
        // A map of our own has all cells that debris reaches into.
        outline = evidenceOf(patch(0, 0, 10, 1.0F), EvidenceKind::Footprint);
        outline.reached = true;
        EXPECT_EQ(departureFrom(outline, debris), 0.0) << part;
    }
}

TEST(CauseComparison, HeightsBelowTheLeastAreGroundOnBothSides) {
    SurfaceEvidence evidence = evidenceOf(patch(0, 0, 10, 2.0F), EvidenceKind::Heights);
    evidence.least = 0.3;
    MemberSurface low = patch(20, 0, 10, 0.2F);
    EXPECT_EQ(departureFrom(evidence, low), 1.0) << "it counts nowhere";
    EXPECT_TRUE(std::isnan(departureFrom(seenAs(low, evidence), low)));
    MemberSurface both = patch(0, 0, 10, 2.0F);
    for (const std::int32_t i : {20, 21}) {
        both.cells.push_back({9, i});
        both.heights.push_back(0.2F);
        both.covered.push_back(1.0F);
    }
    EXPECT_EQ(departureFrom(evidence, both), 0.0);
    both.heights.back() = 0.4F;
    EXPECT_NEAR(departureFrom(evidence, both), 0.4 / 400.4, 1e-6);
}

/// Heights of a square of 60 cells with noise, debris as given among them.
SurfaceEvidence surveyOf(const MemberSurface& debris, double noise, double offset, std::int32_t margin = 25, unsigned seed = 11) {
    std::mt19937 random(seed);
    std::normal_distribution<double> error(offset, noise);
    SurfaceEvidence evidence = evidenceOf({}, EvidenceKind::Heights);
    for (std::int32_t j = -margin; j < 10 + margin; ++j) {
        for (std::int32_t i = -margin; i < 10 + margin; ++i) {
            const std::ptrdiff_t at = debris.find({j, i});
            const double height = at >= 0 ? double{debris.heights[static_cast<std::size_t>(at)]} : 0.0;
            evidence.seen.cells.push_back({j, i});
            evidence.seen.heights.push_back(static_cast<float>(height + error(random)));
        }
    }
    evidence.surveyed = true;
    evidence.everywhere = false;
    evidence.looked = evidence.seen.cells;
    evidence.least = 0.05;
    return evidence;
}

TEST(CauseComparison, HeightsCountFromTheLevelOfDetectionOn) {
    const std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, 1), scattering("east", 3, 1, 2)};
    CauseEvidence evidence;
    evidence.surfaces.push_back(surveyOf(patch(0, 1, 10, 1.1F), 0.1, 0.0));
    Findings said;
    const SurfaceEvidence held = withDetection(evidence, hypotheses, said).surfaces.front();
    EXPECT_NEAR(held.least, 1.96 * 0.1, 0.02) << "of some 3,000 cells";
    EXPECT_EQ(said.count("evidence.detection"), 1);
    EXPECT_EQ(said.list().size(), 1u);
    // Noise over a field of thirty times the area of the debris is not taken for debris.
    EXPECT_LT(departureFrom(held, patch(0, 1, 10, 1.1F)), 0.15);
    EXPECT_GT(departureFrom(evidence.surfaces.front(), patch(0, 1, 10, 1.1F)), 0.35) << "as it was without";
    const CauseComparison made = compareCauses(hypotheses, evidence);
    EXPECT_EQ(made.hypotheses[made.ranking.causes.front().hypothesis], "west");
    EXPECT_EQ(made.findings.count("evidence.detection"), 1);

    evidence.surfaces.front().noise = 0.2;
    evidence.surfaces.front().groundNoise = 0.0;
    Findings stated;
    EXPECT_NEAR(withDetection(evidence, hypotheses, stated).surfaces.front().least, 1.96 * 0.2, 1e-9);
    EXPECT_EQ(englishText(stated.list().front().what),
              "heights count from 0.392 m on; the level of detection (95 %) is 0.392 m, of the stated noise of 0.2 m");
    // Less noise than what nobody would call debris lets no lower height count.
    evidence.surfaces.front().noise = 0.01;
    Findings fine;
    withDetection(evidence, hypotheses, fine);
    EXPECT_EQ(englishText(fine.list().front().what),
              "heights count from 0.05 m on; the level of detection (95 %) is 0.0196 m, of the stated noise of 0.01 m");
}

// What a survey adds to the departure of the true cause is no other cause.
TEST(CauseComparison, TheNoiseOfASurveyIsSeldomTakenForSomethingElse) {
    int outside = 0;
    const int trials = 100;
    for (int t = 0; t < trials; ++t) {
        const auto seed = static_cast<unsigned>(5000 + 3 * t);
        const std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, seed, 10), scattering("east", 60, 1, seed + 1, 10)};
        const Hypothesis truth = scattering("truth", 0, 1, seed + 2, 1);
        CauseEvidence evidence;
        evidence.surfaces.push_back(surveyOf(*truth.ensemble->members.front().surface, 0.4, 0.0, 15, seed));
        evidence.surfaces.front().noise = 0.4;
        evidence.surfaces.front().groundNoise = 0.0;
        outside += compareCauses(hypotheses, evidence).unexplained ? 1 : 0;
    }
    EXPECT_LE(outside, 5) << "1 % is meant; without the noise on members it was more than half";
}

TEST(CauseComparison, SaysWhatItDoesNotKnowOfASurvey) {
    const std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, 1), scattering("east", 3, 1, 2)};
    CauseEvidence evidence;
    evidence.surfaces.push_back(surveyOf(patch(0, 1, 10, 1.1F), 0.1, 0.0, 3));
    Findings close;
    EXPECT_EQ(withDetection(evidence, hypotheses, close).surfaces.front().least, 0.05);
    EXPECT_EQ(close.count("evidence.noise_unknown"), 1) << "it ends beside the debris";
    evidence.surfaces.front() = surveyOf(patch(0, 1, 10, 1.1F), 0.05, -0.5);
    Findings low;
    withDetection(evidence, hypotheses, low);
    ASSERT_EQ(low.count("evidence.offset"), 1);
    EXPECT_NE(englishText(low.list().back().what).find("below the ground"), std::string::npos);
    // An outline and a map of our own have no noise.
    evidence.surfaces.front() = evidenceOf(patch(0, 0, 10, 1.0F), EvidenceKind::Heights);
    Findings none;
    EXPECT_EQ(withDetection(evidence, hypotheses, none).surfaces.front().least, 0.0);
    EXPECT_TRUE(none.empty());
}

TEST(CauseComparison, SaysWhatLiesApartFromAllHypotheses) {
    const std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, 1), scattering("east", 30, 1, 2)};
    CauseEvidence evidence;
    MemberSurface seen = patch(0, 1, 10, 1.1F);
    const MemberSurface truck = patch(3, 30, 3, 2.0F);
    for (std::size_t c = 0; c < truck.cells.size(); ++c) {
        seen.cells.push_back(truck.cells[c]);
        seen.heights.push_back(truck.heights[c]);
        seen.covered.push_back(1.0F);
    }
    for (const EvidenceKind kind : {EvidenceKind::Footprint, EvidenceKind::Heights}) {
        evidence.surfaces = {evidenceOf(seen, kind)};
        const CauseComparison made = compareCauses(hypotheses, evidence);
        EXPECT_EQ(made.findings.count("causes.apart"), 1);
        evidence.surfaces.front().leftOut = truck.cells;
        EXPECT_EQ(compareCauses(hypotheses, evidence).findings.count("causes.apart"), 0) << "left out of the comparison";
    }
}

TEST(CauseComparison, NamesTheCauseAndWhereItShows) {
    const std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, 1), scattering("east", 30, 1, 2)};
    CauseEvidence evidence;
    evidence.surfaces.push_back(evidenceOf(patch(30, 1, 10, 1.1F), EvidenceKind::Footprint));
    const CauseComparison made = compareCauses(hypotheses, evidence);
    EXPECT_TRUE(made.ranking.decided());
    EXPECT_EQ(made.hypotheses[made.ranking.causes.front().hypothesis], "east");
    EXPECT_EQ(made.verdict.id, "causes.told_outline") << "an outline does not show that there is no other cause";
    EXPECT_TRUE(made.alike.empty());
    EXPECT_GT(made.fit, 0.05) << "as like its members as they are each other";
    EXPECT_FALSE(made.unexplained);
    EXPECT_TRUE(made.findings.empty());
    ASSERT_TRUE(made.separation && made.place);
    EXPECT_EQ(made.separation->hypotheses, (std::vector<std::string>{"east", "west"}));
    // Debris in the east and none in the west speak for the east.
    const std::vector<double>& says = made.separation->layer(MapLayer::Separation);
    for (std::size_t c = 0; c < says.size(); ++c) {
        if (made.separation->cells[c].j >= 2 && made.separation->cells[c].j < 10) {
            const int i = made.separation->cells[c].i;
            EXPECT_TRUE(i < 1 || (i >= 9 && i < 31) || i >= 39 || says[c] > 0.0) << i;
        }
    }
    EXPECT_EQ(made.separation->present(), std::vector<MapLayer>{MapLayer::Separation});
}

TEST(CauseComparison, HeightsSeparateWhereBothHaveDebris) {
    std::vector<MemberSurface> low;
    std::vector<MemberSurface> high;
    for (int m = 0; m < 12; ++m) {
        low.push_back(patch(0, 0, 10, 1.0F + 0.01F * static_cast<float>(m)));
        high.push_back(patch(0, 0, 10, 3.0F + 0.01F * static_cast<float>(m)));
    }
    const std::vector<Hypothesis> hypotheses{{"low", std::make_shared<const EnsembleReport>(ensembleOf(low))},
                                             {"high", std::make_shared<const EnsembleReport>(ensembleOf(high))}};
    CauseEvidence evidence;
    evidence.surfaces.push_back(evidenceOf(patch(0, 0, 10, 2.9F), EvidenceKind::Heights));
    const CauseComparison made = compareCauses(hypotheses, evidence);
    EXPECT_EQ(made.hypotheses[made.ranking.causes.front().hypothesis], "high");
    for (const double says : made.separation->layer(MapLayer::Separation)) {
        EXPECT_NEAR(says, std::log(12.5 / 0.5), 1e-9) << "all of one are higher than half of all, none of the other";
    }
    ASSERT_TRUE(made.place);
    EXPECT_NEAR(made.place->area, 50.0, 1.0);
}

TEST(CauseComparison, SaysWhenTheEvidenceDoesNotSeparate) {
    const std::vector<Hypothesis> hypotheses{scattering("a", 0, 4, 3), scattering("b", 1, 4, 4), scattering("far", 40, 1, 5)};
    CauseEvidence evidence;
    evidence.surfaces.push_back(evidenceOf(patch(0, 1, 10, 1.1F), EvidenceKind::Footprint));
    const CauseComparison made = compareCauses(hypotheses, evidence);
    EXPECT_FALSE(made.ranking.decided());
    EXPECT_EQ(made.verdict.id, "causes.not_told");
    ASSERT_EQ(made.alike.size(), 1u);
    EXPECT_NE(made.alike.front(), "far");
}

TEST(CauseComparison, SaysWhenNoneOfThemFits) {
    const std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, 1), scattering("east", 30, 1, 2)};
    CauseEvidence evidence;
    evidence.surfaces.push_back(evidenceOf(patch(80, 80, 10, 1.0F), EvidenceKind::Footprint));
    const CauseComparison made = compareCauses(hypotheses, evidence);
    EXPECT_LT(made.fit, 1e-4);
    EXPECT_TRUE(made.unexplained);
    EXPECT_EQ(made.verdict.id, "causes.not_told_none");
    EXPECT_EQ(made.findings.count("causes.no_fit"), 1);
    EXPECT_EQ(made.findings.count("causes.apart"), 1);
    EXPECT_EQ(made.findings.list().size(), 2u);
    EXPECT_FALSE(made.ranking.decided());
}

TEST(CauseComparison, SaysThatFewMembersCannotJudge) {
    const std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, 1, 2), scattering("east", 30, 1, 2, 2)};
    CauseEvidence evidence;
    evidence.surfaces.push_back(evidenceOf(patch(80, 80, 10, 1.0F), EvidenceKind::Footprint));
    const CauseComparison made = compareCauses(hypotheses, evidence);
    EXPECT_FALSE(made.unexplained);
    EXPECT_EQ(made.findings.count("causes.few_members"), 1);
}

TEST(CauseComparison, WhatIsSaidAgainstAPhotographIsSaidHere) {
    std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, 1), scattering("east", 30, 1, 2)};
    for (Hypothesis& hypothesis : hypotheses) {
        EnsembleReport looked = *hypothesis.ensemble;
        for (EnsembleMember& member : looked.members) {
            member.looked = {hypothesis.name == "west" ? 0.2 : 0.6};
        }
        hypothesis.ensemble = std::make_shared<const EnsembleReport>(std::move(looked));
    }
    CauseEvidence evidence;
    PhotoEvidence& photo = evidence.photographs.emplace_back();
    photo.name = "north.jpg";
    photo.match.verdict = MatchVerdict::Good;
    EXPECT_TRUE(compareCauses(hypotheses, evidence).findings.empty());
    for (Hypothesis& hypothesis : hypotheses) {
        EnsembleReport few = *hypothesis.ensemble;
        few.members.resize(3);
        hypothesis.ensemble = std::make_shared<const EnsembleReport>(std::move(few));
    }
    const Findings few = compareCauses(hypotheses, evidence).findings;
    EXPECT_EQ(few.count("causes.few_members"), 0) << "photographs are not judged by, whatever the members";
    EXPECT_EQ(few.list().size(), 1u);
    EXPECT_EQ(few.count("causes.too_few_to_tell"), 1);
    photo.match.verdict = MatchVerdict::Poor;
    EXPECT_EQ(compareCauses(hypotheses, evidence).findings.count("caution.poor_camera"), 1);
}

TEST(CauseComparison, TheClosestOfWrongCausesIsNotNamed) {
    const std::vector<Hypothesis> hypotheses{scattering("near", 0, 1, 1), scattering("far", 30, 1, 2)};
    CauseEvidence evidence;
    evidence.surfaces.push_back(evidenceOf(patch(7, 1, 10, 1.1F), EvidenceKind::Footprint));
    const CauseComparison made = compareCauses(hypotheses, evidence);
    EXPECT_TRUE(made.ranking.decided()) << "it is told from the other";
    EXPECT_EQ(made.hypotheses[made.ranking.causes.front().hypothesis], "near");
    EXPECT_TRUE(made.unexplained) << made.fit;
    EXPECT_EQ(made.verdict.id, "causes.closest_only");
}

TEST(CauseComparison, AMemberMoreIsSeldomTakenForSomethingElse) {
    // As many members as a small ensemble has, and one more of the same kind as evidence, with two pieces.
    int outside = 0;
    const int trials = 300;
    for (int t = 0; t < trials; ++t) {
        const auto seed = static_cast<unsigned>(1000 + 3 * t);
        const std::vector<Hypothesis> hypotheses{scattering("west", 0, 3, seed, 10), scattering("east", 60, 3, seed + 1, 10)};
        const Hypothesis truth = scattering("truth", 0, 3, seed + 2, 1);
        CauseEvidence evidence;
        for (const EvidenceKind kind : {EvidenceKind::Footprint, EvidenceKind::Heights}) {
            evidence.surfaces.push_back(evidenceOf(*truth.ensemble->members.front().surface, kind));
        }
        outside += compareCauses(hypotheses, evidence).unexplained ? 1 : 0;
    }
    EXPECT_LE(outside, 0.03 * trials) << "1 % is meant; three times that for what is no normal distribution";
}

TEST(CauseComparison, BlindTestFindsWhatCanBeFound) {
    const std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, 1), scattering("east", 30, 1, 2),
                                             scattering("north", 60, 1, 6)};
    for (const EvidenceKind kind : {EvidenceKind::Footprint, EvidenceKind::Heights}) {
        const BlindTest test = blindTest(hypotheses, kind, Execution());
        EXPECT_EQ(test.trials(), 36);
        EXPECT_EQ(test.right(), 36);
        EXPECT_EQ(test.wrong(), 0);
        EXPECT_EQ(test.noticed, (std::vector<std::int64_t>{12, 12, 12})) << "they lie far apart";
    }
    const std::vector<Hypothesis> alike{scattering("a", 0, 3, 1), scattering("b", 0, 3, 2)};
    const BlindTest test = blindTest(alike, EvidenceKind::Footprint, Execution());
    EXPECT_LE(test.wrong(), 2) << "one cause under two names";
    EXPECT_EQ(test.trials(), 24);
    EXPECT_LE(test.noticed[0] + test.noticed[1], 2) << "the other name stands for the same";
    const std::vector<Hypothesis> few{scattering("a", 0, 1, 1, 5), scattering("b", 30, 1, 2, 5)};
    EXPECT_TRUE(blindTest(few, EvidenceKind::Footprint, Execution()).noticed.empty());
}

TEST(CauseComparison, SaysHowManyMembersItTakesToNameACause) {
    const int needed = static_cast<int>(membersToTell(2, 1));
    EXPECT_GT(needed, 3);
    EXPECT_GT(membersToTell(6), membersToTell(2)) << "all intervals hold together";
    const auto clear = [](int members) {
        return std::vector<Hypothesis>{scattering("a", 0, 1, 1, members), scattering("b", 60, 1, 2, members)};
    };
    const BlindTest enough = blindTest(clear(needed), EvidenceKind::Footprint, Execution());
    EXPECT_EQ(enough.right(), 2 * needed);
    EXPECT_TRUE(enough.findings.empty());
    const BlindTest few = blindTest(clear(needed - 1), EvidenceKind::Footprint, Execution());
    EXPECT_EQ(few.right(), 0) << "however clear the evidence is";
    EXPECT_EQ(few.findings.count("causes.too_few_to_tell"), 1);
}

TEST(CauseComparison, RefusesWhatCannotBeCompared) {
    std::vector<Hypothesis> hypotheses{scattering("west", 0, 1, 1), scattering("east", 30, 1, 2)};
    EXPECT_THROW(compareCauses(hypotheses, CauseEvidence()), UsageError);
    EnsembleReport other = *hypotheses[1].ensemble;
    other.surface.cell = 2.0;
    hypotheses[1].ensemble = std::make_shared<const EnsembleReport>(other);
    CauseEvidence evidence;
    evidence.surfaces.push_back(evidenceOf(patch(0, 0, 3, 1.0F), EvidenceKind::Footprint));
    EXPECT_THROW(compareCauses(hypotheses, evidence), UsageError);
    EXPECT_THROW(blindTest(hypotheses, EvidenceKind::Footprint, Execution()), UsageError);
}

TEST(ProbabilityMap, IsThatOfClosedForm) {
    // Two of four members reach a cell, of 1 and 3 m; one reaches another.
    EnsembleReport report = ensembleOf({patch(0, 0, 1, 1.0F), patch(0, 0, 1, 3.0F), patch(1, 0, 1, 0.3F), MemberSurface()});
    const DebrisMap map = probabilityMap(report, {0.25, 0.5, 2.0});
    ASSERT_EQ(map.cells.size(), 2u);
    EXPECT_EQ(map.members, 4);
    EXPECT_EQ(map.layer(MapLayer::Probability), (std::vector<double>{0.5, 0.25}));
    EXPECT_EQ(map.layer(MapLayer::AboveFirst), (std::vector<double>{0.5, 0.25}));
    EXPECT_EQ(map.layer(MapLayer::AboveSecond), (std::vector<double>{0.5, 0.0}));
    EXPECT_EQ(map.layer(MapLayer::AboveThird), (std::vector<double>{0.25, 0.0}));
    // Heights 0, 0, 1, 3: linear between ranks.
    EXPECT_NEAR(map.layer(MapLayer::HeightMiddle)[0], 0.5, 1e-6);
    EXPECT_NEAR(map.layer(MapLayer::HeightHigh)[0], 1.0 + 0.85 * 2.0, 1e-6);
    EXPECT_NEAR(map.layer(MapLayer::MassMiddle)[0], 1000.0, 1e-3);
    EXPECT_NEAR(map.layer(MapLayer::ProbabilityError)[0], std::sqrt(0.5 * 0.5 / 8.0), 1e-12);
    EXPECT_FALSE(map.has(MapLayer::Mass));
    EXPECT_FALSE(map.has(MapLayer::Separation));
    EXPECT_EQ(englishText(mapLayerTitle(map, MapLayer::AboveThird)), "Probability of debris higher than 2 m");
    EXPECT_THROW(probabilityMap(report, {1.0, 0.5, 2.0}), UsageError);
    EXPECT_THROW(probabilityMap(EnsembleReport(), usualThresholds), UsageError);
}

TEST(ProbabilityMap, SettlesAsMembersAreAdded) {
    std::vector<MemberSurface> surfaces;
    std::mt19937 random(9);
    for (int m = 0; m < 24; ++m) {
        surfaces.push_back(patch(static_cast<int>(random() % 6), 0, 8, 1.0F));
    }
    const EnsembleReport report = ensembleOf(surfaces);
    const std::vector<ConvergenceRow> rows = convergenceOf(report);
    ASSERT_EQ(rows.size(), 5u) << "2, 4, 8, 16 and all 24";
    EXPECT_EQ(rows.back().members, 24u);
    for (std::size_t k = 1; k < rows.size(); ++k) {
        EXPECT_LT(rows[k].worstError, rows[k - 1].worstError);
    }
}

/// Members that lie alike and reach a place at x = 20 m at times around one, 2 s after their first debris.
Hypothesis reaching(const std::string& name, double at, unsigned seed, int members = 12) {
    std::mt19937 random(seed);
    EnsembleReport report = ensembleOf(std::vector<MemberSurface>(static_cast<std::size_t>(members), patch(0, 0, 10, 1.0F)));
    for (EnsembleMember& member : report.members) {
        const double by = 0.001 * static_cast<double>(random() % 1000) - 0.5;
        member.arrivals.squares = {{0, 0, 2.0}, {0, 20, 2.0 + at + by}};
    }
    return {name, std::make_shared<const EnsembleReport>(std::move(report))};
}

TEST(CauseComparison, ATimeDepartsByWhatLiesBeyondItsAccuracy) {
    DebrisArrivals arrivals;
    arrivals.squares = {{0, 0, 2.0}, {0, 20, 5.0}};
    const TimeEvidence at{"witness", {20.5, 0.5}, 3.0, 3.4, 0.5};
    EXPECT_EQ(departureFrom(at, arrivals), 0.0) << "3 s after the first";
    TimeEvidence late = at;
    late.time = 5.5;
    EXPECT_NEAR(departureFrom(late, arrivals), 2.0 / 3.0, 1e-12);
    late.place = {90.0, 0.0};
    EXPECT_EQ(departureFrom(late, arrivals), 1.0) << "none came there";
    EXPECT_TRUE(std::isnan(departureFrom(at, DebrisArrivals())));
    EXPECT_EQ(timesApart(std::nan(""), std::nan(""), 0.5), 0.0);
}

TEST(CauseComparison, TimesTellCausesThatLieAlikeAndNoticeOneThatIsLeftOut) {
    const std::vector<Hypothesis> hypotheses{reaching("early", 1.0, 1), reaching("late", 6.0, 2)};
    CauseEvidence evidence;
    evidence.times.push_back({"video", {20.5, 0.5}, 3.0, 6.1, 0.5});
    const CauseComparison made = compareCauses(hypotheses, evidence);
    EXPECT_TRUE(made.ranking.decided());
    EXPECT_EQ(made.hypotheses[made.ranking.causes.front().hypothesis], "late");
    EXPECT_EQ(made.kinds.front(), EvidenceKind::Time);
    EXPECT_EQ(made.evidence.front(), "video");
    EXPECT_FALSE(made.unexplained) << made.fit;
    EXPECT_EQ(made.verdict.id, "causes.told_time");
    // Neither: closer to one of them than to the other, but where none of its members comes.
    evidence.times.front().time = 9.0;
    const CauseComparison none = compareCauses(hypotheses, evidence);
    EXPECT_TRUE(none.unexplained) << none.fit;
    // A time that says little notices nothing.
    evidence.times.front().accuracy = 4.0;
    EXPECT_FALSE(compareCauses(hypotheses, evidence).unexplained);
}

}  // namespace
}  // namespace rubble
