#include "io/site/photograph_file.h"

#include <cpl_error.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/json/run_behind.h"
#include "io/site/exif_tags.h"
#include "io/site/gdal_session.h"
#include "io/site/heif_picture.h"

namespace rubble::io {

namespace {

constexpr int sideMin = 16;                ///< px
constexpr int photographSideMax = 100000;  ///< px
constexpr std::array<const char*, 4> photographFormats{"JPEG", "PNG", "GTiff", nullptr};
constexpr const char* siblings[] = {nullptr};  ///< no file beside the photograph says anything of it

void checkPhotograph(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) || !std::ifstream(path, std::ios::binary)) {
        failToRead(path);
    }
}

[[noreturn]] void refusePicture(const std::string& path, const std::string& reason) {
    throw ParseError({"photo.no_photograph", "{0} is no photograph that can be read: {1}", {path, reason}},
                     {"photo.no_photograph.remedy", "Give a JPEG, PNG, TIFF or HEIC file, copied anew from where it came.", {}});
}

[[noreturn]] void refusePixels(const std::string& path, const std::string& reason) {
    throw ParseError({"photo.no_pixels", "The pixels of {0} cannot be read: {1}", {path, reason}},
                     {"photo.no_pixels.remedy", "Copy the photograph anew from where it came, or save it again as JPEG.", {}});
}

void checkSize(const std::string& path, int width, int height) {
    if (std::min(width, height) < sideMin || std::max(width, height) > photographSideMax) {
        throw ParseError(
            {"photo.size", "{0} has {1} x {2} pixels, which is no photograph that could be matched", {path, width, height}},
            {"photo.size.remedy", "Give a picture of 16 to 100,000 pixels on each side.", {}});
    }
}

GDALDatasetUniquePtr openPicture(const std::string& path) {
    GDALDatasetUniquePtr dataset(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, photographFormats.data(), nullptr, siblings)));
    if (!dataset || dataset->GetRasterCount() < 1) {
        refusePicture(path, GdalSession::reason());
    }
    checkSize(path, dataset->GetRasterXSize(), dataset->GetRasterYSize());
    return dataset;
}

std::unique_ptr<HeifPicture> openHeif(const std::string& path) {
    try {
        auto picture = std::make_unique<HeifPicture>(path);
        checkSize(path, picture->width(), picture->height());
        return picture;
    } catch (const std::runtime_error& error) {
        refusePicture(path, error.what());
    }
}

ExifReading exifOfFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return exifOfPicture(file);
}

std::string textOf(const ExifTags& tags, ExifDirectory directory, int tag) {
    const auto entry = tags.find({directory, tag});
    std::string text = entry != tags.end() ? entry->second.text : "";
    // What stands in a case must be UTF-8; makers of cameras have ASCII.
    std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    return text;
}

std::vector<double> numbersOf(const ExifTags& tags, ExifDirectory directory, int tag) {
    const auto entry = tags.find({directory, tag});
    return entry != tags.end() ? entry->second.numbers : std::vector<double>();
}

std::optional<double> positiveOf(const ExifTags& tags, int tag) {
    const std::vector<double> numbers = numbersOf(tags, ExifDirectory::Exif, tag);
    return !numbers.empty() && numbers.front() > 0.0 ? std::optional(numbers.front()) : std::nullopt;
}

/// Degrees, minutes and seconds under a tag, and the side of the Earth under the one before; nothing if they are none.
std::optional<double> angleOf(const ExifTags& tags, int tag, double most) {
    const std::vector<double> parts = numbersOf(tags, ExifDirectory::Gps, tag);
    if (parts.size() != 3) {
        return std::nullopt;
    }
    const double degrees = parts[0] + parts[1] / 60.0 + parts[2] / 3600.0;
    const std::string side = textOf(tags, ExifDirectory::Gps, tag - 1);
    const double sign = side.starts_with('S') || side.starts_with('W') ? -1.0 : 1.0;
    return degrees >= 0.0 && degrees <= most ? std::optional(sign * degrees) : std::nullopt;
}

