#pragma once

#include <vector>

#include "core/fe/site_mesh.h"
#include "io/exports/page/page_scene.h"

namespace rubble::io {

/// Most triangles of what stands around the structure that a page draws.
inline constexpr std::size_t pageSiteTrianglesMost = 400000;

/// Packs the meshes around the structure in the steps of the nodes, or says that they are left out.
/// @param meshes  null: there are none
void addSite(PageScene& scene, const std::vector<SiteMesh>* meshes);

}  // namespace rubble::io
