#include "io/geo/evidence_surface.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "io/geo/gdal_memory.h"
#include "io/geo/map_place.h"

namespace rubble::io {

namespace {

constexpr double cellsMost = 4e7;
constexpr int samplesPerSide = 4;
/// m: less than this over the ground is no debris of a survey, but grass and noise.
constexpr double leastHeight = 0.05;

[[noreturn]] void refuse(Message what, std::string_view remedy) {
    std::string id = what.id + ".remedy";
    throw ParseError(std::move(what), {std::move(id), std::string(remedy), {}});
}

[[noreturn]] void refuseUnreadable(const std::string& path) {
    throw WorldError({"evidence.unreadable", "{0} cannot be read as evidence: {1}", {path, GdalCalls::reason()}},
                     {"evidence.unreadable.remedy", "Give polygons (GeoPackage, GeoJSON, Shapefile) or a raster of heights.", {}});
}

GDALDatasetUniquePtr open(const std::string& path, unsigned int kind) {
    GDALDatasetUniquePtr file(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), kind | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr)));
    if (!file) {
        refuseUnreadable(path);
    }
    return file;
}

/// The edges of polygons, and which cells lie within them by the even-odd rule.
class PolygonFill {
public:
    explicit PolygonFill(double cell) : m_cell(cell) {}

    void add(const OGRGeometry& geometry, const MapPlace& place) {
        if (const auto* polygon = dynamic_cast<const OGRPolygon*>(&geometry)) {
            for (const OGRLinearRing* ring : *polygon) {
                addRing(*ring, place);
            }
        } else if (const auto* many = dynamic_cast<const OGRGeometryCollection*>(&geometry)) {
            for (const OGRGeometry* each : *many) {
                add(*each, place);
            }
        }
    }

    /// Ascending.
    std::vector<MapCell> cells() {
        std::vector<MapCell> list;
        for (auto& [row, crossings] : m_crossings) {
            std::sort(crossings.begin(), crossings.end());
            for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
                const auto first = static_cast<std::int32_t>(std::ceil(crossings[k] / m_cell - 0.5));
                const auto last = static_cast<std::int32_t>(std::ceil(crossings[k + 1] / m_cell - 0.5));
                if (list.size() + static_cast<std::size_t>(std::max(0, last - first)) > cellsMost) {
                    m_rows = std::numeric_limits<double>::infinity();
                    return {};
                }
                for (std::int32_t i = first; i < last; ++i) {
                    list.push_back({row, i});
                }
            }
        }
        return list;
    }

    /// That edges cross; infinite for what lies farther away than can be mapped.
    double rows() const { return m_rows; }

private:
    void addRing(const OGRLinearRing& ring, const MapPlace& place) {
        for (int k = 0; k + 1 < ring.getNumPoints(); ++k) {
            addEdge(place.toLocal({ring.getX(k), ring.getY(k)}), place.toLocal({ring.getX(k + 1), ring.getY(k + 1)}));
        }
    }

    void addEdge(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        const double low = std::min(a.y(), b.y()) / m_cell;
        const double high = std::max(a.y(), b.y()) / m_cell;
        const double reach = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()) / m_cell;
        if (!(reach < 1e8)) {
            m_rows = std::numeric_limits<double>::infinity();
            return;
        }
        m_rows += high - low;
        if (m_rows > cellsMost) {
            return;
        }
        for (auto row = static_cast<std::int32_t>(std::ceil(low - 0.5)); row + 0.5 < high; ++row) {
            const double y = (row + 0.5) * m_cell;
            m_crossings[row].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
    }

    double m_cell;
    double m_rows = 0.0;
    std::map<std::int32_t, std::vector<double>> m_crossings;
};

OGRLayer* polygonsOf(GDALDataset& file) {
    if (OGRLayer* layer = file.GetLayerByName("footprint")) {
        return layer;
    }
    for (int k = 0; k < file.GetLayerCount(); ++k) {
        const OGRwkbGeometryType type = wkbFlatten(file.GetLayer(k)->GetGeomType());
        if (type == wkbPolygon || type == wkbMultiPolygon || type == wkbUnknown) {
            return file.GetLayer(k);
        }
    }
    return nullptr;
}

/// Brings a geometry into the system of the case, where both are known and differ.
void bringOver(OGRGeometry& geometry, const OGRSpatialReference* from, const MapPlace& place, const Frame& frame,
               const std::string& path) {
    if (from == nullptr || from->IsLocal() || frame.crs.empty() || from->IsSame(&place.system())) {
        return;
    }
    OGRSpatialReference source(*from);
    source.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    OGRSpatialReference target(place.system());
    geometry.assignSpatialReference(&source);
    if (geometry.transformTo(&target) != OGRERR_NONE) {
        refuse({"evidence.system",
                "{0} cannot be brought from its coordinate system into that of the case: {1}",
                {path, GdalCalls::reason()}},
               "Bring it over with ogr2ogr -t_srs.");
    }
    geometry.assignSpatialReference(nullptr);
}