int orientationOf(const ExifTags& tags) {
    const std::vector<double> numbers = numbersOf(tags, ExifDirectory::First, 0x112);
    return numbers.size() == 1 && numbers[0] >= 1.0 && numbers[0] <= 8.0 ? static_cast<int>(numbers[0]) : 1;
}

/// Turned onto a side: width and height change places.
bool onASide(int orientation) {
    return orientation >= 5;
}

/// What the tags say of a picture of a size as stored.
PhotoFacts factsOf(const ExifTags& tags, int width, int height, int orientation) {
    PhotoFacts facts;
    facts.orientation = orientation;
    facts.width = width;
    facts.height = height;
    const auto wide = positiveOf(tags, 0xa002);
    const auto high = positiveOf(tags, 0xa003);
    if (wide && high && *wide <= photographSideMax && *high <= photographSideMax) {
        facts.recorded = {static_cast<int>(*wide), static_cast<int>(*high)};
    }
    if (onASide(facts.orientation)) {
        std::swap(facts.width, facts.height);
        if (facts.recorded) {
            std::swap((*facts.recorded)[0], (*facts.recorded)[1]);
        }
    }
    facts.focalLength = positiveOf(tags, 0x920a);
    facts.focalLength35 = positiveOf(tags, 0xa405);
    const std::string make = textOf(tags, ExifDirectory::First, 0x10f);
    const std::string model = textOf(tags, ExifDirectory::First, 0x110);
    facts.camera = model.starts_with(make) || make.empty() ? model : make + " " + model;
    facts.taken = clockTime(textOf(tags, ExifDirectory::Exif, 0x9003));
    const auto north = angleOf(tags, 2, 90.0);
    const auto east = angleOf(tags, 4, 180.0);
    if (north && east) {
        facts.position = {*north, *east};
    }
    if (const std::vector<double> altitude = numbersOf(tags, ExifDirectory::Gps, 6); altitude.size() == 1) {
        const std::vector<double> below = numbersOf(tags, ExifDirectory::Gps, 5);
        facts.altitude = !below.empty() && below[0] == 1.0 ? -altitude[0] : altitude[0];
    }
    return facts;
}

void find(Findings& findings, Message what, std::string_view remedy) {
    std::string id = what.id + ".remedy";
    findings.add(what, {std::move(id), std::string(remedy), {}});
}

void addFindings(PhotographFile& file, ExifReading::State state) {
    const PhotoFacts& facts = file.facts;
    constexpr std::string_view byHand =
        "The focal length is found from the point pairs. For the time, untick \"when all lay at rest\" and type it.";
    if (state == ExifReading::State::NotRead) {
        find(file.findings,
             {"photo.exif_not_read",
              "What the photograph says of its camera, time and place is not read from this kind of file.",
              {}},
             "The focal length is found from the point pairs. For the time, untick \"when all lay at rest\" and type it, or give "
             "the photograph as it came from the camera.");
    } else if (state == ExifReading::State::Damaged) {
        find(file.findings,
             {"photo.exif_damaged", "What the photograph says of its camera, time and place is damaged and cannot be read.", {}},
             "Copy the photograph anew from where it came. Else untick \"when all lay at rest\" and type the time.");
    } else if (!facts.focalLength && !facts.focalLength35 && facts.taken.empty() && facts.camera.empty()) {
        find(file.findings, {"photo.no_exif", "The photograph says nothing of its camera, time and place.", {}}, byHand);
    }
    const bool other = facts.recorded && ((*facts.recorded)[0] != facts.width || (*facts.recorded)[1] != facts.height);
    if (other && cropped(facts)) {
        find(file.findings,
             {"photo.cropped",
              "The photograph has {0} x {1} pixels, the camera recorded {2} x {3}: it is cropped.",
              {facts.width, facts.height, (*facts.recorded)[0], (*facts.recorded)[1]}},
             "Let the principal point be found, or take the photograph as it came from the camera.");
    } else if (other) {
        find(file.findings,
             {"photo.resized",
              "The photograph has {0} x {1} pixels, the camera recorded {2} x {3}: it was made smaller or larger.",
              {facts.width, facts.height, (*facts.recorded)[0], (*facts.recorded)[1]}},
             "The photograph as it came from the camera shows more.");
    }
}

