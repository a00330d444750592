#include "core/evidence/cautions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

const Caution* find(const std::vector<Caution>& list, std::string_view key) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Caution& each) { return each.key == key; });
    return found == list.end() ? nullptr : &*found;
}

RunStanding rested() {
    RunStanding run;
    run.reached = 9.5;
    run.fragments = 500;
    run.bodies = 40;
    return run;
}

HealthBreach outside() {
    HealthBreach breach;
    breach.check = HealthCheck::OutsideSite;
    breach.worst = 300.0;
    breach.limit = 200.0;
    return breach;
}

TEST(Cautions, ASoundRunThatRestsSaysThatItIsOneAndHowManyBodiesItHas) {
    const std::vector<Caution> list = runCautions(rested());
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(list[0].key, "single_run");
    EXPECT_EQ(list[1].key, "bodies");
    EXPECT_EQ(list[1].grade, HealthGrade::Notice);
    EXPECT_EQ(englishText(list[1].what), "bodies that carry the fragments: 40 for 500");
    EXPECT_EQ(pictureCautions(list),
              "one set of assumptions: what is not known of friction, restitution and births is not in these figures");
}

TEST(Cautions, SayWhatMassesRestOnAndThatDebrisBeganAtRest) {
    Findings findings;
    const Message density{"components.assumed_density", "No density is known: {0} is assumed", {{2400.0, "kg/m3"}}};
    findings.add(density, {"r", "set it", {}}, "element 1", 300);
    findings.add(density, {"r", "set it", {}}, "element 301", 100);
    findings.add({"components.assumed_thickness", "No thickness is known: {0} is assumed", {{0.02, "m"}}}, {"r", "set it", {}}, "",
                 68);
    findings.add({"fragments.no_death_time", "another", {}}, {"r", "set it", {}});
    RunStanding run = rested();
    run.assumed = assumedMasses(findings);
    run.bornAtRest = true;
    const std::vector<Caution> list = runCautions(run);
    EXPECT_EQ(pictureCautions(list).find("masses are assumed: no density is known of 400 elements, and 2,400 kg/m3 was taken") !=
                  std::string::npos,
              true)
        << pictureCautions(list);
    EXPECT_NE(pictureCautions(list).find("no thickness is known of 68 elements, and 0.02 m was taken"), std::string::npos);
    ASSERT_NE(find(list, "born_at_rest"), nullptr);
    EXPECT_TRUE(find(list, "born_at_rest")->inPictures());
    EXPECT_EQ(std::ranges::count(list, std::string_view("assumed"), &Caution::key), 2);
}

TEST(Cautions, SayWhichBirthsWereGuessed) {
    Findings findings;
    findings.add({"fragments.no_velocity", "one", {}}, {"r", "set it", {}}, "", 12);
    findings.add({"fragments.part_velocity", "another", {}}, {"r", "set it", {}}, "", 3);
    findings.add({"fragments.death_time_outside", "a third", {}}, {"r", "set it", {}}, "", 5);
    findings.add({"components.implausible_density", "No material has this density: they have {0} to {1}", {10.0, 23000.0}},
                 {"r", "set it", {}}, "", 40);
    RunStanding run = rested();
    tellInputs(run, findings, BirthVelocity::Fe);
    const std::vector<Caution> list = runCautions(run);
    const std::string words = pictureCautions(list);
    EXPECT_NE(words.find("the velocity of 12 elements at their death is not known: their fragments began at rest"),
              std::string::npos)
        << words;
    EXPECT_NE(words.find("of 3 elements the velocity of some corners is not known"), std::string::npos) << words;
    EXPECT_NE(words.find("the time of death of 5 elements lies outside"), std::string::npos) << words;
    EXPECT_NE(words.find("40 elements have a density that no material has"), std::string::npos) << words;
    EXPECT_EQ(find(list, "born_at_rest"), nullptr);

    tellInputs(run, findings, BirthVelocity::Rest);
    const std::vector<Caution> resting = runCautions(run);
    ASSERT_NE(find(resting, "born_at_rest"), nullptr);
    EXPECT_EQ(std::ranges::count(resting, std::string_view("birth_doubt"), &Caution::key), 1) << "all began at rest anyway";
}

TEST(Cautions, SayWhatMovesWhatWasStoppedAndWhatIsTainted) {
    RunStanding run = rested();
    run.moving = 12;
    run.complete = false;
    run.breaches = {outside(), outside()};
    const std::vector<Caution> list = runCautions(run);
    ASSERT_NE(find(list, "tainted"), nullptr);
    EXPECT_EQ(englishText(find(list, "tainted")->what),
              "tainted: 1 limit of health passed, far outside the site, and nobody vouches for the run");
    EXPECT_EQ(list.front().key, "tainted") << "the gravest first";
    EXPECT_EQ(englishText(find(list, "not_complete")->what),
              "not complete: the run goes up to 9.5 s, what comes later is not in it");
    EXPECT_EQ(englishText(find(list, "still_moving")->what),
              "not all at rest: at 9.5 s, the last instant, 12 of 40 bodies still moved");
    // Beside what shows an earlier instant it says what moved then.
    run.earlier = 3.25;
    EXPECT_EQ(englishText(find(runCautions(run), "still_moving")->what),
              "not all at rest: at 3.25 s, the instant that is shown, 12 of 40 bodies moved");
    run.earlier.reset();
    run.acknowledged = true;
    EXPECT_EQ(find(runCautions(run), "tainted"), nullptr);
    // What the status bar says stands below pictures too, whatever its grade.
    EXPECT_TRUE((Caution{"limits_passed", HealthGrade::Notice, {}}).inPictures());
    EXPECT_EQ(englishText(find(runCautions(run), "limits_passed")->what),
              "1 limit of health passed, acknowledged: far outside the site");
}

