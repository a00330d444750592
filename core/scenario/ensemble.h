#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/scenario/scenario.h"

namespace rubble {

/// How members of an ensemble get a value.
enum class Distribution : std::uint8_t { Uniform, Normal, Choice };

/// A parameter that members of an ensemble get different values of.
struct VariedSetting {
    std::string key;  ///< of the parameter table, or scenarioKey
    Distribution distribution = Distribution::Uniform;
    double first = 0.0;                ///< least value, or mean
    double second = 0.0;               ///< greatest value, or standard deviation
    std::vector<std::string> choices;  ///< that are equally likely
    friend bool operator==(const VariedSetting&, const VariedSetting&) = default;
};

/// In place of a parameter: which scenario of the case, and so which FE result, a member is of.
inline constexpr std::string_view scenarioKey = "scenario";

/// An ensemble: one collapse simulated again and again with what is not known drawn anew (DESIGN.md 2.6).
struct EnsembleSettings {
    std::vector<VariedSetting> varied;
    std::int64_t members = 16;
    std::int64_t seed = 1;
    friend bool operator==(const EnsembleSettings&, const EnsembleSettings&) = default;
};
inline constexpr std::int64_t ensembleMembersMax = 10000;

/// What is varied unless somebody says otherwise: friction and restitution over the ranges of the table of materials, and births.
std::vector<VariedSetting> usualVariations();

/// A variation from text as on the command line: "uniform:0.4:0.8", "normal:0.6:0.1" or "choice:a:b".
/// Throws UsageError for a key that is unknown, says how the FE file is read, or takes no such value; numbers that are none or out
/// of the range of the parameter; a least value that is not the least.
VariedSetting variationFrom(std::string_view key, std::string_view text);
/// The same back; variationFrom() reads it to the same.
std::string variationText(const VariedSetting& varied);

/// Throws UsageError for numbers of members or seeds out of range, a key that is varied twice, and as variationFrom().
void checkEnsemble(const EnsembleSettings& settings);

/// What a member was given: key and value, of six digits, the same however many there are. Members 8 k to 8 k + 7 draw each from
/// another eighth of a distribution, cut at the range of its parameter (Latin hypercube: McKay, Beckman and Conover, 1979).
/// @param member  0, 1, ... Standard errors and intervals that take members as independent are rather too wide.
using DrawnValues = std::vector<std::pair<std::string, std::string>>;
DrawnValues drawnValues(const EnsembleSettings& settings, std::int64_t member);

/// The scenario of a member: that of the case with what was drawn, a seed of its own, and births moved by a micrometre at least, as
/// in the repeat floor.
Scenario memberScenario(const Scenario& scenario, const EnsembleSettings& settings, std::int64_t member);

}  // namespace rubble
