#include "io/site/photograph_file.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "core/base/error.h"
#include "io/base/files.h"
#include "tests/support/temporary_folder.h"

namespace rubble::io {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A picture by the colour of each pixel, as a file of a format of GDAL.
void writePicture(const std::string& path, const char* format, int width, int height,
                  const std::function<std::array<int, 3>(int, int)>& colour, int bands = 3) {
    GDALAllRegister();
    GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
    GDALDataset* picture = memory->Create("", width, height, bands, GDT_Byte, nullptr);
    Bytes row(static_cast<std::size_t>(width));
    for (int band = 0; band < bands; ++band) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                row[static_cast<std::size_t>(x)] = static_cast<std::uint8_t>(colour(x, y)[static_cast<std::size_t>(band)]);
            }
            ASSERT_EQ(picture->GetRasterBand(band + 1)->RasterIO(GF_Write, 0, y, width, 1, row.data(), width, 1, GDT_Byte, 0, 0),
                      CE_None);
        }
    }
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(format);
    GDALDataset* file = driver->CreateCopy(path.c_str(), picture, FALSE, nullptr, nullptr, nullptr);
    ASSERT_NE(file, nullptr);
    GDALClose(file);
    GDALClose(picture);
    std::filesystem::remove(path + ".aux.xml");
}

/// An EXIF segment (JEITA CP-3451), big-endian: tags of the first directory, of the EXIF and of the GPS directory.
class ExifBlock {
public:
    struct Entry {
        int tag;
        int type;  // 1 byte, 2 text, 3 short, 4 long, 5 rational
        std::vector<std::array<std::uint32_t, 2>> values;
        std::string text;
    };
    std::vector<Entry> first, exif, gps;

    Bytes segment() const {
        Bytes tiff{'M', 'M', 0, 42, 0, 0, 0, 8};
        std::vector<Entry> top = first;
        // Where the others begin is known once the length of those before is.
        const std::size_t exifAt = 8 + sizeOf(first, 2);
        const std::size_t gpsAt = exifAt + sizeOf(exif, 0);
        top.push_back({0x8769, 4, {{static_cast<std::uint32_t>(exifAt), 1}}, {}});
        top.push_back({0x8825, 4, {{static_cast<std::uint32_t>(gpsAt), 1}}, {}});
        append(tiff, top);
        append(tiff, exif);
        append(tiff, gps);
        Bytes made{0xff, 0xe1};
        put(made, static_cast<std::uint32_t>(tiff.size() + 8), 2);
        for (const char c : std::string("Exif")) {
            made.push_back(static_cast<std::uint8_t>(c));
        }
        made.insert(made.end(), {0, 0});
        made.insert(made.end(), tiff.begin(), tiff.end());
        return made;
    }

private:
    static void put(Bytes& bytes, std::uint32_t value, int count) {
        for (int k = count - 1; k >= 0; --k) {
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * k)));
        }
    }
    static Bytes payload(const Entry& entry) {
        Bytes bytes;
        if (entry.type == 2) {
            bytes.assign(entry.text.begin(), entry.text.end());
            bytes.push_back(0);
        }
        for (const auto& value : entry.values) {
            put(bytes, value[0], entry.type == 1 ? 1 : entry.type == 3 ? 2 : 4);
            if (entry.type == 5) {
                put(bytes, value[1], 4);
            }
        }
        return bytes;
    }
    static std::size_t sizeOf(const std::vector<Entry>& entries, std::size_t more) {
        std::size_t size = 2 + 12 * (entries.size() + more) + 4;
        for (const Entry& entry : entries) {
            const std::size_t bytes = payload(entry).size();
            size += bytes > 4 ? bytes : 0;
        }
        return size;
    }
    static void append(Bytes& tiff, const std::vector<Entry>& entries) {
        const std::size_t begin = tiff.size();
        std::size_t data = begin + 2 + 12 * entries.size() + 4;
        put(tiff, static_cast<std::uint32_t>(entries.size()), 2);
        Bytes after;
        for (const Entry& entry : entries) {
            put(tiff, static_cast<std::uint32_t>(entry.tag), 2);
            put(tiff, static_cast<std::uint32_t>(entry.type), 2);
            put(tiff, static_cast<std::uint32_t>(entry.type == 2 ? entry.text.size() + 1 : entry.values.size()), 4);
            Bytes bytes = payload(entry);
            if (bytes.size() > 4) {
                put(tiff, static_cast<std::uint32_t>(data), 4);
                data += bytes.size();
                after.insert(after.end(), bytes.begin(), bytes.end());
            } else {
                bytes.resize(4, 0);
                tiff.insert(tiff.end(), bytes.begin(), bytes.end());
            }
        }
        put(tiff, 0, 4);
        tiff.insert(tiff.end(), after.begin(), after.end());
    }
};

