#include "io/terrain/raster_file.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/base/error.h"
#include "io/native_lock.h"

namespace rubble::io {

namespace {

/// Formats that hold one raster in one local file. Those that point to other files or hosts are left out: the content of such a
/// terrain would not be that of the file whose SHA-256 is kept.
constexpr std::array<const char*, 17> formats{"GTiff",   "COG",     "AAIGrid", "GRASSASCIIGrid", "EHdr", "ENVI",  "HFA",
                                              "SRTMHGT", "DTED",    "XYZ",     "GSAG",           "GSBG", "GS7BG", "SAGA",
                                              "NWT_GRD", "USGSDEM", nullptr};
constexpr std::size_t rowsAtOnce = 256;

/// The lock, and errors of GDAL kept for the message instead of printed.
class Session {
public:
    Session() : m_lock(nativeLibraries()) {
        CPLPushErrorHandler(CPLQuietErrorHandler);
        CPLErrorReset();
        // Else whole numbers on the first lines make an integer grid, in which "nan" further down would be read as zero.
        CPLSetThreadLocalConfigOption("AAIGRID_DATATYPE", "Float64");
    }
    ~Session() {
        CPLSetThreadLocalConfigOption("AAIGRID_DATATYPE", nullptr);
        CPLPopErrorHandler();
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    static std::string reason() {
        const std::string text = CPLGetLastErrorMsg();
        return text.empty() ? "no more is known" : text;
    }

private:
    std::scoped_lock<std::recursive_mutex> m_lock;
};

[[noreturn]] void refuse(Message what, std::string_view remedy) {
    std::string id = what.id + ".remedy";
    throw ParseError(std::move(what), {std::move(id), std::string(remedy), {}});
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

struct RasterFile::Handles {
    GDALDatasetUniquePtr dataset;
    GDALRasterBand* band = nullptr;
};

RasterFile::RasterFile(const std::string& path) : m_path(path), m_handles(std::make_unique<Handles>()) {
    const Session session;
    static const bool registered = [] {
        GDALAllRegister();
        return true;
    }();
    (void)registered;
    m_handles->dataset.reset(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, formats.data(), nullptr, nullptr)));
    if (!m_handles->dataset) {
        refuse({"terrain.unknown_format", "{0} is no terrain that can be read: {1}", {path, Session::reason()}},
               "Give a raster of heights with one band: GeoTIFF, ESRI ASCII grid, BIL, ENVI, IMG, HGT, DTED, XYZ or Surfer.");
    }
    m_bands = m_handles->dataset->GetRasterCount();
    if (m_bands < 1) {
        refuse({"terrain.no_band", "{0} holds no raster", {path}}, "Give a raster of heights with one band.");
    }
    m_handles->band = m_handles->dataset->GetRasterBand(1);
    const GDALColorInterp meaning = m_handles->band->GetColorInterpretation();
    if (meaning == GCI_RedBand || meaning == GCI_PaletteIndex || GDALDataTypeIsComplex(m_handles->band->GetRasterDataType())) {
        refuse({"terrain.picture", "{0} holds colours or complex numbers, not heights", {path}},
               "Give the elevation model, not a picture of it.");
    }
    readPlace();
    readUnits();
}

RasterFile::~RasterFile() {
    const Session session;
    m_handles->dataset.reset();
}

void RasterFile::readPlace() {
    std::array<double, 6> g{};
    if (m_handles->dataset->GetGeoTransform(g.data()) != CE_None) {
        refuse({"terrain.no_place", "{0} does not say where its pixels lie", {m_path}},
               "Give it a place with gdal_translate -a_ullr, or put its world file beside it.");
    }
    const bool finite = std::all_of(g.begin(), g.end(), [](double value) { return std::isfinite(value); });
    if (!finite || g[1] == 0.0 || g[5] == 0.0 || g[2] != 0.0 || g[4] != 0.0) {
        refuse({"terrain.turned", "The rows of {0} do not run along east and north", {m_path}},
               "Turn it upright with gdalwarp -r bilinear.");
    }
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
    const Session session;
    const OGRSpatialReference* own = m_handles->dataset->GetSpatialRef();
    OGRSpatialReference other;
    if (own == nullptr || own->IsEmpty() || text.empty() ||
        other.SetFromUserInput(text.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE) {
        return SameCrs::Unknown;
    }
    OGRSpatialReference plain(*own);
    plain.StripVertical();
    other.StripVertical();
    const std::array<const char*, 3> options{"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT", nullptr};
    return plain.IsSame(&other, options.data()) ? SameCrs::Yes : SameCrs::No;
}

std::vector<double> RasterFile::values(std::size_t column, std::size_t row, std::size_t columns, std::size_t rows,
                                       const Execution& execution) const {
    GDALRasterBand& band = *m_handles->band;
    std::vector<double> all(columns * rows);
    std::vector<std::uint8_t> mask(columns * std::min(rows, rowsAtOnce));
    for (std::size_t from = 0; from < rows; from += rowsAtOnce) {
        execution.check();
        const Session session;
        const int count = static_cast<int>(std::min(rowsAtOnce, rows - from));
        const int x = static_cast<int>(column);
        const int y = static_cast<int>(row + from);
        const int width = static_cast<int>(columns);
        double* target = &all[from * columns];
        const bool masked = (band.GetMaskFlags() & GMF_ALL_VALID) == 0;
        if (band.RasterIO(GF_Read, x, y, width, count, target, width, count, GDT_Float64, 0, 0, nullptr) != CE_None ||
            (masked && band.GetMaskBand()->RasterIO(GF_Read, x, y, width, count, mask.data(), width, count, GDT_Byte, 0, 0,
                                                    nullptr) != CE_None)) {
            refuse({"terrain.unreadable_rows",
                    "{0} cannot be read from row {1} of {2} on: {3}",
                    {m_path, y + 1, m_place.rows, Session::reason()}},
                   "The file may be cut short: copy it again from where it came.");
        }
        const double scale = band.GetScale();
        const double offset = band.GetOffset();
        for (std::size_t k = 0; k < columns * static_cast<std::size_t>(count); ++k) {
            const bool known = (!masked || mask[k] != 0) && std::isfinite(target[k]);
            target[k] = known ? scale * target[k] + offset : std::numeric_limits<double>::quiet_NaN();
        }
    }
    return all;
}

}  // namespace rubble::io
