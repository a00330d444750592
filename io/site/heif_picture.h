#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace rubble::io {

/// True if a file begins as HEIF does (HEIC, HEIF, AVIF): a box of the kind "ftyp".
bool looksLikeHeif(const std::string& path);

/// The primary picture of a HEIF file, decoded by libheif, which turns and mirrors it as the file's own boxes say.
class HeifPicture {
public:
    /// Opens a file without decoding it. Throws std::runtime_error with the reason in the words of libheif.
    explicit HeifPicture(const std::string& path);
    ~HeifPicture();
    HeifPicture(const HeifPicture&) = delete;
    HeifPicture& operator=(const HeifPicture&) = delete;

    int width() const;  ///< px, upright
    int height() const;
    /// The EXIF block that belongs to the picture, from the mark of its TIFF on; empty if there is none.
    std::string exif() const;
    /// The picture made smaller by the mean of what falls into a pixel. [height * width * 3]
    /// Throws std::runtime_error as above.
    std::vector<std::uint8_t> pixels(int width, int height) const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

}  // namespace rubble::io
