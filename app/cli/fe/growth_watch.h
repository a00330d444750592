#pragma once

#include <optional>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/session.h"
#include "app/cli/frame/subject.h"

namespace rubble::cli {

/// Seconds between two looks, from --follow; nothing without it. Throws UsageError for less than 0.1 s, and beside --json.
std::optional<double> followPause(const Arguments& arguments);

/// Looks at the FE result of a subject again and again, and prints a line whenever states have come, until it is cancelled. A
/// result that cannot be read just now is looked at again.
[[noreturn]] void followGrowth(const io::OpenedCase& subject, double pause, Session& session);

}  // namespace rubble::cli
