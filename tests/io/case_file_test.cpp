#include "io/case/case_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "core/base/error.h"
#include "core/fe/components.h"
#include "core/scenario/parameters.h"
#include "io/base/files.h"
#include "io/fe/fe_reader.h"
#include "io/json/case_migrations.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/whole_file.h"

namespace rubble::io {
namespace {

using nlohmann::json;

const std::string sampleFolder = sourcePath("resources/samples/");

ParameterValue randomValue(const Parameter& row, std::mt19937& engine) {
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); };
    switch (row.kind) {
        case ParameterKind::Switch:
            return engine() % 2 == 0;
        case ParameterKind::Integer:
            return static_cast<std::int64_t>(between(row.low, row.high));
        case ParameterKind::Number:
            return between(row.low, row.high);
        case ParameterKind::Choice:
            return std::string(row.choices[engine() % row.choices.size()]);
        case ParameterKind::Text:
            break;
    }
    return std::string("name \"") + std::to_string(engine()) + "\" \xC3\xA4, [x]";
}

void addRandomStep(std::vector<RegroupStep>& steps, std::mt19937& engine) {
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vec3(normal(engine) / 3.0, normal(engine), 1e-20 * normal(engine)); };
    switch (engine() % 5) {
        case 0:
            steps.emplace_back(SplitByConnectivity{"deck 1"});
            break;
        case 1:
            steps.emplace_back(SplitByBox{"deck 1", vector(), vector(), "new"});
            break;
        case 2:
            steps.emplace_back(SplitByPlane{"pier", vector(), vector(), "\"new\""});
            break;
        case 3:
            steps.emplace_back(MergeComponents{{"a", "b, c"}, "d"});
            break;
        default:
            steps.emplace_back(RenameComponent{"old", "new"});
    }
}

Scenario randomScenario(std::mt19937& engine, double share) {
    Scenario scenario;
    const std::vector<std::string> components{"deck 1", "arch ring 1, failing strip", "a [1].b", "\xE6\xA1\xA5"};
    for (const Parameter& row : parameterTable()) {
        for (const std::string& component : components) {
            if (std::uniform_real_distribution<double>()(engine) > share) {
                continue;
            }
            const bool pair = row.subject() == ParameterSubject::Pair;
            const std::string subject = pair ? pairName(materialPairs()[engine() % materialPairs().size()]) : component;
            setParameter(scenario, row.keyFor(subject), randomValue(row, engine));
        }
    }
    for (std::size_t i = engine() % 6; i > 0; --i) {
        addRandomStep(scenario.regrouping, engine);
    }
    return scenario;
}

Photograph randomPhotograph(std::mt19937& engine) {
    std::normal_distribution<double> normal;
    Photograph photograph;
    photograph.input = "p";
    photograph.note =
        "from the \xC3\xBC"
        "bank";
    photograph.facts.width = photograph.camera.width = 4000;
    photograph.facts.height = photograph.camera.height = 3000;
    photograph.facts.orientation = 6;
    if (engine() % 2 == 0) {
        photograph.facts.recorded = {6000, 4000};
        photograph.facts.focalLength = 24.0;
        photograph.facts.focalLength35 = 36.1;
        photograph.facts.position = {51.5, -0.1};
        photograph.facts.altitude = -3.0;
        photograph.camera.focal = 4123.4;
        photograph.camera.principal = Eigen::Vector2d(2010.0, 1490.0);
        photograph.time = 5.76;
        photograph.timeUncertainty = 0.1;
    }
    photograph.facts.taken = "2026-03-14 17:05:12";
    if (const auto terms = static_cast<int>(engine() % 4); terms < 3) {
        photograph.camera.radialTerms = terms;
    }
    for (std::size_t i = engine() % 5; i > 0; --i) {
        photograph.pairs.push_back(
            {"pier " + std::to_string(i), {100.0 * normal(engine), normal(engine)}, {normal(engine), 1e-9 * normal(engine), 3.0}});
    }
    for (const MaskClass kind : maskClasses) {
        photograph.masks.push_back({kind, {{0.0, 0.0}, {100.5, normal(engine)}, {50.0, 80.0}}});
    }
    return photograph;
}

