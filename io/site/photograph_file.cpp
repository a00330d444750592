#include "io/site/photograph_file.h"

#include <cpl_error.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

#include "core/base/error.h"
#include "io/base/files.h"
#include "io/site/gdal_session.h"

namespace rubble::io {

namespace {

constexpr int sideMin = 16;                ///< px
constexpr int photographSideMax = 100000;  ///< px
constexpr std::array<const char*, 4> photographFormats{"JPEG", "PNG", "GTiff", nullptr};
constexpr const char* siblings[] = {nullptr};  ///< no file beside the photograph says anything of it

void checkPhotograph(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) || !std::ifstream(path, std::ios::binary)) {
        throw WorldError({"photo.unreadable", "The photograph {0} cannot be read", {path}},
                         {"photo.unreadable.remedy", "Check that the file is there and that you may read it.", {}});
    }
}

GDALDatasetUniquePtr openPicture(const std::string& path) {
    GDALDatasetUniquePtr dataset(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, photographFormats.data(), nullptr, siblings)));
    if (!dataset || dataset->GetRasterCount() < 1) {
        throw ParseError({"photo.no_photograph", "{0} is no photograph that can be read: {1}", {path, GdalSession::reason()}},
                         {"photo.no_photograph.remedy", "Give a JPEG, PNG or TIFF file, copied anew from where it came.", {}});
    }
    const int shortest = std::min(dataset->GetRasterXSize(), dataset->GetRasterYSize());
    const int longest = std::max(dataset->GetRasterXSize(), dataset->GetRasterYSize());
    if (shortest < sideMin || longest > photographSideMax) {
        throw ParseError({"photo.size",
                          "{0} has {1} x {2} pixels, which is no photograph that could be matched",
                          {path, dataset->GetRasterXSize(), dataset->GetRasterYSize()}},
                         {"photo.size.remedy", "Give a picture of 16 to 100,000 pixels on each side.", {}});
    }
    return dataset;
}

std::string textOf(GDALDataset& dataset, const char* key) {
    const char* value = dataset.GetMetadataItem(key);
    std::string text = value != nullptr ? value : "";
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) {
        text.pop_back();
    }
    // What stands in a case must be UTF-8; makers of cameras have ASCII.
    std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    return text;
}

/// The numbers in "(51) (30) (12.3)".
std::vector<double> numbersOf(GDALDataset& dataset, const char* key) {
    const std::string text = textOf(dataset, key);
    std::vector<double> numbers;
    for (const char* c = text.data(); c < text.data() + text.size();) {
        double number = 0.0;
        const auto [end, error] = std::from_chars(c, text.data() + text.size(), number);
        if (error == std::errc{} && std::isfinite(number)) {
            numbers.push_back(number);
        }
        c = error == std::errc{} ? end : c + 1;
    }
    return numbers;
}

std::optional<double> positiveOf(GDALDataset& dataset, const char* key) {
    const std::vector<double> numbers = numbersOf(dataset, key);
    return !numbers.empty() && numbers.front() > 0.0 ? std::optional(numbers.front()) : std::nullopt;
}

/// Degrees, minutes and seconds; nothing if they are none.
std::optional<double> angleOf(GDALDataset& dataset, const std::string& key, double most) {
    const std::vector<double> parts = numbersOf(dataset, key.c_str());
    if (parts.size() != 3) {
        return std::nullopt;
    }
    const double degrees = parts[0] + parts[1] / 60.0 + parts[2] / 3600.0;
    const std::string side = textOf(dataset, (key + "Ref").c_str());
    const double sign = side.starts_with('S') || side.starts_with('W') ? -1.0 : 1.0;
    return degrees >= 0.0 && degrees <= most ? std::optional(sign * degrees) : std::nullopt;
}

int orientationOf(GDALDataset& dataset) {
    const std::vector<double> numbers = numbersOf(dataset, "EXIF_Orientation");
    return numbers.size() == 1 && numbers[0] >= 1.0 && numbers[0] <= 8.0 ? static_cast<int>(numbers[0]) : 1;
}

/// Turned onto a side: width and height change places.
bool onASide(int orientation) {
    return orientation >= 5;
}