/// A raster with the bands that count.
class HeightBands {
public:
    HeightBands(const std::string& path, bool withFallen) : m_path(path), m_file(open(path, GDAL_OF_RASTER)) {
        if (m_file->GetGeoTransform(m_place.data()) != CE_None || GDALInvGeoTransform(m_place.data(), m_pixels.data()) == FALSE) {
            refuse({"evidence.no_place", "{0} does not say where its pixels lie", {path}},
                   "Give it a place with gdal_translate -a_ullr.");
        }
        const char* ours = m_file->GetMetadataItem("RUBBLE_CLASS");
        m_ours = ours != nullptr;
        for (int b = 1; b <= m_file->GetRasterCount(); ++b) {
            const std::string name = m_file->GetRasterBand(b)->GetDescription();
            if (name == "height" || name == "height_p50" || (withFallen && name == "live_height") ||
                (!m_ours && b == 1 && m_bands.empty())) {
                m_bands.push_back(b);
            }
        }
        if (m_bands.empty()) {
            refuse({"evidence.no_heights", "{0} has no layer of heights", {path}}, "Write the map with the layer height.");
        }
        readAll();
    }

    bool ours() const { return m_ours; }
    const OGRSpatialReference* system() const { return m_file->GetSpatialRef(); }
    /// Its corners, in coordinates of the file.
    std::array<Eigen::Vector2d, 4> corners() const {
        const auto corner = [&](double column, double row) {
            return Eigen::Vector2d(m_place[0] + column * m_place[1] + row * m_place[2],
                                   m_place[3] + column * m_place[4] + row * m_place[5]);
        };
        return {corner(0.0, 0.0), corner(m_width, 0.0), corner(0.0, m_height), corner(m_width, m_height)};
    }
    /// The greatest of the bands at a place of the file; NaN where none has a value.
    double at(const Eigen::Vector2d& place) const {
        const auto column = static_cast<int>(std::floor(m_pixels[0] + place.x() * m_pixels[1] + place.y() * m_pixels[2]));
        const auto row = static_cast<int>(std::floor(m_pixels[3] + place.x() * m_pixels[4] + place.y() * m_pixels[5]));
        double value = std::numeric_limits<double>::quiet_NaN();
        if (column < 0 || row < 0 || column >= m_width || row >= m_height) {
            return value;
        }
        const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(column);
        for (const std::vector<float>& band : m_values) {
            value = std::fmax(value, double{band[i]});
        }
        return value;
    }

private:
    void readAll() {
        m_width = m_file->GetRasterXSize();
        m_height = m_file->GetRasterYSize();
        if (double{1.0} * m_width * m_height > cellsMost) {
            refuse({"evidence.too_large", "{0} has {1} x {2} pixels, more than can be compared", {m_path, m_width, m_height}},
                   "Cut it to the site with gdal_translate -projwin, or make it coarser with -tr.");
        }
        for (const int b : m_bands) {
            GDALRasterBand& band = *m_file->GetRasterBand(b);
            std::vector<float>& values =
                m_values.emplace_back(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height));
            if (band.RasterIO(GF_Read, 0, 0, m_width, m_height, values.data(), m_width, m_height, GDT_Float32, 0, 0, nullptr) !=
                CE_None) {
                refuseUnreadable(m_path);
            }
            int has = 0;
            const double noData = band.GetNoDataValue(&has);
            for (float& value : values) {
                if (!std::isfinite(value) || (has != 0 && value == static_cast<float>(noData))) {
                    value = std::numeric_limits<float>::quiet_NaN();
                }
            }
        }
    }

    std::string m_path;
    GDALDatasetUniquePtr m_file;
    std::array<double, 6> m_place{};
    std::array<double, 6> m_pixels{};  ///< from places to pixels
    bool m_ours = false;
    std::vector<int> m_bands;
    int m_width = 0;
    int m_height = 0;
    std::vector<std::vector<float>> m_values;
};

/// Mean height of the debris in a cell; NaN where it was not looked at.
double heightIn(const HeightBands& bands, const MapPlace& place, const Eigen::Vector2d& corner, double cell, bool surface,
                double zero, const SiteSurface& ground) {
    double sum = 0.0;
    for (int k = 0; k < samplesPerSide * samplesPerSide; ++k) {
        const Eigen::Vector2d at =
            corner + cell / samplesPerSide * Eigen::Vector2d(k % samplesPerSide + 0.5, k / samplesPerSide + 0.5);
        double value = bands.at(place(at));
        if (bands.ours() && std::isnan(value)) {
            value = 0.0;
        }
        sum += surface ? std::max(0.0, value - zero - ground.height(at.x(), at.y())) : value;
        if (std::isnan(value)) {
            return value;
        }
    }
    const double mean = sum / (samplesPerSide * samplesPerSide);
    return bands.ours() || mean >= leastHeight ? mean : 0.0;
}

}  // namespace