Case randomCase(std::mt19937& engine, double share) {
    Case theCase;
    theCase.title = "Bridge \xC3\xBC\n\"2\"";
    theCase.frame.origin = {static_cast<std::int64_t>(engine()), -5, 1};
    theCase.frame.metresPerUnit = 0.001;
    theCase.frame.upAxis = "y";
    theCase.frame.crs = "EPSG:25832";
    theCase.inputs = {{"fe-1", InputRole::Fe, "a/b.exo", std::string(64, '0')},
                      {"fe-2", InputRole::Fe, "../c.exo", ""},
                      {"t", InputRole::Terrain, "dem.tif", ""},
                      {"p", InputRole::Photograph, "p.jpg", ""},
                      {"s", InputRole::Survey, "s.csv", "", true}};
    for (int i = 0; i < 3; ++i) {
        theCase.scenarios.push_back(
            {"scenario-" + std::to_string(i), "Name", "note", i == 1 ? "fe-2" : "fe-1", randomScenario(engine, share)});
    }
    theCase.activeScenario = "scenario-2";
    theCase.cameraKeys = {{-0.25, {1.5, -20.0, 3.0}, {0.0, 0.0, 1.0}, Vec3::UnitZ(), 28.5, false, 1.0},
                          {2.0, {0.0, 0.0, 30.0}, {0.0, 0.0, 1.0}, Vec3::UnitY(), 30.0, true, 12.25}};
    theCase.bookmarks = {{-0.25, "before \"it\" began"}, {4.75, "crown \xC3\xA4"}};
    theCase.photographs = {randomPhotograph(engine)};
    theCase.evidence = {0.05 + 0.1 * static_cast<double>(engine() % 90), 0.3, SurveyFit::Ground, engine() % 2 == 0, false};
    return theCase;
}

std::string errorOf(const std::string& text) {
    try {
        caseFromText(text, "test.rubble");
    } catch (const ParseError& error) {
        EXPECT_FALSE(error.remedy().empty());
        return error.what();
    }
    return "no error";
}

TEST(CaseFile, GivesBackRandomScenariosOverAllParameters) {
    std::mt19937 engine(4711);
    for (int i = 0; i < 200; ++i) {
        const Case before = randomCase(engine, i % 10 == 0 ? 1.0 : 0.3);
        const std::string text = caseText(before);
        const Case after = caseFromText(text, "test");
        EXPECT_EQ(after, before);
        EXPECT_EQ(caseText(after), text);
    }
}

TEST(CaseFile, AComplaintAboutAPhotographNamesItsPlace) {
    std::mt19937 engine(5);
    const json good = json::parse(caseText(randomCase(engine, 0.0)));
    const auto complaint = [&](const char* place, const json& value) {
        json wrong = good;
        wrong[json::json_pointer(place)] = value;
        return errorOf(wrong.dump());
    };
    using testing::HasSubstr;
    EXPECT_THAT(complaint("/photographs/0/input", "fe-1"), HasSubstr("/photographs/0/input"));
    EXPECT_THAT(complaint("/photographs/0/masks/1/class", "seen"), HasSubstr("/photographs/0/masks/1/class"));
    EXPECT_THAT(complaint("/photographs/0/masks/0/corners_px", json::array({json::array({1, 2})})), HasSubstr("three corners"));
    EXPECT_THAT(complaint("/photographs/0/facts/width_px", 0), HasSubstr("/photographs/0/facts/width_px"));
    EXPECT_THAT(complaint("/photographs/0/camera/radial_terms", 3), HasSubstr("from 0 to 2"));
    EXPECT_THAT(complaint("/photographs/0/camera/focal_px", -1.0), HasSubstr("above zero"));
    EXPECT_THAT(complaint("/photographs/0/time_uncertainty_s", -1.0), HasSubstr("not below zero"));
    EXPECT_THAT(complaint("/photographs/0/unheard", 1), HasSubstr("unheard"));
}

TEST(CaseFile, ACaseOfVersionTwoHasNoPhotographs) {
    json old = json::parse(caseText(caseForFe("/x/bridge.exo", "/x/bridge.rubble")));
    old["version"] = 2;
    old.erase("photographs");
    EXPECT_TRUE(caseFromText(old.dump(), "old").photographs.empty());
}

