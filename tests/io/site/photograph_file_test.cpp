#include "io/site/photograph_file.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <libheif/heif.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "core/base/error.h"
#include "io/base/files.h"
#include "tests/support/error_id.h"
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

    /// The block itself: a TIFF without a picture.
    Bytes block() const {
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
        return tiff;
    }
    /// As a JPEG has it.
    Bytes segment() const {
        const Bytes tiff = block();
        Bytes made{0xff, 0xe1};
        put(made, static_cast<std::uint32_t>(tiff.size() + 8), 2);
        for (const char c : std::string("Exif")) {
            made.push_back(static_cast<std::uint8_t>(c));
        }
        made.insert(made.end(), {0, 0});
        made.insert(made.end(), tiff.begin(), tiff.end());
        return made;
    }
    /// As a chunk of a PNG.
    Bytes chunk() const {
        const Bytes tiff = block();
        Bytes made;
        put(made, static_cast<std::uint32_t>(tiff.size()), 4);
        made.insert(made.end(), {'e', 'X', 'I', 'f'});
        made.insert(made.end(), tiff.begin(), tiff.end());
        put(made, crcOf(made.data() + 4, made.size() - 4), 4);
        return made;
    }
    /// As a TIFF with a grey picture behind it, 0 at its left and 200 at its right.
    Bytes tiffFile(std::uint32_t width, std::uint32_t height) const {
        const auto with = [&](std::uint32_t at) {
            ExifBlock whole = *this;
            const std::vector<std::pair<int, std::uint32_t>> tags{{256, width}, {257, height}, {258, 8},
                                                                  {259, 1},     {262, 1},      {273, at},
                                                                  {277, 1},     {278, height}, {279, width * height}};
            for (const auto& [tag, value] : tags) {
                whole.first.push_back({tag, 4, {{value, 1}}, {}});
            }
            std::sort(whole.first.begin(), whole.first.end(), [](const Entry& a, const Entry& b) { return a.tag < b.tag; });
            return whole.block();
        };
        Bytes made = with(static_cast<std::uint32_t>(with(0).size()));
        for (std::uint32_t k = 0; k < width * height; ++k) {
            made.push_back(k % width < width / 2 ? 0 : 200);
        }
        return made;
    }

private:
    static std::uint32_t crcOf(const std::uint8_t* bytes, std::size_t count) {
        std::uint32_t crc = 0xffffffffu;
        for (std::size_t k = 0; k < count; ++k) {
            crc ^= bytes[k];
            for (int bit = 0; bit < 8; ++bit) {
                crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
            }
        }
        return ~crc;
    }
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

/// Writes a picture as HEVC by the encoder of libheif, turned by the boxes of the file as an orientation says, with an EXIF block.
/// False if this machine has no encoder.
bool writeHeic(const std::string& path, int width, int height, int turn, const Bytes& exif, int bits = 8) {
    heif_context* context = heif_context_alloc();
    heif_encoder* encoder = nullptr;
    if (heif_context_get_encoder_for_format(context, heif_compression_HEVC, &encoder).code != heif_error_Ok) {
        heif_context_free(context);
        return false;
    }
    heif_image* image = nullptr;
    heif_image_create(width, height, heif_colorspace_RGB,
                      bits > 8 ? heif_chroma_interleaved_RRGGBB_LE : heif_chroma_interleaved_RGB, &image);
    heif_image_add_plane(image, heif_channel_interleaved, width, height, bits);
    int stride = 0;
    std::uint8_t* plane = heif_image_get_plane(image, heif_channel_interleaved, &stride);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::array<int, 3> colour = corners(x, y, width, height);
            for (int c = 0; c < 3; ++c) {
                const int value = colour[static_cast<std::size_t>(c)] == 0 ? 0 : (1 << bits) - 1;
                std::uint8_t* at = plane + static_cast<std::ptrdiff_t>(y) * stride + (3 * x + c) * (bits > 8 ? 2 : 1);
                at[0] = static_cast<std::uint8_t>(value & 255);
                if (bits > 8) {
                    at[1] = static_cast<std::uint8_t>(value >> 8);
                }
            }
        }
    }
    heif_encoding_options* options = heif_encoding_options_alloc();
    options->image_orientation = static_cast<heif_orientation>(turn);
    heif_image_handle* handle = nullptr;
    const heif_error encoded = heif_context_encode_image(context, image, encoder, options, &handle);
    EXPECT_EQ(encoded.code, heif_error_Ok) << encoded.message;
    if (!exif.empty()) {
        heif_context_add_exif_metadata(context, handle, exif.data(), static_cast<int>(exif.size()));
    }
    EXPECT_EQ(heif_context_write_to_file(context, path.c_str()).code, heif_error_Ok);
    heif_image_handle_release(handle);
    heif_encoding_options_free(options);
    heif_image_release(image);
    heif_encoder_release(encoder);
    heif_context_free(context);
    return true;
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

