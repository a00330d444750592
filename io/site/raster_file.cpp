#include "io/site/raster_file.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <type_traits>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "io/base/file_words.h"
#include "io/base/length_unit.h"
#include "io/site/gdal_session.h"
#include "io/site/raster_colours.h"
#include "io/site/system_way.h"

namespace rubble::io {

namespace {

/// Formats that hold one raster in one local file. Those that point to other files or hosts are left out: the content of such a
/// terrain would not be that of the file whose SHA-256 is kept.
constexpr std::array<const char*, 17> formats{"GTiff",   "COG",     "AAIGrid", "GRASSASCIIGrid", "EHdr", "ENVI",  "HFA",
                                              "SRTMHGT", "DTED",    "XYZ",     "GSAG",           "GSBG", "GS7BG", "SAGA",
                                              "NWT_GRD", "USGSDEM", nullptr};
constexpr std::array<const char*, 8> pictures{"GTiff", "COG", "JPEG", "PNG", "JP2OpenJPEG", "HFA", "ENVI", nullptr};
constexpr std::size_t rowsAtOnce = 256;
constexpr std::size_t pixelsAtOnce = std::size_t{4} << 20;

/// Formats that only say where the heights are.
constexpr std::array<std::string_view, 5> pointers{"VRT", "GTI", "WMS", "WCS", "STACTA"};
/// Formats that hold colours and nothing else.
constexpr std::array<std::string_view, 5> picturesOnly{"PNG", "JPEG", "GIF", "BMP", "WEBP"};

[[noreturn]] void refusePicture(const std::string& path) {
    refuseContent({"terrain.picture", "{0} holds colours or complex numbers, not heights", {path}},
                  "Give the elevation model, not a picture of it.");
}

}  // namespace

namespace {

/// Says what a file is that cannot be opened as heights.
[[noreturn]] void refuseHeights(const std::string& path) {
    const std::string reason = GdalSession::reason();
    GDALDriverH driver = GDALIdentifyDriverEx(path.c_str(), GDAL_OF_RASTER, nullptr, nullptr);
    const std::string format = driver != nullptr ? GDALGetDriverShortName(driver) : "";
    if (std::find(pointers.begin(), pointers.end(), format) != pointers.end()) {
        refuseContent({"terrain.points_elsewhere", "{0} points to heights in other files, which may change unnoticed", {path}},
                      "Make one file of it with gdal_translate, such as a GeoTIFF.");
    }
    if (std::find(picturesOnly.begin(), picturesOnly.end(), format) != picturesOnly.end()) {
        refusePicture(path);
    }
    refuseContent({"terrain.unknown_format", "{0} is no raster of heights that can be read: {1}", {path, reason}},
                  "Give a raster of heights with one band (GeoTIFF, ESRI ASCII grid, BIL, ENVI, IMG, HGT, DTED, XYZ or Surfer), or "
                  "a point cloud.");
}

GDALDatasetUniquePtr openRaster(const std::string& path, RasterFile::Holds what) {
    return GDALDatasetUniquePtr(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                   what == RasterFile::Holds::Heights ? formats.data() : pictures.data(), nullptr, nullptr)));
}

/// A band that says which pixels are there, where GDAL itself does not take it as a mask; null: none.
GDALRasterBand* opacityOf(GDALDataset& file) {
    const int last = file.GetRasterCount();
    GDALRasterBand* band = last > 1 ? file.GetRasterBand(last) : nullptr;
    return band != nullptr && band->GetColorInterpretation() == GCI_AlphaBand ? band : nullptr;
}

}  // namespace

struct RasterFile::Handles {
    GDALDatasetUniquePtr dataset;
    GDALRasterBand* band = nullptr;
    std::vector<GDALRasterBand*> others;  ///< whose values count where they are greater
    GDALRasterBand* opacity = nullptr;    ///< of all bands; null: none
};

RasterFile::RasterFile(const std::string& path, Holds what, const std::string& shown)
    : m_path(shown.empty() ? path : shown), m_handles(std::make_unique<Handles>()) {
    const GdalSession session;
    m_handles->dataset = openRaster(path, what);
    if (!m_handles->dataset && what == Holds::Colours) {
        refuseContent({"terrain.unknown_picture", "{0} is no orthophoto that can be read: {1}", {path, GdalSession::reason()}},
                      "Give a picture of the ground with its place: GeoTIFF, JPEG 2000, or JPEG or PNG with a world file.");
    }
    if (!m_handles->dataset) {
        refuseHeights(path);
    }
    m_bands = m_handles->dataset->GetRasterCount();
    if (m_bands < 1) {
        refuseContent({"terrain.no_band", "{0} holds no raster", {path}}, "Give a raster of heights with one band.");
    }
    m_handles->band = m_handles->dataset->GetRasterBand(1);
    m_handles->opacity = opacityOf(*m_handles->dataset);
    m_bands -= m_handles->opacity != nullptr ? 1 : 0;
    checkLength();
    checkKind(what);
    readPlace();
    readUnits();
}

