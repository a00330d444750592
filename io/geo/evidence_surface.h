#pragma once

#include <string>

#include "core/evidence/cause_comparison.h"
#include "core/fe/frame.h"
#include "core/fe/site_surface.h"
#include "core/scenario/site.h"

namespace rubble::io {

/// The area that debris covered, from polygons that OGR reads (GeoPackage, GeoJSON, Shapefile): those of the layer "footprint" if
/// there is one, else of the first layer with polygons. A cell is covered if its middle is. Coordinates are those of the case; a
/// file that names another system is brought over.
/// @param cell        m, of the ensembles
/// @param withFallen  of a map of this program: fallen live structure counts as debris
/// Throws WorldError (cannot be read), ParseError (no polygons, elsewhere than can be mapped), UsageError (system of the case).
SurfaceEvidence readFootprint(const std::string& path, const Frame& frame, const Site& site, double cell, bool withFallen);

/// Heights that were surveyed, from a raster that GDAL reads, in metres.
enum class SurveyedHeights {
    OfDebris,   ///< above the ground, as in maps of this program: of those the layers of debris and fallen structure, nothing is
                ///< zero
    OfSurface,  ///< of the surface in the coordinates of the case: the height shift of the site is added, the ground is taken off
};
/// A cell has the mean of four by four samples of the nearest pixels; where any of them is none it was not looked at.
/// @param withFallen  of a map of this program: fallen live structure counts as debris
/// Throws as readFootprint(); ParseError for a raster of another coordinate system than the case.
SurfaceEvidence readHeights(const std::string& path, const Frame& frame, const Site& site, double cell, SurveyedHeights meaning,
                            bool withFallen, const SiteSurface& ground);

}  // namespace rubble::io
