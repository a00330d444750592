#pragma once

#include <optional>
#include <string>

#include "io/site/clouds/cloud_raster.h"

namespace rubble::io {

/// The raster that heights are read from: a file of heights itself, or the grid that a point cloud is laid on. Whether a file is a
/// cloud is told by its content; text is a cloud where it is no raster.
class HeightSource {
public:
    /// @param read  of a cloud. Throws as cloudRaster(), UsageError: it is stated of another file.
    HeightSource(const std::string& path, CloudPart part, const CloudRequest& read, const Frame& frame, const Site& site,
                 const SiteWindow& window, const Execution& execution);

    /// What a reader of rasters opens.
    const std::string& opened() const { return m_cloud ? m_cloud->file->name() : m_path; }
    bool cloud() const { return m_cloud.has_value(); }
    /// Of the cloud.
    Findings findings() const { return m_cloud ? m_cloud->findings : Findings(); }

private:
    std::string m_path;
    std::optional<CloudRaster> m_cloud;
};

/// Whether a file is read as a point cloud where heights are wanted: by its first bytes, as a table whose heading or request names
/// x, y and z, or as another one that is no raster.
bool holdsCloud(const std::string& path, const CloudRequest& read = {});

/// Throws UsageError: system or columns are stated of a file that is no point cloud.
[[noreturn]] void refuseRequestOfNoCloud(const std::string& path);

}  // namespace rubble::io
