#pragma once

#include <memory>
#include <string>

#include "app/cli/exports/run_surroundings.h"
#include "app/cli/frame/session.h"
#include "core/pipeline/pipeline.h"
#include "io/run/run_file.h"

namespace rubble::cli {

/// Writes a run as a page, with pictures of its views and its debris map, and with the photographs of the case that `around` names.
/// What had to be rounded or left out is a note on standard error. Throws what io::exportPage() throws, and what drawing throws.
void writePage(const std::string& path, const std::shared_ptr<const io::RunReader>& run, const Inputs& inputs,
               const RunSurroundings& around, Session& session);

}  // namespace rubble::cli
