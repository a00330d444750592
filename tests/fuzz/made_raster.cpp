#include "tests/fuzz/made_raster.h"

#include <cmath>
#include <limits>

#include "io/site/clouds/height_source.h"

namespace rubble {

MadeRaster& madeRaster() {
    static MadeRaster made;
    return made;
}

}  // namespace rubble

namespace rubble::io {

struct RasterFile::Handles {};

// Stands in for GDAL.
RasterFile::RasterFile(const std::string& path, Holds, const std::string&)
    : m_path(path),
      m_place(madeRaster().place),
      m_turned(madeRaster().transform[2] != 0.0 || madeRaster().transform[4] != 0.0),
      m_transform(madeRaster().transform),
      m_bands(madeRaster().bands),
      m_crsName(madeRaster().crs),
      m_geographic(madeRaster().geographic),
      m_metresPerUnit(madeRaster().metres),
      m_heightUnit(madeRaster().heightUnit),
      m_metresPerHeightUnit(madeRaster().heightMetres) {}

RasterFile::~RasterFile() = default;

RasterFile::SameCrs RasterFile::sameCrs(const std::string&) const {
    return madeRaster().same;
}

std::string RasterFile::entry(const std::string&) const {
    return {};
}

std::vector<std::string> RasterFile::bandNames() const {
    return std::vector<std::string>(static_cast<std::size_t>(m_bands));
}

void RasterFile::take(const std::vector<int>&) {}

std::string RasterFile::verticalDatum() const {
    return madeRaster().datum;
}

std::string RasterFile::verticalDatum(const std::string& crs) {
    return crs.empty() ? "" : "DHHN2016 height";
}

// Another system bends what is straight, and knows no place beyond its edge.
void RasterFile::change(const std::string& crs, bool toFile, std::vector<Eigen::Vector2d>& places) const {
    const bool other = !crs.empty() && !m_crsName.empty() && madeRaster().same == SameCrs::No;
    for (Eigen::Vector2d& place : places) {
        place *= toFile ? 1.0 / m_metresPerUnit : m_metresPerUnit;
        if (other) {
            place += Eigen::Vector2d::Constant(madeRaster().bend * place.squaredNorm());
        }
        if (!place.allFinite()) {
            place.setConstant(std::numeric_limits<double>::quiet_NaN());
        }
    }
}

void RasterFile::toPixels(const std::string& crs, std::vector<Eigen::Vector2d>& places) const {
    change(crs, true, places);
    Eigen::Matrix2d way;
    way << m_transform[1], m_transform[2], m_transform[4], m_transform[5];
    const Eigen::Matrix2d back = way.inverse();
    for (Eigen::Vector2d& place : places) {
        place = back * (place - Eigen::Vector2d(m_transform[0], m_transform[3])) - Eigen::Vector2d(0.5, 0.5);
    }
}

void RasterFile::fromPixels(const std::string& crs, std::vector<Eigen::Vector2d>& places) const {
    Eigen::Matrix2d way;
    way << m_transform[1], m_transform[2], m_transform[4], m_transform[5];
    for (Eigen::Vector2d& place : places) {
        place = way * (place + Eigen::Vector2d(0.5, 0.5)) + Eigen::Vector2d(m_transform[0], m_transform[3]);
    }
    change(crs, false, places);
}

std::vector<double> RasterFile::values(const RasterWindow& window, const Execution&) const {
    if (window.factor < 1 || window.column > m_place.columns || window.columns > m_place.columns - window.column ||
        window.row > m_place.rows || window.rows > m_place.rows - window.row || window.columns % window.factor != 0 ||
        window.rows % window.factor != 0) {
        __builtin_trap();
    }
    std::vector<double> values(window.width() * window.height(), 1.0);
    for (std::size_t i = 0; i < values.size() && !madeRaster().heights.empty(); ++i) {
        values[i] = madeRaster().heights[i % madeRaster().heights.size()];
    }
    return values;
}

void RasterFile::checkWay(const std::string&, const Eigen::Vector2d&, Findings&) const {}

// No file is a cloud where heights are wanted.
HeightSource::HeightSource(const std::string& path, CloudPart, const CloudRequest&, const Frame&, const Site&, const SiteWindow&,
                           const Execution&)
    : m_path(path) {}

GdalMemoryFile::~GdalMemoryFile() = default;

std::vector<std::uint8_t> RasterFile::colours(const RasterWindow& window, const Execution&, Findings&) const {
    return std::vector<std::uint8_t>(4 * window.width() * window.height(), 255);
}

}  // namespace rubble::io