TEST(Cautions, WhatMakesEveryPlaceUncertainIsToldOnce) {
    Findings findings;
    findings.add({"terrain.spikes", "{0} spikes", {3}}, {});
    findings.add({"terrain.filled", "{0} of {1} were filled", {10, 1000}}, {});
    EXPECT_TRUE(placeDoubts(findings).empty()) << "one place in a hundred";
    findings.add({"site.way_accuracy", "good to {0}", {{5.0, "m"}}}, {});
    RunStanding run = rested();
    run.placeDoubts = placeDoubts(findings);
    std::vector<Caution> list = runCautions(run);
    ASSERT_NE(find(list, "place_doubt"), nullptr);
    EXPECT_EQ(englishText(find(list, "place_doubt")->what), "good to 5 m");
    EXPECT_NE(pictureCautions(list).find("good to 5 m"), std::string::npos);
    const std::size_t before = list.size();
    addCautions(list, inputCautions({}, run.placeDoubts));
    EXPECT_EQ(list.size(), before);
    Findings much;
    much.add({"terrain.filled", "{0} of {1} were filled", {300, 1000}}, {});
    EXPECT_EQ(placeDoubts(much).size(), 1u);
}

TEST(Cautions, WhatHeldBodiesBackIsToldBesideEveryFigure) {
    SimulationResult result;
    result.findings.add({"simulation.speed_held", "{0} times in {1} steps a body was held back", {14'088, 623}}, {}, "", 14'088);
    result.findings.add({"simulation.auto_remedy", "{0} steps were halved", {3}}, {});
    const std::vector<Caution> list = runCautions(standingOf(result, 40, false));
    EXPECT_EQ(std::ranges::count(list, std::string_view("motion_doubt"), &Caution::key), 1);
    ASSERT_NE(find(list, "motion_doubt"), nullptr);
    EXPECT_EQ(englishText(find(list, "motion_doubt")->what), "14,088 times in 623 steps a body was held back");
    EXPECT_NE(pictureCautions(list).find("held back"), std::string::npos);
}

TEST(Cautions, OtherSettingsAndUnitsThatNobodySaidAreToldInPictures) {
    RunStanding run = rested();
    EXPECT_EQ(find(runCautions(run), "other_settings"), nullptr);
    EXPECT_EQ(find(runCautions(run), "units_unsaid"), nullptr);
    run.outgrown = true;
    run.unsaidUnits = "g-cm-s, g-cm-us";
    const std::vector<Caution> list = runCautions(run);
    for (const char* key : {"other_settings", "units_unsaid"}) {
        ASSERT_NE(find(list, key), nullptr) << key;
        EXPECT_TRUE(find(list, key)->inPictures()) << key;
    }
    EXPECT_EQ(englishText(find(list, "units_unsaid")->what),
              "nobody has said which units the FE result counts in: it would fit g-cm-s, g-cm-us as well, with other lengths, "
              "masses and times");
}

TEST(Cautions, AnEnsembleSaysHowFarItsProbabilitiesMayBeOff) {
    EXPECT_EQ(pictureCautions({ensembleCaution(16, 0.09, 0.11)}),
              "members: 16; the probability of a cell may be off by 0.09 in the mean and by 0.11 at most, one standard error; that "
              "covers what was varied and nothing else");
    EXPECT_EQ(pictureCautions({ensembleCaution(1, std::nan(""), std::nan(""))}),
              "members: 1; how far the probability of a cell may be off is not known, and nothing but what was varied is in it");
}

TEST(Cautions, ASystemWithoutAPlaceInItIsToldInPictures) {
    RunStanding run = rested();
    EXPECT_EQ(find(runCautions(run), "no_place"), nullptr);
    run.unplaced = "EPSG:25832";
    const std::vector<Caution> list = runCautions(run);
    ASSERT_NE(find(list, "no_place"), nullptr);
    EXPECT_TRUE(find(list, "no_place")->inPictures());
    EXPECT_NE(pictureCautions(list).find("the coordinate system \"EPSG:25832\" is named, but the model has no place in it"),
              std::string::npos)
        << pictureCautions(list);
}

TEST(Cautions, APhotographAtRestIsNotHeldAgainstMovingDebrisWithoutAWord) {
    RunStanding run = rested();
    Photograph photograph;
    CameraMatch match;
    match.verdict = MatchVerdict::Good;
    EXPECT_TRUE(photographCautions(photograph, &match, &run).empty());
    run.moving = 3;
    ASSERT_NE(find(photographCautions(photograph, &match, &run), "not_at_rest"), nullptr);
    photograph.time = 4.0;
    EXPECT_TRUE(photographCautions(photograph, &match, &run).empty()) << "it shows them on their way";
    match.verdict = MatchVerdict::Poor;
    ASSERT_NE(find(photographCautions(photograph, &match, nullptr), "poor_camera"), nullptr);
}

}  // namespace
}  // namespace rubble
