#include "io/site/raster_colours.h"

#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "core/base/small_letters.h"
#include "io/base/file_words.h"

namespace rubble::io {

namespace {

constexpr std::array<GDALColorInterp, 3> colourMeanings{GCI_RedBand, GCI_GreenBand, GCI_BlueBand};
constexpr std::array<std::string_view, 3> colourNames{"red", "green", "blue"};

/// The band that says to hold a colour, by its meaning or else by its name; null: none does.
GDALRasterBand* bandOf(GDALDataset& file, std::size_t colour) {
    for (const bool byName : {false, true}) {
        for (int b = 1; b <= file.GetRasterCount(); ++b) {
            GDALRasterBand* band = file.GetRasterBand(b);
            const std::string name = inSmallLetters(band->GetDescription());
            if (byName ? name == colourNames[colour] : band->GetColorInterpretation() == colourMeanings[colour]) {
                return band;
            }
        }
    }
    return nullptr;
}

GDALRasterBand* opacityBand(GDALDataset& file) {
    for (int b = 1; b <= file.GetRasterCount(); ++b) {
        if (file.GetRasterBand(b)->GetColorInterpretation() == GCI_AlphaBand) {
            return file.GetRasterBand(b);
        }
    }
    return nullptr;
}

void assignByPlace(GDALDataset& file, ColourBands& bands, int count, const std::string& path, Findings& findings) {
    const bool grey = count < 3;
    for (std::size_t colour = 0; colour < 3; ++colour) {
        bands.colours[colour] = file.GetRasterBand(grey ? 1 : static_cast<int>(colour) + 1);
    }
    if (count == 2) {
        addFinding(
            findings, path,
            {"orthophoto.second_band", "the picture has two bands, and none says what it holds; the first is taken as grey", {}},
            "name the colours of the bands with gdal_translate -colorinterp if that is not right");
    } else if (!grey) {
        addFinding(findings, path,
                   {"orthophoto.bands_assumed",
                    "the {0} bands of the picture do not say their colours; the first three are taken as red, green and blue",
                    {count}},
                   "name the colours of the bands with gdal_translate -colorinterp if that is not right");
    }
}

/// Bits that a band says its numbers have; 0: it does not say.
int bitsStated(GDALRasterBand& band) {
    const char* text = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE");
    return text != nullptr ? std::clamp(std::atoi(text), 0, 16) : 0;
}

void addMasks(GDALDataset& file, ColourBands& bands) {
    if (GDALRasterBand* opacity = opacityBand(file)) {
        bands.masks = {opacity};
        const int stated = bitsStated(*opacity);
        const int bits = opacity->GetRasterDataType() == GDT_UInt16 && stated == 0 ? 16 : stated;
        bands.maskScale = bits > 0 ? 255.0F / static_cast<float>((1 << bits) - 1) : 1.0F;
        return;
    }
    for (GDALRasterBand* band : bands.colours) {
        if ((band->GetMaskFlags() & GMF_ALL_VALID) != 0) {
            // Where one colour is always there, so is the pixel.
            bands.masks.clear();
            return;
        }
        if (std::find(bands.masks.begin(), bands.masks.end(), band->GetMaskBand()) == bands.masks.end()) {
            bands.masks.push_back(band->GetMaskBand());
        }
    }
}

}  // namespace

ColourBands colourBands(GDALDataset& file, const std::string& path, Findings& findings) {
    ColourBands bands;
    const int count = file.GetRasterCount() - (opacityBand(file) != nullptr ? 1 : 0);
    for (std::size_t colour = 0; colour < 3; ++colour) {
        bands.colours[colour] = bandOf(file, colour);
    }
    if (std::find(bands.colours.begin(), bands.colours.end(), nullptr) != bands.colours.end()) {
        assignByPlace(file, bands, count, path, findings);
    }
    if (bands.colours[0] == bands.colours[1]) {
        bands.palette = bands.colours[0]->GetColorTable();
    }
    addMasks(file, bands);
    return bands;
}

bool holdsColours(GDALDataset& file, int bands) {
    const GDALDataType type = file.GetRasterBand(1)->GetRasterDataType();
    const GDALColorInterp meaning = file.GetRasterBand(1)->GetColorInterpretation();
    const bool grey = type == GDT_Byte || (type == GDT_UInt16 && meaning == GCI_GrayIndex);
    return !GDALDataTypeIsComplex(type) && (grey || bands >= 3);
}

std::uint8_t ColourScale::operator()(float value) const {
    // More bits than a byte go down, as their upper byte does; what is no number is black.
    const float scaled = value * factor + (factor < 1.0F ? 1e-3F : 0.5F);
    return static_cast<std::uint8_t>(scaled > 0.0F ? std::min(scaled, 255.0F) : 0.0F);
}

ColourScale colourScale(GDALRasterBand& band, bool palette, float most, const std::string& path, Findings& findings) {
    const GDALDataType type = band.GetRasterDataType();
    if (palette) {
        return {};
    }
    const bool whole = type == GDT_Byte || type == GDT_UInt16 || type == GDT_Int16;
    int bits = whole ? bitsStated(band) : 0;
    const bool stated = bits > 0;
    if (!stated) {
        // Sensors of 12 bits are kept in 16 as they are: their upper byte would be black.
        bits = type == GDT_Byte || most <= 255.0F ? 8 : most <= 4095.0F ? 12 : 16;
    }
    if (!whole && most <= 1.0F) {
        addFinding(findings, path, {"orthophoto.fractions", "the colours of the picture are fractions from 0 to 1", {}},
                   "none is needed if it looks right");
        return {255.0F};
    }
    if (most > 65535.0F) {
        refuseContent({"orthophoto.no_colours", "{0} holds values as large as {1}, which are no colours", {path, most}},
                      "Scale it to bytes with gdal_translate -ot Byte -scale.");
    }
    if (type != GDT_Byte) {
        addFinding(findings, path,
                   stated ? Message{"orthophoto.depth", "the colours of the picture have {0} bits and were scaled to 8", {bits}}
                          : Message{"orthophoto.depth_assumed",
                                    "the picture does not say how many bits its colours have; {0} were taken and scaled to 8, for "
                                    "its greatest "
                                    "value is {1}",
                                    {bits, static_cast<double>(most)}},
                   "scale it to bytes with gdal_translate -ot Byte -scale if it looks too dark or too bright");
    }
    return {bits < 8 ? 255.0F / static_cast<float>((1 << bits) - 1) : 1.0F / static_cast<float>(1 << (bits - 8))};
}

void applyPalette(const GDALColorTable& palette, std::vector<std::uint8_t>& rgba) {
    for (std::size_t k = 0; k + 4 <= rgba.size(); k += 4) {
        GDALColorEntry entry{};
        // A number beyond the palette has no colour.
        palette.GetColorEntryAsRGB(rgba[k], &entry);
        rgba[k] = static_cast<std::uint8_t>(entry.c1);
        rgba[k + 1] = static_cast<std::uint8_t>(entry.c2);
        rgba[k + 2] = static_cast<std::uint8_t>(entry.c3);
        rgba[k + 3] = std::min(rgba[k + 3], static_cast<std::uint8_t>(entry.c4));
    }
}

}  // namespace rubble::io
