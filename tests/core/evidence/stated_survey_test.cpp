#include "core/evidence/surveys/stated_survey.h"

#include <gtest/gtest.h>

#include "core/evidence/evidence_list.h"
#include "core/evidence/no_evidence.h"
#include "tests/support/error_id.h"

namespace rubble {

namespace {

Outline squareFrom(double low, double high) {
    return {{{{{low, low}, {high, low}, {high, high}, {low, high}}}}};
}

/// A case of whose debris two places were cleared, on two days.
Case clearedCase() {
    Case theCase;
    theCase.removals.push_back({"north", "2021-06-25 12:00:00", squareFrom(0.0, 5.0)});
    theCase.removals.push_back({"south", "2021-06-27 08:00:00", squareFrom(10.0, 15.0)});
    return theCase;
}

TEST(StatedSurvey, TimesAreReadAsPeopleWriteThem) {
    EXPECT_EQ(clockTimeFrom("2021-06-25 16:30"), "2021-06-25 16:30:00");
    EXPECT_EQ(clockTimeFrom("2021-06-25T16:30:05"), "2021-06-25 16:30:05");
    for (const char* none :
         {"", "2021-06-25", "2021-06-31 16:30", "25.06.2021 16:30", "2021-06-25 25:30", "2021-06-25T16:30:05Z"}) {
        EXPECT_EQ(clockTimeFrom(none), "") << none;
    }
}

TEST(StatedSurvey, WhatWasRemovedByThenIsNotCompared) {
    const Case theCase = clearedCase();
    CaseInput survey;
    survey.scope.leftOut = squareFrom(20.0, 21.0);
    Findings said;
    survey.taken = "2021-06-24 10:00:00";
    EXPECT_EQ(scopeWhenTaken(theCase, survey, said), survey.scope) << "nothing was removed before the first day";
    EXPECT_TRUE(said.empty());
    survey.taken = "2021-06-26 10:00:00";
    SurveyScope scope = scopeWhenTaken(theCase, survey, said);
    ASSERT_EQ(scope.leftOut.polygons.size(), 2u);
    EXPECT_EQ(scope.leftOut.polygons[1], theCase.removals[0].area.polygons[0]);
    EXPECT_EQ(said.count("survey.removed"), 1);
    survey.taken = "2021-06-27 08:00:00";
    EXPECT_EQ(scopeWhenTaken(theCase, survey, said).leftOut.polygons.size(), 3u);
    survey.taken.clear();
    Findings open;
    EXPECT_EQ(scopeWhenTaken(theCase, survey, open), survey.scope);
    EXPECT_EQ(open.count("survey.removal_unknown"), 2);
}

TEST(StatedSurvey, WhatIsStatedStandsWhereNothingElseWasAskedFor) {
    CaseInput survey;
    survey.noise = 0.05;
    survey.registration.emplace().error = 0.03;
    SurveySettings settings;
    settings.noise = 0.1;
    Findings said;
    takeStated(settings, {}, survey, said);
    EXPECT_EQ(settings.noise, 0.1);
    EXPECT_EQ(settings.offsetError, 0.03) << "that of the registration, which all heights share";
    survey.offsetError = 0.2;
    SurveySettings other;
    takeStated(other, {}, survey, said);
    EXPECT_EQ(other.offsetError, 0.2);
    EXPECT_EQ(other.noise, 0.05);
    survey.registration->error.reset();
    survey.offsetError.reset();
    SurveySettings none;
    takeStated(none, {}, survey, said);
    EXPECT_EQ(none.offsetError, std::nullopt) << "what nobody stated is not known, never 0";
}

TEST(StatedSurvey, OneOfBeforeTheCollapseShowsNoDebris) {
    CaseInput survey;
    EXPECT_NO_THROW(checkShowsDebris(survey));
    survey.before = true;
    EXPECT_EQ(idOfError([&] { checkShowsDebris(survey); }), "survey.before");
}

TEST(StatedSurvey, OneOfAnInstantIsNotHeldAgainstWhatLiesAtRest) {
    CaseInput survey;
    EXPECT_NO_THROW(checkShowsRest(survey));
    survey.instant = 0.5;
    EXPECT_EQ(idOfError([&] { checkShowsRest(survey); }), "survey.not_at_rest");
}

TEST(EvidenceList, AKindThatWasSeenStandsBeforeTheEndingOfTheFile) {
    Case theCase;
    for (const auto& [path, kind] : {std::pair("points.xyz", SurveyKind::Cloud), std::pair("edge.dxf", SurveyKind::Outline),
                                     std::pair("grid.txt", SurveyKind::Heights)}) {
        theCase.inputs.push_back({path, InputRole::Survey, path, {}});
        theCase.inputs.back().kind = kind;
    }
    const std::vector<EvidenceRow> rows = evidenceOf(theCase);
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].form, EvidenceForm::Cloud);
    EXPECT_EQ(rows[1].form, EvidenceForm::Outline);
    EXPECT_EQ(rows[2].form, EvidenceForm::Heights);
}