TEST(CaseFile, KeepsOnlyWhatDiffersFromTheDefaults) {
    Case theCase = caseForFe("/x/bridge.exo", "/x/bridge.rubble");
    theCase.scenarios[0].scenario.simulation.friction = 0.7;
    const json text = json::parse(caseText(theCase));
    EXPECT_EQ(text["scenarios"][0]["settings"], (json{{"friction", 0.7}}));
    EXPECT_EQ(text["version"], 5);
    EXPECT_EQ(text["inputs"][0]["path"], "bridge.exo");
}

TEST(CaseFile, DoesNotDependOnTheLocale) {
    std::mt19937 engine(1);
    const Case theCase = randomCase(engine, 1.0);
    const std::string before = caseText(theCase);
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const TemporaryFolder folder;
    saveCase(folder / "a.rubble", theCase);
    const Case loaded = loadCase(folder / "a.rubble");
    EXPECT_EQ(loaded, theCase);
    EXPECT_EQ(caseText(theCase), before);
    std::locale::global(old);
    EXPECT_EQ(wholeFile(folder / "a.rubble"), caseText(loaded));
}

TEST(CaseFile, TruncatedAtAnyByteIsRefusedWithItsPlace) {
    std::mt19937 engine(3);
    std::string text = caseText(randomCase(engine, 0.2));
    text.pop_back();
    for (std::size_t length = 0; length < text.size(); ++length) {
        const std::string error = errorOf(text.substr(0, length));
        EXPECT_THAT(error, testing::HasSubstr("test.rubble, line ")) << length;
        EXPECT_THAT(error, testing::HasSubstr(", column ")) << length;
    }
    EXPECT_THAT(errorOf("{\n  \"format\": ?"), testing::HasSubstr("line 2, column 13 (byte 14)"));
}

TEST(CaseFile, SurvivesRandomDamage) {
    std::mt19937 engine(5);
    const std::string text = caseText(randomCase(engine, 0.2));
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = text;
        for (std::size_t n = 1 + engine() % 3; n > 0; --n) {
            damaged[engine() % damaged.size()] = static_cast<char>(engine());
        }
        try {
            caseFromText(damaged, "damaged");
        } catch (const ParseError&) {
            continue;
        }
    }
}

TEST(CaseFile, NamesThePlaceOfWhatItDoesNotUnderstand) {
    std::mt19937 engine(7);
    const json good = json::parse(caseText(randomCase(engine, 0.0)));
    const auto with = [&good](const char* place, const json& value) {
        json changed = good;
        changed[json::json_pointer(place)] = value;
        return errorOf(changed.dump());
    };
    const auto names = [](const char* place) { return testing::HasSubstr(std::string("at ") + place + ":"); };
    EXPECT_THAT(with("/extra", 1), names("/extra"));
    EXPECT_THAT(with("/frame/extra", 1), names("/frame/extra"));
    EXPECT_THAT(with("/inputs/0/extra", 1), names("/inputs/0/extra"));
    EXPECT_THAT(with("/scenarios/1/extra", 1), names("/scenarios/1/extra"));
    EXPECT_THAT(with("/scenarios/1/settings/frcition", 1),
                testing::AllOf(names("/scenarios/1/settings/frcition"), testing::HasSubstr("friction")));
    EXPECT_THAT(with("/scenarios/1/settings/friction", -3), names("/scenarios/1/settings/friction"));
    EXPECT_THAT(with("/scenarios/1/settings/friction", "high"), names("/scenarios/1/settings/friction"));
    EXPECT_THAT(with("/scenarios/0/fe_input", "fe-9"), names("/scenarios/0/fe_input"));
    EXPECT_THAT(with("/scenarios/0/fe_input", "t"), names("/scenarios/0/fe_input"));
    EXPECT_THAT(with("/scenarios/0/id", "scenario-1"), names("/scenarios/1/id"));
    EXPECT_THAT(with("/inputs/1/id", "fe-1"), names("/inputs/1/id"));
    EXPECT_THAT(with("/inputs/0/role", "video"), names("/inputs/0/role"));
    EXPECT_THAT(with("/inputs/0/sha256", "abc"), names("/inputs/0/sha256"));
    EXPECT_THAT(with("/active_scenario", "none"), names("/active_scenario"));
    EXPECT_THAT(with("/frame/metres_per_unit", 0), names("/frame/metres_per_unit"));
    EXPECT_THAT(with("/frame/origin", json::array({1, 2})), names("/frame/origin"));
    EXPECT_THAT(with("/title", 3), names("/title"));
    EXPECT_THAT(with("/evidence/cell_m", 0.01), names("/evidence/cell_m"));
    EXPECT_THAT(with("/evidence/least_height_m", -1), names("/evidence/least_height_m"));
    EXPECT_THAT(with("/evidence/registration", "crown"), names("/evidence/registration"));
    EXPECT_THAT(with("/evidence/extra", 1), names("/evidence/extra"));
    EXPECT_THAT(with("/scenarios", 3), names("/scenarios"));
    EXPECT_THAT(with("/scenarios/0/regrouping", json::array({{{"step", "explode"}}})), names("/scenarios/0/regrouping/0/step"));
    json missing = good;
    missing.erase("title");
    EXPECT_THAT(errorOf(missing.dump()), testing::HasSubstr("\"title\" is missing"));
    EXPECT_THAT(errorOf(R"({"format": "rubble-case", "format": "rubble-case"})"), testing::HasSubstr("stands twice"));
    EXPECT_THAT(errorOf(R"({"format": "rubble-case", "version": 1e999})"), testing::HasSubstr("too large"));
    EXPECT_THAT(errorOf("[]"), testing::HasSubstr("not a case of Rubble"));
    EXPECT_THAT(errorOf(R"({"format": "other"})"), testing::HasSubstr("not a case of Rubble"));
}

