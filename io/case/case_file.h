#pragma once

#include <string>

#include "core/scenario/case.h"

namespace rubble::io {

/// True if the file's content is that of a case, whatever its name. False for files that cannot be read.
bool isCaseFile(const std::string& path);

/// Reads a case. Older versions are migrated one step at a time, newer ones refused; unknown keys are errors with their place.
/// Throws WorldError, ParseError.
Case loadCase(const std::string& path);

/// Writes a case atomically: sorted JSON, locale-free, only settings that differ from the defaults. What has changed since it was
/// last saved is added to its journal. Returns the case as it was written. Throws WorldError; the old file is then unchanged.
Case saveCase(const std::string& path, const Case& theCase);

/// A case around a single FE result: one input, one scenario named "As computed". `casePath` settles what paths are relative to.
Case caseForFe(const std::string& fePath, const std::string& casePath);

/// Absolute path of an input of a case file at casePath.
std::string inputPath(const std::string& casePath, const CaseInput& input);

/// The case as JSON text and back (as in the file).
std::string caseText(const Case& theCase);
Case caseFromText(const std::string& text, const std::string& nameForErrors);

}  // namespace rubble::io
