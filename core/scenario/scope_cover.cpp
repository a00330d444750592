#include "core/scenario/scope_cover.h"

#include "core/base/outline_cover.h"

namespace rubble {

bool covers(const SurveyScope& scope, const Eigen::Vector2d& place) {
    return (scope.area.empty() || covers(scope.area, place)) && !covers(scope.leftOut, place);
}

}  // namespace rubble
