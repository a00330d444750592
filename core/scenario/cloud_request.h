#pragma once

#include <string>
#include <vector>

namespace rubble {

/// How a point cloud or a table of points is to be read, where its file does not say it.
struct CloudRequest {
    std::string crs = {};                   ///< coordinate system, where the file names none; EPSG code, WKT or PROJ
    std::vector<std::string> columns = {};  ///< of a table: x, y, z, intensity, red, green, blue, class, skip
    bool empty() const { return crs.empty() && columns.empty(); }
    friend bool operator==(const CloudRequest&, const CloudRequest&) = default;
};

}  // namespace rubble
