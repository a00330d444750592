#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

class Inspect : public testing::Test {
protected:
    io::TemporaryFolder m_folder;
};

TEST_F(Inspect, JsonHasTheDocumentedKeysAndTheRightNumbers) {
    const Outcome outcome = cli({"inspect", writeSmallCollapse(m_folder / "small.exo"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const nlohmann::json object = outcome.json();
    EXPECT_EQ(object["format"], "Exodus II");
    EXPECT_EQ(object["nodes"], 48);
    EXPECT_EQ(object["elements"], smallElements);
    EXPECT_EQ(object["states"], 6);
    EXPECT_EQ(object["time_first_s"], 0.0);
    EXPECT_EQ(object["time_last_s"], 0.5);
    EXPECT_EQ(object["dead_total"], smallDead);
    EXPECT_EQ(object["dead_per_state"], nlohmann::json({0, 2, 5, 5, 5, 5}));
    EXPECT_EQ(object["has_velocity"], false);
    EXPECT_EQ(object["has_death_time"], false);
    EXPECT_TRUE(object["anomalies"].is_array());
    ASSERT_EQ(object["components"].size(), 3u);
    const nlohmann::json& deck = object["components"][0];
    EXPECT_EQ(deck["name"], "deck");
    EXPECT_EQ(deck["kind"], "solid");
    EXPECT_EQ(deck["elements"], 3);
    EXPECT_EQ(deck["dead"], 3);
    EXPECT_EQ(deck["density_kg_m3"], 2000.0);
    // Unit cubes: the quadrature is exact but for rounding.
    EXPECT_NEAR(deck["mass_kg"], 6000.0, 1e-6);
    EXPECT_NEAR(deck["dead_mass_kg"], 6000.0, 1e-6);
}

TEST_F(Inspect, StoneArchIsWhatItsAuthorsCounted) {
    const Outcome outcome = cli({"inspect", sourcePath("resources/samples/stone-arch.exo"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json object = outcome.json();
    EXPECT_EQ(object["elements"], 60660);
    EXPECT_EQ(object["nodes"], 80066);
    EXPECT_EQ(object["states"], 122);
    EXPECT_EQ(object["dead_total"], 49561);
    EXPECT_EQ(object["components"].size(), 24u);
    const std::vector<int> everyTenth{812, 1384, 2191, 4992, 11740, 20527, 27070, 42643, 46410, 49298, 49561};
    for (std::size_t i = 0; i < everyTenth.size(); ++i) {
        EXPECT_EQ(object["dead_per_state"][10 * (i + 1)], everyTenth[i]) << "state " << 10 * (i + 1);
    }
    // Counted by shared faces, which part a little earlier than shared nodes: 90.9 %, and 30,117 loose at one time.
    const nlohmann::json& loose = object["loose"];
    EXPECT_EQ(loose["dead"], 49561);
    EXPECT_NEAR(loose["dead_while_loose"].get<double>() / 49561, 0.909, 0.01);
    EXPECT_NEAR(loose["loose_at_once_max"].get<double>(), 30117, 500);
    const nlohmann::json& heaviest = loose["islands"][0];
    EXPECT_EQ(heaviest["elements"], 8735);
    EXPECT_EQ(heaviest["out_of"], nullptr);
    EXPECT_EQ(heaviest["end"], "died");
    // Its authors give whole tonnes.
    EXPECT_NEAR(object["dead_mass_kg"], 65'869e3, 1e3);
    EXPECT_NEAR(object["mass_kg"], 111'254e3, 1e3);
}

TEST_F(Inspect, TellsForPeopleWhatComesLoose) {
    const Outcome arch = cli({"inspect", sourcePath("resources/samples/rc-arch.exo")});
    ASSERT_EQ(arch.exitCode, 0) << arch.err;
    EXPECT_THAT(arch.out, testing::HasSubstr("Loose structure: 55 islands without a path to a support"));
    EXPECT_THAT(arch.out, testing::HasSubstr("lives on"));
    EXPECT_THAT(arch.out, testing::HasSubstr("--json lists all"));
}

TEST_F(Inspect, SaysWhoSettledDensityAndMaterial) {
    const nlohmann::json bare = cli({"inspect", writeSmallCollapse(m_folder / "small.exo"), "--json"}).json();
    EXPECT_EQ(bare["components"][0]["density_from"], "file");
    EXPECT_EQ(bare["components"][0]["material"], "masonry") << "2,000 kg/m3";
    EXPECT_EQ(bare["components"][0]["material_from"], "density");
    EXPECT_EQ(bare["scenario"]["note"], "");
    const Outcome set = cli({"inspect", m_folder / "small.exo", "--json", "--set", "component[deck].density=2500", "--set",
                             "component[deck].material=stone"});
    EXPECT_EQ(set.json()["components"][0]["density_from"], "settings");
    EXPECT_EQ(set.json()["components"][0]["material"], "stone");
    EXPECT_EQ(set.json()["components"][0]["material_from"], "settings");
    EXPECT_EQ(set.json()["components"][1]["density_from"], "file");

    io::ExodusBuilder light = smallCollapse();
    for (auto& block : light.blocks) {
        block.attributes.clear();
        block.attributeNames.clear();
        block.attributeCount = 0;
    }
    light.write(m_folder / "light.exo");
    const nlohmann::json assumed = cli({"inspect", m_folder / "light.exo", "--json"}).json();
    EXPECT_EQ(assumed["components"][0]["density_from"], "assumed");
}

TEST_F(Inspect, TheSampleIsStoneAndSaysWhereItsDensityComesFrom) {
    const std::string sample = sourcePath("resources/samples/stone-arch.rubble");
    const nlohmann::json object = cli({"inspect", sample, "--json"}).json();
    for (const nlohmann::json& component : object["components"]) {
        EXPECT_EQ(component["material"], "stone") << component;
        EXPECT_EQ(component["density_from"], "settings") << component;
        EXPECT_GE(component["density_kg_m3"].get<double>(), 2140.0);
        EXPECT_LE(component["density_kg_m3"].get<double>(), 2750.0);
    }
    EXPECT_THAT(object["scenario"]["note"].get<std::string>(), HasSubstr("EN 1991-1-1:2002, table A.2"));
    EXPECT_THAT(cli({"inspect", sample}).out, HasSubstr("Scenario \"As computed\": "));
    EXPECT_NEAR(object["mass_kg"], 111'254e3, 1e3) << "as its authors have it";
}

TEST_F(Inspect, CsvIsTheTableOfComponents) {
    const std::string csv = m_folder / "components.csv";
    ASSERT_EQ(cli({"inspect", writeSmallCollapse(m_folder / "small.exo"), "--csv", csv}).exitCode, 0);
    const std::string text = textOf(csv);
    EXPECT_THAT(text, testing::StartsWith(
                          "component,kind,elements,dead,density_kg_m3,mass_kg,dead_mass_kg,density_from,material,material_from\n"
                          "deck,solid,3,3,2000,"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
}

TEST_F(Inspect, NobodyDeadIsAValidAnswer) {
    io::ExodusBuilder builder = smallCollapse();
    builder.element.clear();
    builder.element.emplace_back("STATUS", [](std::size_t, std::size_t) { return 1.0; });
    builder.write(m_folder / "whole.exo");
    const Outcome outcome = cli({"inspect", m_folder / "whole.exo"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("No element is dead at the end"));
}

TEST_F(Inspect, DeadThatComeBackAreCounted) {
    io::ExodusBuilder builder = smallCollapse();
    builder.element.clear();
    builder.element.emplace_back("STATUS",
                                 [](std::size_t state, std::size_t element) { return element == 4 && state == 2 ? 0.0 : 1.0; });
    builder.write(m_folder / "back.exo");
    const Outcome outcome = cli({"inspect", m_folder / "back.exo", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json object = outcome.json();
    const auto revived = std::find_if(object["anomalies"].begin(), object["anomalies"].end(),
                                      [](const nlohmann::json& anomaly) { return anomaly["kind"] == "revived"; });
    ASSERT_NE(revived, object["anomalies"].end()) << outcome.out;
    EXPECT_EQ((*revived)["count"], 1);
    EXPECT_THAT((*revived)["example"].get<std::string>(), HasSubstr("5"));
}

TEST_F(Inspect, WithoutAStatusVariableItSaysWhichThereAre) {
    io::ExodusBuilder builder = smallCollapse();
    builder.element.clear();
    builder.element.emplace_back("PRESSURE", [](std::size_t, std::size_t) { return 3.5; });
    builder.write(m_folder / "no-status.exo");
    const Outcome outcome = cli({"inspect", m_folder / "no-status.exo"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("No element is dead at the end"));
    EXPECT_THAT(outcome.out, HasSubstr("PRESSURE"));
    EXPECT_THAT(outcome.out, HasSubstr("status_variable"));
}

TEST_F(Inspect, AStatusVariableByAnotherNameCanBeSet) {
    io::ExodusBuilder builder = smallCollapse();
    builder.element.front().first = "GONE_OR_NOT";
    builder.write(m_folder / "other.exo");
    const Outcome outcome = cli({"inspect", m_folder / "other.exo", "--json", "--set", "status_variable=GONE_OR_NOT"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.json()["dead_total"], smallDead);
}

TEST_F(Inspect, UnusableFilesAreToldWithFilePlaceAndRemedy) {
    const std::string whole = textOf(writeSmallCollapse(m_folder / "small.exo"));
    std::ofstream(m_folder / "empty.exo");
    std::ofstream(m_folder / "text.exo") << "this is no finite-element result\n";
    std::ofstream(m_folder / "cut.exo", std::ios::binary) << whole.substr(0, whole.size() / 4);
    std::ofstream(m_folder / "stump.exo", std::ios::binary) << whole.substr(0, 100);
    io::ExodusBuilder still = smallCollapse();
    still.nodal.clear();
    still.write(m_folder / "still.exo");
    io::ExodusBuilder nan = smallCollapse();
    nan.nodes[7].y() = std::numeric_limits<double>::quiet_NaN();
    nan.write(m_folder / "nan.exo");
    for (const char* name : {"empty.exo", "text.exo", "cut.exo", "stump.exo", "still.exo", "nan.exo", "missing.exo"}) {
        const Outcome outcome = cli({"inspect", m_folder / name});
        EXPECT_THAT(outcome.exitCode, testing::AnyOf(1, 2)) << name << outcome.out;
        EXPECT_EQ(outcome.out, "") << name;
        EXPECT_THAT(outcome.err, HasSubstr(name));
        EXPECT_GE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << name << " has no remedy: " << outcome.err;
    }
    EXPECT_EQ(cli({"inspect", m_folder.path()}).exitCode, 1) << "a folder";
}

TEST_F(Inspect, NeverWritesOverWhatItReads) {
    const std::string path = writeSmallCollapse(m_folder / "small.exo");
    const std::string before = textOf(path);
    const Outcome outcome = cli({"inspect", path, "--csv", path});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(textOf(path), before);
    EXPECT_EQ(cli({"inspect", path, "--csv", m_folder / "no/such/folder.csv"}).exitCode, 0) << "folders are made";
    EXPECT_EQ(cli({"inspect", path, "--csv", m_folder.path()}).exitCode, 2);
}

}  // namespace

}  // namespace rubble::cli