Bytes bytesOf(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void writeBytes(const std::string& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void addExif(const std::string& path, const ExifBlock& block) {
    Bytes bytes = bytesOf(path);
    const Bytes segment = block.segment();
    bytes.insert(bytes.begin() + 2, segment.begin(), segment.end());
    writeBytes(path, bytes);
}

/// Red at the upper left, green at the upper right, blue at the lower left, white at the lower right.
std::array<int, 3> corners(int x, int y, int width, int height) {
    const bool right = x >= width / 2;
    const bool low = y >= height / 2;
    return low ? right ? std::array{255, 255, 255} : std::array{0, 0, 255} : right ? std::array{0, 255, 0} : std::array{255, 0, 0};
}

std::array<int, 3> pixel(const PhotoPicture& picture, int x, int y) {
    const std::uint8_t* p = picture.rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                                      static_cast<std::size_t>(x));
    const auto rounded = [](int value) { return value > 127 ? 255 : 0; };
    return {rounded(p[0]), rounded(p[1]), rounded(p[2])};
}

ExifBlock fullBlock(int orientation) {
    ExifBlock block;
    block.first = {
        {0x10f, 2, {}, "Maker"}, {0x110, 2, {}, "Model 3"}, {0x112, 3, {{static_cast<std::uint32_t>(orientation), 1}}, {}}};
    block.exif = {{0x9003, 2, {}, "2026:03:14 17:05:12"},
                  {0x920a, 5, {{240, 10}}, {}},
                  {0xa002, 4, {{120, 1}}, {}},
                  {0xa003, 4, {{80, 1}}, {}},
                  {0xa405, 3, {{36, 1}}, {}}};
    block.gps = {{1, 2, {}, "N"},      {2, 5, {{51, 1}, {30, 1}, {1800, 100}}, {}},
                 {3, 2, {}, "W"},      {4, 5, {{0, 1}, {6, 1}, {0, 1}}, {}},
                 {5, 1, {{0, 1}}, {}}, {6, 5, {{1234, 100}}, {}}};
    return block;
}

class Photo : public testing::Test {
protected:
    std::string write(int orientation) {
        const std::string path = m_folder / ("photo-" + std::to_string(orientation) + ".jpg");
        writePicture(path, "JPEG", 120, 80, [](int x, int y) { return corners(x, y, 120, 80); });
        addExif(path, fullBlock(orientation));
        return path;
    }
    TemporaryFolder m_folder;
};

TEST_F(Photo, SaysWhatItsExifSaysAndStaysAsItIs) {
    const std::string path = write(1);
    const std::string before = sha256OfFile(path);
    const PhotographFile file = readPhotograph(path);
    EXPECT_EQ(file.facts.width, 120);
    EXPECT_EQ(file.facts.height, 80);
    EXPECT_EQ(file.facts.camera, "Maker Model 3");
    EXPECT_EQ(file.facts.taken, "2026-03-14 17:05:12");
    ASSERT_TRUE(file.facts.focalLength && file.facts.focalLength35 && file.facts.position && file.facts.altitude);
    EXPECT_DOUBLE_EQ(*file.facts.focalLength, 24.0);
    EXPECT_DOUBLE_EQ(*file.facts.focalLength35, 36.0);
    EXPECT_NEAR((*file.facts.position)[0], 51.505, 1e-9);
    EXPECT_NEAR((*file.facts.position)[1], -0.1, 1e-9);
    EXPECT_NEAR(*file.facts.altitude, 12.34, 1e-9);
    EXPECT_TRUE(file.findings.empty());
    EXPECT_NEAR(*focalFrom(file.facts), 36.0 * std::hypot(120.0, 80.0) / std::hypot(36.0, 24.0), 1e-9);
    EXPECT_EQ(file.sha256, before);
    readPicture(path, 60, Execution());
    EXPECT_EQ(sha256OfFile(path), before);
    EXPECT_FALSE(std::filesystem::exists(path + ".aux.xml"));
}

// The colours that each of the eight ways to hold a camera shows, upright: upper left, upper right, lower left, lower right.
TEST_F(Photo, IsTurnedUprightInAllEightWays) {
    const std::array red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, white{255, 255, 255};
    const std::array<std::array<std::array<int, 3>, 4>, 8> expected{{{red, green, blue, white},
                                                                     {green, red, white, blue},
                                                                     {white, blue, green, red},
                                                                     {blue, white, red, green},
                                                                     {red, blue, green, white},
                                                                     {blue, red, white, green},
                                                                     {white, green, blue, red},
                                                                     {green, white, red, blue}}};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const std::string path = write(orientation);
        const PhotoFacts facts = readPhotograph(path).facts;
        const PhotoPicture picture = readPicture(path, 1000, Execution());
        const bool side = orientation >= 5;
        EXPECT_EQ(facts.width, side ? 80 : 120) << orientation;
        EXPECT_EQ(picture.width, side ? 80 : 120) << orientation;
        EXPECT_EQ(picture.height, side ? 120 : 80) << orientation;
        EXPECT_FALSE(cropped(facts)) << orientation;
        const int r = picture.width - 10;
        const int b = picture.height - 10;
        const std::array shown{pixel(picture, 10, 10), pixel(picture, r, 10), pixel(picture, 10, b), pixel(picture, r, b)};
        EXPECT_EQ(shown, expected[static_cast<std::size_t>(orientation - 1)]) << orientation;
    }
}

