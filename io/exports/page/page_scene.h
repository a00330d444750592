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
    nlohmann::json about;           ///< what the script needs beside the arrays: counts, steps, names
    double placeError = 0.0;        ///< m, largest of a corner of a fragment or an island at any recorded instant
    double nodeError = 0.0;         ///< m, largest of a node of the FE result at the states that are kept
    double nodeErrorBetween = 0;    ///< m, the same at those that are left out; 0: none is
    std::size_t statesKept = 0;     ///< of the FE result
    std::size_t statesThere = 0;    ///< that the run reached
    double siteError = 0.0;         ///< m, largest of a corner of what stands around the structure
    std::size_t siteTriangles = 0;  ///< of it
    bool siteLeftOut = false;       ///< it has more of them than a page takes
};

/// Most fragments, and most elements, of a page.
inline constexpr std::size_t pagePiecesMost = 400000;

/// m, by which a place of a page may lie from the recorded one, at recorded instants and at states that are kept.
inline constexpr double pageErrorMost = 5e-3;

/// Packs mesh, places of its nodes state by state, fragments, islands and their motion. Places are local, m, z up. Where a place
/// lies farther off than pageErrorMost, all is packed again in smaller steps.
/// Throws UsageError (no fragments; not the FE file of the run; more pieces than a page can show; places that stay too far off),
/// ParseError, Cancelled.
PageScene pageScene(const RunReader& run, const FeResult& fe, PagePrecision precision, const Execution& execution);

}  // namespace rubble::io
