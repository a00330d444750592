#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/analysis/debris/debris.h"
#include "core/evidence/maps/debris_map.h"
#include "core/evidence/maps/run_map.h"
#include "core/fe/frame.h"
#include "core/scenario/site.h"
#include "io/run/run_file.h"

namespace rubble::io {

struct ShownFile;

/// What a map was made from, as every file of it says.
struct MapOrigin {
    Frame frame;
    Site site;
    std::vector<std::pair<std::string, std::string>> facts;  ///< key and value, in the order in which they are written
    std::string provenance;                                  ///< the sidecar, JSON
    std::string subject;                                     ///< what it is a map of, above its picture
};

/// The inputs of a map of several, for the line below its picture: "inputs" and the first digits of each digest; empty: it names
/// none.
std::string inputsLine(const MapOrigin& origin);

/// What a map of a run is of, above its picture: the case, or the FE result where no case is known, and the scenario.
std::string mapSubject(const RunOrigin& origin, const std::string& casePath);

/// @param shown  what the frame at the time of the map was: simulated, or interpolated between two
MapOrigin mapOrigin(const RunReader& run, const DebrisMap& map, FrameKind shown);
/// The same of a picture. @param drawn  files whose outlines it shows
MapOrigin mapOrigin(const RunReader& run, const DebrisMap& map, FrameKind shown, const std::vector<ShownFile>& drawn);

/// Where the fragments of a map lie, for files that list them.
struct MapFragments {
    const FragmentSet* set = nullptr;
    const Debris* debris = nullptr;
    std::vector<std::int64_t> elementIds;  ///< user's number of each
    std::vector<double> arrivals;          ///< s, [fragments]
    std::vector<double> energies;          ///< J, [fragments]; empty: not known
};

/// Writes a map as GeoTIFF: one band of 64-bit floats for each layer, with name, unit and no-data value -9999, rows from the north,
/// the coordinate system of the case; of a case whose control points turn it pixels are turned likewise. Blocks without debris take
/// no room. Atomic, with NAME.provenance.json.
/// @param layers  that the map has
/// Throws WorldError, UsageError (too large for a file; a coordinate system that does not do), Cancelled.
void writeMapTiff(const std::string& path, const DebrisMap& map, const std::vector<MapLayer>& layers, const MapOrigin& origin,
                  const Execution& execution);

/// Writes a map as CSV: one row for each cell, easting and northing of its middle in metres, then a column for each layer. Atomic,
/// with NAME.provenance.json. Throws WorldError, Cancelled.
void writeMapCsv(const std::string& path, const DebrisMap& map, const std::vector<MapLayer>& layers, const MapOrigin& origin,
                 const Execution& execution);

/// Writes a GeoPackage: `footprint` (polygons of the cells that fragments, and fallen live structure, reach into), `contours` of
/// the height and `fragments` (outlines seen from above, with attributes). Atomic, with NAME.provenance.json.
/// @param contourSpacing  m
/// Throws as writeMapTiff(), and as heightContours().
void writeMapPackage(const std::string& path, const DebrisMap& map, const MapFragments& fragments, double contourSpacing,
                     const MapOrigin& origin, const Execution& execution);

/// Writes a map of a run in the format that the path's ending names: CSV, GeoPackage, else GeoTIFF.
/// @param layers           that the map has
/// @param contourSpacing   m, of a GeoPackage
/// Throws as the writers of these.
void writeRunMap(const std::string& path, const RunMap& made, const std::vector<MapLayer>& layers, double contourSpacing,
                 const RunReader& run, const Execution& execution);

/// Writes only the sidecar, beside a map that somebody else drew.
void writeMapProvenance(const std::string& path, const MapOrigin& origin);

/// Column of a layer in a table: key and unit, "mass_kg_per_m2".
std::string mapColumn(MapLayer layer);

}  // namespace rubble::io
