#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/base/geometry.h"

class GDALRasterBand;

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

/// A window of a raster. Pixels may be put together, `factor` by `factor`: sides are then multiples of it.
struct RasterWindow {
    std::size_t column = 0;
    std::size_t row = 0;
    std::size_t columns = 0;  ///< of the file
    std::size_t rows = 0;
    std::size_t factor = 1;

    std::size_t width() const { return columns / factor; }
    std::size_t height() const { return rows / factor; }
};

/// A raster file, read through GDAL. Pyramids in it or beside it change nothing. Every call takes the lock of native libraries.
class RasterFile {
public:
    enum class Holds { Heights, Colours };
    /// Throws WorldError (cannot be read) or ParseError (no raster of that kind, no place).
    /// @param shown  path that messages name; empty: the path itself
    explicit RasterFile(const std::string& path, Holds what = Holds::Heights, const std::string& shown = "");
    ~RasterFile();
    RasterFile(const RasterFile&) = delete;
    RasterFile& operator=(const RasterFile&) = delete;

    /// Of a raster that is turned only its columns and rows mean anything.
    const RasterPlace& place() const { return m_place; }
    /// Its rows do not run along the axes of its system.
    bool turned() const { return m_turned; }
    /// Without one that only says which pixels are there.
    int bands() const { return m_bands; }
    /// What the file calls its bands, in their order; empty where it does not.
    std::vector<std::string> bandNames() const;
    /// Values are from now on those of these bands, counted from 0, where they overlap the greatest; at first those of the first.
    void take(const std::vector<int>& bands);
    /// A named entry of its metadata; empty if it has none.
    std::string entry(const std::string& name) const;
    /// Name of the coordinate reference system, empty if the file states none.
    const std::string& crsName() const { return m_crsName; }
    /// Coordinates are degrees.
    bool geographic() const { return m_geographic; }
    double metresPerUnit() const { return m_metresPerUnit; }  ///< of x and y; 1 if the file does not say
    /// Unit of the heights as the file states it, empty if it does not.
    const std::string& heightUnit() const { return m_heightUnit; }
    /// Metres in it; 0 if the file states no unit or one that is not known.
    double metresPerHeightUnit() const { return m_metresPerHeightUnit; }
    /// Name of the vertical datum that a system states, or of the ellipsoid in one of three dimensions; empty if it states none.
    std::string verticalDatum() const;
    static std::string verticalDatum(const std::string& crs);
    /// Takes places in metres of a system (its coordinates times its unit; empty: the file's own) to fractional pixels, the middle
    /// of the first at (0, 0), and back. What has no place there is not a number.
    /// Throws UsageError if the system is not known or PROJ finds no way between the two.
    void toPixels(const std::string& crs, std::vector<Eigen::Vector2d>& places) const;
    void fromPixels(const std::string& crs, std::vector<Eigen::Vector2d>& places) const;
    /// Says how well places of its system are known in that of a case: which operation of PROJ leads there, how accurate it is, and
    /// which grids are missing. A file whose system, or a case that names none, is said as well.
    /// @param place  easting and northing of the site in metres of the case's system
    void checkWay(const std::string& crs, const Eigen::Vector2d& place, Findings& findings) const;
    /// Whether the system of the file is the one that a text (EPSG code, WKT, PROJ) names, heights apart.
    enum class SameCrs { Yes, No, Unknown };
    SameCrs sameCrs(const std::string& text) const;

    /// Values of a window, row by row as in the file, scale and offset of the file applied; not a number where the file has none.
    /// Of pixels put together the mean of those that have a value.
    /// Throws ParseError naming the row that cannot be read, Cancelled.
    std::vector<double> values(const RasterWindow& window, const Execution& execution) const;
    /// Red, green, blue and opacity of a window, row by row, each of a byte. What is assumed of bands and depth is a finding.
    /// Throws as values(), and ParseError where values are no colours.
    std::vector<std::uint8_t> colours(const RasterWindow& window, const Execution& execution, Findings& findings) const;

private:
    struct Handles;
    void readGreater(GDALRasterBand& band, const RasterWindow& window, std::vector<double>& all, const Execution& execution) const;
    [[noreturn]] void refuseRows(std::size_t first) const;
    void checkLength() const;
    void checkKind(Holds what) const;
    void readPlace();
    void readUnits();
    void change(const std::string& crs, bool toFile, std::vector<Eigen::Vector2d>& places) const;

    std::string m_path;
    std::unique_ptr<Handles> m_handles;
    RasterPlace m_place;
    bool m_turned = false;
    std::array<double, 6> m_transform{};  ///< GDAL's: from the corner of the first pixel
    int m_bands = 0;
    std::string m_crsName;
    bool m_geographic = false;
    double m_metresPerUnit = 1.0;
    std::string m_heightUnit;
    double m_metresPerHeightUnit = 0.0;
};

}  // namespace rubble::io