void RasterFile::checkLength() const {
    // GDAL looks for each missing row of a text from its beginning.
    const std::string format = m_handles->dataset->GetDriverName();
    const double values = static_cast<double>(m_handles->dataset->GetRasterXSize()) * m_handles->dataset->GetRasterYSize();
    std::error_code ignored;
    const auto bytes = static_cast<double>(std::filesystem::file_size(m_path, ignored));
    if ((format == "AAIGrid" || format == "GRASSASCIIGrid" || format == "GSAG") && bytes < values) {
        refuseContent({"terrain.cut", "{0} promises more heights than it can hold", {m_path}},
                      "The file may be cut short: copy it again from where it came.");
    }
}

void RasterFile::checkKind(Holds what) const {
    const GDALColorInterp meaning = m_handles->band->GetColorInterpretation();
    const bool complex = GDALDataTypeIsComplex(m_handles->band->GetRasterDataType());
    if (what == Holds::Heights && (meaning == GCI_RedBand || meaning == GCI_PaletteIndex || complex)) {
        refusePicture(m_path);
    }
    if (what == Holds::Colours && !holdsColours(*m_handles->dataset, m_bands)) {
        refuseContent({"terrain.no_picture", "{0} holds no colours", {m_path}},
                      "Give an orthophoto: three bands, or one of bytes.");
    }
}

RasterFile::~RasterFile() {
    const GdalSession session;
    m_handles->dataset.reset();
}

void RasterFile::readPlace() {
    std::array<double, 6>& g = m_transform;
    if (m_handles->dataset->GetGeoTransform(g.data()) != CE_None) {
        refuseContent({"terrain.no_place", "{0} does not say where its pixels lie", {m_path}},
                      "Give it a place with gdal_translate -a_ullr, or put its world file beside it.");
    }
    const bool finite = std::all_of(g.begin(), g.end(), [](double value) { return std::isfinite(value); });
    if (!finite || !(std::abs(g[1] * g[5] - g[2] * g[4]) > 0.0)) {
        refuseContent({"terrain.flat_place", "The pixels of {0} have no size", {m_path}},
                      "Give it a place with gdal_translate -a_ullr.");
    }
    m_turned = g[2] != 0.0 || g[4] != 0.0;
    m_place.columns = static_cast<std::size_t>(m_handles->dataset->GetRasterXSize());
    m_place.rows = static_cast<std::size_t>(m_handles->dataset->GetRasterYSize());
    m_place.dx = g[1];
    m_place.dy = g[5];
    m_place.x0 = g[0] + 0.5 * g[1];
    m_place.y0 = g[3] + 0.5 * g[5];
}

void RasterFile::readUnits() {
    m_heightUnit = m_handles->band->GetUnitType();
    m_metresPerHeightUnit = metresInUnit(m_heightUnit).value_or(0.0);
    const OGRSpatialReference* crs = m_handles->dataset->GetSpatialRef();
    if (crs == nullptr || crs->IsEmpty()) {
        return;
    }
    const char* name = crs->GetName();
    m_crsName = name != nullptr ? name : "unnamed";
    m_geographic = crs->IsGeographic();
    if (!m_geographic) {
        m_metresPerUnit = crs->GetLinearUnits();
    }
    const char* verticalUnit = nullptr;
    if (m_heightUnit.empty() && crs->IsVertical()) {
        m_metresPerHeightUnit = crs->GetTargetLinearUnits("VERT_CS", &verticalUnit);
        m_heightUnit = verticalUnit != nullptr ? verticalUnit : "";
    }
}

RasterFile::SameCrs RasterFile::sameCrs(const std::string& text) const {
    const GdalSession session;
    const OGRSpatialReference* own = m_handles->dataset->GetSpatialRef();
    OGRSpatialReference other;
    if (own == nullptr || own->IsEmpty() || !setFromText(other, text)) {
        return SameCrs::Unknown;
    }
    OGRSpatialReference plain(*own);
    plain.StripVertical();
    other.StripVertical();
    const std::array<const char*, 3> options{"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT", nullptr};
    return plain.IsSame(&other, options.data()) ? SameCrs::Yes : SameCrs::No;
}

