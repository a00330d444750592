#include "core/evidence/report_facts.h"

#include <algorithm>

namespace rubble {

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
