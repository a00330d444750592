#include "io/geo/survey_file.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "core/base/error.h"
#include "io/files.h"
#include "io/geo/gdal_memory.h"
#include "io/terrain/height_reading.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

/// Formats of one local file (a Shapefile has others beside it).
constexpr std::array<const char*, 6> formats{"GPKG", "GeoJSON", "ESRI Shapefile", "FlatGeobuf", "KML", nullptr};
constexpr std::size_t cornersMax = 2'000'000;

struct CloseDataset {
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

/// Reads the polygons of one file.
class FootprintReading {
public:
    FootprintReading(SurveyInput& input, const Frame& frame, const Site& site)
        : m_input(input), m_crs(frame.crs), m_place(frame, site) {}

    void read(GDALDataset& file) {
        std::vector<OGRLayer*> layers;
        for (int l = 0; l < file.GetLayerCount(); ++l) {
            OGRLayer* layer = file.GetLayer(l);
            if (std::string(layer->GetName()) == "footprint") {
                layers.assign(1, layer);
                break;
            }
            layers.push_back(layer);
        }
        for (OGRLayer* layer : layers) {
            read(*layer);
        }
        if (m_input.survey.footprint.rings.empty()) {
            throw ParseError({"survey.no_polygon", "{0} holds no polygon", {m_input.path}},
                             {"survey.no_polygon.remedy", "Give the outline of the debris as one or more polygons.", {}});
        }
    }

private:
    void read(OGRLayer& layer) {
        findWay(layer);
        layer.ResetReading();
        while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
            const OGRGeometry* shape = feature->GetGeometryRef();
            // What our own maps call live structure is a layer of its own there as well.
            const int of = feature->GetFieldIndex("of");
            if (of >= 0 && std::string(feature->GetFieldAsString(of)) == "live structure") {
                ++m_live;
                continue;
            }
            if (shape != nullptr) {
                add(*shape);
            }
        }
        if (m_live > 0) {
            m_input.survey.showsFallen = false;
            m_input.findings.add({"survey.live", "{0} outlines of live structure in the file were left out", {m_live}},
                                 {"survey.live.remedy", "remove the attribute \"of\" where they belong to the debris", {}},
                                 m_input.path, m_live);
        }
    }

    void findWay(OGRLayer& layer) {
        const OGRSpatialReference* system = layer.GetSpatialRef();
        m_way.reset();
        m_unit = 1.0;
        if (system == nullptr || system->IsEmpty()) {
            return;
        }
        m_input.crs = system->GetName() != nullptr ? system->GetName() : "unnamed";
        OGRSpatialReference other;
        const bool known =
            !m_crs.empty() &&
            other.SetFromUserInput(m_crs.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) == OGRERR_NONE;
        if (!known && system->IsGeographic()) {
            throw ParseError(
                {"survey.degrees", "{0} lies in degrees, and the case does not say where on Earth it is", {m_input.path}},
                {"survey.degrees.remedy", "Give the case the coordinate system of its site, such as EPSG:25832.", {}});
        }
        if (!known) {
            m_unit = system->GetLinearUnits();
            return;
        }
        OGRSpatialReference own(*system);
        own.StripVertical();
        other.StripVertical();
        own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        other.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        m_way.reset(OGRCreateCoordinateTransformation(&own, &other));
        m_unit = other.GetLinearUnits();
        if (!m_way) {
            throw ParseError({"survey.no_way", "There is no way from the system of {0} to that of the case", {m_input.path}},
                             {"survey.no_way.remedy", "Project the outline to the system of the case first.", {}});
        }
    }

    void add(const OGRGeometry& shape) {
        if (wkbFlatten(shape.getGeometryType()) == wkbPolygon) {
            for (const OGRLinearRing* ring : *shape.toPolygon()) {
                addRing(*ring);
            }
        } else if (OGR_GT_IsSubClassOf(wkbFlatten(shape.getGeometryType()), wkbGeometryCollection)) {
            for (const OGRGeometry* part : *shape.toGeometryCollection()) {
                add(*part);
            }
        } else if (wkbFlatten(shape.getGeometryType()) == wkbCurvePolygon) {
            const std::unique_ptr<OGRGeometry> straight(shape.getLinearGeometry());
            add(*straight);
        }
    }

