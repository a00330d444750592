#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "io/site/clouds/cloud_summary.h"
#include "io/site/clouds/e57/e57_pages.h"
#include "io/site/clouds/las/las_head.h"

namespace rubble::io {

using CloudBytes = std::vector<unsigned char>;

template <class Number>
void putNumber(CloudBytes& bytes, std::size_t at, Number number) {
    bytes.resize(std::max(bytes.size(), at + sizeof number));
    std::memcpy(&bytes[at], &number, sizeof number);
}

inline std::string layCloud(const std::string& path, const CloudBytes& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return path;
}
inline std::string layCloud(const std::string& path, const std::string& text) {
    return layCloud(path, CloudBytes(text.begin(), text.end()));
}

/// All points that are taken of a cloud, and what is told of it.
struct WholeCloud {
    CloudHead head;
    CloudBlock points;
    CloudSummary summary;
};
inline WholeCloud readCloud(const std::string& path, const CloudRequest& request = {}) {
    const std::unique_ptr<PointCloud> cloud = openCloud(path, request);
    WholeCloud whole;
    whole.points.resize(0, cloud->head().columns);
    whole.summary = summariseCloud(*cloud, Execution(), [&](const CloudBlock& block) {
        for (std::size_t i = 0; i < block.size(); ++i) {
            whole.points.add(block, i);
        }
    });
    whole.head = cloud->head();
    return whole;
}

/// A point of a LAS that is made.
struct MadePoint {
    std::array<std::int32_t, 3> place{};
    std::uint16_t intensity = 0;
    std::uint8_t echo = 1;
    std::uint8_t echoes = 1;
    std::uint8_t kind = 2;
    bool withheld = false;
    double time = 0.0;
    std::array<std::uint16_t, 3> colour{};
};

/// A LAS to be made.
struct MadeLas {
    int minor = 2;
    int format = 0;
    Vec3 scale = Vec3::Constant(0.01);
    Vec3 offset = Vec3::Zero();
    std::string wkt;
    std::size_t extra = 0;  ///< bytes of each point
    std::vector<MadePoint> points;

    CloudBytes bytes() const;
};

/// A section of points of an E57 and the XML that tells of it.
class MadeE57 {
public:
    /// Numbers of one column that lie in so many bits, at most 64.
    struct Column {
        std::uint32_t bits = 64;
        std::vector<std::uint64_t> raw;
    };
    /// Adds the points of a scan in packets of so many. @return the place of its section, for fileOffset
    std::uint64_t addPoints(const std::vector<Column>& columns, std::size_t packetPoints);
    /// Adds bytes of a picture. @return their place, for fileOffset
    std::uint64_t addBlob(const std::string& picture);
    CloudBytes bytes(const std::string& xml) const;

private:
    static constexpr std::size_t content = 1020;
    static std::uint64_t placeInFile(std::uint64_t at) { return at / content * 1024 + at % content; }
    CloudBytes m_content = CloudBytes(48);
};

/// An E57 with one point and two pinhole pictures; the first looks straight down from 10, 20, 50 with y up in it, the second has no
/// pose.
/// @param width    px, as the cloud states it
/// @param which    which one of a small cloud it holds
/// @param pixelHeight  m; their width is 0.1 mm
CloudBytes cloudWithPictures(const std::string& width = "100", std::size_t which = 1, const std::string& pixelHeight = "0.0001");

}  // namespace rubble::io
