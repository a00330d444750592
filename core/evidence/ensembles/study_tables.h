#pragma once

#include <iosfwd>

#include "core/evidence/ensembles/cause_comparison.h"

namespace rubble {

/// Every member of an ensemble as CSV: what it was given, whether it is done, its figures and its trajectory; the columns of
/// `rubble-cli ensemble --csv`.
void writeMembersCsv(const EnsembleReport& report, std::ostream& out);

/// The ranking of causes as CSV, the closest first; the columns of `rubble-cli compare --csv`.
void writeRankingCsv(const CauseComparison& comparison, std::ostream& out);

}  // namespace rubble