TEST(CaseFile, LooksAtTheVersionBeforeAnythingElse) {
    EXPECT_THAT(errorOf(R"({"format": "rubble-case", "version": 6, "unheard": []})"),
                testing::HasSubstr("newer Rubble: case version 6"));
    EXPECT_THAT(errorOf(R"({"format": "rubble-case", "version": 0})"), testing::HasSubstr("/version"));
    EXPECT_THAT(errorOf(R"({"format": "rubble-case", "version": "1"})"), testing::HasSubstr("/version"));
    EXPECT_THAT(errorOf(R"({"format": "rubble-case"})"), testing::HasSubstr("\"version\" is missing"));
}

TEST(CaseMigration, GoesOneStepAtATime) {
    const CaseMigration steps[] = {{1, [](json& d) { d["path"] = d["path"].get<std::string>() + "1"; }},
                                   {2, [](json& d) { d["path"] = d["path"].get<std::string>() + "2"; }},
                                   {3, [](json& d) { d["path"] = d["path"].get<std::string>() + "3"; }}};
    json document{{"version", 2}, {"path", ""}};
    EXPECT_TRUE(migrateCase(document, 2, 4, steps));
    EXPECT_EQ(document, (json{{"version", 4}, {"path", "23"}}));
    EXPECT_FALSE(migrateCase(document, 4, 5, steps));
    for (int version = 1; version < caseVersion; ++version) {
        json old;
        EXPECT_TRUE(migrateCase(old, version, version + 1, caseMigrations())) << version;
    }
}

TEST(CaseMigration, VersionTwoHadNoBookmarks) {
    const Case theCase = caseForFe("/x/bridge.exo", "/x/bridge.rubble");
    json old = json::parse(caseText(theCase));
    old.erase("bookmarks");
    EXPECT_THAT(errorOf(old.dump()), testing::HasSubstr("bookmarks"));
    old["version"] = 2;
    EXPECT_EQ(caseFromText(old.dump(), "test"), theCase);
}

TEST(CaseMigration, VersionFourHadNoEnsemble) {
    Case theCase = caseForFe("/x/bridge.exo", "/x/bridge.rubble");
    json old = json::parse(caseText(theCase));
    old.erase("ensemble");
    old["version"] = 4;
    EXPECT_EQ(caseFromText(old.dump(), "test"), theCase);
    theCase.ensemble = {{variationFrom("friction", "normal:0.6:0.1")}, 40, 9};
    EXPECT_EQ(caseFromText(caseText(theCase), "test"), theCase);
}

