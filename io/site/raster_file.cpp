#include "io/site/raster_file.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "io/base/file_words.h"
#include "io/base/files.h"
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

/// Formats that only say where the heights are.
constexpr std::array<std::string_view, 5> pointers{"VRT", "GTI", "WMS", "WCS", "STACTA"};
/// Formats that hold colours and nothing else.
constexpr std::array<std::string_view, 5> picturesOnly{"PNG", "JPEG", "GIF", "BMP", "WEBP"};

[[noreturn]] void refusePicture(const std::string& path) {
    refuseContent({"terrain.picture", "{0} holds colours or complex numbers, not heights", {path}},
                  "Give the elevation model, not a picture of it.");
}

/// Metres in a unit of height by the names that files use; 0 if unknown.
double metresInUnit(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::erase_if(name, [](char c) { return c == ' ' || c == '_' || c == '-' || c == '.'; });
    struct Unit {
        double metres;
        std::vector<std::string> names;
    };
    static const std::vector<Unit> units{
        {1.0, {"m", "metre", "metres", "meter", "meters"}},
        {0.3048, {"ft", "foot", "feet", "internationalfoot", "internationalfeet"}},
        {1200.0 / 3937.0, {"ftus", "usft", "sft", "footus", "ussurveyfoot", "ussurveyfeet", "ussft", "surveyfoot", "surveyfeet"}},
        {0.01, {"cm", "centimetre", "centimetres", "centimeter", "centimeters"}},
        {0.001, {"mm", "millimetre", "millimetres", "millimeter", "millimeters"}},
        {1000.0, {"km", "kilometre", "kilometres", "kilometer", "kilometers"}},
    };
    for (const Unit& unit : units) {
        if (std::find(unit.names.begin(), unit.names.end(), name) != unit.names.end()) {
            return unit.metres;
        }
    }
    return 0.0;
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

GDALDatasetUniquePtr openRaster(const std::string& path, RasterFile::Holds what, const char* option = nullptr) {
    const std::array<const char*, 2> options{option, nullptr};
    return GDALDatasetUniquePtr(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                   what == RasterFile::Holds::Heights ? formats.data() : pictures.data(), options.data(), nullptr)));
}

/// Whether GDAL would take pixels that are put together from a file beside the raster.
bool hasPyramidsBeside(GDALDataset& file) {
    GDALRasterBand* const band = file.GetRasterBand(1);
    GDALRasterBand* const pyramid = band->GetOverviewCount() > 0 ? band->GetOverview(0) : nullptr;
    const GDALDataset* const of = pyramid != nullptr ? pyramid->GetDataset() : nullptr;
    return of != nullptr && (hasEnding(of->GetDescription(), ".ovr") || hasEnding(of->GetDescription(), ".rrd"));
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
    /// The same without pyramids in a file of their own, which are no part of its digest: heights come from here. Null: it has
    /// none.
    GDALDatasetUniquePtr pixels;

    GDALRasterBand* pixelsOf(GDALRasterBand* of) const {
        return pixels && of != nullptr ? pixels->GetRasterBand(of->GetBand()) : of;
    }
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
    if (what == Holds::Heights && hasPyramidsBeside(*m_handles->dataset)) {
        m_handles->pixels = openRaster(path, what, "OVERVIEW_LEVEL=NONE");
    }
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
    m_handles->pixels.reset();
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
    m_metresPerHeightUnit = metresInUnit(m_heightUnit);
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

/// Reads some rows of a window into a buffer, pixels put together by their mean.
bool readRows(GDALRasterBand& band, const RasterWindow& window, std::size_t from, std::size_t count, void* target,
              GDALDataType type) {
    GDALRasterIOExtraArg extra;
    INIT_RASTERIO_EXTRA_ARG(extra);
    // The mean of two numbers of a palette is another colour.
    const bool mean = window.factor > 1 && band.GetColorInterpretation() != GCI_PaletteIndex;
    extra.eResampleAlg = mean ? GRIORA_Average : GRIORA_NearestNeighbour;
    const auto whole = [](std::size_t n) { return static_cast<int>(n); };
    return band.RasterIO(GF_Read, whole(window.column), whole(window.row + from * window.factor), whole(window.columns),
                         whole(count * window.factor), target, whole(window.width()), whole(count), type, 0, 0, &extra) == CE_None;
}

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
    const std::size_t columns = window.width();
    const std::size_t rows = window.height();
    const std::size_t atOnce = std::max<std::size_t>(1, rowsAtOnce / window.factor);
    std::vector<double> values(columns * std::min(rows, atOnce));
    std::vector<std::uint8_t> mask(values.size());
    for (std::size_t from = 0; from < rows; from += atOnce) {
        execution.check();
        const GdalSession session;
        const std::size_t count = std::min(atOnce, rows - from);
        // GDAL takes an opacity beside heights with fractions for one more height: then its average of pixels mixes in hidden ones.
        const bool known = (band.GetMaskFlags() & GMF_ALL_VALID) == 0;
        GDALRasterBand* const pixels = m_handles->pixelsOf(&band);
        GDALRasterBand* const masking = known ? pixels->GetMaskBand() : m_handles->pixelsOf(m_handles->opacity);
        const int least = !known && window.factor > 1 ? 255 : 1;
        if (!readRows(*pixels, window, from, count, values.data(), GDT_Float64) ||
            (masking != nullptr && !readRows(*masking, window, from, count, mask.data(), GDT_Byte))) {
            refuseRows(window.row + from * window.factor + 1);
        }
        const double scale = band.GetScale();
        const double offset = band.GetOffset();
        for (std::size_t k = 0; k < columns * count; ++k) {
            if ((masking == nullptr || mask[k] >= least) && std::isfinite(values[k])) {
                double& greatest = all[from * columns + k];
                greatest = std::fmax(greatest, scale * values[k] + offset);
            }
        }
    }
}

