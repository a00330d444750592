#pragma once

#include <string_view>
#include <vector>

#include "app/cli/frame/arguments.h"
#include "core/analysis/accuracy/study_world.h"

namespace rubble::cli {

/// Options of every study of debris: --repeats, --instant, --tolerances, --threads.
std::vector<Option> studyOptions();

/// What they were given as. @param repeatsLeast  of the floor
/// Throws UsageError for a value out of range.
StudySettings parseStudySettings(const Arguments& arguments, int repeatsLeast);

}  // namespace rubble::cli
