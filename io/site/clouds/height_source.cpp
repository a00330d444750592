#include "io/site/clouds/height_source.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "io/base/native_lock.h"
#include "io/base/trial.h"
#include "io/site/clouds/cloud_file.h"
#include "io/site/clouds/point_cloud.h"
#include "io/site/raster_file.h"

namespace rubble::io {

namespace {

/// Whether a file is text that no format of rasters takes.
bool textWithoutRaster(const std::string& path) {
    std::array<unsigned char, 4096> start{};
    const std::size_t got = CloudFile(path).readSome(0, start.data(), start.size());
    const bool text = std::none_of(start.data(), start.data() + got, [](unsigned char c) { return c < 9; });
    if (!text || got == 0) {
        return false;
    }
    try {
        const std::scoped_lock lock(nativeLibraries());
        survivesTrial([&] { const RasterFile file(path); });
    } catch (const ParseError& error) {
        return error.message().id == "terrain.unknown_format";
    }
    return false;
}

bool opensAsCloud(const std::string& path) {
    try {
        openCloud(path);
        return true;
    } catch (const Error&) {
        return false;  // what is said of it as a raster says more
    }
}

}  // namespace

bool holdsCloud(const std::string& path) {
    return beginsAsCloud(path) || (textWithoutRaster(path) && opensAsCloud(path));
}

HeightSource::HeightSource(const std::string& path, CloudPart part, const Frame& frame, const Site& site, const SiteWindow& window,
                           const Execution& execution)
    : m_path(path) {
    if (holdsCloud(path)) {
        m_cloud = cloudRaster(path, part, frame, site, window, execution);
    }
}

}  // namespace rubble::io
