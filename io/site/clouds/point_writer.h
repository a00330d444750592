#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// The record of a LAS of ours that says where its scanners stood: for each three doubles, in the numbers of the file, and how many
/// points it has. The source of a point is then the number of its scanner, from 1.
inline constexpr const char* scannerUser = "Rubble";
inline constexpr std::uint16_t scannerRecord = 1;
inline constexpr std::size_t scannerBytes = 32;
/// The record of a LAS of ours that says which instant of a run it was taken of: a double, s on the clock of the FE file.
inline constexpr std::uint16_t instantRecord = 2;
/// The record of a LAS of ours that says which run was scanned: its fingerprint, hex.
inline constexpr std::uint16_t runRecord = 3;
/// What a LAS of ours names as the program that made it.
inline constexpr const char* writingProgram = "Rubble";

/// Bytes as they stand in a file, little end first.
using FileBytes = std::vector<unsigned char>;

template <class Number>
void appendNumber(FileBytes& bytes, Number number) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof number);
    std::memcpy(&bytes[at], &number, sizeof number);
}

/// A number that points have beside those of every cloud.
struct WrittenColumn {
    const char* name;
    std::uint8_t ofLas;  ///< its type among extra bytes
    const char* ofPly;
    std::uint16_t bytes;
};

/// Where a scanner stood, in the numbers of the file, and how many points are its own.
struct WrittenScanner {
    Vec3 place = Vec3::Zero();
    std::uint64_t points = 0;
};

/// What a cloud that is written says before its points.
struct WrittenCloud {
    std::uint64_t points = 0;
    Aabb box;         ///< of all points, in the numbers of the file
    std::string crs;  ///< EPSG code, WKT or PROJ; empty: none is written
    std::vector<WrittenColumn> columns = {};
    std::vector<WrittenScanner> scanners = {};  ///< empty: points are of no scan
    std::optional<double> instant =
        {};                ///< s, on the clock of the FE file, of the run that was scanned; unset: at rest, or no scan
    std::string run = {};  ///< fingerprint of the run that was scanned, hex; empty: no scan
    bool classes = false;  ///< a PLY gets a column of classes; a LAS has one anyway
};

/// A point that is written.
struct WrittenPoint {
    Vec3 place = Vec3::Zero();
    std::array<std::uint8_t, 3> colour{};
    std::uint8_t kind = 0;      ///< class
    std::uint16_t scanner = 0;  ///< index
    FileBytes more = {};        ///< the columns, one behind the other
};

/// Whether a path ends as that of a cloud that can be written: .las or .ply.
bool namesWrittenCloud(const std::string& path);

/// Writes points as LAS 1.4 or as a binary PLY, by the ending of the path. Atomic; equal points give equal bytes.
/// @param fill  (k, point) makes a point that is empty the one with number k
/// Throws WorldError.
void writePoints(const std::string& path, const WrittenCloud& cloud, const std::function<void(std::size_t, WrittenPoint&)>& fill);

}  // namespace rubble::io
