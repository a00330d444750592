#pragma once

#include <ostream>
#include <vector>

#include "app/cli/frame/json_output.h"
#include "app/cli/frame/text_table.h"
#include "core/validation/validation_record.h"

namespace rubble::cli {

/// What was measured beside what was simulated, variant by variant, with parameters and criteria.
void printValidation(std::ostream& out, const ValidationRecord& record, const Findings& findings);
/// One row for each figure.
TextTable validationTable(const std::vector<ValidationRecord>& records);

}  // namespace rubble::cli