std::vector<float> RasterFile::plane(GDALRasterBand& band, const RasterWindow& window, const Execution& execution) const {
    std::vector<float> plane(window.width() * window.height());
    const std::size_t atOnce = std::max<std::size_t>(1, rowsAtOnce / window.factor);
    for (std::size_t from = 0; from < window.height(); from += atOnce) {
        execution.check();
        const GdalSession session;
        const std::size_t count = std::min(atOnce, window.height() - from);
        if (!readRows(band, window, from, count, &plane[from * window.width()], GDT_Float32)) {
            refuseRows(window.row + from * window.factor + 1);
        }
    }
    return plane;
}

std::vector<std::uint8_t> RasterFile::colours(const RasterWindow& window, const Execution& execution, Findings& findings) const {
    const ColourBands bands = colourBands(*m_handles->dataset, m_path, findings);
    std::vector<std::uint8_t> all(4 * window.width() * window.height(), 255);
    for (std::size_t m = 0; m < bands.masks.size(); ++m) {
        const std::vector<float> there = plane(*bands.masks[m], window, execution);
        for (std::size_t k = 0; k < there.size(); ++k) {
            // A pixel is there if any of its colours is: the mark for nothing may be a value of another one.
            const auto opacity = static_cast<std::uint8_t>(std::clamp(there[k] * bands.maskScale, 0.0F, 255.0F));
            all[4 * k + 3] = m == 0 ? opacity : std::max(all[4 * k + 3], opacity);
        }
    }
    std::array<std::vector<float>, 3> values;
    float most = 0.0F;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const bool again = channel > 0 && bands.colours[channel] == bands.colours[channel - 1];
        values[channel] = again ? values[channel - 1] : plane(*bands.colours[channel], window, execution);
        for (std::size_t k = 0; k < values[channel].size(); ++k) {
            most = all[4 * k + 3] > 0 ? std::fmax(most, values[channel][k]) : most;
        }
    }
    const ColourScale scale = colourScale(*bands.colours.front(), bands.palette != nullptr, most, m_path, findings);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        for (std::size_t k = 0; k < values[channel].size(); ++k) {
            all[4 * k + channel] = scale(values[channel][k]);
        }
    }
    if (bands.palette != nullptr) {
        applyPalette(*bands.palette, all);
    }
    return all;
}

}  // namespace rubble::io
