#pragma once

#include <vector>

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/text_table.h"
#include "core/validation/drop_series.h"

namespace rubble::cli {

/// One row for each body and repeat; places in the axes of the table of bodies. @param zero  m, of the local frame in these axes
TextTable dropTable(const std::vector<DropRepeat>& repeats, const Vec3& zero);
/// One row for each body, repeat and sample.
TextTable pathTable(const std::vector<DropRepeat>& repeats, const Vec3& zero);
/// How many steps a second a run took at least, and why.
std::string stepsText(const SimulationResult& simulation);

/// Mean and spread of what the bodies did, one row for each figure.
TextTable dropSummary(const std::vector<DropRepeat>& repeats, const Vec3& zero);
/// The same: {bodies, repeats, endings, figures}.
Json dropJson(const std::vector<DropRepeat>& repeats, const Vec3& zero);

}  // namespace rubble::cli
