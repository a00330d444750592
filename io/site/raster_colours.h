#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/finding.h"

class GDALColorTable;
class GDALDataset;
class GDALRasterBand;

namespace rubble::io {

/// The bands of a picture by what they mean.
struct ColourBands {
    std::array<GDALRasterBand*, 3> colours{};  ///< red, green and blue; of grey and of a palette the same one
    const GDALColorTable* palette = nullptr;   ///< null: the numbers are the colours
    std::vector<GDALRasterBand*> masks;        ///< that say which pixels are there; empty: all are
    float maskScale = 1.0F;                    ///< to bytes
};

/// Finds them by the colour that each says it holds, else by its name, else by its place, which is a finding.
ColourBands colourBands(GDALDataset& file, const std::string& path, Findings& findings);

/// Whether a raster can be a picture: of bytes, or with three bands at least.
/// @param bands  without opacity
bool holdsColours(GDALDataset& file, int bands);

/// Takes the values of a band to bytes.
struct ColourScale {
    float factor = 1.0F;
    std::uint8_t operator()(float value) const;
};

/// By the bits of the band: of 16 the upper byte, fewer where it says so, or where no value of the picture needs more, which is a
/// finding. Fractions up to 1 and values up to 255 are taken as such.
/// @param most  greatest value of the picture
/// Throws ParseError where values are no colours.
ColourScale colourScale(GDALRasterBand& band, bool palette, float most, const std::string& path, Findings& findings);

/// Turns numbers of a palette, in the first byte of each pixel, into colours and opacity.
void applyPalette(const GDALColorTable& palette, std::vector<std::uint8_t>& rgba);

}  // namespace rubble::io
