#pragma once

#include <vector>

#include "core/base/finding.h"
#include "core/evidence/report_facts.h"

namespace rubble {

/// What a report will hold that is made only when it is written.
struct ReportPlan {
    int repeats = 0;        ///< simulated for the spread of the results
    bool selfTest = false;  ///< the self-test is run
};

/// What a report lacks that standards for the reports of experts ask for, by their public abstracts (ASTM E620, E860, E2713,
/// E3176): the question and who answers it, the material and where it comes from, tests of the program, validation, known distance
/// to the reference, results with intervals, what was not known, and of a summary that it fits on a page. One finding for each,
/// with what to do about it.
Findings reportGaps(const ReportFacts& facts, const ReportPlan& plan);

/// What these standards ask for as well and no program can say, as far as its author has not said it; causes that were
/// compared count as said.
std::vector<Message> reportOwnWords(const ReportFacts& facts);

/// Words about both lists.
struct ReportGapWords {
    Message lacks;    ///< above the gaps, or that there are none
    Message example;  ///< before what a gap is an example of
    Message remedy;   ///< before what to do about one
    Message own;      ///< above what its author has to say
};
ReportGapWords reportGapWords(bool gaps);

}  // namespace rubble
