#pragma once

#include "io/exports/page/page_scene.h"

namespace rubble::io {

/// Packs mesh, activity and the places of the nodes at the states that the run reached; evenly thinned where all are too many.
/// @param componentOf  of each element
void addStructure(PageScene& scene, const RunReader& run, const FeResult& fe, const std::vector<ComponentId>& componentOf,
                  const PagePrecision& precision, const Execution& execution);

}  // namespace rubble::io
