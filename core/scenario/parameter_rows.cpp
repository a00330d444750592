#include "core/scenario/parameter_rows.h"

namespace rubble {

namespace {

/// A component without settings of its own needs no entry.
void dropIfDefault(Scenario& scenario, const std::string& component) {
    if (scenario.components[component] == ComponentSettings{}) {
        scenario.components.erase(component);
    }
}

}  // namespace

ParameterRows& ParameterRows::componentMaterial(std::string_view key, std::string_view label, std::string_view help) {
    Parameter row = described(key, ParameterKind::Choice, label, help);
    row.automatic = true;
    for (std::size_t i = 0; i < materialCount; ++i) {
        if (isBodyMaterial(static_cast<Material>(i))) {
            row.choices.push_back(materialName(static_cast<Material>(i)));
        }
    }
    row.get = [](const Scenario& scenario, const std::string& subject) -> ParameterValue {
        const auto entry = scenario.components.find(subject);
        return entry == scenario.components.end() || !entry->second.material
                   ? ParameterValue{}
                   : ParameterValue(std::string(materialName(*entry->second.material)));
    };
    row.set = [](Scenario& scenario, const std::string& subject, const ParameterValue& value) {
        const auto* name = std::get_if<std::string>(&value);
        scenario.components[subject].material = name ? materialNamed(*name) : std::nullopt;
        dropIfDefault(scenario, subject);
    };
    return add(std::move(row));
}

ParameterRows& ParameterRows::componentSwitch(std::string_view key, bool ComponentSettings::* member, std::string_view label,
                                              std::string_view help) {
    Parameter row = described(key, ParameterKind::Switch, label, help);
    row.get = [member](const Scenario& scenario, const std::string& subject) -> ParameterValue {
        const auto entry = scenario.components.find(subject);
        return entry != scenario.components.end() && entry->second.*member;
    };
    row.set = [member](Scenario& scenario, const std::string& subject, const ParameterValue& value) {
        scenario.components[subject].*member = std::get<bool>(value);
        dropIfDefault(scenario, subject);
    };
    return add(std::move(row));
}

ParameterRows& ParameterRows::pair(std::string_view key, double high, double PairProperties::* member, std::string_view label,
                                   std::string_view help) {
    Parameter row = described(key, ParameterKind::Number, label, help);
    row.low = 0.0;
    row.high = high;
    row.automatic = true;
    row.get = [member](const Scenario& scenario, const std::string& subject) -> ParameterValue {
        static const PairTable defaults;
        const std::optional<MaterialPair> pair = pairNamed(subject);
        if (!pair) {
            return {};
        }
        const double value = scenario.effects.pairs.of(pair->first, pair->second).*member;
        return value == defaults.of(pair->first, pair->second).*member ? ParameterValue{} : ParameterValue(value);
    };
    row.set = [member](Scenario& scenario, const std::string& subject, const ParameterValue& value) {
        const MaterialPair pair = pairFrom(subject);
        const auto* number = std::get_if<double>(&value);
        scenario.effects.pairs.of(pair.first, pair.second).*member =
            number ? *number : PairTable().of(pair.first, pair.second).*member;
    };
    return add(std::move(row));
}

Parameter ParameterRows::described(std::string_view key, ParameterKind kind, std::string_view label, std::string_view help) const {
    Parameter row;
    row.key = key;
    row.kind = kind;
    row.stage = m_stage;
    row.label = label;
    row.help = help;
    return row;
}

}  // namespace rubble
