#pragma once

#include <ostream>
#include <vector>

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/text_table.h"
#include "core/validation/validate.h"

namespace rubble::cli {

/// What was measured beside what was simulated, variant by variant, with parameters and criteria.
void printValidation(std::ostream& out, const SetResult& result);
/// One row for each figure.
TextTable validationTable(const std::vector<SetResult>& results);
/// {id, title, source, licence, folder, bodies, variants [...], warnings}; the manual lists the keys.
Json validationJson(const SetResult& result);

}  // namespace rubble::cli
