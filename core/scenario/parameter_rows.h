#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "core/scenario/parameters.h"

namespace rubble {

template <class T>
ParameterValue toValue(const T& member) {
    if constexpr (std::is_same_v<T, int>) {
        return static_cast<std::int64_t>(member);
    } else {
        return member;
    }
}

template <class T>
ParameterValue toValue(const std::optional<T>& member) {
    return member ? toValue(*member) : ParameterValue{};
}

template <class T>
void fromValue(T& member, const ParameterValue& value) {
    if constexpr (std::is_same_v<T, int>) {
        member = static_cast<int>(std::get<std::int64_t>(value));
    } else {
        member = std::get<T>(value);
    }
}

template <class T>
void fromValue(std::optional<T>& member, const ParameterValue& value) {
    if (std::holds_alternative<std::monostate>(value)) {
        member.reset();
    } else {
        T inner{};
        fromValue(inner, value);
        member = inner;
    }
}

/// Builds rows of one stage; each call adds one row.
class ParameterRows {
public:
    explicit ParameterRows(Stage stage) : m_stage(stage) {}

    template <class Access>
    ParameterRows& number(std::string_view key, std::string_view unit, double low, double high, Access access,
                          std::string_view label, std::string_view help) {
        Parameter row = plain(key, ParameterKind::Number, access, label, help);
        row.unit = unit;
        row.low = low;
        row.high = high;
        return add(std::move(row));
    }
    template <class Access>
    ParameterRows& integer(std::string_view key, double low, double high, Access access, std::string_view label,
                           std::string_view help) {
        Parameter row = plain(key, ParameterKind::Integer, access, label, help);
        row.low = low;
        row.high = high;
        return add(std::move(row));
    }
    template <class Access>
    ParameterRows& toggle(std::string_view key, Access access, std::string_view label, std::string_view help) {
        return add(plain(key, ParameterKind::Switch, access, label, help));
    }
    template <class Access>
    ParameterRows& text(std::string_view key, Access access, std::string_view label, std::string_view help) {
        return add(plain(key, ParameterKind::Text, access, label, help));
    }
    /// An enumeration whose values are numbered in the order of `choices`.
    template <class Access>
    ParameterRows& choice(std::string_view key, std::vector<std::string_view> choices, Access access, std::string_view label,
                          std::string_view help) {
        Parameter row = described(key, ParameterKind::Choice, label, help);
        row.choices = choices;
        row.get = [access, choices](const Scenario& scenario, const std::string&) -> ParameterValue {
            return std::string(choices[static_cast<std::size_t>(access(scenario))]);
        };
        row.set = [access, choices](Scenario& scenario, const std::string&, const ParameterValue& value) {
            const std::string& name = std::get<std::string>(value);
            for (std::size_t i = 0; i < choices.size(); ++i) {
                if (choices[i] == name) {
                    auto& member = access(scenario);
                    member = static_cast<std::remove_reference_t<decltype(member)>>(i);
                }
            }
        };
        return add(std::move(row));
    }
    /// An optional member of ComponentSettings; setting the last one back to automatic drops the component's entry.
    template <class T>
    ParameterRows& component(std::string_view key, ParameterKind kind, std::string_view unit, double low, double high,
                             std::optional<T> ComponentSettings::* member, std::string_view label, std::string_view help) {
        Parameter row = described(key, kind, label, help);
        row.unit = unit;
        row.low = low;
        row.high = high;
        row.automatic = true;
        row.get = [member](const Scenario& scenario, const std::string& subject) -> ParameterValue {
            const auto entry = scenario.components.find(subject);
            return entry == scenario.components.end() ? ParameterValue{} : toValue(entry->second.*member);
        };
        row.set = [member](Scenario& scenario, const std::string& subject, const ParameterValue& value) {
            fromValue(scenario.components[subject].*member, value);
            if (scenario.components[subject] == ComponentSettings{}) {
                scenario.components.erase(subject);
            }
        };
        return add(std::move(row));
    }

    /// The material of a component; unset: guessed.
    ParameterRows& componentMaterial(std::string_view key, std::string_view label, std::string_view help);
    /// A switch of a component that is off unless set.
    ParameterRows& componentSwitch(std::string_view key, bool ComponentSettings::* member, std::string_view label,
                                   std::string_view help);
    /// A number of a pair of materials; automatic: that of the sourced table.
    ParameterRows& pair(std::string_view key, double high, double PairProperties::* member, std::string_view label,
                        std::string_view help);

    std::vector<Parameter> rows;

private:
    ParameterRows& add(Parameter row) {
        rows.push_back(std::move(row));
        return *this;
    }

    Parameter described(std::string_view key, ParameterKind kind, std::string_view label, std::string_view help) const;

    template <class Access>
    Parameter plain(std::string_view key, ParameterKind kind, Access access, std::string_view label, std::string_view help) {
        using T = std::remove_reference_t<decltype(access(std::declval<Scenario&>()))>;
        Parameter row = described(key, kind, label, help);
        row.automatic = requires(T t) { t.has_value(); };
        row.get = [access](const Scenario& scenario, const std::string&) { return toValue(access(scenario)); };
        row.set = [access](Scenario& scenario, const std::string&, const ParameterValue& value) {
            fromValue(access(scenario), value);
        };
        return row;
    }

    Stage m_stage;
};

/// Names a member of the scenario for a row, to be read in a constant scenario and written in another.
#define RUBBLE_AT(path) [](auto& s) -> auto& { return s.path; }

std::vector<Parameter> effectRows();

}  // namespace rubble