TEST(CaseMigration, TheGroundOfVersionOneWasASwitch) {
    Case theCase = caseForFe("/x/bridge.exo", "/x/bridge.rubble");
    theCase.scenarios.push_back(theCase.scenarios[0]);
    theCase.scenarios[1].id = "scenario-2";
    theCase.scenarios[0].scenario.effects.of(EffectKind::Ground) = EffectSwitch::Off;
    json old = json::parse(caseText(theCase));
    old["version"] = 1;
    EXPECT_EQ(old["scenarios"][0]["settings"], (json{{"ground", "off"}}));
    old["scenarios"][0]["settings"]["ground"] = false;
    EXPECT_EQ(caseFromText(old.dump(), "test"), theCase);
    old["scenarios"][1]["settings"]["ground"] = true;
    theCase.scenarios[1].scenario.effects.of(EffectKind::Ground) = EffectSwitch::On;
    EXPECT_EQ(caseFromText(old.dump(), "test"), theCase);
    // Something else is left as it is and named.
    old["scenarios"][1]["settings"]["ground"] = 3;
    EXPECT_THAT(errorOf(old.dump()), testing::HasSubstr("at /scenarios/1/settings/ground:"));
    old["scenarios"] = 5;
    EXPECT_THAT(errorOf(old.dump()), testing::HasSubstr("at /scenarios:"));
}

TEST(CaseMigration, TheScenarioOfAnOldRunIsReadToo) {
    json scenario{{"settings", {{"ground", false}, {"friction", 0.5}}}};
    migrateScenario(scenario);
    EXPECT_EQ(scenario["settings"], (json{{"ground", "off"}, {"friction", 0.5}}));
    const json now = scenario;
    migrateScenario(scenario);
    EXPECT_EQ(scenario, now);
    for (json odd : {json(), json(3), json::array(), json{{"settings", 1}}, json{{"settings", {{"ground", "auto"}}}}}) {
        const json before = odd;
        migrateScenario(odd);
        EXPECT_EQ(odd, before);
    }
}

TEST(CaseFile, IsNotSavedWhenItCouldNotBeOpenedAgain) {
    const TemporaryFolder folder;
    const std::string path = folder / "kept.rubble";
    const Case good = caseForFe("/x/bridge.exo", path);
    saveCase(path, good);
    const std::string before = wholeFile(path);
    Case bad = good;
    bad.scenarios[0].scenario.simulation.friction = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(saveCase(path, bad), UsageError);
    bad = good;
    bad.scenarios[0].feInput = "nowhere";
    EXPECT_THROW(saveCase(path, bad), UsageError);
    bad = good;
    bad.scenarios[0].scenario.regrouping.emplace_back(SplitByPlane{"a", Vec3::Constant(INFINITY), Vec3::UnitX(), "b"});
    EXPECT_THROW(saveCase(path, bad), UsageError);
    bad = good;
    bad.title = "\xFF\xFE";
    EXPECT_THROW(saveCase(path, bad), UsageError);
    EXPECT_EQ(wholeFile(path), before);
}

TEST(CaseFile, NamesInputsRelativeToItselfWithTheirSha256) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "models");
    std::filesystem::create_directories(folder / "cases");
    std::ofstream(folder / "models/abc.exo") << "abc";
    const std::string path = folder / "cases/abc.rubble";
    const Case made = caseForFe(folder / "models/abc.exo", path);
    EXPECT_EQ(made.inputs[0].path, "../models/abc.exo");
    EXPECT_EQ(made.scenarios[0].name, "As computed");
    EXPECT_EQ(made.activeScenario, made.scenarios[0].id);
    saveCase(path, made);
    const Case loaded = loadCase(path);
    EXPECT_EQ(loaded.inputs[0].sha256, sha256OfFile(folder / "models/abc.exo"));
    EXPECT_EQ(inputPath(path, loaded.inputs[0]), folder / "models/abc.exo");
    EXPECT_EQ(inputPath(path, {"x", InputRole::Fe, "/elsewhere/b.exo", ""}), "/elsewhere/b.exo");
}

TEST(CaseFile, IsRecognisedByContent) {
    const TemporaryFolder folder;
    saveCase(folder / "without ending", caseForFe("/x/bridge.exo", folder / "a"));
    std::ofstream(folder / "bom") << "\xEF\xBB\xBF \n" << wholeFile(folder / "without ending");
    std::ofstream(folder / "empty.rubble").close();
    std::ofstream(folder / "other.rubble") << "CDF\1";
    EXPECT_TRUE(isCaseFile(folder / "without ending"));
    EXPECT_TRUE(isCaseFile(folder / "bom"));
    EXPECT_EQ(loadCase(folder / "bom"), loadCase(folder / "without ending"));
    EXPECT_FALSE(isCaseFile(folder / "empty.rubble"));
    EXPECT_FALSE(isCaseFile(folder / "other.rubble"));
    EXPECT_FALSE(isCaseFile(folder / "missing"));
    EXPECT_FALSE(isCaseFile(folder.path()));
    EXPECT_FALSE(isCaseFile(sampleFolder + "stone-arch.exo"));
    EXPECT_THROW(loadCase(folder / "missing"), WorldError);
    EXPECT_THROW(loadCase(folder.path()), WorldError);
    EXPECT_THROW(loadCase(folder / "empty.rubble"), ParseError);
}