std::string RasterFile::entry(const std::string& name) const {
    const GdalSession session;
    const char* text = m_handles->dataset->GetMetadataItem(name.c_str());
    return text != nullptr ? text : "";
}

std::vector<std::string> RasterFile::bandNames() const {
    const GdalSession session;
    std::vector<std::string> names;
    for (int b = 1; b <= m_bands; ++b) {
        names.emplace_back(m_handles->dataset->GetRasterBand(b)->GetDescription());
    }
    return names;
}

void RasterFile::take(const std::vector<int>& bands) {
    const GdalSession session;
    m_handles->others.clear();
    for (const int band : bands) {
        m_handles->others.push_back(m_handles->dataset->GetRasterBand(band + 1));
    }
    m_handles->band = m_handles->others.front();
    m_handles->others.erase(m_handles->others.begin());
}

std::string RasterFile::verticalDatum() const {
    const GdalSession session;
    const OGRSpatialReference* own = m_handles->dataset->GetSpatialRef();
    return own != nullptr && !own->IsEmpty() ? heightSystemOf(*own) : "";
}

std::string RasterFile::verticalDatum(const std::string& crs) {
    const GdalSession session;
    OGRSpatialReference system;
    return setFromText(system, crs) ? heightSystemOf(system) : "";
}

void RasterFile::checkWay(const std::string& crs, const Eigen::Vector2d& place, Findings& findings) const {
    const GdalSession session;
    const OGRSpatialReference* own = m_handles->dataset->GetSpatialRef();
    OGRSpatialReference of;
    const Eigen::Vector2d unknown = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    addWayFindings(findings, m_path, own, crs, setFromText(of, crs) ? degreesOf(of, place / of.GetLinearUnits()) : unknown);
}

void RasterFile::change(const std::string& crs, bool toFile, std::vector<Eigen::Vector2d>& places) const {
    const GdalSession session;
    const OGRSpatialReference* own = m_handles->dataset->GetSpatialRef();
    if (crs.empty() || own == nullptr || own->IsEmpty()) {
        for (Eigen::Vector2d& place : places) {
            place = toFile ? Eigen::Vector2d(place / m_metresPerUnit) : Eigen::Vector2d(place * m_metresPerUnit);
        }
        return;
    }
    OGRSpatialReference file(*own);
    OGRSpatialReference other;
    const bool known = setFromText(other, crs) && !other.IsGeographic();
    file.StripVertical();
    other.StripVertical();
    file.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    other.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> way(
        known ? OGRCreateCoordinateTransformation(toFile ? &other : &file, toFile ? &file : &other) : nullptr);
    if (!way) {
        throw UsageError(
            {"terrain.no_way", "There is no way from the system \"{0}\" of {1} to \"{2}\" of the case", {m_crsName, m_path, crs}},
            {"terrain.no_way.remedy", "Give the case a projected system in metres, such as EPSG:25832.", {}});
    }
    const double unit = other.GetLinearUnits();
    std::vector<double> x;
    std::vector<double> y;
    for (const Eigen::Vector2d& place : places) {
        x.push_back(toFile ? place.x() / unit : place.x());
        y.push_back(toFile ? place.y() / unit : place.y());
    }
    std::vector<int> done(places.size(), FALSE);
    way->Transform(static_cast<int>(places.size()), x.data(), y.data(), nullptr, done.data());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const bool good = done[k] != FALSE && std::isfinite(x[k]) && std::isfinite(y[k]);
        const double nothing = std::numeric_limits<double>::quiet_NaN();
        places[k] = !good ? Eigen::Vector2d(nothing, nothing) : Eigen::Vector2d(x[k], y[k]) * (toFile ? 1.0 : unit);
    }
}

void RasterFile::toPixels(const std::string& crs, std::vector<Eigen::Vector2d>& places) const {
    change(crs, true, places);
    const std::array<double, 6>& g = m_transform;
    const double area = g[1] * g[5] - g[2] * g[4];
    for (Eigen::Vector2d& place : places) {
        const double x = place.x() - g[0];
        const double y = place.y() - g[3];
        place = {(g[5] * x - g[2] * y) / area - 0.5, (g[1] * y - g[4] * x) / area - 0.5};
    }
}

void RasterFile::fromPixels(const std::string& crs, std::vector<Eigen::Vector2d>& places) const {
    const std::array<double, 6>& g = m_transform;
    for (Eigen::Vector2d& place : places) {
        const double column = place.x() + 0.5;
        const double row = place.y() + 0.5;
        place = {g[0] + g[1] * column + g[2] * row, g[3] + g[4] * column + g[5] * row};
    }
    change(crs, false, places);
}

