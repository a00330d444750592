#include "core/evidence/report_gaps.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rubble {

namespace {

/// Characters that fill a page; Chinese ones say about twice as much each.
bool fillsAPage(const std::string& text) {
    constexpr std::size_t page = 3000;
    std::size_t taken = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        // Bytes within a character are not counted; those of East Asian scripts begin with 0xE3 and above.
        taken += (byte & 0xC0U) == 0x80U ? 0 : byte >= 0xE3U ? 2 : 1;
    }
    return taken > page;
}

void addPerson(Findings& gaps, const ReportFacts& facts) {
    if (facts.question.empty()) {
        gaps.add({"report.gap.question", "the report states no question that it answers", {}},
                 {"report.gap.question.remedy", "state it in the words of whoever asked (--question)", {}});
    }
    if (facts.author.empty()) {
        gaps.add({"report.gap.author", "the report does not say who makes it", {}},
                 {"report.gap.author.remedy", "name who answers for it (--by)", {}});
    }
    if (fillsAPage(facts.words.summary)) {
        gaps.add({"report.gap.summary", "the summary in plain language is longer than a page", {}},
                 {"report.gap.summary.remedy", "shorten it to 3,000 letters", {}});
    }
}

void addMaterial(Findings& gaps, const ReportFacts& facts) {
    if (facts.casePath.empty()) {
        gaps.add({"report.gap.case", "the run stands alone: no case tells what was received and assumed", {}},
                 {"report.gap.case.remedy", "make a case of the FE result and report the run with it (--case)", {}});
    } else if (facts.journal.empty()) {
        gaps.add({"report.gap.journal", "the case has no journal, so who changed what in it cannot be told", {}},
                 {"report.gap.journal.remedy", "save the case once with this version", {}});
    }
    for (const ReportFile& file : facts.files) {
        if (file.sha256.empty()) {
            gaps.add({"report.gap.digest", "files of the material have no digest", {}},
                     {"report.gap.digest.remedy", "save the case once the files are where it says", {}}, file.path);
        }
    }
    if (facts.photographs.empty() && facts.surveys.empty()) {
        gaps.add({"report.gap.evidence", "the result is held against no photograph and no survey", {}},
                 {"report.gap.evidence.remedy", "add what was found on the site to the case", {}});
    }
    for (const ReportPhoto& photo : facts.photographs) {
        if (!photo.comparison) {
            gaps.add({"report.gap.photograph", "photographs are in the case, and nothing is compared with them", {}},
                     {"report.gap.photograph.remedy",
                      "match their cameras and draw outlines of the debris, or take them "
                      "out",
                      {}},
                     photo.name);
        }
    }
    for (const ReportSurvey& survey : facts.surveys) {
        if (!survey.comparison) {
            gaps.add({"report.gap.survey", "surveys are in the case, and nothing is compared with them", {}},
                     {"report.gap.survey.remedy", "see what the Evidence panel says of them, or take them out", {}}, survey.name);
        }
    }
}

void addReliability(Findings& gaps, const ReportFacts& facts, const ReportPlan& plan) {
    if (plan.repeats == 0 && !facts.floor) {
        gaps.add({"report.gap.intervals", "the results have no intervals: nothing was repeated", {}},
                 {"report.gap.intervals.remedy", "let at least two repeats be simulated (--repeats)", {}});
    }
    if (!plan.selfTest && facts.selfTest.empty()) {
        gaps.add({"report.gap.self_test", "the program was not tested on this machine", {}},
                 {"report.gap.self_test.remedy", "let the self-test run (--self-test)", {}});
    }
    if (facts.validation.empty()) {
        gaps.add({"report.gap.validation",
                  "the program was not held against measured falls on this machine: its error is not known",
                  {}},
                 {"report.gap.validation.remedy", "run rubble-cli validate once with this version, or Help > Validation", {}});
    }
    if (facts.points.empty()) {
        gaps.add({"report.gap.accuracy", "how far these settings are from the reference is not known", {}},
                 {"report.gap.accuracy.remedy", "measure it with rubble-cli accuracy, or in the panel Accuracy", {}});
    }
    const bool tainted =
        std::any_of(facts.cautions.begin(), facts.cautions.end(), [](const Caution& caution) { return caution.key == "tainted"; });
    if (tainted) {
        gaps.add({"report.gap.health", "the run passed limits of health, and nobody vouches for it", {}},
                 {"report.gap.health.remedy", "mend what the Health panel names, or acknowledge it with reasons", {}});
    }
}

void addUnknowns(Findings& gaps, const ReportFacts& facts) {
    if (facts.ensemble == nullptr) {
        gaps.add(
            {"report.gap.ensemble", "what was not known was not varied", {}},
            {"report.gap.ensemble.remedy", "simulate the ensemble of the case: rubble-cli ensemble, or on the page Ensemble", {}});
    }
}

}  // namespace

Findings reportGaps(const ReportFacts& facts, const ReportPlan& plan) {
    Findings gaps;
    addPerson(gaps, facts);
    addMaterial(gaps, facts);
    addReliability(gaps, facts, plan);
    addUnknowns(gaps, facts);
    return gaps;
}

std::vector<Message> reportOwnWords(const ReportFacts& facts) {
    const OwnWords& said = facts.words;
    const bool compared = facts.causes.has_value();
    std::vector<Message> missing;
    const auto ask = [&](const std::string& words, Message what) {
        if (words.empty()) {
            missing.push_back(std::move(what));
        }
    };
    ask(said.custody, {"report.own.custody", "who held the material before it came here, and what was done to it", {}});
    ask(compared ? "compared" : said.alternatives,
        {"report.own.alternatives",
         "which other causes were considered, and how each was excluded (rubble-cli compare, or the page Causes)",
         {}});
    ask(said.change, {"report.own.change", "what would change the opinion", {}});
    ask(said.summary, {"report.own.summary", "a summary of one page in plain language", {}});
    ask(said.qualification, {"report.own.qualification", "what qualifies its author, and what binds them to a party", {}});
    return missing;
}

ReportGapWords reportGapWords(bool gaps) {
    return {gaps ? Message{"report.gaps.some", "The report would lack", {}}
                 : Message{"report.gaps.none", "The report lacks nothing that the program can tell", {}},
            {"report.gaps.example", "for example", {}},
            {"report.gaps.remedy", "remedy", {}},
            {"report.gaps.own", "For you to say", {}}};
}

}  // namespace rubble