SurfaceEvidence readFootprint(const std::string& path, const Frame& frame, const Site& site, double cell, bool withFallen) {
    const MapPlace place(frame, site);
    const GdalCalls calls;
    const GDALDatasetUniquePtr file = open(path, GDAL_OF_VECTOR);
    OGRLayer* layer = polygonsOf(*file);
    if (layer == nullptr) {
        refuse({"evidence.no_polygons", "{0} has no layer of polygons", {path}}, "Give the outline of the debris as polygons.");
    }
    std::vector<MapCell> cells;
    double rows = 0.0;
    layer->ResetReading();
    while (const OGRFeatureUniquePtr feature{layer->GetNextFeature()}) {
        OGRGeometry* geometry = feature->GetGeometryRef();
        // A map of this program tells the fallen live structure apart.
        const int of = feature->GetFieldIndex("of");
        const bool fallen = of >= 0 && std::string_view(feature->GetFieldAsString(of)) == "live structure";
        if (geometry == nullptr || (fallen && !withFallen)) {
            continue;
        }
        bringOver(*geometry, layer->GetSpatialRef(), place, frame, path);
        PolygonFill fill(cell);
        fill.add(*geometry, place);
        const std::vector<MapCell> more = fill.rows() > cellsMost ? std::vector<MapCell>() : fill.cells();
        rows += fill.rows();
        if (rows > cellsMost) {
            break;
        }
        cells.insert(cells.end(), more.begin(), more.end());
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    if (cells.empty() || rows > cellsMost) {
        refuse({"evidence.no_area", "The polygons of {0} cover no cell of {1}, or lie too far from the site", {path, {cell, "m"}}},
               "Check their coordinate system and that of the case, or choose smaller cells.");
    }
    SurfaceEvidence evidence;
    evidence.name = std::filesystem::path(path).filename().string();
    evidence.kind = EvidenceKind::Footprint;
    evidence.seen.cells = std::move(cells);
    evidence.seen.heights.assign(evidence.seen.cells.size(), 1.0F);
    return evidence;
}

SurfaceEvidence readHeights(const std::string& path, const Frame& frame, const Site& site, double cell, SurveyedHeights meaning,
                            bool withFallen, const SiteSurface& ground) {
    const MapPlace place(frame, site);
    const GdalCalls calls;
    const HeightBands bands(path, withFallen);
    const OGRSpatialReference* system = bands.system();
    if (system != nullptr && !system->IsLocal() && !frame.crs.empty()) {
        OGRSpatialReference flat(*system);
        flat.StripVertical();
        if (!flat.IsSame(&place.system())) {
            refuse({"evidence.other_system", "{0} is in another coordinate system than the case, {1}", {path, place.name()}},
                   "Bring it over with gdalwarp -t_srs.");
        }
    }
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : bands.corners()) {
        box.extend(Eigen::Vector2d(place.toLocal(corner) / cell));
    }
    const Eigen::Vector2d low = box.min();
    const Eigen::Vector2d high = box.max();
    if (!(std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) < 1e8) || (high - low).prod() > cellsMost) {
        refuse({"evidence.elsewhere", "{0} lies too far from the site to be compared on cells of {1}", {path, {cell, "m"}}},
               "Check its coordinate system and that of the case, or choose larger cells.");
    }
    SurfaceEvidence evidence;
    evidence.name = std::filesystem::path(path).filename().string();
    evidence.kind = EvidenceKind::Heights;
    evidence.everywhere = bands.ours();
    for (auto j = static_cast<std::int32_t>(std::floor(low.y() + 1e-6)); j < high.y() - 1e-6; ++j) {
        for (auto i = static_cast<std::int32_t>(std::floor(low.x() + 1e-6)); i < high.x() - 1e-6; ++i) {
            const double height = heightIn(bands, place, cell * Eigen::Vector2d(i, j), cell, meaning == SurveyedHeights::OfSurface,
                                           place.zeroHeight() - site.heightShift, ground);
            if (std::isfinite(height) && !bands.ours()) {
                evidence.looked.push_back({j, i});
            }
            if (height > 0.0) {
                evidence.seen.cells.push_back({j, i});
                evidence.seen.heights.push_back(static_cast<float>(height));
            }
        }
    }
    if (evidence.seen.cells.empty()) {
        refuse({"evidence.no_debris", "{0} shows no debris: no cell of {1} is higher than the ground", {path, {cell, "m"}}},
               "Check what its heights are measured from: height= is above the ground, surface= in the heights of the case.");
    }
    return evidence;
}

}  // namespace rubble::io
