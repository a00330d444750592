#pragma once

#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/fe/activity.h"
#include "core/scenario/scenario.h"
#include "io/fe/exodus/exodus_mesh.h"

namespace rubble::io {

struct ExodusActivity {
    Activity activity;
    std::string from;               ///< for people: "STATUS, 1 is active (by its name; 60,660 of 60,660 active at the first state)"
    std::vector<double> deathTime;  ///< exact, s, NaN where the file has none; empty if it has none at all
    Findings findings;
};

/// Reads which elements are active at which state. The flag is the user's, else the first with a known name; the value of active
/// elements is the user's, else that of the known name, else what most elements hold at the first state. Active at 1: dead is 0,
/// values between are fading and still active. Active at 0: dead is 1 and beyond, or negative. Any other: dead is what differs.
/// Blocks without the flag are always active.
/// Throws UsageError if the named flag does not exist, ParseError if there is none; both list the element variables.
ExodusActivity readExodusActivity(const ExodusFile& file, const ExodusMesh& mesh, const ImportSettings& settings,
                                  const Execution& execution);

}  // namespace rubble::io
