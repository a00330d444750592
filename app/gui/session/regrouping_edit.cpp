#include "app/gui/session/regrouping_edit.h"

#include <algorithm>

namespace rubble {

namespace {

using Settings = std::map<std::string, ComponentSettings>;

ComponentSettings taken(Settings& settings, const std::string& name) {
    const auto found = settings.find(name);
    if (found == settings.end()) {
        return {};
    }
    const ComponentSettings value = found->second;
    settings.erase(found);
    return value;
}

void put(Settings& settings, const std::string& name, const ComponentSettings& value) {
    if (!(value == ComponentSettings())) {
        settings[name] = value;
    }
}

struct Carry {
    Settings& settings;

    void operator()(const SplitByConnectivity& step) const { taken(settings, step.component); }
    void operator()(const SplitByBox& step) const { copy(step.component, step.newName); }
    void operator()(const SplitByPlane& step) const { copy(step.component, step.newName); }
    void operator()(const MergeComponents& step) const {
        std::vector<ComponentSettings> said;
        for (const std::string& name : step.components) {
            said.push_back(taken(settings, name));
        }
        const bool agree =
            std::adjacent_find(said.begin(), said.end(), [](const auto& a, const auto& b) { return !(a == b); }) == said.end();
        if (agree && !said.empty()) {
            put(settings, step.newName, said.front());
        }
    }
    void operator()(const RenameComponent& step) const { put(settings, step.newName, taken(settings, step.component)); }

private:
    void copy(const std::string& from, const std::string& to) const {
        if (const auto found = settings.find(from); found != settings.end()) {
            put(settings, to, found->second);
        }
    }
};

}  // namespace

Scenario withRegrouping(const Scenario& scenario, const RegroupStep& step) {
    Scenario after = scenario;
    after.regrouping.push_back(step);
    std::visit(Carry{after.components}, step);
    return after;
}

Scenario withoutRegrouping(const Scenario& scenario, const std::vector<std::string>& parts) {
    Scenario after = scenario;
    after.regrouping.clear();
    std::erase_if(after.components,
                  [&](const auto& entry) { return std::find(parts.begin(), parts.end(), entry.first) == parts.end(); });
    return after;
}

}  // namespace rubble
