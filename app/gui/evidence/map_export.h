#pragma once

#include <QString>
#include <optional>

#include "core/evidence/cautions.h"
#include "io/exports/map_files.h"
#include "widgets/figures/map_picture.h"

namespace rubble {

/// How a map is drawn that was made so. @param cautions  what must be known beside it
figures::MapPictureStyle pictureStyle(const io::MapOrigin& origin, const std::vector<Caution>& cautions);

/// Writes a map with where it came from: as GeoTIFF or CSV with all layers that it has, as PNG one of them, by the end of the path.
/// @param ring  around something on the picture; unset: nothing
/// Throws what the writers throw.
void writeMapFile(const QString& path, const DebrisMap& map, MapLayer layer, const io::MapOrigin& origin,
                  const std::vector<Caution>& cautions, const Execution& execution,
                  const std::optional<figures::MapRing>& ring = std::nullopt);

}  // namespace rubble