/// Where the density of the sample comes from; stands in the notes of both scenarios.
const std::string sampleDensity =
    " All is natural stone of 2,400 kg/m3, as in the FE result; EN 1991-1-1:2002, table A.2, gives sandstone 21 to 27 kN/m3 "
    "(2,140 to 2,750 kg/m3).";

/// Every component of the sample as stone, with the density of the FE result.
std::map<std::string, ComponentSettings> sampleStone() {
    std::map<std::string, ComponentSettings> stone;
    const auto name = [&](const std::string& component) {
        stone[component].density = 2400.0;
        stone[component].material = Material::Stone;
    };
    for (const std::string part : {"arch ring ", "deck ", "spandrel walls ", "pier ", "deck over pier "}) {
        const int count = part.ends_with("pier ") ? 3 : 4;
        for (int i = 1; i <= count; ++i) {
            name(part + std::to_string(i));
        }
    }
    for (const std::string side : {"east", "west"}) {
        name("abutment " + side);
        name("deck over " + side + " abutment");
    }
    return stone;
}

// The sample: failing strips merged into their rings, so that no cluster spans a strip and its ring by name only.
Case sampleCase() {
    Case theCase = caseForFe(sampleFolder + "stone-arch.exo", sampleFolder + "stone-arch.rubble");
    theCase.title = "Stone arch bridge, four spans";
    theCase.inputs[0].sha256 = sha256OfFile(sampleFolder + "stone-arch.exo");
    theCase.scenarios[0].note = "The strips whose loss of strength starts the collapse belong to their arch rings." + sampleDensity;
    theCase.scenarios[0].scenario.components = sampleStone();
    theCase.scenarios[0].scenario.grid.bodiesMax = 4086;
    for (const std::string ring : {"arch ring 1", "arch ring 4"}) {
        theCase.scenarios[0].scenario.regrouping.emplace_back(MergeComponents{{ring, ring + ", failing strip"}, ring});
    }
    CaseScenario quick = theCase.scenarios[0];
    quick.id = "scenario-2";
    quick.name = "Quick";
    quick.note =
        "2,000 bodies, and spans that fall as in the FE result: simulated several times as fast, but debris lies inside debris." +
        sampleDensity;
    quick.scenario.grid.bodiesMax = 2000;
    quick.scenario.effects.loose = LooseStructurePolicy::Fe;
    theCase.scenarios.push_back(quick);
    return theCase;
}

TEST(SampleCase, IsWhatTheProgramWrites) {
    const std::string expected = caseText(sampleCase());
    if (wholeFile(sampleFolder + "stone-arch.rubble") != expected) {
        const std::string actual = buildPath("stone-arch.rubble.actual");
        std::ofstream(actual) << expected;
        FAIL() << "the sample case differs from what the program would write: see " << actual;
    }
    EXPECT_EQ(loadCase(sampleFolder + "stone-arch.rubble"), sampleCase());
    EXPECT_TRUE(isCaseFile(sampleFolder + "stone-arch.rubble"));
}

TEST(SampleCase, MergesTheFailingStripsIntoTheirRings) {
    const std::string path = sampleFolder + "stone-arch.rubble";
    const Case sample = loadCase(path);
    const Scenario& scenario = sample.scenarios[0].scenario;
    const auto fe = openFe(inputPath(path, sample.inputs[0]), scenario.import, sample.frame, Execution());
    const Components components = groupComponents(fe->mesh(), scenario.regrouping, scenario.components, scenario.assumptions);
    EXPECT_EQ(fe->contents().sha256, sample.inputs[0].sha256);
    EXPECT_EQ(components.list.size(), fe->mesh().parts.size() - 2);
    EXPECT_EQ(scenario.components.size(), components.list.size());
    for (const Component& component : components.list) {
        EXPECT_EQ(component.material, Material::Stone) << component.name;
        // Within the range of the source, and what the FE analysis counted with: masses stay those of its account.
        EXPECT_NEAR(component.density, 2400.0, 1e-6) << component.name;
        EXPECT_THAT(component.name, testing::Not(testing::HasSubstr("failing")));
        // 4,320 elements of the ring and 216 of the strip, as the file's account of its parts says.
        if (component.name == "arch ring 1" || component.name == "arch ring 4") {
            EXPECT_EQ(component.elements.size(), 4320u + 216u);
        }
    }
}

