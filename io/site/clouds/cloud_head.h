#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "io/site/clouds/cloud_block.h"

namespace rubble::io {

/// Where a scanner or a camera stood, in units of the file.
struct CloudPose : Pose {
    bool stated = false;   ///< the file says it
    bool applied = false;  ///< the points are brought to it
};

/// One scan of a file that holds several.
struct CloudScan {
    std::string name;
    std::uint64_t promised = 0;  ///< points, by the head
    CloudPose pose;
};

/// A picture that lies in the file with its place.
struct CloudPhotograph {
    std::string name;
    std::string projection;   ///< "pinhole", "spherical", "cylindrical", "visual reference"
    std::string kind;         ///< "jpeg" or "png"
    std::uint64_t start = 0;  ///< of its bytes in the file, for photographBytes()
    std::uint64_t bytes = 0;
    std::int64_t width = 0;                               ///< px
    std::int64_t height = 0;                              ///< px
    double focal = 0.0;                                   ///< px, of a pinhole; 0: the file does not say
    Eigen::Vector2d principal = Eigen::Vector2d::Zero();  ///< px, from the upper left, of a pinhole
    CloudPose pose;                                       ///< it looks along -z of its own frame, y up
};

/// What the numbers of a cloud mean on Earth.
struct CloudUnits {
    std::string name;           ///< of the coordinate system; empty: none is known
    std::string heightSystem;   ///< what heights count from; empty: not known
    bool degrees = false;       ///< x and y are longitude and latitude
    bool geocentric = false;    ///< z is not up
    double metres = 1.0;        ///< per unit of x and y; not a number: they are degrees
    double heightMetres = 1.0;  ///< per unit of z
    bool metresStated = false;  ///< the unit of x and y is known, not assumed
    bool heightStated = false;  ///< that of z is
    bool local() const { return name.empty(); }
};

/// What a file says of itself before its points.
struct CloudHead {
    std::string format;                     ///< "LAS", "LAZ", "E57", "PLY", "PCD", "PTX", "PTS", "table"
    std::string version;                    ///< empty: the format has none
    std::string coding;                     ///< how the points lie, for people: "point format 3, chunks of 50,000 points"
    std::optional<std::uint64_t> promised;  ///< points, those that will be left out among them
    CloudColumns columns;
    double fullColour = 65535.0;  ///< step of full brightness
    std::optional<Vec3> scale;    ///< units of the file, of whole numbers
    std::optional<Vec3> offset;
    Aabb stated;                  ///< bounds that the head states, units of the file; empty: none
    double step = 0.0;            ///< units: neighbouring numbers of single precision at the largest coordinate; 0: they are finer
    std::string crs;              ///< WKT or what was asked for; empty: none
    std::string crsFrom;          ///< "WKT", "GeoTIFF keys", "asked for"
    bool metresByFormat = false;  ///< the format has no other unit
    std::optional<double> planMetres;    ///< in a unit of x and y that headings of columns name
    std::optional<double> heightMetres;  ///< in one of z
    CloudUnits units;
    std::vector<CloudScan> scans;  ///< empty: the format has none
    /// s, on the clock of the FE file: the instant of a run that was scanned; unset: the file does not say one.
    std::optional<double> instant;
    std::string run;    ///< fingerprint of that run, hex; empty: the file does not say one
    bool ours = false;  ///< this program wrote the file
    std::vector<CloudPhotograph> photographs;
    std::vector<std::string> unread;  ///< columns beside those that are kept
};

}  // namespace rubble::io
