#include "core/analysis/accuracy/study_tasks.h"

#include <algorithm>
#include <set>

#include "core/analysis/accuracy/accuracy_settings.h"
#include "core/base/error.h"
#include "core/simulation/effects/decisions.h"

namespace rubble {

Scenario settledBy(const Inputs& inputs, const Scenario& scenario, const Results& results) {
    return settledScenario(
        {*inputs.fe, *results.components, *results.fragments, *results.clustering, inputs.terrain.get(), scenario});
}

double collapseSpan(const FragmentSet& fragments, double feEnd) {
    double first = feEnd;
    for (const Fragment& fragment : fragments.list) {
        first = std::min(first, fragment.birthTime);
    }
    return feEnd - first;
}

StudyTask studyTask(const Inputs& inputs, const Scenario& scenario, const Results* results, WorldOrigin origin, std::string name) {
    StudyTask task;
    task.reference = originOf(inputs, referenceScenario(scenario), 0, 0.0, origin.machine);
    task.origin = std::move(origin);
    task.name = std::move(name);
    task.scenario = scenario;
    const double feEnd = inputs.fe->times().back();
    task.collapse = feEnd + scenario.simulation.settleTime;
    if (results != nullptr) {
        task.bodies = static_cast<std::int64_t>(results->clustering->list.size());
        task.fragments = static_cast<std::int64_t>(results->fragments->size());
        task.span = collapseSpan(*results->fragments, feEnd);
        task.carries = settledBy(inputs, scenario, *results).effects.loose != LooseStructurePolicy::Fe;
    }
    return task;
}

void WorldChoice::check(const std::vector<StudyTask>& tasks) const {
    const auto wanted = [&](const StudyTask& task) { return task.origin.key == *m_only; };
    if (single() && std::none_of(tasks.begin(), tasks.end(), wanted)) {
        throw UsageError(
            {"analysis.no_such_world",
             "This study has no world {0}: its inputs, settings or the build of Rubble are not those that the list was made with.",
             {m_only->hex()}},
            {"analysis.no_such_world.remedy",
             "Use one build of Rubble on processors of one kind, leave the inputs as they are, or have the list made anew.",
             {}});
    }
}

std::optional<Digest> digestFromHex(std::string_view text) {
    Digest digest;
    if (text.size() != 2 * digest.bytes.size() || text.find_first_not_of("0123456789abcdef") != std::string_view::npos) {
        return {};
    }
    for (std::size_t i = 0; i < digest.bytes.size(); ++i) {
        digest.bytes[i] = static_cast<std::uint8_t>(std::stoi(std::string(text.substr(2 * i, 2)), nullptr, 16));
    }
    return digest;
}

std::vector<StudyTask> distinctTasks(std::vector<StudyTask> tasks) {
    std::set<Digest> seen;
    std::erase_if(tasks, [&](const StudyTask& task) { return !seen.insert(task.origin.key).second; });
    return tasks;
}

}  // namespace rubble
