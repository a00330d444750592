#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "io/base/files.h"
#include "io/case/case_file.h"
#include "io/exports/provenance.h"
#include "io/run/run_file.h"
#include "io/validation/kept_validation.h"
#include "tests/scenes/validation_records.h"
#include "tests/support/command_run.h"
#include "tests/support/small_collapse.h"
#include "tests/support/temporary_folder.h"

namespace rubble::cli {

namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

class ReportCommand : public SmallRun {
protected:
    void SetUp() override { m_ran = run({}, "0.5"); }
    /// @param spoken  by the system
    Outcome report(std::vector<std::string> more, const std::string& spoken = "C.UTF-8") {
        more.insert(more.begin(), "report");
        more.insert(more.end(), {"--out", m_folder / "report", "--cache", m_folder / "cache"});
        return CommandRun().with("DISPLAY", std::nullopt).with("LC_ALL", spoken).with("LANG", spoken).cli(more);
    }
    /// Its words are English, so a reader who speaks German or Chinese must not be sent over them, nor take its points for commas.
    static void expectEnglish(const std::string& page) {
        EXPECT_THAT(page, HasSubstr("<html lang=\"en\">"));
        EXPECT_THAT(page, HasSubstr("together 10.00 t"));
        EXPECT_THAT(page, testing::Not(HasSubstr("10,00")));
    }
    /// The run with a density that is stated for each component by itself.
    void runAlike(const std::string& density) {
        std::vector<std::string> alike;
        for (const char* name : {"deck", "girder", "pier"}) {
            alike.insert(alike.end(), {"--set", std::string("component[") + name + "].density=" + density});
        }
        m_ran = run(alike, "0.5");
    }
    std::string html() const { return textOf(m_folder / "report/report.html"); }

    nlohmann::json m_ran;
};

TEST_F(ReportCommand, SaysTheNumbersOfTheRunInEnglishInGermany) {
    const Outcome outcome =
        report({m_out, "--question", "Where did <it> go?", "--by", "A. Person", "--self-test", "none", "--repeats", "1", "--json"},
               "de_DE.UTF-8");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.json()["reproduced"].get<bool>());
    const std::string page = html();
    expectEnglish(page);
    EXPECT_THAT(page, HasSubstr("Where did &lt;it&gt; go?"));
    EXPECT_THAT(page, HasSubstr("A. Person"));
    EXPECT_THAT(page, HasSubstr(m_ran["trajectory_hash"].get<std::string>()));
    EXPECT_THAT(page, HasSubstr(m_ran["fe"]["sha256"].get<std::string>()));
    EXPECT_THAT(page, HasSubstr(std::to_string(smallDead) + " elements of " + std::to_string(smallElements) + " were deactivated"));
    EXPECT_THAT(page, HasSubstr("together 10.00 t")) << "five cubes of 1 m with 2,000 kg/m3";
    const auto run = io::openRun(m_out);
    // Every table of results names the run under it.
    std::size_t tables = 0, sources = 0;
    for (std::size_t at = page.find("<table"); at != std::string::npos; at = page.find("<table", at + 1)) {
        ++tables;
    }
    const std::string source = "From run <code>" + run->origin().fingerprint.hex().substr(0, 16);
    for (std::size_t at = page.find(source); at != std::string::npos; at = page.find(source, at + 1)) {
        ++sources;
    }
    EXPECT_GE(tables, 8u);
    EXPECT_GE(sources, tables - 1);
    for (const char* part : {"Method", "Assumptions and findings", "Effects", "Health of the run", "Limits",
                             "All settings of the run", "repeat floor", "kinetic energy with which fragments became bodies",
                             "work of parting what overlapped at birth", "<td class=\"w\">FE result</td>"}) {
        EXPECT_THAT(page, HasSubstr(part));
    }
    for (const char* name : {"report.html", "report.pdf"}) {
        const auto carried = io::readProvenance(m_folder / "report" + "/" + name);
        ASSERT_TRUE(carried) << name;
        EXPECT_EQ(carried->kind, "report");
        EXPECT_EQ(carried->fingerprint, run->origin().fingerprint.hex());
    }
}

