#pragma once

#include <QString>

#include "io/exports/map_files.h"
#include "widgets/figures/map_picture.h"

namespace rubble {

/// How a map is drawn that was made so.
figures::MapPictureStyle pictureStyle(const io::MapOrigin& origin);

/// Writes a map with where it came from: as GeoTIFF or CSV with all layers that it has, as PNG one of them, by the end of the path.
/// Throws what the writers throw.
void writeMapFile(const QString& path, const DebrisMap& map, MapLayer layer, const io::MapOrigin& origin,
                  const Execution& execution);

}  // namespace rubble