namespace {

/// Rows of pixels put together that are read at once.
std::size_t rowsTogether(const RasterWindow& window) {
    const std::size_t rows = std::clamp<std::size_t>(pixelsAtOnce / std::max<std::size_t>(window.columns, 1), 1, rowsAtOnce);
    return std::max<std::size_t>(1, rows / window.factor);
}

/// Reads rows of a window as the file has them. Never fewer pixels than it has: GDAL would take them from pyramids, which may hold
/// anything.
template <class Number>
bool readRows(GDALRasterBand& band, const RasterWindow& window, std::size_t first, std::size_t count, std::vector<Number>& into) {
    const GDALDataType type =
        std::is_same_v<Number, double> ? GDT_Float64 : (std::is_same_v<Number, float> ? GDT_Float32 : GDT_Byte);
    const auto whole = [](std::size_t n) { return static_cast<int>(n); };
    return band.RasterIO(GF_Read, whole(window.column), whole(first), whole(window.columns), whole(count), into.data(),
                         whole(window.columns), whole(count), type, 0, 0, nullptr) == CE_None;
}

/// Visits the pixels that are put together to one, by their index among those that were read.
template <class Visit>
void visitTogether(const RasterWindow& window, std::size_t row, std::size_t column, Visit visit) {
    for (std::size_t j = 0; j < window.factor; ++j) {
        for (std::size_t i = 0; i < window.factor; ++i) {
            visit((row * window.factor + j) * window.columns + column * window.factor + i);
        }
    }
}

/// Mean of the pixels that count; not a number without any.
class PixelMean {
public:
    void add(double value) {
        m_sum += value;
        ++m_count;
    }
    double value() const { return m_count > 0 ? m_sum / static_cast<double>(m_count) : unknown; }

private:
    double m_sum = 0.0;
    std::size_t m_count = 0;
};

}  // namespace

void RasterFile::refuseRows(std::size_t first) const {
    refuseContent({"terrain.unreadable_rows",
                   "{0} cannot be read from row {1} of {2} on: {3}",
                   {m_path, first, m_place.rows, GdalSession::reason()}},
                  "The file may be cut short: copy it again from where it came.");
}

std::vector<double> RasterFile::values(const RasterWindow& window, const Execution& execution) const {
    std::vector<double> all(window.width() * window.height(), std::numeric_limits<double>::quiet_NaN());
    readGreater(*m_handles->band, window, all, execution);
    for (GDALRasterBand* band : m_handles->others) {
        readGreater(*band, window, all, execution);
    }
    return all;
}

void RasterFile::readGreater(GDALRasterBand& band, const RasterWindow& window, std::vector<double>& all,
                             const Execution& execution) const {
    const std::size_t atOnce = rowsTogether(window);
    std::vector<double> values(window.columns * std::min(window.height(), atOnce) * window.factor);
    std::vector<std::uint8_t> mask(values.size());
    for (std::size_t from = 0; from < window.height(); from += atOnce) {
        execution.check();
        const GdalSession session;
        const std::size_t count = std::min(atOnce, window.height() - from);
        const std::size_t first = window.row + from * window.factor;
        // GDAL takes an opacity beside heights with fractions for one more height.
        const bool known = (band.GetMaskFlags() & GMF_ALL_VALID) == 0;
        GDALRasterBand* const masking = known ? band.GetMaskBand() : m_handles->opacity;
        if (!readRows(band, window, first, count * window.factor, values) ||
            (masking != nullptr && !readRows(*masking, window, first, count * window.factor, mask))) {
            refuseRows(first + 1);
        }
        const double scale = band.GetScale();
        const double offset = band.GetOffset();
        for (std::size_t k = 0; k < window.width() * count; ++k) {
            PixelMean mean;
            visitTogether(window, k / window.width(), k % window.width(), [&](std::size_t pixel) {
                if ((masking == nullptr || mask[pixel] > 0) && std::isfinite(values[pixel])) {
                    mean.add(values[pixel]);
                }
            });
            double& greatest = all[from * window.width() + k];
            greatest = std::fmax(greatest, scale * mean.value() + offset);
        }
    }
}