TEST_F(ReportCommand, SpeaksChineseWhereItIsAsked) {
    runAlike("2400");
    const Outcome outcome = report({m_out, "--language", "zh_CN", "--repeats", "0"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string page = html();
    EXPECT_THAT(page, HasSubstr("<html lang=\"zh-CN\">"));
    EXPECT_THAT(page, HasSubstr("2 s 后偏差 1 mm 以内")) << "a criterion of the self-test";
    EXPECT_THAT(page, HasSubstr("以下 3 个取值相同：deck、girder、pier"));
    for (const char* english : {"<code>true</code>", "<code>false</code>", "within 1 mm", "is active", "set alike for"}) {
        EXPECT_THAT(page, testing::Not(HasSubstr(english))) << english;
    }
    const Outcome wrong = report({m_out, "--language", "de"});
    EXPECT_EQ(wrong.exitCode, 2);
    EXPECT_THAT(wrong.err, HasSubstr("en or zh_CN"));
}

TEST_F(ReportCommand, CheckListsWhatItLacksAndWritesNothing) {
    const Outcome bare = cli({"report", m_out, "--check", "--cache", m_folder / "cache", "--repeats", "0"});
    EXPECT_EQ(bare.exitCode, 1) << bare.err;
    for (const char* id :
         {"report.gap.question", "report.gap.author", "report.gap.case", "report.gap.evidence", "report.gap.intervals"}) {
        EXPECT_THAT(bare.out, HasSubstr(id));
    }
    EXPECT_THAT(bare.out, HasSubstr("what would change the opinion"));
    const Outcome asked =
        cli({"report", m_out, "--check", "--cache", m_folder / "cache", "--question", "Where?", "--by", "A. Miller"});
    EXPECT_THAT(asked.out, testing::Not(HasSubstr("report.gap.question")));
    EXPECT_THAT(asked.out, testing::Not(HasSubstr("report.gap.intervals")));
    const std::vector<std::string> chinese{"report", m_out, "--check", "--cache", m_folder / "cache", "--language", "zh_CN"};
    const std::string told = cli(chinese).out;
    EXPECT_THAT(told, HasSubstr("报告将缺少\n"));
    EXPECT_THAT(told, HasSubstr("[report.gap.question]\n"));
    for (const char* english : {"would lack", "remedy", "the report states no question", "what would change the opinion"}) {
        EXPECT_THAT(told, testing::Not(HasSubstr(english)));
    }
    std::vector<std::string> asJson = chinese;
    asJson.push_back("--json");
    EXPECT_THAT(cli(asJson).json()["lacks"][0]["what"].get<std::string>(), testing::Not(HasSubstr("report")));
    EXPECT_FALSE(fs::exists(m_folder / "report"));
}

TEST_F(ReportCommand, SaysWhatItsAuthorSaysInEnglishInChinaAndWhatWasNotDone) {
    runAlike("2000");
    const std::string words = m_folder / "words.txt";
    std::ofstream(words) << "# summary\nThe deck fell <east>.\nNobody stood there.\n\n- first\n- second\n  goes on\n"
                         << "# custody\nHeld by the county.\n# change\nA survey of the north bank.\n"
                         << "# qualification\nEngineer since 1998, paid by the county.\n";
    ASSERT_EQ(report({m_out, "--words", words, "--self-test", "none", "--repeats", "0"}, "zh_CN.UTF-8").exitCode, 0);
    const std::string page = html();
    expectEnglish(page);
    EXPECT_THAT(page, HasSubstr("set alike for 3: deck, girder, pier"));
    EXPECT_THAT(page, HasSubstr("was not held against measured falls on this machine"));
    EXPECT_THAT(page, HasSubstr("No settings of this scene have been compared with the reference"));
    EXPECT_THAT(page, HasSubstr("1  Summary in plain language</h2>\n<p>The deck fell &lt;east&gt;. Nobody stood there.</p>"));
    EXPECT_THAT(page, HasSubstr("<li>first</li>\n<li>second goes on</li>"));
    EXPECT_THAT(page, HasSubstr("<p>Held by the county.</p>"));
    EXPECT_THAT(page, HasSubstr("<p>A survey of the north bank.</p>"));
    EXPECT_THAT(page, HasSubstr("<p>Engineer since 1998, paid by the county.</p>\n<p>Name: "));
    EXPECT_THAT(page, HasSubstr("<p>Signature: ."));
    EXPECT_THAT(page, HasSubstr("It does not say which other causes were considered"));
    EXPECT_THAT(page, HasSubstr(io::sha256OfFile(words))) << "it is one of the files that the report rests on";
    const Outcome check = cli({"report", m_out, "--check", "--cache", m_folder / "cache", "--words", words, "--json"});
    EXPECT_EQ(check.json()["own_words"].size(), 1u) << "the causes are still to be said";
}

TEST_F(ReportCommand, NamesTheLineOfWordsThatAreNoPartOfAReport) {
    const std::string words = m_folder / "words.txt";
    for (const auto& [text, line] :
         {std::pair("# summary\na\n# opinion\nb\n", "line 3"), std::pair("stray\n# change\na\n", "line 1"),
          std::pair("# change\na\n# change\nb\n", "line 3"), std::pair("# change\n\n# summary\na\n", "line 1")}) {
        std::ofstream(words) << text;
        const Outcome outcome = cli({"report", m_out, "--check", "--cache", m_folder / "cache", "--words", words});
        EXPECT_NE(outcome.exitCode, 0) << text;
        EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr("words.txt"), HasSubstr(line), HasSubstr("# custody"))) << text;
    }
    EXPECT_THAT(cli({"report", m_out, "--check", "--words", m_folder / "none.txt"}).err, HasSubstr("none.txt"));
}

