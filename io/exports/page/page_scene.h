#pragma once

#include <nlohmann/json.hpp>

#include "core/fe/fe_result.h"
#include "io/exports/page/page_data.h"
#include "io/exports/page/page_motion.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// What the views of a page draw, and how far it may lie from what was recorded.
struct PageScene {
    PageData data;
    nlohmann::json about;         ///< what the script needs beside the arrays: counts, steps, names
    double placeError = 0.0;      ///< m, largest of a corner of a fragment or an island at any recorded instant
    double nodeError = 0.0;       ///< m, largest of a node of the FE result at the states that are kept
    std::size_t statesKept = 0;   ///< of the FE result
    std::size_t statesThere = 0;  ///< that the run reached
};

/// Most fragments, and most elements, of a page.
inline constexpr std::size_t pagePiecesMost = 400000;

/// Packs mesh, places of its nodes state by state, fragments, islands and their motion. Places are local, m, z up.
/// Throws UsageError (no fragments; not the FE file of the run; more pieces than a page can show), ParseError, Cancelled.
PageScene pageScene(const RunReader& run, const FeResult& fe, const Execution& execution);

}  // namespace rubble::io
