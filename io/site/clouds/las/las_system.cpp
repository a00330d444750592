#include "io/site/clouds/las/las_system.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>

#include "io/base/trial.h"
#include "io/site/clouds/cloud_system.h"
#include "io/site/gdal_memory.h"
#include "io/site/gdal_session.h"

namespace rubble::io {

namespace {

constexpr std::string_view projection = "LASF_Projection";
constexpr std::uint16_t wktId = 2112;
constexpr std::uint16_t geoKeysId = 34735;
constexpr std::uint64_t systemBytesMax = std::uint64_t{1} << 20;

std::vector<unsigned char> contentOfRecord(const CloudFile& file, const LasRecord* record) {
    if (record == nullptr || record->bytes == 0 || record->bytes > systemBytesMax) {
        return {};
    }
    return file.bytes(record->start, record->bytes);
}

template <class Number>
void append(std::vector<unsigned char>& bytes, Number number) {
    const auto* begin = reinterpret_cast<const unsigned char*>(&number);
    bytes.insert(bytes.end(), begin, begin + sizeof number);
}

/// A picture of one pixel that carries keys of a GeoTIFF, so that GDAL says what they mean.
std::vector<unsigned char> pixelWithKeys(const std::vector<std::vector<unsigned char>>& keys) {
    struct Entry {
        std::uint16_t tag;
        std::uint16_t kind;
        std::uint32_t count;
        std::uint32_t value;
    };
    constexpr std::uint16_t text = 2;
    constexpr std::uint16_t shortNumber = 3;
    constexpr std::uint16_t longNumber = 4;
    constexpr std::uint16_t real = 12;
    std::vector<Entry> entries{{256, shortNumber, 1, 1}, {257, shortNumber, 1, 1}, {258, shortNumber, 1, 8},
                               {259, shortNumber, 1, 1}, {262, shortNumber, 1, 1}, {273, longNumber, 1, 8},
                               {277, shortNumber, 1, 1}, {278, shortNumber, 1, 1}, {279, longNumber, 1, 1}};
    std::vector<unsigned char> bytes{'I', 'I', 42, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    for (std::size_t k = 0; k < keys.size(); ++k) {
        constexpr std::size_t widths[] = {2, 8, 1};
        constexpr std::uint16_t kinds[] = {shortNumber, real, text};
        const auto count = static_cast<std::uint32_t>(keys[k].size() / widths[k]);
        if (count * widths[k] > 4) {
            entries.push_back(
                {static_cast<std::uint16_t>(geoKeysId + k), kinds[k], count, static_cast<std::uint32_t>(bytes.size())});
            bytes.insert(bytes.end(), keys[k].begin(), keys[k].begin() + static_cast<std::ptrdiff_t>(count * widths[k]));
            bytes.resize((bytes.size() + 7) / 8 * 8);
        }
    }
    const auto directory = static_cast<std::uint32_t>(bytes.size());
    append(bytes, static_cast<std::uint16_t>(entries.size()));
    for (const Entry& entry : entries) {
        append(bytes, entry.tag);
        append(bytes, entry.kind);
        append(bytes, entry.count);
        append(bytes, entry.value);
    }
    append(bytes, std::uint32_t{0});
    std::copy_n(reinterpret_cast<const unsigned char*>(&directory), sizeof directory, bytes.begin() + 4);
    return bytes;
}

/// WKT of the keys of a GeoTIFF; empty if they say nothing.
std::string wktOfKeys(const std::vector<std::vector<unsigned char>>& keys) {
    const GdalSession session;
    const GdalMemoryFile memory(".tif");
    std::vector<unsigned char> bytes = pixelWithKeys(keys);
    VSIFCloseL(VSIFileFromMemBuffer(memory.name().c_str(), bytes.data(), bytes.size(), FALSE));
    CPLSetThreadLocalConfigOption("GTIFF_REPORT_COMPD_CS", "YES");
    std::string wkt;
    {
        constexpr const char* drivers[] = {"GTiff", nullptr};
        const GDALDatasetUniquePtr picture(GDALDataset::Open(memory.name().c_str(), GDAL_OF_RASTER, drivers));
        const OGRSpatialReference* system = picture ? picture->GetSpatialRef() : nullptr;
        char* made = nullptr;
        const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
        if (system != nullptr && !system->IsEmpty() && system->exportToWkt(&made, options) == OGRERR_NONE) {
            wkt = made;
        }
        CPLFree(made);
    }
    CPLSetThreadLocalConfigOption("GTIFF_REPORT_COMPD_CS", nullptr);
    return wkt;
}

std::string textOfRecord(const CloudFile& file, const LasRecord* record) {
    const std::vector<unsigned char> bytes = contentOfRecord(file, record);
    return {bytes.begin(), std::find(bytes.begin(), bytes.end(), '\0')};
}

}  // namespace

void takeLasSystem(const CloudFile& file, const LasHead& las, CloudHead& head) {
    const LasRecord* own = las.record(projection, wktId);
    const std::string wkt = textOfRecord(file, own != nullptr ? own : las.record("liblas", wktId));
    std::string keys;
    if (const LasRecord* record = las.record(projection, geoKeysId); record != nullptr && !(las.wkt && knowsSystem(wkt))) {
        const std::vector<std::vector<unsigned char>> found{contentOfRecord(file, record),
                                                            contentOfRecord(file, las.record(projection, geoKeysId + 1)),
                                                            contentOfRecord(file, las.record(projection, geoKeysId + 2))};
        const GdalSession session;
        keys = survivesTrial([&] { wktOfKeys(found); }) ? wktOfKeys(found) : "";
    }
    const bool fromKeys = knowsSystem(keys);
    head.crs = fromKeys ? keys : wkt;
    head.crsFrom = fromKeys ? "GeoTIFF keys" : wkt.empty() ? "" : "WKT";
}

}  // namespace rubble::io
