#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "io/site/clouds/cloud_file.h"
#include "io/site/clouds/cloud_head.h"

namespace rubble::io {

/// A record of variable length, in front of the points or behind them.
struct LasRecord {
    std::string user;
    std::uint16_t id = 0;
    std::string description;
    std::uint64_t start = 0;  ///< of its content in the file
    std::uint64_t bytes = 0;
};

/// Where the numbers of a point lie in its record, in bytes; below zero: the format has none.
struct LasLayout {
    int format = 0;
    std::size_t bytes = 0;  ///< that the format takes
    bool wide = false;      ///< formats 6 to 10
    int time = -1;
    int colour = -1;
    int waves = -1;
};

/// The layout of a point format from 0 to 10; nothing for any other.
std::optional<LasLayout> lasLayout(int format);

/// Where a scanner stood, in units of the file, and how many points it has.
struct LasScanner {
    Vec3 place = Vec3::Zero();
    std::uint64_t points = 0;
};

/// The head of a LAS file, checked against its length.
struct LasHead {
    int minor = 0;
    LasLayout layout;
    bool packed = false;  ///< LAZ
    std::size_t recordBytes = 0;
    std::uint64_t pointsStart = 0;
    std::uint64_t points = 0;
    bool wkt = false;  ///< its system is WKT
    Vec3 scale = Vec3::Ones();
    Vec3 offset = Vec3::Zero();
    Aabb stated;
    std::vector<LasRecord> records;
    std::vector<LasScanner> scanners;  ///< of a scan that we wrote; else empty
    std::optional<double> instant;     ///< s, of the run of such a scan; unset: at rest, or no scan of ours
    std::string run;                   ///< fingerprint of that run, hex; empty: no scan of ours, or an older one
    bool ours = false;                 ///< the head names this program as the one that made it

    const LasRecord* record(std::string_view user, std::uint16_t id) const;
};

/// Reads the head of a LAS or LAZ, 1.0 to 1.4. Records that cannot be are left out and counted. Throws ParseError.
LasHead readLasHead(const CloudFile& file, Findings& findings);

/// What people call the columns of the extra bytes of each point, empty if nothing tells.
std::vector<std::string> lasExtraNames(const CloudFile& file, const LasHead& head);

}  // namespace rubble::io
