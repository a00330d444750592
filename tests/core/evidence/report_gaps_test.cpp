#include "core/evidence/report_gaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rubble {
namespace {

std::vector<std::string> idsOf(const Findings& gaps) {
    std::vector<std::string> ids;
    for (const Finding& gap : gaps.list()) {
        EXPECT_FALSE(gap.remedy.empty()) << gap.what.id;
        ids.push_back(gap.what.id);
    }
    return ids;
}

/// A report that lacks nothing.
ReportFacts wholeReport() {
    ReportFacts facts;
    facts.question = "Where did the deck fall?";
    facts.author = "A. Engineer";
    facts.casePath = "bridge.rubble";
    facts.journal.emplace_back();
    facts.files = {{"fe", "bridge.exo", "0123"}};
    facts.surveys.emplace_back();
    facts.surveys.back().comparison.emplace();
    facts.points.emplace_back();
    facts.validation.emplace_back();
    facts.ensemble = std::make_shared<const EnsembleReport>();
    return facts;
}

TEST(ReportGaps, AWholeReportHasNone) {
    EXPECT_THAT(idsOf(reportGaps(wholeReport(), {2, true})), testing::IsEmpty());
}

TEST(ReportGaps, OwnWordsAreAskedForUntilTheyAreSaid) {
    const auto idsOfWords = [](const OwnWords& words) {
        std::vector<std::string> ids;
        ReportFacts facts;
        facts.words = words;
        for (const Message& each : reportOwnWords(facts)) {
            ids.push_back(each.id);
        }
        return ids;
    };
    OwnWords words;
    EXPECT_THAT(idsOfWords(words), testing::ElementsAre("report.own.custody", "report.own.alternatives", "report.own.change",
                                                        "report.own.summary", "report.own.qualification"));
    words.custody = words.change = words.qualification = "a";
    EXPECT_THAT(idsOfWords(words), testing::ElementsAre("report.own.alternatives", "report.own.summary"));
    words.alternatives = words.summary = "b";
    EXPECT_THAT(idsOfWords(words), testing::IsEmpty());
}

TEST(ReportGaps, CausesThatWereComparedNeedNoWords) {
    ReportFacts facts;
    const std::size_t before = reportOwnWords(facts).size();
    facts.causes.emplace();
    EXPECT_EQ(reportOwnWords(facts).size(), before - 1);
}

TEST(ReportGaps, ASummaryFitsOnAPageInEitherScript) {
    const auto gapsOf = [](const std::string& letter, int count) {
        ReportFacts facts = wholeReport();
        for (int i = 0; i < count; ++i) {
            facts.words.summary += letter;
        }
        return idsOf(reportGaps(facts, {2, true}));
    };
    EXPECT_THAT(gapsOf("a", 3000), testing::IsEmpty());
    EXPECT_THAT(gapsOf("a", 3001), testing::ElementsAre("report.gap.summary"));
    EXPECT_THAT(gapsOf("桥", 1500), testing::IsEmpty());
    EXPECT_THAT(gapsOf("桥", 1501), testing::ElementsAre("report.gap.summary"));
}

TEST(ReportGaps, EachThatIsTakenAwayIsNamedAlone) {
    const auto without = [](void (*take)(ReportFacts&)) {
        ReportFacts facts = wholeReport();
        take(facts);
        return idsOf(reportGaps(facts, {2, true}));
    };
    using testing::ElementsAre;
    EXPECT_THAT(without([](ReportFacts& facts) { facts.question.clear(); }), ElementsAre("report.gap.question"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.author.clear(); }), ElementsAre("report.gap.author"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.casePath.clear(); }), ElementsAre("report.gap.case"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.journal.clear(); }), ElementsAre("report.gap.journal"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.files[0].sha256.clear(); }), ElementsAre("report.gap.digest"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.surveys.clear(); }), ElementsAre("report.gap.evidence"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.surveys[0].comparison.reset(); }), ElementsAre("report.gap.survey"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.photographs.emplace_back(); }), ElementsAre("report.gap.photograph"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.validation.clear(); }), ElementsAre("report.gap.validation"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.points.clear(); }), ElementsAre("report.gap.accuracy"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.ensemble.reset(); }), ElementsAre("report.gap.ensemble"));
    EXPECT_THAT(without([](ReportFacts& facts) { facts.cautions.push_back({"tainted", HealthGrade::Tainted, {}}); }),
                ElementsAre("report.gap.health"));
    EXPECT_THAT(idsOf(reportGaps(wholeReport(), {0, true})), ElementsAre("report.gap.intervals"));
    EXPECT_THAT(idsOf(reportGaps(wholeReport(), {2, false})), ElementsAre("report.gap.self_test"));
}

}  // namespace
}  // namespace rubble
