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

}  // namespace rubble