TEST_F(ReportCommand, HasTheEnsembleOfTheCaseAsFarAsItWasSimulated) {
    Case theCase = io::caseForFe(m_path, m_folder / "small.rubble");
    theCase.scenarios[0].scenario = io::openRun(m_out)->origin().scenario;
    theCase.ensemble = {{variationFrom("friction", "uniform:0.3:0.7")}, 4, 7};
    io::saveCase(m_folder / "small.rubble", theCase);
    const std::vector<std::string> words{m_folder / "small.rubble", "--run", m_out, "--self-test", "none", "--repeats", "0"};
    const Outcome simulated =
        cli({"ensemble", m_folder / "small.rubble", "--members", "3", "--cache", m_folder / "cache", "--json"});
    ASSERT_EQ(simulated.exitCode, 0) << simulated.err;
    EXPECT_EQ(simulated.json()["seed"], 7) << "as the case says";
    EXPECT_EQ(simulated.json()["varied"][0]["distribution"], "uniform:0.3:0.7");
    ASSERT_EQ(report(words).exitCode, 0);
    const std::string page = html();
    EXPECT_THAT(page, HasSubstr("The case asks for 4 members; 3 of them have been simulated"));
    EXPECT_THAT(page, HasSubstr("uniform from 0.300 to 0.700"));
    EXPECT_THAT(page, HasSubstr("Spread over 3 members"));
    EXPECT_THAT(page, HasSubstr("over the ensemble, least to most")) << "three members have no quantiles";
    EXPECT_THAT(page, HasSubstr("With what is not known drawn anew, all 3 members have a run-out of"));
    EXPECT_THAT(page, testing::Not(HasSubstr("nine of ten")));
    EXPECT_THAT(page, HasSubstr("Their debris, laid on cells of 0.50 m with fallen live structure, covers"))
        << "the run has cells of 1 m: two highest cells are two figures";
    EXPECT_THAT(page, HasSubstr(">Friction<")) << "what is drawn has its name, not its key";
    EXPECT_THAT(page, HasSubstr("Probability that debris reaches into a cell, over 3 members"));
    const nlohmann::json members = simulated.json()["list"];
    ASSERT_EQ(members.size(), 3U);
    for (const nlohmann::json& member : members) {
        EXPECT_THAT(page, HasSubstr(member["trajectory_hash"].get<std::string>().substr(0, 8))) << "every number traces to its run";
    }
    // Members of other settings are none of this case, which has none then.
    theCase.ensemble.seed = 8;
    io::saveCase(m_folder / "small.rubble", theCase);
    ASSERT_EQ(report(words).exitCode, 0);
    EXPECT_THAT(html(), HasSubstr("No ensemble was simulated of this case"));
    EXPECT_THAT(html(), HasSubstr("One set of assumptions: what is not known of friction"));
    EXPECT_THAT(html(), HasSubstr("was not varied: what it does to these figures is not known"));
    EXPECT_THAT(html(), HasSubstr("0.3 to 0.6")) << "the range of friction on soil, with its source";
    EXPECT_THAT(html(), testing::Not(HasSubstr("over the ensemble")));
}

