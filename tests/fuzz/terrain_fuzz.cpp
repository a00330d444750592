#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/base/trial.h"
#include "io/case/terrain_reader.h"
#include "io/site/raster_file.h"
#include "tests/fuzz/fuzzed_file.h"

using namespace rubble;

namespace {

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

MadeRaster& raster() {
    static MadeRaster made;
    return made;
}

double lengthFrom(FuzzedDataProvider& data) {
    return data.ConsumeBool() ? data.ConsumeIntegral<std::int16_t>() : data.ConsumeFloatingPoint<double>();
}

double finite(double value, double otherwise) {
    return std::isfinite(value) && value != 0.0 ? value : otherwise;
}

// Small, or, seldom since it takes a second, so large that only a window of it can be read.
std::size_t pixelsFrom(FuzzedDataProvider& data) {
    return data.ConsumeIntegral<std::uint8_t>() != 255 ? data.ConsumeIntegralInRange<std::size_t>(0, 40)
                                                       : data.ConsumeIntegralInRange<std::size_t>(3000, 0x7fffffff);
}

void makeRaster(FuzzedDataProvider& data) {
    constexpr std::array units{"", "m", "ft", "smoots"};
    MadeRaster& made = raster();
    made = {};
    // What GDAL gives: the reader of rasters refuses what is not finite or has no size.
    for (double& number : made.transform) {
        number = finite(lengthFrom(data), 0.0);
    }
    if (data.ConsumeBool()) {
        made.transform[2] = made.transform[4] = 0.0;
    }
    const auto& g = made.transform;
    if (const double area = std::abs(g[1] * g[5] - g[2] * g[4]); !(area > 0.0)) {
        made.transform = {g[0], 1.0, 0.0, g[3], 0.0, -1.0};
    }
    made.place = {g[0] + 0.5 * g[1], g[3] + 0.5 * g[5], g[1], g[5], pixelsFrom(data), pixelsFrom(data)};
    made.bands = data.ConsumeIntegralInRange(1, 3);
    made.geographic = data.ConsumeProbability<double>() > 0.95;
    made.crs = data.ConsumeBool() ? "EPSG:32633" : "";
    made.heightUnit = data.PickValueInArray(units);
    made.metres = data.ConsumeBool() ? 1.0 : finite(lengthFrom(data), 1.0);
    made.heightMetres = data.ConsumeBool() ? 0.0 : std::abs(finite(lengthFrom(data), 1.0));
    made.bend = data.ConsumeBool() ? 0.0 : lengthFrom(data);
    made.datum = data.ConsumeBool() ? "EVRF2007 height" : "";
    made.same = static_cast<io::RasterFile::SameCrs>(data.ConsumeIntegralInRange(0, 2));
    for (std::size_t i = data.ConsumeIntegralInRange<std::size_t>(0, 64); i > 0; --i) {
        made.heights.push_back(data.ConsumeProbability<double>() > 0.9 ? std::numeric_limits<double>::quiet_NaN()
                                                                       : lengthFrom(data));
    }
}

Site siteFrom(FuzzedDataProvider& data) {
    Site site;
    site.heightShift = data.ConsumeBool() ? 0.0 : finite(lengthFrom(data), 0.0);
    const auto place = [&] {
        const double x = data.ConsumeIntegral<std::int16_t>(), y = data.ConsumeIntegral<std::int16_t>();
        return Vec3(x, y, data.ConsumeIntegral<std::int8_t>());
    };
    for (std::size_t i = data.ConsumeIntegralInRange<std::size_t>(0, 3); i > 0; --i) {
        const Vec3 local = place(), world = place();
        site.controlPoints.push_back({"P" + std::to_string(i), local, world, data.ConsumeBool()});
    }
    return site;
}

}  // namespace

namespace rubble::io {

struct RasterFile::Handles {};

// Nothing here can crash that is not a finding.
bool survivesTrial(const std::function<void()>&, std::chrono::seconds) {
    return true;
}

// Stands in for GDAL.
RasterFile::RasterFile(const std::string& path, Holds)
    : m_path(path),
      m_place(raster().place),
      m_turned(raster().transform[2] != 0.0 || raster().transform[4] != 0.0),
      m_transform(raster().transform),
      m_bands(raster().bands),
      m_crsName(raster().crs),
      m_geographic(raster().geographic),
      m_metresPerUnit(raster().metres),
      m_heightUnit(raster().heightUnit),
      m_metresPerHeightUnit(raster().heightMetres) {}

RasterFile::~RasterFile() = default;

RasterFile::SameCrs RasterFile::sameCrs(const std::string&) const {
    return raster().same;
}

std::string RasterFile::entry(const std::string&) const {
    return {};
}

std::vector<std::string> RasterFile::bandNames() const {
    return std::vector<std::string>(static_cast<std::size_t>(m_bands));
}

void RasterFile::take(const std::vector<int>&) {}

std::string RasterFile::verticalDatum() const {
    return raster().datum;
}

std::string RasterFile::verticalDatum(const std::string& crs) {
    return crs.empty() ? "" : "DHHN2016 height";
}

// Another system bends what is straight, and knows no place beyond its edge.
void RasterFile::change(const std::string& crs, bool toFile, std::vector<Eigen::Vector2d>& places) const {
    const bool other = !crs.empty() && !m_crsName.empty() && raster().same == SameCrs::No;
    for (Eigen::Vector2d& place : places) {
        place *= toFile ? 1.0 / m_metresPerUnit : m_metresPerUnit;
        if (other) {
            place += Eigen::Vector2d::Constant(raster().bend * place.squaredNorm());
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
    for (std::size_t i = 0; i < values.size() && !raster().heights.empty(); ++i) {
        values[i] = raster().heights[i % raster().heights.size()];
    }
    return values;
}

void RasterFile::checkWay(const std::string&, const Eigen::Vector2d&, Findings&) const {}

std::vector<std::uint8_t> RasterFile::colours(const RasterWindow& window, const Execution&, Findings&) const {
    return std::vector<std::uint8_t>(4 * window.width() * window.height(), 255);
}

}  // namespace rubble::io

/// Reads rasters made of any bytes as terrain around structures made of them too.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const std::string path = layDown("raster", 6, "terrain.asc");
    FuzzedDataProvider data(bytes, size);
    makeRaster(data);
    Frame frame;
    frame.origin = {data.ConsumeIntegral<std::int16_t>(), data.ConsumeIntegral<std::int16_t>(),
                    data.ConsumeIntegral<std::int8_t>()};
    frame.crs = data.ConsumeBool() ? "EPSG:32633" : "";
    Aabb around;
    if (data.ConsumeBool()) {
        const Vec3 low(data.ConsumeIntegral<std::int8_t>(), data.ConsumeIntegral<std::int8_t>(),
                       data.ConsumeIntegral<std::int8_t>());
        around.extend(low);
        around.extend(Vec3(low + 0.1 * Vec3(data.ConsumeIntegral<std::uint8_t>(), data.ConsumeIntegral<std::uint8_t>(),
                                            data.ConsumeIntegral<std::uint8_t>())));
    }
    const Site site = siteFrom(data);
    try {
        const io::TerrainInput terrain = io::openTerrain(path, frame, around, fuzzExecution(), site);
        for (const double at : {-1e9, -1.0, 0.0, 0.5, 1e9}) {
            if (!std::isfinite(terrain.grid->height(at, at))) {
                __builtin_trap();
            }
        }
    } catch (const Error&) {
    }
    return 0;
}
