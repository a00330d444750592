#pragma once

#include <limits>
#include <vector>

#include "io/exports/page/page_data.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// How exactly a page holds places.
struct PagePrecision {
    double placeStep = 1e-3;               ///< m, of the middle of a body
    double cornerStep = 5e-4;              ///< m, of the corners of what a body carries
    double nodeStep = 2e-3;                ///< m, of the nodes of the FE result
    double kept = 2e-3;                    ///< m, that a place may lie beside the line between two instants that are kept
    double turned = 1e-3;                  ///< m, that a turn may move the farthest corner beside that line
    std::size_t placesMost = 120'000'000;  ///< numbers of the places of nodes, over all states, that a browser is asked to hold

    /// The same in steps a quarter as large.
    PagePrecision finer() const { return {placeStep / 4, cornerStep / 4, nodeStep / 4, kept / 4, turned / 4, placesMost}; }
};

/// Motion of the bodies as a page has it.
struct PageMotion {
    std::vector<double> end;    ///< s, when each body is gone: it left the engine, or its place became no number [bodies]
    double largestError = 0.0;  ///< m, of the corners of a body at any recorded instant, but for the steps of the corners
    std::size_t keys = 0;       ///< instants that were kept, over all bodies
};

/// Packs the recorded motion of all bodies: only the instants that interpolation needs, in steps of the precision. Each body is
/// then played as the page plays it and held against every recorded instant.
/// @param reach  m, of the farthest corner that each body carries [bodies]
/// Throws Cancelled.
PageMotion addMotion(PageData& data, const RunReader& run, const std::vector<BodyRecord>& bodies, const std::vector<double>& reach,
                     const PagePrecision& precision, const Execution& execution);

}  // namespace rubble::io
