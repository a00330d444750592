#pragma once

#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "core/analysis/study_world.h"

namespace rubble::cli {

/// Options of every study of debris: --repeats, --instant, --tolerances, --threads.
std::vector<Option> studyOptions();

/// What they were given as. @param repeatsLeast  of the floor
/// Throws UsageError for a value out of range.
StudySettings parseStudySettings(const Arguments& arguments, int repeatsLeast);

/// A whole number within a range; what otherwise holds if the option was not given.
int parseCount(const Arguments& arguments, std::string_view option, int low, int high, int otherwise);

/// Numbers above zero, separated by commas; empty if the option was not given.
std::vector<double> parsePositives(const Arguments& arguments, std::string_view option, std::string_view offered);

}  // namespace rubble::cli