TEST(EvidenceList, FilesOfOneContentAreOnePieceOfEvidence) {
    Case theCase;
    theCase.inputs = {{"fe-1", InputRole::Fe, "a.vtu", "aa"},
                      {"survey-1", InputRole::Survey, "x/scan.las", "bb"},
                      {"survey-2", InputRole::Survey, "other.las", "cc"},
                      {"survey-3", InputRole::Survey, "site.las", "bb"},
                      {"survey-4", InputRole::Survey, "a.las", "aa"},
                      {"survey-5", InputRole::Survey, "unknown.las", ""},
                      {"survey-6", InputRole::Survey, "unknown too.las", ""}};
    const Findings all = sameEvidence(theCase);
    ASSERT_EQ(all.count("evidence.same"), 1) << "an FE result is no evidence, and what is not known is not the same";
    EXPECT_EQ(englishText(all.list().front().what),
              "\"scan.las\" and \"site.las\" have the same content: they are one piece of evidence");
    EXPECT_EQ(sameEvidence(theCase, "survey-1").count("evidence.same"), 1) << "either one says so";
    EXPECT_EQ(sameEvidence(theCase, "survey-3").count("evidence.same"), 1);
    EXPECT_TRUE(sameEvidence(theCase, "survey-2").empty());
    theCase.inputs.push_back({"terrain-1", InputRole::Terrain, "valley.asc", "cc"});
    EXPECT_EQ(sameEvidence(theCase, "survey-2").count("evidence.is_terrain"), 1) << "the ground that debris falls on shows none";
    EXPECT_EQ(noEvidenceOf(sameEvidence(theCase)).count("evidence.is_terrain"), 1);
    EXPECT_EQ(sameEvidence(theCase, "survey-1").count("evidence.is_terrain"), 0);
}

TEST(EvidenceList, WhatSaysThatEvidenceIsNoneStandsFirst) {
    Findings findings;
    for (const char* id : {"survey.gaps", "evidence.same", "cloud.assumed", "evidence.of_this_run"}) {
        findings.add({id, id, {}}, {"remedy", "", {}}, "a.las", 3);
    }
    const Findings sorted = noEvidenceFirst(findings);
    ASSERT_EQ(sorted.list().size(), 4u);
    EXPECT_EQ(sorted.list()[0].what.id, "evidence.same");
    EXPECT_EQ(sorted.list()[1].what.id, "evidence.of_this_run");
    EXPECT_EQ(sorted.list()[2].what.id, "survey.gaps");
    EXPECT_EQ(sorted.count("cloud.assumed"), 3);
    EXPECT_EQ(noEvidenceOf(findings).list().size(), 2u);
    EXPECT_EQ(otherThanNoEvidence(findings).list().size(), 2u);
    EXPECT_EQ(pictureCautions(evidenceCautions(findings)), "evidence.same · evidence.of_this_run");
    // What makes the figures of the comparison doubtful follows it.
    findings.add({"terrain.height_unit", "taken as metres", {}}, {"remedy", "", {}});
    findings.add({"survey.fallen_unknown", "shows it or not", {}}, {"remedy", "", {}});
    const std::vector<Caution> cautions = evidenceCautions(findings);
    EXPECT_EQ(pictureCautions(cautions), "evidence.same · evidence.of_this_run · taken as metres · shows it or not");
    EXPECT_EQ(cautions.back().key, "evidence_doubt");
}

