#include "core/scenario/differences.h"

#include <algorithm>

namespace rubble {

std::vector<SettingDifference> differencesBetween(const Scenario& first, const Scenario& second) {
    std::vector<SettingDifference> found;
    for (const Parameter& row : parameterTable()) {
        std::vector<std::string> subjects = row.subjectsIn(first);
        for (const std::string& subject : row.subjectsIn(second)) {
            if (std::find(subjects.begin(), subjects.end(), subject) == subjects.end()) {
                subjects.push_back(subject);
            }
        }
        for (const std::string& subject : subjects) {
            ParameterValue a = row.get(first, subject);
            ParameterValue b = row.get(second, subject);
            if (a != b) {
                found.push_back({&row, subject, std::move(a), std::move(b)});
            }
        }
    }
    return found;
}

std::string SharedDifference::key() const {
    return subjects.size() == 1 ? change.row->keyFor(subjects.front())
                                : std::string(change.row->key) + " (" + std::to_string(subjects.size()) + ")";
}

std::vector<SharedDifference> sharedDifferences(const std::vector<SettingDifference>& differences) {
    std::vector<SharedDifference> shared;
    for (const SettingDifference& each : differences) {
        const auto same = std::find_if(shared.begin(), shared.end(), [&](const SharedDifference& known) {
            return known.change.row == each.row && known.change.first == each.first && known.change.second == each.second;
        });
        if (same != shared.end()) {
            same->subjects.push_back(each.subject);
        } else {
            shared.push_back({each, {each.subject}});
        }
    }
    return shared;
}

}  // namespace rubble
