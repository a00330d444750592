#pragma once

#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/validation/validation_record.h"

namespace rubble::io {

/// Keeps what came of a set with this build, in place of what was kept of that set. Throws WorldError.
/// @param cache  folder, such as cacheFolder()
void keepValidation(const ValidationRecord& record, const std::string& cache);

/// What is kept of this build, by id. Files that cannot be read are findings.
std::vector<ValidationRecord> keptValidations(const std::string& cache, Findings& findings);

/// Those in cacheFolder(); none where there is no such folder, or where they cannot be read.
std::vector<ValidationRecord> keptValidations();

}  // namespace rubble::io
