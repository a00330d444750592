#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "io/site/clouds/cloud_head.h"
#include "io/site/clouds/e57/e57_pages.h"

namespace rubble::io {

/// How the values of one column lie in an E57.
struct E57Field {
    enum class Kind : std::uint8_t { Single, Double, Whole, Text };
    std::string name;
    Kind kind = Kind::Double;
    std::int64_t least = 0;  ///< of whole numbers, which lie as differences from it
    std::uint32_t bits = 64;
    double scale = 1.0;  ///< of whole numbers
    double offset = 0.0;
};

/// Where the points of a scan lie.
struct E57Points {
    std::uint64_t start = 0;  ///< of the section, in the content
    std::uint64_t records = 0;
    std::vector<E57Field> fields;
    double colourLeast = 0.0;
    double colourMost = 0.0;  ///< 0: not stated
};

/// What the XML of an E57 says.
struct E57Head {
    std::string crs;
    std::vector<CloudScan> scans;
    std::vector<E57Points> points;  ///< of each scan
    std::vector<CloudPhotograph> photographs;
};

/// Throws ParseError: the XML is damaged, or a column is of a kind that is not known.
E57Head readE57Head(E57Pages& pages, Findings& findings);

}  // namespace rubble::io
