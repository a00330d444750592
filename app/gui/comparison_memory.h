#pragma once

#include <optional>

#include "widgets/accuracy_panel.h"

namespace rubble {

/// Keeps which settings were compared last, for the next window: what, how often and with which tolerances, not where or whether
/// anew.
void rememberComparison(const widgets::AccuracyPanel::Request& request);
/// Over `standard`; what does not read is left as it is there.
widgets::AccuracyPanel::Request rememberedComparison(const widgets::AccuracyPanel::Request& standard);

}  // namespace rubble