TEST(EvidenceList, SaysWhatEachIsHeldToShow) {
    Case theCase;
    theCase.inputs.push_back({"fe-1", InputRole::Fe, "a.vtu", {}});
    CaseInput cloud{"survey-1", InputRole::Survey, "site.LAZ", {}};
    cloud.registration.emplace().error = 0.02;
    cloud.taken = "2021-06-25 16:30:00";
    CaseInput before{"survey-2", InputRole::Survey, "before.tif", {}};
    before.before = true;
    CaseInput outline{"survey-3", InputRole::Survey, "outline.geojson", {}};
    outline.instant = 2.5;
    theCase.inputs.insert(theCase.inputs.end(), {cloud, before, outline, {"photograph-1", InputRole::Photograph, "a.jpg", {}}});
    Photograph& photograph = theCase.photographs.emplace_back();
    photograph.input = "photograph-1";
    photograph.masks.push_back({MaskClass::Debris, {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}});
    theCase.site.controlPoints = {{"a", Vec3::Zero(), Vec3::Zero()}, {"b", Vec3(10, 0, 0), Vec3(10, 0, 0)}};
    const std::vector<EvidenceRow> rows = evidenceOf(theCase);
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(rows[0].form, EvidenceForm::Cloud);
    EXPECT_NEAR(rows[0].within, 1.96 * 0.02, 1e-12);
    EXPECT_EQ(rows[0].says.id, "evidence.at_rest");
    EXPECT_EQ(rows[1].says.id, "evidence.before");
    EXPECT_TRUE(std::isnan(rows[1].within));
    EXPECT_EQ(rows[2].form, EvidenceForm::Outline);
    EXPECT_EQ(rows[2].says.id, "evidence.at");
    EXPECT_EQ(rows[3].form, EvidenceForm::Photograph);
    EXPECT_EQ(rows[3].says.id, "evidence.at_rest");
    EXPECT_EQ(rows[4].form, EvidenceForm::Points);
    EXPECT_TRUE(std::isnan(rows[4].within)) << "two points leave nothing to judge by";
}

TEST(EvidenceList, MeasuredPointsSayWhatTheyAreHeldToSay) {
    Case theCase;
    CaseInput points{"survey-1", InputRole::Survey, "station.csv", {}};
    points.kind = SurveyKind::Points;
    theCase.inputs.push_back(points);
    const auto row = [&](PointsHeld held, std::optional<double> instant = {}) {
        theCase.inputs[0].held = held;
        theCase.inputs[0].instant = instant;
        return evidenceOf(theCase).front();
    };
    EXPECT_EQ(row(PointsHeld::Section).says.id, "evidence.measured");
    EXPECT_EQ(row(PointsHeld::Outline).says.id, "evidence.edge");
    EXPECT_EQ(row(PointsHeld::Outline, 2.5).says.id, "evidence.edge_at");
    EXPECT_EQ(row(PointsHeld::Control).says.id, "evidence.control");
    EXPECT_EQ(row(PointsHeld::Control).held, PointsHeld::Control);
    EXPECT_FALSE(row(PointsHeld::Control).byEnding);
    EXPECT_FALSE(hasOverlap(theCase.inputs[0]));
    EXPECT_THROW(checkShowsDebris(theCase.inputs[0]), UsageError);
    theCase.inputs[0].held = PointsHeld::Outline;
    EXPECT_TRUE(hasOverlap(theCase.inputs[0]));
    EXPECT_NO_THROW(checkShowsDebris(theCase.inputs[0]));
    theCase.inputs[0].kind.reset();
    EXPECT_TRUE(evidenceOf(theCase).front().byEnding) << "nobody looked into it";
    EXPECT_FALSE(evidenceOf(theCase).front().held);
}

}  // namespace

}  // namespace rubble
