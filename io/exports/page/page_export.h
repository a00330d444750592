#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/evidence/maps/debris_map.h"
#include "core/evidence/page_picture.h"
#include "core/fe/fe_result.h"
#include "core/fe/orthophoto.h"
#include "core/fe/site_mesh.h"
#include "core/fe/terrain_grid.h"
#include "core/scenario/case.h"
#include "core/validation/validation_record.h"
#include "io/exports/provenance.h"
#include "io/run/run_file.h"

namespace rubble::io {

/// What goes into a page beside the run.
struct PageExtras {
    std::string title;                           ///< empty: the name of the FE file
    const Case* theCase = nullptr;               ///< its bookmarks become chapters; null: the run alone
    std::string casePath;                        ///< of the case, empty: none
    std::shared_ptr<const TerrainGrid> terrain;  ///< that is shown; null: the level ground
    std::shared_ptr<const DebrisMap> map;        ///< of the end, whose sums the page prints; null: none
    std::vector<PagePicture> pictures;
    std::vector<ShownFile> around{};                              ///< drawn around the structure in the pictures
    std::shared_ptr<const std::vector<SiteMesh>> surroundings{};  ///< of these files; null: none
    std::shared_ptr<const Orthophoto> orthophoto{};               ///< where the picture of the ground lies; null: nowhere
    std::vector<ValidationRecord> validation{};                   ///< that the build of now was held against
    Findings siteFindings{};                                      ///< openingFindings() of terrain and what stands around
    std::function<std::string(const Message&)> chinese;           ///< in Chinese, settings by names; unset: English
};

/// What was written.
struct PageReport {
    std::uint64_t bytes = 0;        ///< of the file
    double placeError = 0.0;        ///< m, largest of a corner at any recorded instant
    double nodeError = 0.0;         ///< m, largest of a node at the states that are kept
    double nodeErrorBetween = 0.0;  ///< m, the same at those that are left out
    std::size_t statesLeftOut = 0;
    double siteError = 0.0;         ///< m, largest of a corner of what stands around the structure
    std::size_t siteTriangles = 0;  ///< of it that the views draw
    bool siteLeftOut = false;       ///< it has more triangles than a page takes
};

/// Throws UsageError if a page cannot show a run: no fragments, another FE file, more than a browser holds; ParseError.
void checkPage(const RunReader& run, const FeResult& fe);

/// Writes a run as one HTML file that a browser opens without network and without installation: both views with linked cameras,
/// timeline, picking, measuring, colours, chapters, pictures, health, provenance and limits, in English and Chinese. Places are
/// rounded and motion is thinned; the largest error is measured against every recorded instant, stands on the page and is 5 mm at
/// most. Atomic. The file holds its provenance as readProvenance() finds it. Throws UsageError (no fragments; not the FE file of
/// the run; more than a page can show; places that would lie farther off), WorldError, ParseError, Cancelled.
PageReport exportPage(const std::string& path, const RunReader& run, const FeResult& fe, const PageExtras& extras,
                      const Execution& execution);

}  // namespace rubble::io
