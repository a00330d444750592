#include "io/fe/series/later_branch.h"

#include <string>

namespace rubble::io {

namespace {

void noteTwice(double time, Findings& findings) {
    findings.add({"fe.written_twice", "States were written twice at one time: the later one counts", {}},
                 {"fe.written_twice.remedy", "Nothing to do: a restart writes its first state again.", {}},
                 "at " + englishNumber(time) + " s");
}

void noteAbandoned(double from, double to, std::size_t count, Findings& findings) {
    findings.add({"fe.abandoned", "The analysis went back in time: the states that a restart abandoned were left out", {}},
                 {"fe.abandoned.remedy",
                  "Nothing to do if the later states count; if an earlier run left them behind, move its files away.",
                  {}},
                 "from " + englishNumber(from) + " s to " + englishNumber(to) + " s", static_cast<std::int64_t>(count));
}

}  // namespace

std::vector<std::size_t> laterBranch(const std::vector<double>& times, Findings& findings) {
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < times.size(); ++k) {
        std::size_t left = kept.size();
        while (left > 0 && times[kept[left - 1]] >= times[k]) {
            --left;
        }
        if (left < kept.size()) {
            const double from = times[kept[left]], to = times[kept.back()];
            if (to == times[k]) {
                noteTwice(to, findings);
            } else {
                noteAbandoned(from, to, kept.size() - left, findings);
            }
            kept.resize(left);
        }
        kept.push_back(k);
    }
    return kept;
}

}  // namespace rubble::io