namespace {

/// Colours of a window before they are scaled, pixels put together by their mean.
struct ColourPlanes {
    std::array<std::vector<float>, 3> colours;
    std::vector<std::uint8_t> opacity;
    float most = 0.0F;  ///< greatest of a pixel that is there
};

/// Rows of a picture as they were read.
struct ColourRows {
    std::array<std::vector<float>, 3> colours;
    std::vector<std::uint8_t> opacity;
};

/// Puts rows of a picture together. @param from  first row of the planes
void putTogether(ColourPlanes& planes, const ColourRows& rows, const RasterWindow& window, std::size_t from, std::size_t count,
                 bool palette) {
    for (std::size_t k = 0; k < window.width() * count; ++k) {
        const std::size_t to = from * window.width() + k;
        const std::size_t row = k / window.width();
        const std::size_t column = k % window.width();
        if (palette) {
            // The mean of two numbers of a palette is another colour.
            const std::size_t half = window.factor / 2;
            const std::size_t middle = (row * window.factor + half) * window.columns + column * window.factor + half;
            planes.opacity[to] = rows.opacity[middle];
            for (std::size_t channel = 0; channel < 3; ++channel) {
                planes.colours[channel][to] = rows.colours[channel][middle];
            }
            continue;
        }
        PixelMean opacity;
        std::array<PixelMean, 3> means;
        visitTogether(window, row, column, [&](std::size_t pixel) {
            opacity.add(rows.opacity[pixel]);
            for (std::size_t channel = 0; channel < 3 && rows.opacity[pixel] > 0; ++channel) {
                planes.most = std::fmax(planes.most, rows.colours[channel][pixel]);
                means[channel].add(rows.colours[channel][pixel]);
            }
        });
        planes.opacity[to] = static_cast<std::uint8_t>(std::lround(opacity.value()));
        for (std::size_t channel = 0; channel < 3; ++channel) {
            planes.colours[channel][to] = static_cast<float>(means[channel].value());
        }
    }
}

/// Reads rows of each band, and of those that say which pixels are there.
bool readColourRows(const ColourBands& bands, const RasterWindow& window, std::size_t first, std::size_t count, ColourRows& rows) {
    std::vector<float>& there = rows.colours[0];
    std::fill(rows.opacity.begin(), rows.opacity.end(), std::uint8_t{255});
    for (std::size_t m = 0; m < bands.masks.size(); ++m) {
        if (!readRows(*bands.masks[m], window, first, count, there)) {
            return false;
        }
        for (std::size_t k = 0; k < count * window.columns; ++k) {
            // A pixel is there if any of its colours is: the mark for nothing may be a value of another one.
            const auto opacity = static_cast<std::uint8_t>(std::clamp(there[k] * bands.maskScale, 0.0F, 255.0F));
            rows.opacity[k] = m == 0 ? opacity : std::max(rows.opacity[k], opacity);
        }
    }
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (channel > 0 && bands.colours[channel] == bands.colours[channel - 1]) {
            rows.colours[channel] = rows.colours[channel - 1];
        } else if (!readRows(*bands.colours[channel], window, first, count, rows.colours[channel])) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<std::uint8_t> RasterFile::colours(const RasterWindow& window, const Execution& execution, Findings& findings) const {
    const ColourBands bands = colourBands(*m_handles->dataset, m_path, findings);
    const std::size_t pixels = window.width() * window.height();
    const std::size_t atOnce = rowsTogether(window);
    ColourPlanes planes;
    ColourRows rows;
    planes.opacity.resize(pixels);
    rows.opacity.resize(window.columns * std::min(window.height(), atOnce) * window.factor);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        planes.colours[channel].resize(pixels);
        rows.colours[channel].resize(rows.opacity.size());
    }
    for (std::size_t from = 0; from < window.height(); from += atOnce) {
        execution.check();
        const GdalSession session;
        const std::size_t count = std::min(atOnce, window.height() - from);
        const std::size_t first = window.row + from * window.factor;
        if (!readColourRows(bands, window, first, count * window.factor, rows)) {
            refuseRows(first + 1);
        }
        putTogether(planes, rows, window, from, count, bands.palette != nullptr);
    }
    const ColourScale scale = colourScale(*bands.colours.front(), bands.palette != nullptr, planes.most, m_path, findings);
    std::vector<std::uint8_t> all;
    all.reserve(4 * pixels);
    for (std::size_t k = 0; k < pixels; ++k) {
        for (const std::vector<float>& colour : planes.colours) {
            all.push_back(scale(colour[k]));
        }
        all.push_back(planes.opacity[k]);
    }
    if (bands.palette != nullptr) {
        applyPalette(*bands.palette, all);
    }
    return all;
}

}  // namespace rubble::io