/// A picture as stored turned upright, for the eight ways in which EXIF says that a camera was held.
std::vector<std::uint8_t> upright(const std::vector<std::uint8_t>& stored, int w, int h, int orientation) {
    if (orientation == 1) {
        return stored;
    }
    const int width = onASide(orientation) ? h : w;
    const int height = onASide(orientation) ? w : h;
    std::vector<std::uint8_t> turned(stored.size());
    std::uint8_t* out = turned.data();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, out += 3) {
            int column = onASide(orientation) ? y : x;
            int row = onASide(orientation) ? x : y;
            if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8) {
                column = w - 1 - column;
            }
            if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7) {
                row = h - 1 - row;
            }
            std::copy_n(stored.data() + 3 * (static_cast<std::ptrdiff_t>(row) * w + column), 3, out);
        }
    }
    return turned;
}

/// How many values a band has for its shades: 256 of a byte, fewer or more where it says how many bits it uses.
int shadesOf(GDALRasterBand& band) {
    const char* said = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE");
    const int bits = said != nullptr ? std::atoi(said) : 0;
    const int stored = band.GetRasterDataType() == GDT_Byte ? 8 : 16;
    return 1 << (bits >= 1 && bits <= stored ? bits : stored);
}

/// Reads one band into every third byte, its darkest shade as 0 and its lightest as 255.
bool readBand(GDALRasterBand& band, int w, int h, std::uint8_t* out, GDALRasterIOExtraArg& extra) {
    const auto read = [&](void* into, GDALDataType type, GSpacing pixel) {
        return band.RasterIO(GF_Read, 0, 0, band.GetXSize(), band.GetYSize(), into, w, h, type, pixel,
                             pixel * static_cast<GSpacing>(w), &extra) == CE_None;
    };
    // The numbers of a table of colours are no shades.
    const bool table = band.GetColorTable() != nullptr;
    const int shades = table ? 256 : shadesOf(band);
    const char* white = band.GetDataset()->GetMetadataItem("MINISWHITE", "IMAGE_STRUCTURE");
    const bool inverted = !table && white != nullptr && CPLTestBool(white);
    if (shades == 256 && !inverted) {
        return read(out, GDT_Byte, 3);
    }
    std::vector<float> values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    if (!read(values.data(), GDT_Float32, sizeof(float))) {
        return false;
    }
    for (const float value : values) {
        const double share = std::clamp(static_cast<double>(value) / (shades - 1), 0.0, 1.0);
        *out = static_cast<std::uint8_t>(std::lround(255.0 * (inverted ? 1.0 - share : share)));
        out += 3;
    }
    return true;
}

/// The colours that a picture's numbers stand for.
void applyTable(GDALRasterBand& band, std::vector<std::uint8_t>& rgb) {
    const GDALColorTable* table = band.GetColorTable();
    if (table == nullptr) {
        return;
    }
    for (std::size_t i = 0; i + 2 < rgb.size(); i += 3) {
        const GDALColorEntry* entry = rgb[i] < table->GetColorEntryCount() ? table->GetColorEntry(rgb[i]) : nullptr;
        const std::array<short, 3> colour =
            entry != nullptr ? std::array<short, 3>{entry->c1, entry->c2, entry->c3} : std::array<short, 3>{};
        std::transform(colour.begin(), colour.end(), rgb.begin() + static_cast<std::ptrdiff_t>(i),
                       [](short value) { return static_cast<std::uint8_t>(value); });
    }
}

int CPL_STDCALL heed(double, const char*, void* execution) {
    return static_cast<const Execution*>(execution)->cancelled() ? FALSE : TRUE;
}

}  // namespace

