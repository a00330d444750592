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

bool isText(const std::string& path) {
    std::array<unsigned char, 4096> start{};
    const std::size_t got = CloudFile(path).readSome(0, start.data(), start.size());
    return got > 0 && std::none_of(start.data(), start.data() + got, [](unsigned char c) { return c < 9; });
}

/// Whether no format of rasters takes a file.
bool isNoRaster(const std::string& path) {
    try {
        const std::scoped_lock lock(nativeLibraries());
        survivesTrial([&] { const RasterFile file(path); });
    } catch (const ParseError& error) {
        return error.message().id == "terrain.unknown_format";
    }
    return false;
}

/// A file of text as a cloud; null: it is none.
std::unique_ptr<PointCloud> textAsCloud(const std::string& path, const CloudRequest& read) {
    try {
        return openCloud(path, read);
    } catch (const Error&) {
        return nullptr;  // what is said of it as a raster says more
    }
}

/// A table that names its coordinates: a raster of text has three columns as well.
bool namesPlaces(const PointCloud& cloud) {
    return cloud.head().format == "table" && cloud.findings().count("cloud.columns_assumed") == 0;
}

}  // namespace

bool holdsCloud(const std::string& path, const CloudRequest& read) {
    if (beginsAsCloud(path) || !isText(path)) {
        return beginsAsCloud(path);
    }
    const std::unique_ptr<PointCloud> cloud = textAsCloud(path, read);
    return cloud != nullptr && (namesPlaces(*cloud) || isNoRaster(path));
}

void refuseRequestOfNoCloud(const std::string& path) {
    throw UsageError(
        {"cloud.read_no_cloud", "{0} is no point cloud or table of points: it has no columns, and names its system itself", {path}},
        {"cloud.read_no_cloud.remedy", "Leave columns and system out, or give a cloud.", {}});
}

HeightSource::HeightSource(const std::string& path, CloudPart part, const CloudRequest& read, const Frame& frame, const Site& site,
                           const SiteWindow& window, const Execution& execution)
    : m_path(path) {
    if (holdsCloud(path, read)) {
        m_cloud = cloudRaster(path, part, read, frame, site, window, execution);
    } else if (!read.empty()) {
        refuseRequestOfNoCloud(path);
    }
}

}  // namespace rubble::io
