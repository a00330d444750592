#pragma once

#include <string>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/session.h"
#include "core/pipeline/pipeline.h"
#include "io/case/terrain_reader.h"
#include "io/run/run_file.h"

namespace rubble::cli {

/// What pictures of a run show around its structure; a run keeps only what debris fell on.
struct RunSurroundings {
    std::string casePath;    ///< that they were read from; empty: none
    io::TerrainInput shown;  ///< orthophoto and meshes, no grid
};

/// --case of commands that draw a run.
Option caseOption();

/// A case that has the FE result of a run. Throws UsageError if it has another, and as io::loadCase().
Case loadCaseOfRun(const std::string& path, const io::RunOrigin& origin);

/// Those of the case that --case names, placed as the run has its site; none without it. What cannot be read is a note on stderr.
/// Throws as loadCaseOfRun().
RunSurroundings surroundingsOfRun(const io::RunOrigin& origin, const Inputs& inputs, const Arguments& arguments, Session& session);
/// The same for a case that was read before.
RunSurroundings surroundingsOfRun(const Case& theCase, const std::string& casePath, const io::RunOrigin& origin,
                                  const Inputs& inputs, Session& session);

}  // namespace rubble::cli