// One EXIF block in all containers says the same.
TEST_F(Photo, TiffAndPngSayWhatAJpegSays) {
    const PhotoFacts jpeg = readPhotograph(write(6)).facts;
    const std::string png = m_folder / "photo.png";
    writePicture(png, "PNG", 120, 80, [](int x, int y) { return corners(x, y, 120, 80); });
    Bytes bytes = bytesOf(png);
    const Bytes chunk = fullBlock(6).chunk();
    constexpr std::ptrdiff_t behindHeader = 8 + 25;
    bytes.insert(bytes.begin() + behindHeader, chunk.begin(), chunk.end());
    writeBytes(png, bytes);
    EXPECT_EQ(readPhotograph(png).facts, jpeg);
    EXPECT_TRUE(readPhotograph(png).findings.empty());
    const PhotoPicture picture = readPicture(png, 1000, Execution());
    EXPECT_EQ(picture.width, 80);
    EXPECT_EQ(pixel(picture, 5, 5), (std::array{0, 0, 255})) << "lower left as stored";

    const std::string tiff = m_folder / "photo.tif";
    writeBytes(tiff, fullBlock(6).tiffFile(120, 80));
    EXPECT_EQ(readPhotograph(tiff).facts, jpeg);
    const PhotoPicture turned = readPicture(tiff, 1000, Execution());
    EXPECT_EQ(turned.height, 120);
    EXPECT_EQ(pixel(turned, 40, 10), (std::array{0, 0, 0}));
    EXPECT_EQ(pixel(turned, 40, 110), (std::array{255, 255, 255}));
}

TEST_F(Photo, BelowTheSeaIsBelowIt) {
    const std::string path = m_folder / "deep.tif";
    ExifBlock block = fullBlock(1);
    block.gps[4].values = {{1, 1}};
    block.gps[4].type = 3;
    writeBytes(path, block.tiffFile(120, 80));
    EXPECT_NEAR(*readPhotograph(path).facts.altitude, -12.34, 1e-9);
    // The reference is one byte, which stands at the left of its place.
    Bytes bytes = fullBlock(1).tiffFile(120, 80);
    const Bytes entry{0, 5, 0, 1, 0, 0, 0, 1, 0};
    const auto at = std::search(bytes.begin(), bytes.end(), entry.begin(), entry.end());
    ASSERT_NE(at, bytes.end());
    *(at + 8) = 1;
    writeBytes(path, bytes);
    EXPECT_NEAR(*readPhotograph(path).facts.altitude, -12.34, 1e-9);
}

TEST_F(Photo, WhatIsNotReadOrDamagedIsNotSaidToBeMissing) {
    const std::string png = m_folder / "old.png";
    writePicture(png, "PNG", 64, 48, [](int x, int y) { return corners(x, y, 64, 48); });
    Bytes bytes = bytesOf(png);
    const std::string text = "Raw profile type exif";
    Bytes chunk{0, 0, 0, static_cast<std::uint8_t>(text.size() + 3), 't', 'E', 'X', 't'};
    chunk.insert(chunk.end(), text.begin(), text.end());
    chunk.insert(chunk.end(), {0, '4', '9', 0, 0, 0, 0});
    bytes.insert(bytes.begin() + 8 + 25, chunk.begin(), chunk.end());
    writeBytes(png, bytes);
    const Findings findings = readPhotograph(png).findings;
    EXPECT_EQ(findings.count("photo.exif_not_read"), 1);
    EXPECT_EQ(findings.count("photo.no_exif"), 0);

    const std::string path = write(1);
    bytes = bytesOf(path);
    bytes[2 + 4 + 6] = 'X';  // the mark of the TIFF
    writeBytes(path, bytes);
    EXPECT_EQ(readPhotograph(path).findings.count("photo.exif_damaged"), 1);
}

// A depth of 12 bits in 16, of 4 in 8, and a picture whose zero is white.
TEST_F(Photo, ShadesAreThoseOfTheDepth) {
    const auto shade = [&](const char* name, GDALDataType type, std::vector<const char*> options, int value) {
        const std::string path = m_folder / name;
        GDALAllRegister();
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        options.push_back(nullptr);
        GDALDataset* file = driver->Create(path.c_str(), 64, 48, 1, type, const_cast<char**>(options.data()));
        const std::vector<std::uint16_t> values(64 * 48, static_cast<std::uint16_t>(value));
        EXPECT_EQ(file->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 64, 48, const_cast<std::uint16_t*>(values.data()), 64, 48,
                                                   GDT_UInt16, 0, 0),
                  CE_None);
        GDALClose(file);
        return static_cast<int>(readPicture(path, 64, Execution()).rgb[0]);
    };
    EXPECT_EQ(shade("twelve.tif", GDT_UInt16, {"NBITS=12"}, 4095), 255);
    EXPECT_EQ(shade("half.tif", GDT_UInt16, {"NBITS=12"}, 2048), 128);
    EXPECT_EQ(shade("sixteen.tif", GDT_UInt16, {}, 65535), 255);
    EXPECT_EQ(shade("four.tif", GDT_Byte, {"NBITS=4"}, 15), 255);
    EXPECT_EQ(shade("white.tif", GDT_Byte, {"PHOTOMETRIC=MINISWHITE"}, 0), 255);
    EXPECT_THROW(shade("numbers.tif", GDT_Float32, {}, 1), ParseError);
}