PhotographFile readPhotograph(const std::string& path) {
    checkPhotograph(path);
    PhotographFile file;
    ExifReading exif;
    if (looksLikeHeif(path)) {
        const auto picture = openHeif(path);
        if (const std::string block = picture->exif(); !block.empty()) {
            exif = exifOfBlock(block);
        }
        // The file's own boxes have turned it; EXIF only repeats them.
        file.facts = factsOf(exif.tags, picture->width(), picture->height(), 1);
        auto& recorded = file.facts.recorded;
        const bool upright = recorded && ((*recorded)[0] > (*recorded)[1]) == (file.facts.width > file.facts.height);
        if (recorded && !upright) {
            std::swap((*recorded)[0], (*recorded)[1]);
        } else if (upright && onASide(orientationOf(exif.tags))) {
            find(file.findings,
                 {"photo.heif_turn",
                  "EXIF says that the photograph lies on a side, the boxes of its HEIF file do not; these count.",
                  {}},
                 "If it lies on its side, turn it in a program for photographs and add it anew.");
        }
    } else {
        exif = exifOfFile(path);
        const GdalSession session;
        const GDALDatasetUniquePtr dataset = openPicture(path);
        file.facts = factsOf(exif.tags, dataset->GetRasterXSize(), dataset->GetRasterYSize(), orientationOf(exif.tags));
    }
    file.sha256 = sha256OfFile(path);
    addFindings(file, exif.state);
    noteRunBehind(file.findings, path, runWithin(path), {});
    return file;
}

namespace {

/// Sides of a picture of a size made smaller.
std::array<int, 2> smallerSides(int width, int height, int longestSide) {
    const double scale = std::min(1.0, static_cast<double>(longestSide) / std::max(width, height));
    return {std::max(1, static_cast<int>(std::lround(scale * width))), std::max(1, static_cast<int>(std::lround(scale * height)))};
}

PhotoPicture readHeif(const std::string& path, int longestSide, const Execution& execution) {
    const auto file = openHeif(path);
    PhotoPicture picture;
    const auto [w, h] = smallerSides(file->width(), file->height(), longestSide);
    picture.width = w;
    picture.height = h;
    execution.check();
    try {
        picture.rgb = file->pixels(w, h);
    } catch (const std::runtime_error& error) {
        refusePixels(path, error.what());
    }
    execution.check();
    return picture;
}

}  // namespace

PhotoPicture readPicture(const std::string& path, int longestSide, const Execution& execution) {
    checkPhotograph(path);
    if (looksLikeHeif(path)) {
        return readHeif(path, longestSide, execution);
    }
    const int orientation = orientationOf(exifOfFile(path).tags);
    const GdalSession session;
    const GDALDatasetUniquePtr dataset = openPicture(path);
    if (const GDALDataType type = dataset->GetRasterBand(1)->GetRasterDataType(); type != GDT_Byte && type != GDT_UInt16) {
        refusePixels(path, std::string("its values are of the kind ") + GDALGetDataTypeName(type) + ", not of 8 or 16 bits");
    }
    const auto [w, h] = smallerSides(dataset->GetRasterXSize(), dataset->GetRasterYSize(), longestSide);
    std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    GDALRasterIOExtraArg extra;
    INIT_RASTERIO_EXTRA_ARG(extra);
    const bool table = dataset->GetRasterBand(1)->GetColorTable() != nullptr;
    extra.eResampleAlg = table ? GRIORA_NearestNeighbour : GRIORA_Average;
    extra.pfnProgress = heed;
    extra.pProgressData = const_cast<Execution*>(&execution);
    const bool colour = dataset->GetRasterCount() >= 3;
    CPLErrorReset();
    bool whole = true;
    for (int channel = 0; channel < 3 && whole; ++channel) {
        whole = readBand(*dataset->GetRasterBand(colour ? channel + 1 : 1), w, h, rgb.data() + channel, extra);
        execution.check();
    }
    if (!whole) {
        refusePixels(path, GdalSession::reason());
    }
    PhotoPicture picture;
    if (CPLGetLastErrorType() != CE_None) {
        find(picture.findings, {"photo.damaged", "The photograph is damaged: {0}", {GdalSession::reason()}},
             "A part of it may be missing; copy it anew from where it came.");
    }
    applyTable(*dataset->GetRasterBand(1), rgb);
    picture.rgb = upright(rgb, w, h, orientation);
    picture.width = onASide(orientation) ? h : w;
    picture.height = onASide(orientation) ? w : h;
    return picture;
}

}  // namespace rubble::io
