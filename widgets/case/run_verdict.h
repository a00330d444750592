#pragma once

#include <QString>
#include <cstdint>

#include "core/pipeline/run_entry.h"

namespace rubble::widgets {

/// A passed limit's grade in the language of the window.
QString gradeWords(HealthGrade grade);
/// "2 limits passed"
QString limitsPassed(std::int64_t count);
/// What came of a run, wherever runs are listed: "sound", "tainted: 2 limits passed", "cancelled at 3.20 s",
/// "interrupted at 3.20 s" where its program ended before it.
QString runVerdict(const RunEntry& run);

}  // namespace rubble::widgets