TEST_F(Photo, HeicIsReadWithItsExifAndTurnedOnce) {
    const std::string path = m_folder / "photo.heic";
    const Bytes exif = fullBlock(6).block();
    ASSERT_TRUE(writeHeic(path, 120, 80, 6, exif)) << "libheif has no encoder of HEVC";
    const PhotographFile file = readPhotograph(path);
    PhotoFacts expected = readPhotograph(write(6)).facts;
    expected.orientation = 1;
    EXPECT_EQ(file.facts, expected) << "turned by the file's own boxes, not by EXIF once more";
    EXPECT_TRUE(file.findings.empty());
    EXPECT_EQ(file.sha256, sha256OfFile(path));
    const PhotoPicture picture = readPicture(path, 1000, Execution());
    EXPECT_EQ(picture.width, 80);
    EXPECT_EQ(picture.height, 120);
    EXPECT_EQ(pixel(picture, 10, 10), (std::array{0, 0, 255}));
    EXPECT_EQ(pixel(picture, 70, 10), (std::array{255, 0, 0}));
    EXPECT_EQ(pixel(picture, 10, 110), (std::array{255, 255, 255}));
    EXPECT_EQ(readPicture(path, 60, Execution()).height, 60);

    writeHeic(path, 120, 80, 1, {});
    EXPECT_EQ(readPhotograph(path).findings.count("photo.no_exif"), 1);
    writeHeic(path, 120, 80, 1, exif);
    EXPECT_EQ(readPhotograph(path).findings.count("photo.heif_turn"), 1);
    EXPECT_EQ(readPhotograph(path).facts.width, 120);
    writeHeic(path, 120, 80, 1, exif, 10);
    EXPECT_EQ(pixel(readPicture(path, 120, Execution()), 100, 70), (std::array{255, 255, 255}));
}

TEST_F(Photo, ADamagedHeicIsRefusedWithAReason) {
    const std::string path = m_folder / "photo.heic";
    ASSERT_TRUE(writeHeic(path, 120, 80, 1, {})) << "libheif has no encoder of HEVC";
    const Bytes whole = bytesOf(path);
    for (const double share : {0.02, 0.2, 0.5, 0.9}) {
        writeBytes(path,
                   Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(whole.size()))));
        try {
            readPhotograph(path);
            readPicture(path, 120, Execution());
            ADD_FAILURE() << share;
        } catch (const ParseError& error) {
            EXPECT_FALSE(error.remedy().empty());
        }
    }
    writeBytes(path, {0, 0, 0, 24, 'f', 't', 'y', 'p', 'm', 'p', '4', '2', 0, 0, 0, 0, 'm', 'p', '4', '2', 'i', 's', 'o', 'm'});
    EXPECT_THROW(readPhotograph(path), ParseError);
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
    EXPECT_EQ(idOfError([&] { readPhotograph(m_folder / "none.jpg"); }), "io.file.unreadable");
    EXPECT_EQ(idOfError([&] { readPhotograph(m_folder.path()); }), "io.file.unreadable");
    const std::string text = m_folder / "text.jpg";
    std::ofstream(text) << "this is no photograph";
    EXPECT_EQ(idOfError([&] { readPhotograph(text); }), "photo.no_photograph");
    EXPECT_EQ(idOfError([&] { readPicture(text, 100, Execution()); }), "photo.no_photograph");
    const std::string stamp = m_folder / "stamp.png";
    writePicture(stamp, "PNG", 12, 12, [](int x, int y) { return corners(x, y, 12, 12); });
    EXPECT_EQ(idOfError([&] { readPhotograph(stamp); }), "photo.size");
    const std::string half = m_folder / "half.png";
    writePicture(half, "PNG", 640, 480, [](int x, int y) { return std::array{(x * y) % 251, (x + 7 * y) % 241, x % 239}; });
    const Bytes all = bytesOf(half);
    writeBytes(half, Bytes(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2)));
    EXPECT_EQ(idOfError([&] { readPicture(half, 640, Execution()); }), "photo.no_pixels");

    // Cut off in the middle, and with bytes overturned anywhere: never worse than an error.
    const std::string cut = m_folder / "cut.jpg";
    writeBytes(cut, Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(whole.size() * 3 / 4)));
    try {
        EXPECT_EQ(readPicture(cut, 120, Execution()).findings.count("photo.damaged"), 1);
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
