#include "core/evidence/report_facts.h"

#include <algorithm>

namespace rubble {

ReportCauses reportCauses(const CauseComparison& comparison, const Findings& findings, const TellingEvidence* further) {
    ReportCauses causes;
    for (const RankedCause& ranked : comparison.ranking.causes) {
        ReportCause& cause = causes.ranked.emplace_back();
        cause.name = comparison.hypotheses[ranked.hypothesis];
        cause.members = static_cast<std::int64_t>(ranked.score.count);
        if (causes.ranked.size() > 1) {
            cause.closestOver = ranked.bestOver;
            cause.apart = ranked.apart;
        }
    }
    causes.evidence = comparison.evidence;
    causes.toldApart = comparison.ranking.decided();
    causes.unexplained = comparison.unexplained;
    for (const Finding& finding : findings.list()) {
        causes.findings.push_back(finding.what);
    }
    if (further != nullptr) {
        causes.atHand = further->atHand;
        causes.further = further->ranked;
    }
    return causes;
}

FigureRange rangeOver(const ReportFacts& facts, double DebrisFigures::* figure) {
    FigureRange range{facts.atRest.*figure, facts.atRest.*figure};
    if (facts.floor) {
        for (const RepeatRow& row : facts.floor->repeats) {
            range.low = std::min(range.low, row.figures.*figure);
            range.high = std::max(range.high, row.figures.*figure);
        }
    }
    return range;
}

}  // namespace rubble