PhotoFacts factsOf(GDALDataset& dataset) {
    PhotoFacts facts;
    facts.orientation = orientationOf(dataset);
    facts.width = dataset.GetRasterXSize();
    facts.height = dataset.GetRasterYSize();
    const auto wide = positiveOf(dataset, "EXIF_PixelXDimension");
    const auto high = positiveOf(dataset, "EXIF_PixelYDimension");
    if (wide && high && *wide <= photographSideMax && *high <= photographSideMax) {
        facts.recorded = {static_cast<int>(*wide), static_cast<int>(*high)};
    }
    if (onASide(facts.orientation)) {
        std::swap(facts.width, facts.height);
        if (facts.recorded) {
            std::swap((*facts.recorded)[0], (*facts.recorded)[1]);
        }
    }
    facts.focalLength = positiveOf(dataset, "EXIF_FocalLength");
    facts.focalLength35 = positiveOf(dataset, "EXIF_FocalLengthIn35mmFilm");
    const std::string make = textOf(dataset, "EXIF_Make");
    const std::string model = textOf(dataset, "EXIF_Model");
    facts.camera = model.starts_with(make) || make.empty() ? model : make + " " + model;
    facts.taken = clockTime(textOf(dataset, "EXIF_DateTimeOriginal"));
    const auto north = angleOf(dataset, "EXIF_GPSLatitude", 90.0);
    const auto east = angleOf(dataset, "EXIF_GPSLongitude", 180.0);
    if (north && east) {
        facts.position = {*north, *east};
    }
    if (const std::vector<double> altitude = numbersOf(dataset, "EXIF_GPSAltitude"); altitude.size() == 1) {
        const std::vector<double> below = numbersOf(dataset, "EXIF_GPSAltitudeRef");
        facts.altitude = !below.empty() && below[0] == 1.0 ? -altitude[0] : altitude[0];
    }
    return facts;
}

void find(Findings& findings, Message what, std::string_view remedy) {
    std::string id = what.id + ".remedy";
    findings.add(what, {std::move(id), std::string(remedy), {}});
}

void addFindings(PhotographFile& file) {
    const PhotoFacts& facts = file.facts;
    if (!facts.focalLength && !facts.focalLength35 && facts.taken.empty() && facts.camera.empty()) {
        find(file.findings, {"photo.no_exif", "The photograph says nothing of its camera, time and place.", {}},
             "The focal length is found from the point pairs; set the time by hand.");
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

/// Reads one band into every third byte; values of more than a byte keep their upper one.
bool readBand(GDALRasterBand& band, int w, int h, std::uint8_t* out, GDALRasterIOExtraArg& extra) {
    const auto read = [&](void* into, GDALDataType type, GSpacing pixel) {
        return band.RasterIO(GF_Read, 0, 0, band.GetXSize(), band.GetYSize(), into, w, h, type, pixel,
                             pixel * static_cast<GSpacing>(w), &extra) == CE_None;
    };
    if (band.GetRasterDataType() == GDT_Byte) {
        return read(out, GDT_Byte, 3);
    }
    std::vector<std::uint16_t> wide(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    if (!read(wide.data(), GDT_UInt16, 2)) {
        return false;
    }
    for (const std::uint16_t value : wide) {
        *out = static_cast<std::uint8_t>(value >> 8);
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
    {
        const GdalSession session;
        file.facts = factsOf(*openPicture(path));
    }
    file.sha256 = sha256OfFile(path);
    addFindings(file);
    return file;
}

PhotoPicture readPicture(const std::string& path, int longestSide, const Execution& execution) {
    checkPhotograph(path);
    const GdalSession session;
    const GDALDatasetUniquePtr dataset = openPicture(path);
    const double scale =
        std::min(1.0, static_cast<double>(longestSide) / std::max(dataset->GetRasterXSize(), dataset->GetRasterYSize()));
    const int w = std::max(1, static_cast<int>(std::lround(scale * dataset->GetRasterXSize())));
    const int h = std::max(1, static_cast<int>(std::lround(scale * dataset->GetRasterYSize())));
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
        throw ParseError({"photo.no_pixels", "The pixels of {0} cannot be read: {1}", {path, GdalSession::reason()}},
                         {"photo.no_pixels.remedy", "Copy the photograph anew from where it came, or save it again as JPEG.", {}});
    }
    PhotoPicture picture;
    if (CPLGetLastErrorType() != CE_None) {
        find(picture.findings, {"photo.damaged", "The photograph is damaged: {0}", {GdalSession::reason()}},
             "A part of it may be missing; copy it anew from where it came.");
    }
    applyTable(*dataset->GetRasterBand(1), rgb);
    const int orientation = orientationOf(*dataset);
    picture.rgb = upright(rgb, w, h, orientation);
    picture.width = onASide(orientation) ? h : w;
    picture.height = onASide(orientation) ? w : h;
    return picture;
}

}  // namespace rubble::io
