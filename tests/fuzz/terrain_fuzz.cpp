#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "io/case/terrain_reader.h"
#include "tests/fuzz/fuzzed_file.h"
#include "tests/fuzz/made_raster.h"

using namespace rubble;

namespace {

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
    MadeRaster& made = madeRaster();
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
