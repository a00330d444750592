#pragma once

#include <optional>
#include <string>

#include "core/base/geometry.h"

namespace rubble::io {

/// What is added to the coordinates of a mesh that was written about an origin near the site, as a file beside it says.
struct MeshOffset {
    Vec3 by = Vec3::Zero();  ///< m: easting, northing and height
    std::string file;
    std::string system;  ///< the coordinate system, in the file's words; empty if it names none
};

/// What was found beside a mesh.
struct OffsetSearch {
    std::optional<MeshOffset> offset;  ///< of the first file that can be read
    std::string unread;                ///< a file before it that looks like one and cannot be read; empty: none
};

/// Looks for the offset files that photogrammetric programs write: `*_offset.xyz` beside the mesh or among the parameters of its
/// project (Pix4D), `coords.txt` and `odm_georeferencing_model_geo.txt` beside it or in `odm_georeferencing` (OpenDroneMap; without
/// height), `metadata.xml` beside or above it (Metashape, ContextCapture, DJI Terra), and `offset.txt`, `NAME_offset.txt` or
/// `SHIFT.txt` with three numbers.
OffsetSearch offsetBeside(const std::string& meshPath);

}  // namespace rubble::io
