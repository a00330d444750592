#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/hash.h"
#include "core/scenario/scenario.h"
#include "core/scenario/stage.h"

namespace rubble {

/// Value of a parameter: automatic (monostate), switch, whole number, number, or text (also for choices).
using ParameterValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

enum class ParameterKind { Switch, Integer, Number, Choice, Text };

/// What stands in the brackets of a keyed row: component[deck].density, pair[stone,soil].friction.
enum class ParameterSubject { None, Component, Pair };

/// One row of the parameter table: feeds panel, --set, case file and manual.
struct Parameter {
    std::string_view key;  ///< "multiple", or with a wildcard: "component[*].density"
    ParameterKind kind;
    std::string_view unit;                                  ///< "m", "kg/m3", "" for none
    double low = -std::numeric_limits<double>::infinity();  ///< inclusive
    double high = std::numeric_limits<double>::infinity();
    std::vector<std::string_view> choices;
    bool automatic = false;  ///< "auto" is a legal value (and the default then)
    Stage stage;
    std::string_view label;  ///< for the panel: "Live frame rate"
    std::string_view help;   ///< one or two sentences: what it does and what it costs
    std::function<ParameterValue(const Scenario&, const std::string& subject)> get;
    std::function<void(Scenario&, const std::string& subject, const ParameterValue&)> set;

    bool keyed() const { return key.find("[*]") != std::string_view::npos; }
    ParameterSubject subject() const {
        return !keyed() ? ParameterSubject::None : key.starts_with("pair") ? ParameterSubject::Pair : ParameterSubject::Component;
    }
    /// The key with a subject in the place of the star.
    std::string keyFor(const std::string& name) const;
    /// Subjects that have a value of their own in a scenario, in the order of files; one empty name for a row that is not keyed.
    std::vector<std::string> subjectsIn(const Scenario& scenario) const;
};

/// All parameters, in the order of the stages.
std::span<const Parameter> parameterTable();

/// The row of a key and, for a keyed row, what stands in the brackets: findParameter("component[deck].density"). A pair of
/// materials comes back in its canonical order. Throws UsageError naming the nearest keys or materials.
std::pair<const Parameter*, std::string> findParameter(std::string_view key);

/// Value of a key in a scenario. Throws UsageError for an unknown key.
ParameterValue parameterValue(const Scenario& scenario, std::string_view key);

/// Sets a value. Throws UsageError if the key is unknown, the kind wrong, or the value not finite or out of range;
/// the scenario is then unchanged.
void setParameter(Scenario& scenario, std::string_view key, const ParameterValue& value);

/// Sets a value from text, the halves of "key=value". Numbers have a point as decimal sign in every locale and may be followed by
/// a blank and their unit ("0.25 m"); switches are true/false/on/off/yes/no, also for choices with on and off; "auto" where
/// allowed. `preset` as a key applies applyPreset(). Throws UsageError as setParameter(), and for another unit.
void setParameterText(Scenario& scenario, std::string_view key, std::string_view value);

/// A value as text that setParameterText() reads back to the same value ("auto", "true", "4500", "0.5", "oriented_box").
std::string valueText(const ParameterValue& value);

/// Applies a named preset: "default", "paper" (the published method as printed) or "reference" (a body per fragment). Throws
/// UsageError for others.
void applyPreset(Scenario& scenario, std::string_view name);
std::span<const std::string_view> presetNames();

/// Hash of the slice of the scenario that a stage itself reads (not what earlier stages read). Components includes the regrouping.
Digest scenarioSlice(const Scenario& scenario, Stage stage);

/// The first stage whose slice differs between two scenarios, or nothing if none does.
std::optional<Stage> firstStale(const Scenario& before, const Scenario& after);

}  // namespace rubble
