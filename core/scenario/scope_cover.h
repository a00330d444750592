#pragma once

#include "core/scenario/survey_scope.h"

namespace rubble {

/// Whether a place in plan belongs to what is compared.
bool covers(const SurveyScope& scope, const Eigen::Vector2d& place);

}  // namespace rubble
