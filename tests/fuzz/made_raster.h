#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/site/raster_file.h"

namespace rubble {

/// A raster made of bytes, as GDAL may hand it over.
struct MadeRaster {
    io::RasterPlace place;
    std::array<double, 6> transform{};
    int bands = 1;
    std::string crs, heightUnit, datum;
    bool geographic = false;
    double metres = 1.0, heightMetres = 1.0, bend = 0.0;
    io::RasterFile::SameCrs same = io::RasterFile::SameCrs::Unknown;
    std::vector<double> heights;
};

/// The raster that every file is found to hold.
MadeRaster& madeRaster();

}  // namespace rubble
