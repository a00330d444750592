#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/execution.h"
#include "core/base/finding.h"
#include "core/scenario/photograph.h"

namespace rubble::io {

/// What a photograph's file says, and what to know about it.
struct PhotographFile {
    PhotoFacts facts;
    std::string sha256;  ///< of the file, hex
    Findings findings;   ///< no EXIF or none that is read, cropped, made smaller
};

/// Reads size, EXIF and SHA-256 of a photograph (JPEG, PNG, TIFF, HEIC and HEIF) without its pixels. The file is only read. A HEIF
/// file is upright by its own boxes: its orientation is 1 whatever its EXIF says.
/// Throws WorldError (cannot be read), ParseError (not a photograph, too small or too large).
PhotographFile readPhotograph(const std::string& path);

/// A photograph made smaller, upright.
struct PhotoPicture {
    int width = 0;  ///< px
    int height = 0;
    std::vector<std::uint8_t> rgb;  ///< [height * width * 3], row by row
    Findings findings;              ///< damaged
};

/// Reads the pixels of a photograph at no more than a size, turned upright as EXIF says. Memory goes with that size, not with that
/// of the file, but for a HEIF file, which is decoded as a whole.
/// @param longestSide  px, at most
/// Throws WorldError, ParseError (as above; no pixels can be read), Cancelled.
PhotoPicture readPicture(const std::string& path, int longestSide, const Execution& execution);

}  // namespace rubble::io
