#pragma once

#include <span>
#include <string>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/text_table.h"

namespace rubble::cli {

/// Refuses a path that cannot be meant as an output, before any work is done: a file that was read, a folder, or a path whose
/// folder is not there and cannot be made. Throws UsageError or WorldError.
void checkOutputPath(const std::string& path, std::span<const std::string> inputs);

/// Checks the path of --csv, if it was given.
void checkCsvPath(const Arguments& arguments, std::span<const std::string> inputs);

/// Writes a table to the path of --csv, if it was given, atomically. Throws WorldError.
void writeCsv(const Arguments& arguments, const TextTable& table);

}  // namespace rubble::cli