    void addRing(const OGRLinearRing& ring) {
        std::vector<Eigen::Vector2d> corners;
        m_corners += static_cast<std::size_t>(ring.getNumPoints());
        if (m_corners > cornersMax) {
            throw ParseError({"survey.too_many", "{0} has more than {1} corners", {m_input.path, cornersMax}},
                             {"survey.too_many.remedy", "Simplify the outline.", {}});
        }
        for (int p = 0; p < ring.getNumPoints(); ++p) {
            double x = ring.getX(p);
            double y = ring.getY(p);
            if (m_way && m_way->Transform(1, &x, &y) == FALSE) {
                x = y = NAN;
            }
            const Vec3 local = m_place.toLocal(Vec3(x * m_unit, y * m_unit, 0.0));
            if (!local.allFinite()) {
                throw ParseError({"survey.corner", "{0} has a corner without a place in the system of the case", {m_input.path}},
                                 {"survey.corner.remedy", "Check the coordinate systems of the outline and of the case.", {}});
            }
            corners.emplace_back(local.head<2>());
        }
        if (corners.size() > 1 && corners.front() == corners.back()) {
            corners.pop_back();
        }
        if (corners.size() >= 3) {
            m_input.survey.footprint.rings.push_back(std::move(corners));
        }
    }

    SurveyInput& m_input;
    const std::string& m_crs;
    SitePlace m_place;
    std::unique_ptr<OGRCoordinateTransformation> m_way;
    double m_unit = 1.0;
    std::size_t m_corners = 0;
    std::int64_t m_live = 0;
};

/// Opened as polygons; null if it holds none.
Dataset openPolygons(const std::string& path) {
    Dataset file(
        GDALDataset::FromHandle(GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, formats.data(), nullptr, nullptr)));
    return file && file->GetLayerCount() > 0 ? std::move(file) : nullptr;
}

}  // namespace

SurveyInput readSurvey(const std::string& path, const Frame& frame, const Site& site, const Aabb& around,
                       const Execution& execution) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) == 0) {
        throw WorldError({"survey.missing", "There is no survey {0}, or it is empty", {path}},
                         {"survey.missing.remedy", "Check the path, or copy the file again.", {}});
    }
    execution.check();
    SurveyInput input;
    input.path = path;
    input.frame = frame;
    input.site = site;
    input.survey.name = fs::path(path).filename().string();
    {
        const GdalCalls calls;
        if (const Dataset polygons = openPolygons(path)) {
            input.survey.isFootprint = true;
            FootprintReading(input, frame, site).read(*polygons);
        }
    }
    if (!input.survey.isFootprint) {
        HeightReading heights = readHeights(path, frame, site, around, execution);
        HeightRaster& raster = heights.raster;
        input.survey.heights = {raster.x0, raster.y0, raster.dx, raster.dy, raster.nx, raster.ny, std::move(raster.heights)};
        if (heights.debrisMap) {
            // What has no height there is ground without debris.
            std::replace_if(
                input.survey.heights.heights.begin(), input.survey.heights.heights.end(),
                [](double height) { return std::isnan(height); }, 0.0);
            input.survey.heights.aboveGround = true;
            input.survey.showsFallen = false;
            heights.findings.add({"survey.debris_map", "the survey is a debris map: its heights are taken above the ground", {}},
                                 {"survey.debris_map.remedy", "none is needed; the comparison is between two simulations", {}},
                                 path);
        }
        input.crs = heights.crs;
        input.findings = std::move(heights.findings);
    }
    input.sha256 = sha256OfFile(path);
    return input;
}

}  // namespace rubble::io
