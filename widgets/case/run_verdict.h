#pragma once

#include <QString>
#include <cstdint>

#include "core/pipeline/run_entry.h"

namespace rubble::widgets {

/// "2 limits passed"
QString limitsPassed(std::int64_t count);
/// What came of a run, wherever runs are listed: "sound", "tainted: 2 limits passed", "cancelled at 3.20 s".
QString runVerdict(const RunEntry& run);

}  // namespace rubble::widgets