TEST_F(ReportCommand, HasWhatCameOfHoldingThisBuildAgainstMeasuredFalls) {
    io::keepValidation(scenes::tossRecord(), m_folder / "cache");
    ASSERT_EQ(report({m_out, "--self-test", "none", "--repeats", "0"}).exitCode, 0);
    const std::string page = html();
    EXPECT_THAT(page, HasSubstr("Agreement with the reference, in the section before"));
    EXPECT_THAT(page, HasSubstr("In the terms of ASME V&amp;V 20"));
    EXPECT_THAT(page, HasSubstr("run-out, Plate [m]"));
    EXPECT_THAT(page, HasSubstr("−0.250 (−0.375 to −0.125)")) << "E = S - D with its interval";
    EXPECT_THAT(page, HasSubstr("0.26 (0.030)")) << "the area between the cumulative curves";
    EXPECT_THAT(page, HasSubstr("assumed: concrete")) << "where the parameters come from";
    EXPECT_THAT(page, HasSubstr("does not hold"));
    EXPECT_THAT(page, testing::Not(HasSubstr("Qt SVG"))) << "a drawing has the title of its figure";
    ASSERT_EQ(report({m_out, "--language", "zh_CN", "--self-test", "none", "--repeats", "0"}).exitCode, 0);
    const std::string chinese = html();
    for (const char* said : {"至少 0.8", "盲算", "朝上的面正确"}) {
        EXPECT_THAT(chinese, HasSubstr(said));
    }
    EXPECT_THAT(chinese, testing::Not(HasSubstr("at least")));
}

TEST_F(ReportCommand, ShowsTheReferenceThatASweepKeptWithItsFloor) {
    const Outcome swept = cli({"accuracy", m_path, "--set", "settle_time=0.5", "--cache", m_folder / "cache", "--multiples", "1,2",
                               "--repeats", "3", "--json"});
    ASSERT_EQ(swept.exitCode, 0) << swept.err;
    ASSERT_EQ(report({m_out, "--self-test", "none", "--repeats", "0"}).exitCode, 0);
    const std::string page = html();
    EXPECT_THAT(page, HasSubstr("The repeat floor of the reference"));
    EXPECT_THAT(page, HasSubstr("It was repeated 3 times"));
    EXPECT_THAT(page, HasSubstr("No repeats were made for this report")) << "of the run itself";
    const nlohmann::json repeats = swept.json()["repeat_floor"]["repeats"];
    ASSERT_EQ(repeats.size(), 3u);
    for (const nlohmann::json& repeat : repeats) {
        EXPECT_THAT(page, HasSubstr(repeat["trajectory_hash"].get<std::string>().substr(0, 16)))
            << "every number traces to its run";
    }
}

TEST_F(ReportCommand, RefusesAStaleRunAndNamesWhatIs) {
    Case theCase = io::caseForFe(m_path, m_folder / "small.rubble");
    theCase.scenarios[0].scenario = io::openRun(m_out)->origin().scenario;
    io::saveCase(m_folder / "small.rubble", theCase);
    const std::vector<std::string> words{m_folder / "small.rubble", "--run", m_out, "--self-test", "none", "--repeats", "0"};
    std::vector<std::string> check = words;
    check.push_back("--check");
    EXPECT_THAT(report(check).out, HasSubstr("report.gap.question")) << "a run of now is looked at";
    theCase.scenarios[0].scenario.simulation.friction = 0.31;
    io::saveCase(m_folder / "small.rubble", theCase);
    const Outcome stale = report(words);
    EXPECT_EQ(stale.exitCode, 2);
    EXPECT_THAT(stale.err, HasSubstr("friction = 0.31"));
    EXPECT_FALSE(fs::exists(m_folder / "report"));
    // A run file that was altered.
    std::fstream file(m_out, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(m_out) / 2));
    file << "altered";
    file.close();
    EXPECT_NE(report({m_out, "--self-test", "none", "--repeats", "0"}).exitCode, 0);
}

