#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/exports/map_files.h"
#include "io/site/gdal_memory.h"
#include "io/site/gdal_session.h"
#include "io/site/map_place.h"

namespace rubble::io {

namespace {

constexpr double noData = -9999.0;
constexpr std::int64_t blockSide = 256;
/// Blocks of all bands together: their table takes 16 bytes each, used or not.
constexpr double blocksMax = 4e6;

/// The rectangle of cells around a map.
struct Extent {
    MapCell low{0, 0};
    MapCell high{0, 0};

    explicit Extent(const DebrisMap& map) {
        for (std::size_t c = 0; c < map.cells.size(); ++c) {
            const MapCell& cell = map.cells[c];
            low = c == 0 ? cell : MapCell{std::min(low.j, cell.j), std::min(low.i, cell.i)};
            high = c == 0 ? cell : MapCell{std::max(high.j, cell.j), std::max(high.i, cell.i)};
        }
    }
    std::int64_t columns() const { return std::int64_t{high.i} - low.i + 1; }
    std::int64_t rows() const { return std::int64_t{high.j} - low.j + 1; }
    std::int64_t column(const MapCell& cell) const { return std::int64_t{cell.i} - low.i; }
    /// From the north.
    std::int64_t row(const MapCell& cell) const { return std::int64_t{high.j} - cell.j; }
};

/// A cell and the block of the file that it falls into.
struct Placed {
    std::int64_t blockRow = 0;
    std::int64_t blockColumn = 0;
    std::uint32_t cell = 0;
    friend auto operator<=>(const Placed&, const Placed&) = default;
};

void checkSize(const DebrisMap& map, const Extent& extent, std::size_t bands) {
    const double blocks = std::ceil(static_cast<double>(extent.columns()) / blockSide) *
                          std::ceil(static_cast<double>(extent.rows()) / blockSide) * static_cast<double>(bands);
    if (blocks > blocksMax) {
        throw UsageError({"map.too_large_for_file",
                          "The map is {0} x {1} cells of {2} and too large for a raster: some debris lies far away.",
                          {extent.columns(), extent.rows(), Argument(map.cell, "m")}},
                         {"map.too_large_for_file.remedy",
                          "Choose larger cells, or write a table, which lists only cells that hold something.",
                          {}});
    }
}

void describe(GDALDataset& file, const DebrisMap& map, const std::vector<MapLayer>& layers, const MapOrigin& origin) {
    for (const auto& [key, value] : origin.facts) {
        file.SetMetadataItem(key.c_str(), value.c_str());
    }
    for (std::size_t b = 0; b < layers.size(); ++b) {
        GDALRasterBand& band = *file.GetRasterBand(static_cast<int>(b + 1));
        const MapLayerRow& row = mapLayerRow(layers[b]);
        band.SetDescription(std::string(row.key).c_str());
        band.SetUnitType(std::string(row.unit).c_str());
        band.SetNoDataValue(noData);
        band.SetMetadataItem("LONG_NAME", englishText(mapLayerTitle(map, layers[b])).c_str());
        band.SetMetadataItem("MEANING", std::string(row.help).c_str());
        for (std::size_t c = 0; layers[b] == MapLayer::Component && c < map.components.size(); ++c) {
            band.SetMetadataItem(("COMPONENT_" + std::to_string(c)).c_str(), map.components[c].c_str());
        }
    }
}

/// Writes the blocks that hold something.
bool writeBlocks(GDALDataset& file, const DebrisMap& map, const std::vector<MapLayer>& layers, const Extent& extent,
                 const Execution& execution) {
    std::vector<Placed> placed;
    placed.reserve(map.cells.size());
    for (std::size_t c = 0; c < map.cells.size(); ++c) {
        placed.push_back(
            {extent.row(map.cells[c]) / blockSide, extent.column(map.cells[c]) / blockSide, static_cast<std::uint32_t>(c)});
    }
    std::sort(placed.begin(), placed.end());
    std::vector<double> block;
    for (std::size_t first = 0; first < placed.size();) {
        execution.check();
        std::size_t last = first;
        while (last < placed.size() && placed[last].blockRow == placed[first].blockRow &&
               placed[last].blockColumn == placed[first].blockColumn) {
            ++last;
        }
        const std::int64_t x = placed[first].blockColumn * blockSide;
        const std::int64_t y = placed[first].blockRow * blockSide;
        const auto width = static_cast<int>(std::min(blockSide, extent.columns() - x));
        const auto height = static_cast<int>(std::min(blockSide, extent.rows() - y));
        for (std::size_t b = 0; b < layers.size(); ++b) {
            block.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), noData);
            const std::vector<double>& values = map.layer(layers[b]);
            assert(values.size() == map.cells.size());
            for (std::size_t p = first; p < last; ++p) {
                const MapCell& cell = map.cells[placed[p].cell];
                const double value = values[placed[p].cell];
                block[static_cast<std::size_t>((extent.row(cell) - y) * width + extent.column(cell) - x)] =
                    std::isfinite(value) ? value : noData;
            }
            if (file.GetRasterBand(static_cast<int>(b + 1))
                    ->RasterIO(GF_Write, static_cast<int>(x), static_cast<int>(y), width, height, block.data(), width, height,
                               GDT_Float64, 0, 0, nullptr) != CE_None) {
                return false;
            }
        }
        first = last;
    }
    return true;
}

}  // namespace

void writeMapTiff(const std::string& path, const DebrisMap& map, const std::vector<MapLayer>& layers, const MapOrigin& origin,
                  const Execution& execution) {
    const Message stage{"io.export.map", "Writing {0}", {path}};
    execution.report(stage, 0.0);
    const MapPlace place(origin.frame, origin.site);
    const Extent extent(map);
    checkSize(map, extent, layers.size());
    const GdalMemoryFile memory(".tif");
    {
        const GdalSession session;
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        // Empty blocks are left out of the file and read as no data.
        const std::array<const char*, 7> options{"TILED=YES",       "COMPRESS=DEFLATE", "PREDICTOR=3", "SPARSE_OK=TRUE",
                                                 "INTERLEAVE=BAND", "BIGTIFF=IF_SAFER", nullptr};
        GDALDatasetUniquePtr file(driver->Create(memory.name().c_str(), static_cast<int>(extent.columns()),
                                                 static_cast<int>(extent.rows()), static_cast<int>(layers.size()), GDT_Float64,
                                                 const_cast<char**>(options.data())));
        if (!file) {
            failGdal(path);
        }
        std::array<double, 6> transform = place.pixels(map.cell * Eigen::Vector2d(extent.low.i, extent.high.j + 1.0), map.cell);
        file->SetGeoTransform(transform.data());
        file->SetSpatialRef(&place.system());
        describe(*file, map, layers, origin);
        if (!writeBlocks(*file, map, layers, extent, execution)) {
            failGdal(path);
        }
    }
    memory.save(path);
    writeProvenance(path, withCoordinates(origin.provenance, place.words()));
    execution.report(stage, 1.0);
}

}  // namespace rubble::io