TEST(CaseFileOfASurvey, KeepsWhatIsComparedAndHowWellItIsKnown) {
    Case theCase;
    theCase.inputs.push_back({"fe-1", InputRole::Fe, "a.vtu", {}});
    CaseInput survey{"survey-1", InputRole::Survey, "after.tif", {}};
    survey.scope.area.polygons = {{{{0.0, 0.0}, {10.5, 0.0}, {10.5, 8.25}}, {{2.0, 1.0}, {3.0, 1.0}, {3.0, 2.0}}}};
    survey.scope.leftOut.polygons = {{{{4.0, 1.0}, {5.0, 1.0}, {5.0, 2.0}}}, {{{6.0, 1.0}, {7.0, 1.0}, {7.0, 2.0}}}};
    survey.noise = 0.05;
    survey.groundNoise = 0.1;
    survey.offsetError = 0.03;
    survey.taken = "2021-06-25 16:30:00";
    survey.instant = 2.25;
    survey.read = {"EPSG:25832", {"skip", "y", "x", "z", "skip"}};
    survey.kind = SurveyKind::Cloud;
    Registration& registration = survey.registration.emplace();
    registration.turn = Vec3(0.01, -0.02, 1.5);
    registration.about = Vec3(3.0, 4.0, 0.5);
    registration.shift = Vec3(0.1, 0.2, -0.3);
    registration.pairs = 4;
    registration.pairsLeft = 0.012;
    registration.control = 0.015;
    registration.error = 0.02;
    theCase.inputs.push_back(survey);
    CaseInput before{"survey-2", InputRole::Survey, "before.laz", {}};
    before.before = true;
    theCase.inputs.push_back(before);
    theCase.removals.push_back({"cleared", "2021-06-26 08:00:00", survey.scope.leftOut});
    theCase.site.groundClasses = {2, 9};
    const std::string text = caseText(theCase);
    EXPECT_EQ(caseFromText(text, "a.rubble").inputs, theCase.inputs);
    EXPECT_EQ(caseFromText(text, "a.rubble").removals, theCase.removals);
    EXPECT_EQ(caseFromText(text, "a.rubble").site, theCase.site);
    // A ring of two corners and noise below zero are refused with their place.
    const auto refused = [&](const std::string& from, const std::string& to) {
        std::string other = text;
        other.replace(other.find(from), from.size(), to);
        try {
            caseFromText(other, "a.rubble");
        } catch (const ParseError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(refused("\"noise_m\": 0.05", "\"noise_m\": -0.05").find("/inputs/1/noise_m"), std::string::npos);
    EXPECT_NE(refused("\"offset_error_m\": 0.03", "\"offset_error_m\": -1").find("/inputs/1/offset_error_m"), std::string::npos);
    EXPECT_NE(refused("\"error_m\": 0.02", "\"error_m\": -1").find("/inputs/1/registration/error_m"), std::string::npos);
    EXPECT_NE(refused("\"control_error_m\": 0.015", "\"control_error_m\": -1").find("registration/control_error_m"),
              std::string::npos);
    EXPECT_NE(refused("\"holds\": \"cloud\"", "\"holds\": \"a heap\"").find("/inputs/1/holds"), std::string::npos);
    EXPECT_NE(refused("2021-06-25 16:30:00", "2021-06-31 16:30:00").find("/inputs/1/taken"), std::string::npos);
    EXPECT_NE(refused("2021-06-26 08:00:00", "then").find("/removals/0/time"), std::string::npos);
    EXPECT_NE(refused("\"area_m\": [", "\"area_m\": [[[[0, 0], [1, 1]]],").find("/inputs/1/area_m/0/0"), std::string::npos);
}

}  // namespace
}  // namespace rubble::io
