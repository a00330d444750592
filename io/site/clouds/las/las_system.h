#pragma once

#include "io/site/clouds/las/las_head.h"

namespace rubble::io {

/// Takes the coordinate system of a LAS or LAZ: what its GeoTIFF keys say, but where its head prefers WKT.
void takeLasSystem(const CloudFile& file, const LasHead& las, CloudHead& head);

}  // namespace rubble::io
