#pragma once

#include <string>
#include <vector>

#include "widgets/accuracy/accuracy_panel.h"

namespace rubble {

/// What is compared, in the words of rubble-cli accuracy.
std::vector<std::string> wordsOf(const widgets::AccuracyPanel::Request& request);
/// What such words ask for, and the rest as it was.
widgets::AccuracyPanel::Request requestFrom(const std::vector<std::string>& words, widgets::AccuracyPanel::Request request);

/// Keeps what was compared last for the next window: which settings, how often and with which tolerances, not where or whether
/// anew.
void rememberComparison(const widgets::AccuracyPanel::Request& request);
/// Over `standard`; what does not read is left as it is there.
widgets::AccuracyPanel::Request rememberedComparison(const widgets::AccuracyPanel::Request& standard);

}  // namespace rubble
