#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/base/execution.h"

namespace rubble::io {

/// Where the pixels of a raster lie: the middle of pixel (column, row) is at (x0 + column dx, y0 + row dy), in units of the file.
struct RasterPlace {
    double x0 = 0.0;
    double y0 = 0.0;
    double dx = 1.0;  ///< negative where columns run westwards
    double dy = 1.0;  ///< negative where rows run southwards, as in most files
    std::size_t columns = 0;
    std::size_t rows = 0;
};

/// The first band of a raster file, read through GDAL. Every call takes the lock of native libraries.
class RasterFile {
public:
    /// Throws WorldError (cannot be read) or ParseError (no raster of heights, no place, turned against the axes).
    explicit RasterFile(const std::string& path);
    ~RasterFile();
    RasterFile(const RasterFile&) = delete;
    RasterFile& operator=(const RasterFile&) = delete;

    const RasterPlace& place() const { return m_place; }
    int bands() const { return m_bands; }
    /// Name of the coordinate reference system, empty if the file states none.
    const std::string& crsName() const { return m_crsName; }
    /// Coordinates are degrees.
    bool geographic() const { return m_geographic; }
    double metresPerUnit() const { return m_metresPerUnit; }  ///< of x and y; 1 if the file does not say
    /// Unit of the heights as the file states it, empty if it does not.
    const std::string& heightUnit() const { return m_heightUnit; }
    /// Metres in it; 0 if the file states no unit or one that is not known.
    double metresPerHeightUnit() const { return m_metresPerHeightUnit; }
    /// Whether the system of the file is the one that a text (EPSG code, WKT, PROJ) names, heights apart.
    enum class SameCrs { Yes, No, Unknown };
    SameCrs sameCrs(const std::string& text) const;

    /// Values of a window, row by row as in the file, scale and offset of the file applied; not a number where the file has none.
    /// Throws ParseError naming the row that cannot be read, Cancelled.
    std::vector<double> values(std::size_t column, std::size_t row, std::size_t columns, std::size_t rows,
                               const Execution& execution) const;

private:
    struct Handles;
    void readPlace();
    void readUnits();

    std::string m_path;
    std::unique_ptr<Handles> m_handles;
    RasterPlace m_place;
    int m_bands = 0;
    std::string m_crsName;
    bool m_geographic = false;
    double m_metresPerUnit = 1.0;
    std::string m_heightUnit;
    double m_metresPerHeightUnit = 0.0;
};

}  // namespace rubble::io
