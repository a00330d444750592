#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/finding.h"
#include "core/scenario/parameters.h"
#include "core/scenario/scenario.h"
#include "core/simulation/health/health.h"

namespace rubble {

/// The setting that a remedy names, and what it is to be: the window applies it as one edit that can be undone.
struct RemedySetting {
    std::string key;
    ParameterValue value;
    friend bool operator==(const RemedySetting&, const RemedySetting&) = default;
};

/// What a remedy is chosen by.
struct RemedyGrounds {
    Scenario ran = {};      ///< with which was made what something was found in
    double stepRate = 0.0;  ///< 1/s, that the run had on average; 0: not known, or nothing ran
};

/// The one setting to try first: one that differs from what was set already. Unset where no setting alone helps; the sentence of
/// the remedy then says what to do.
std::optional<RemedySetting> remedySettingOf(const HealthBreach& breach, const RemedyGrounds& grounds);
std::optional<RemedySetting> remedySettingOf(const Finding& finding, const RemedyGrounds& grounds);

/// 1/s, of a simulation on average; 0 where it had no steps.
double meanStepRate(std::int64_t steps, double seconds);

}  // namespace rubble