TEST_F(ReportCommand, SaysThatBirthsWereTakenTogether) {
    Case theCase = io::caseForFe(m_path, m_folder / "small.rubble");
    theCase.scenarios[0].scenario.fragments.birthWindow = 0.25;
    io::saveCase(m_folder / "small.rubble", theCase);
    const Outcome together = report({m_folder / "small.rubble", "--self-test", "none", "--repeats", "0"});
    ASSERT_EQ(together.exitCode, 0) << together.err;
    EXPECT_THAT(html(), HasSubstr("was handed over together"));
    EXPECT_THAT(html(), HasSubstr("within 0.25"));
}

TEST_F(ReportCommand, SimulatesACaseThatHasNoRun) {
    Case theCase = io::caseForFe(m_path, m_folder / "small.rubble");
    theCase.scenarios[0].scenario.fragments.birthWindow = 0.0;
    io::saveCase(m_folder / "small.rubble", theCase);
    const Outcome outcome = report({m_folder / "small.rubble", "--self-test", "closed-form", "--repeats", "0"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_THAT(html(), HasSubstr("form-"));
    EXPECT_THAT(html(), testing::Not(HasSubstr("was handed over together"))) << "without a window";
    EXPECT_THAT(html(), HasSubstr("No repeats were made"));
    // The file that it was simulated into is gone: no report names it.
    EXPECT_THAT(html(), testing::Not(HasSubstr("temporary")));
    EXPECT_THAT(html(), HasSubstr("was simulated for this report and lies in no file"));
    EXPECT_EQ(report({m_out, "--repeats", "many"}).exitCode, 2);
    EXPECT_EQ(report({m_out, "--self-test", "some"}).exitCode, 2);
}

class FigureFiles : public SmallRun {
protected:
    void SetUp() override { run({}, "0.5"); }
    Outcome without(std::vector<std::string> words) { return CommandRun().with("DISPLAY", std::nullopt).cli(words); }
};

TEST_F(FigureFiles, PresetsAreDrawnInEveryFormatAndCarryTheirSource) {
    for (const char* preset : {"fe_against_fragments", "at_the_end", "in_its_surroundings", "stages"}) {
        const std::string path = m_folder / (std::string(preset) + ".svg");
        const Outcome outcome = without({"figure", m_out, "--preset", preset, "--size", "800x500", "--dpi", "100", "--out", path});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_THAT(textOf(path), HasSubstr("a) "));
    }
    EXPECT_THAT(textOf(m_folder / "fe_against_fragments.svg"),
                testing::AllOf(HasSubstr("Conventional FE result (t = 0.30 s"), HasSubstr("computed)")));
    EXPECT_THAT(textOf(m_folder / "stages.svg"), HasSubstr("Original (t = 0.00 s"));
    for (const char* name : {"f.png", "f.pdf", "f.svg"}) {
        ASSERT_EQ(without({"figure", m_out, "--time", "0.3", "--out", m_folder / name}).exitCode, 0);
        const auto carried = io::readProvenance(m_folder / name);
        ASSERT_TRUE(carried) << name;
        EXPECT_EQ(carried->kind, "figure");
        EXPECT_EQ(carried->fingerprint, io::openRun(m_out)->origin().fingerprint.hex());
        const auto about = nlohmann::json::parse(carried->text);
        EXPECT_EQ(about["shown"].size(), 2u);
        EXPECT_EQ(about["view"]["time"], 0.3);
        EXPECT_EQ(about["shown"][1]["class"], "simulated");
    }
    EXPECT_EQ(without({"figure", m_out, "--preset", "15", "--out", m_folder / "x.png"}).exitCode, 2);
    EXPECT_EQ(without({"figure", m_out, "--preset", "11", "--times", "0.1", "--out", m_folder / "x.png"}).exitCode, 2);
    EXPECT_EQ(without({"figure", m_out, "--preset", "12", "--time", "0.1", "--out", m_folder / "x.png"}).exitCode, 2);
    EXPECT_EQ(without({"figure", m_out, "--out", m_folder / "x.tiff"}).exitCode, 2);
}

TEST_F(FigureFiles, AMovieIsPicturesOfEveryInstantAndNothingAfterCtrlC) {
    const Outcome made = without({"movie", m_out, "--out", m_folder / "frames", "--from", "0.1", "--to", "0.5", "--fps", "10",
                                  "--size", "320x200", "--json"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_EQ(made.json()["pictures"], 5);
    EXPECT_TRUE(fs::exists(m_folder / "frames/frame-00005.png"));
    EXPECT_NE(textOf(m_folder / "frames/frame-00001.png"), textOf(m_folder / "frames/frame-00005.png"));
    EXPECT_EQ(io::readProvenance(m_folder / "frames/frame-00001.png")->kind, "movie");
    bool sent = false;
    const Outcome stopped = CommandRun()
                                .with("DISPLAY", std::nullopt)
                                .meanwhile([&](pid_t id) {
                                    if (!sent && fs::exists(m_folder / "long/frame-00003.png")) {
                                        sent = ::kill(id, SIGINT) == 0;
                                    }
                                })
                                .cli({"movie", m_out, "--out", m_folder / "long", "--pace", "0.01", "--size", "320x200"});
    EXPECT_EQ(stopped.exitCode, 3);
    EXPECT_FALSE(fs::exists(m_folder / "long"));
    EXPECT_EQ(without({"movie", m_out, "--out", m_folder / "x", "--to", "99"}).exitCode, 2);
    EXPECT_EQ(without({"movie", m_out, "--out", m_folder / "x", "--fps", "0"}).exitCode, 2);
    EXPECT_EQ(without({"movie", m_out}).exitCode, 2);
}

TEST_F(FigureFiles, AnMp4WithoutFfmpegNamesTheRemedy) {
    // Only the X server is found.
    fs::create_directories(m_folder / "bin");
    fs::create_symlink("/usr/bin/Xvfb", m_folder / "bin/Xvfb");
    fs::create_symlink("/usr/bin/xkbcomp", m_folder / "bin/xkbcomp");
    const Outcome outcome = CommandRun()
                                .with("DISPLAY", std::nullopt)
                                .with("PATH", m_folder / "bin")
                                .cli({"movie", m_out, "--out", m_folder / "a.mp4", "--size", "320x200"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.err, HasSubstr("ffmpeg"));
    EXPECT_FALSE(fs::exists(m_folder / "a.mp4"));
}

TEST_F(FigureFiles, VerifyNamesWhatWasAlteredInACase) {
    const std::string path = m_folder / "small.rubble";
    Case theCase = io::caseForFe(m_path, path);
    theCase.scenarios[0].scenario.simulation.friction = 0.5;
    io::saveCase(path, theCase);
    EXPECT_EQ(cli({"verify", path}).exitCode, 0);
    auto document = nlohmann::json::parse(textOf(path));
    document["scenarios"][0]["settings"]["friction"] = 0.6;
    std::ofstream(path) << document.dump(2);
    const Outcome altered = cli({"verify", path});
    EXPECT_EQ(altered.exitCode, 1);
    EXPECT_THAT(altered.out, HasSubstr("altered outside Rubble"));
    EXPECT_THAT(altered.out, HasSubstr("scenarios/scenario-1/settings/friction"));
    document["journal"][0]["who"] = "nobody";
    std::ofstream(path) << document.dump(2);
    EXPECT_THAT(cli({"verify", path}).out, HasSubstr("the journal was altered"));
}

}  // namespace

}  // namespace rubble::cli