TEST_F(Photo, WithoutExifOrCroppedIsPointedOut) {
    const std::string bare = m_folder / "bare.png";
    writePicture(bare, "PNG", 64, 48, [](int x, int y) { return corners(x, y, 64, 48); });
    EXPECT_EQ(readPhotograph(bare).findings.count("photo.no_exif"), 1);
    EXPECT_FALSE(focalFrom(readPhotograph(bare).facts));

    const std::string part = m_folder / "part.jpg";
    writePicture(part, "JPEG", 100, 80, [](int x, int y) { return corners(x, y, 100, 80); });
    addExif(part, fullBlock(1));
    const PhotographFile file = readPhotograph(part);
    EXPECT_TRUE(cropped(file.facts));
    EXPECT_EQ(file.findings.count("photo.cropped"), 1);
    // A crop keeps the pixels of what was recorded.
    EXPECT_NEAR(*focalFrom(file.facts), 36.0 * std::hypot(120.0, 80.0) / std::hypot(36.0, 24.0), 1e-9);

    const std::string small = m_folder / "small.jpg";
    writePicture(small, "JPEG", 60, 40, [](int x, int y) { return corners(x, y, 60, 40); });
    addExif(small, fullBlock(1));
    EXPECT_EQ(readPhotograph(small).findings.count("photo.resized"), 1);
    EXPECT_NEAR(*focalFrom(readPhotograph(small).facts), 36.0 * std::hypot(60.0, 40.0) / std::hypot(36.0, 24.0), 1e-9);
}

TEST_F(Photo, DamagedOrNoPhotographIsRefusedOrSaid) {
    const std::string path = write(1);
    const Bytes whole = bytesOf(path);
    EXPECT_THROW(readPhotograph(m_folder / "none.jpg"), WorldError);
    EXPECT_THROW(readPhotograph(m_folder.path()), WorldError);
    const std::string text = m_folder / "text.jpg";
    std::ofstream(text) << "this is no photograph";
    EXPECT_THROW(readPhotograph(text), ParseError);
    EXPECT_THROW(readPicture(text, 100, Execution()), ParseError);

    // Cut off in the middle, and with bytes overturned anywhere: never worse than an error.
    const std::string cut = m_folder / "cut.jpg";
    writeBytes(cut, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * 3 / 4)));
    try {
        EXPECT_FALSE(readPicture(cut, 120, Execution()).findings.empty());
    } catch (const ParseError& error) {
        EXPECT_FALSE(error.remedy().empty());
    }
    std::uint32_t state = 1;
    for (int trial = 0; trial < 300; ++trial) {
        Bytes bytes = whole;
        for (int k = 0; k < 6; ++k) {
            state = state * 1664525u + 1013904223u;
            bytes[(state >> 8) % bytes.size()] = static_cast<std::uint8_t>(state >> 24);
        }
        writeBytes(cut, bytes);
        try {
            const PhotoFacts facts = readPhotograph(cut).facts;
            EXPECT_GT(facts.width, 0);
            readPicture(cut, 120, Execution());
        } catch (const Error&) {
        }
    }
}

// 100 megapixels: what is read is no larger than what is asked for, and cancelling is heeded.
TEST_F(Photo, LargePicturesAreReadSmall) {
    const std::string path = m_folder / "large.jpg";
    writePicture(path, "JPEG", 11600, 8700, [](int x, int y) { return corners(x, y, 11600, 8700); });
    const PhotographFile file = readPhotograph(path);
    EXPECT_EQ(file.facts.width, 11600);
    const PhotoPicture picture = readPicture(path, 1160, Execution());
    EXPECT_EQ(picture.width, 1160);
    EXPECT_EQ(picture.height, 870);
    EXPECT_EQ(picture.rgb.size(), 3u * 1160u * 870u);
    EXPECT_EQ(pixel(picture, 100, 100), (std::array{255, 0, 0}));
    EXPECT_EQ(pixel(picture, 1100, 800), (std::array{255, 255, 255}));
    const Execution cancelled;
    cancelled.cancel();
    EXPECT_THROW(readPicture(path, 1160, cancelled), Cancelled);
}

TEST_F(Photo, GreyPicturesAreGrey) {
    const std::string path = m_folder / "grey.tif";
    writePicture(path, "GTiff", 64, 48, [](int, int) { return std::array{200, 0, 0}; }, 1);
    const PhotoPicture picture = readPicture(path, 64, Execution());
    EXPECT_EQ(picture.rgb, std::vector<std::uint8_t>(picture.rgb.size(), 200));
}

}  // namespace
}  // namespace rubble::io
