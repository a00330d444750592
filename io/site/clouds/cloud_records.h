#pragma once

#include <memory>
#include <vector>

#include "io/site/clouds/cloud_columns.h"
#include "io/site/clouds/cloud_file.h"
#include "io/site/clouds/cloud_source.h"

namespace rubble::io {

/// A number of each point in a file of bytes.
struct StoredColumn {
    ColumnRole role = ColumnRole::Unread;
    NumberType type;
    std::uint64_t start = 0;   ///< of the first point's, in the file or in what was unpacked
    std::uint64_t step = 0;    ///< bytes from one point's to the next
    double colourScale = 1.0;  ///< from its steps to those of 8 or 16 bits
    bool floatBits = false;    ///< a packed colour whose bits are those of a real number
};

/// Numbers of points, in records or column by column.
struct StoredPoints {
    std::vector<StoredColumn> columns;
    std::uint64_t count = 0;
    bool bigEndian = false;
};

/// A cloud whose points lie in records of bytes, one after another; all columns have the step of a record.
/// @param head  what the file says of itself
std::unique_ptr<CloudSource> recordsCloud(std::unique_ptr<CloudFile> file, StoredPoints points, CloudHead head, Findings found);

/// A cloud whose columns lie one after another in memory.
std::unique_ptr<CloudSource> unpackedCloud(std::vector<unsigned char> bytes, StoredPoints points, CloudHead head, Findings found);

}  // namespace rubble::io
