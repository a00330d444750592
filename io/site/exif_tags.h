#pragma once

#include <cstdint>
#include <istream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rubble::io {

/// The directories of an EXIF block (JEITA CP-3451).
enum class ExifDirectory : std::uint8_t { First, Exif, Gps };

/// What stands under one tag.
struct ExifEntry {
    std::vector<double> numbers;  ///< finite ones, in their order; of a byte as of a fraction
    std::string text;             ///< of text, up to its end, without blanks there
};

using ExifTags = std::map<std::pair<ExifDirectory, int>, ExifEntry>;

/// What a file of a photograph says under the tags of EXIF.
struct ExifReading {
    enum class State : std::uint8_t {
        Read,     ///< there are tags
        None,     ///< the file has no EXIF
        NotRead,  ///< it has some, or may have, in a way that is not read
        Damaged,  ///< what is said to be EXIF is none
    };
    State state = State::None;
    ExifTags tags;
};

/// Reads the EXIF of a JPEG (segment APP1), a PNG (chunk eXIf) or a TIFF (its own directories). Every count and offset is bounded
/// by the length of the block; entries that lead out of it are left out.
ExifReading exifOfPicture(std::istream& file);
/// Reads a block of its own, which begins with the mark of a TIFF.
ExifReading exifOfBlock(const std::string& block);

}  // namespace rubble::io
