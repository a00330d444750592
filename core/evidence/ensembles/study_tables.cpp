#include "core/evidence/ensembles/study_tables.h"

#include <ostream>

#include "core/base/csv_text.h"

namespace rubble {

namespace {

std::string drawnText(const DrawnValues& drawn) {
    std::string text;
    for (const auto& [key, value] : drawn) {
        text += (text.empty() ? "" : " ") + key + '=' + value;
    }
    return text;
}

}  // namespace

void writeMembersCsv(const EnsembleReport& report, std::ostream& out) {
    out << "member,drawn,done";
    for (std::size_t k = 0; k < memberMeasureCount; ++k) {
        out << ',' << memberMeasureRow(static_cast<MemberMeasure>(k)).key;
    }
    out << ",health_breaches,trajectory_hash\n";
    for (const EnsembleMember& member : report.members) {
        out << member.number << ',' << csvField(drawnText(member.drawn)) << ','
            << (!member.done  ? "no"
                : member.kept ? "kept"
                              : "yes");
        for (const double figure : member.figures) {
            out << ',' << (member.done ? exactNumber(figure) : std::string());
        }
        out << ',' << (member.done ? std::to_string(member.breaches) : std::string()) << ','
            << (member.done ? member.trajectoryHash.hex() : std::string()) << '\n';
    }
}

void writeRankingCsv(const CauseComparison& comparison, std::ostream& out) {
    out << "rank,cause,members,score_p50,score_p05,score_p95,superiority,superiority_low,told_apart";
    for (std::size_t e = 1; e <= comparison.evidence.size(); ++e) {
        out << ",departure_" << e << ",departure_" << e << "_deviation";
    }
    out << '\n';
    std::size_t rank = 0;
    for (const RankedCause& cause : comparison.ranking.causes) {
        const bool closest = rank++ == 0;
        out << rank << ',' << csvField(comparison.hypotheses[cause.hypothesis]) << ',' << cause.score.count << ','
            << exactNumber(cause.score.middle) << ',' << exactNumber(cause.score.low) << ',' << exactNumber(cause.score.high) << ','
            << (closest ? std::string() : exactNumber(cause.bestOver.share)) << ','
            << (closest ? std::string() : exactNumber(cause.bestOver.low)) << ','
            << (closest       ? "closest"
                : cause.apart ? "told apart"
                              : "not told apart");
        for (const FigureSpread& spread : cause.departures) {
            out << ',' << exactNumber(spread.mean) << ',' << exactNumber(spread.deviation);
        }
        out << '\n';
    }
}

}  // namespace rubble
