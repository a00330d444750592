#include "io/site/outline_file.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "io/base/drawing_unit.h"
#include "io/base/file_words.h"
#include "io/site/gdal_session.h"
#include "io/site/site_place.h"
#include "io/site/system_way.h"

namespace rubble::io {

namespace {

/// Formats of one local file (a Shapefile has others beside it).
constexpr std::array<const char*, 7> outlineFormats{"GPKG", "GeoJSON", "ESRI Shapefile", "FlatGeobuf", "KML", "DXF", nullptr};
constexpr std::size_t cornersMax = 2'000'000;
/// m. No site reaches as far from the zero of its frame.
constexpr double reachMax = 1e8;
const Eigen::Vector2d unknownPlace = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());

/// Reads the polygons of one file.
class PolygonReading {
public:
    PolygonReading(const std::string& path, const Frame& frame, const Site& site, bool withFallen, const Execution& execution)
        : m_path(path), m_crs(frame.crs), m_place(frame, site), m_withFallen(withFallen), m_execution(execution) {}

    OutlineReading read(GDALDataset& file) {
        m_drawing = file.GetDriver() != nullptr && std::string_view(file.GetDriver()->GetDescription()) == "DXF";
        m_drawingUnit = m_drawing ? drawingUnit(m_path, m_result.findings) : 1.0;
        for (OGRLayer* layer : layersOf(file)) {
            readLayer(*layer);
        }
        if (m_result.outline.polygons.empty()) {
            refuseContent({"survey.no_polygon", "{0} holds no polygon", {m_path}},
                          "Give the outline of the debris as one or more polygons.");
        }
        conclude();
        return std::move(m_result);
    }

private:
    std::vector<OGRLayer*> layersOf(GDALDataset& file) {
        if (OGRLayer* ours = file.GetLayerByName("footprint")) {
            m_ours = true;
            return {ours};
        }
        std::vector<OGRLayer*> layers;
        for (int l = 0; l < file.GetLayerCount(); ++l) {
            layers.push_back(file.GetLayer(l));
        }
        return layers;
    }

    void readLayer(OGRLayer& layer) {
        findWay(layer);
        layer.ResetReading();
        while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
            m_execution.check();
            const OGRGeometry* shape = feature->GetGeometryRef();
            // What our own maps call live structure is a layer of its own there as well.
            const int of = feature->GetFieldIndex("of");
            const std::string_view what = of >= 0 ? feature->GetFieldAsString(of) : "";
            const bool fallen = what == "live structure";
            m_result.debrisMap = m_result.debrisMap || (m_ours && (fallen || what == "fragments"));
            m_result.fallen += fallen ? 1 : 0;
            if (shape != nullptr && (m_withFallen || !fallen)) {
                add(*shape);
            }
        }
    }

    /// Between the system of a layer and that of the case.
    void findWay(OGRLayer& layer) {
        const OGRSpatialReference* system = layer.GetSpatialRef();
        m_way.reset();
        m_unit = m_drawingUnit;
        m_degrees = false;
        if (system == nullptr || system->IsEmpty()) {
            m_unplaced = true;
            return;
        }
        m_result.crs = system->GetName() != nullptr ? system->GetName() : "unnamed";
        if (!system->IsGeographic() || !m_crs.empty()) {
            OGREnvelope box;
            const bool known = layer.GetExtent(&box) == OGRERR_NONE;
            const Eigen::Vector2d middle(0.5 * (box.MinX + box.MaxX), 0.5 * (box.MinY + box.MaxY));
            addWayFindings(m_result.findings, m_path, system, m_crs, degreesOf(*system, known ? middle : unknownPlace));
        }
        OGRSpatialReference other;
        const bool known = setFromText(other, m_crs);
        if (!known || system->IsLocal()) {
            m_degrees = system->IsGeographic();
            m_unplaced = m_unplaced || system->IsLocal();
            m_unit = m_degrees ? 1.0 : system->GetLinearUnits();
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
            refuseContent({"survey.no_way", "There is no way from the system of {0} to that of the case", {m_path}},
                          "Project the outline to the system of the case first.");
        }
        m_projected = m_projected || own.IsSame(&other) == FALSE;
    }

    void add(const OGRGeometry& shape) {
        const OGRwkbGeometryType type = wkbFlatten(shape.getGeometryType());
        if (type == wkbPolygon) {
            OutlinePolygon polygon;
            for (const OGRLinearRing* ring : *shape.toPolygon()) {
                addRing(*ring, polygon);
            }
            if (!polygon.empty()) {
                m_result.outline.polygons.push_back(std::move(polygon));
            }
        } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
            for (const OGRGeometry* part : *shape.toGeometryCollection()) {
                add(*part);
            }
        } else if (type == wkbCurvePolygon) {
            const std::unique_ptr<OGRGeometry> straight(shape.getLinearGeometry());
            add(*straight);
        } else if (m_drawing && type == wkbLineString && shape.toLineString()->get_IsClosed() != 0) {
            // A drawing has no polygons: a closed line is the edge of one.
            OutlinePolygon polygon;
            addRing(*shape.toLineString(), polygon);
            if (!polygon.empty()) {
                m_result.outline.polygons.push_back(std::move(polygon));
                ++m_closed;
            }
        } else {
            ++m_others;
        }
    }

    void addRing(const OGRLineString& ring, OutlinePolygon& polygon) {
        OutlineRing corners;
        m_corners += static_cast<std::size_t>(ring.getNumPoints());
        if (m_corners > cornersMax) {
            refuseContent({"survey.too_many", "{0} has more than {1} corners", {m_path, cornersMax}}, "Simplify the outline.");
        }
        for (int p = 0; p < ring.getNumPoints(); ++p) {
            corners.push_back(localOf(ring.getX(p), ring.getY(p)));
        }
        if (corners.size() > 1 && corners.front() == corners.back()) {
            corners.pop_back();
        }
        if (corners.size() >= 3) {
            polygon.push_back(std::move(corners));
        }
    }

    Eigen::Vector2d localOf(double x, double y) {
        if (m_degrees && std::abs(x) <= 360.0 && std::abs(y) <= 90.0) {
            refuseContent({"survey.degrees", "{0} lies in degrees, and the case does not say where on Earth it is", {m_path}},
                          "Give the case the coordinate system of its site, such as EPSG:25832.");
        }
        m_noDegrees = m_noDegrees || m_degrees;
        const bool placed = !m_way || m_way->Transform(1, &x, &y) != FALSE;
        const Eigen::Vector2d local = m_place.toLocal(Vec3(x * m_unit, y * m_unit, 0.0)).head<2>();
        if (!placed || !local.allFinite() || local.cwiseAbs().maxCoeff() > reachMax) {
            refuseContent({"survey.corner", "{0} has a corner without a place in the system of the case", {m_path}},
                          "Check the coordinate systems of the outline and of the case.");
        }
        return local;
    }

    void conclude() {
        if (m_result.fallen > 0 && !m_withFallen) {
            find({"survey.live", "{0} outlines of live structure in the file were left out", {m_result.fallen}},
                 "remove the attribute \"of\" where they belong to the debris", m_result.fallen);
        }
        if (m_closed > 0) {
            find({"survey.closed_lines", "closed lines of the drawing were taken as edges of polygons", {}},
                 "leave out layers whose lines are none", m_closed);
        }
        if (m_others > 0) {
            find({"survey.other_shapes", "{0} points or lines in the file were left out", {m_others}},
                 "give outlines as polygons if they belong to the debris", m_others);
        }
        if (m_projected) {
            find({"survey.projected", "the outline was projected from \"{0}\" to the system of the case", {m_result.crs}},
                 "none is needed");
        }
        if (m_noDegrees) {
            find({"survey.no_degrees", "the outline says that it lies in degrees, but cannot; it is taken as metres", {}},
                 "write the outline with the system that its coordinates are of");
        } else if (m_unplaced && !m_crs.empty()) {
            find({"survey.unplaced", "the outline names no coordinate system; it is taken to be that of the case", {}},
                 "make sure that both are in the same one");
        }
    }

    void find(Message what, std::string_view remedy, std::int64_t count = 1) {
        addFinding(m_result.findings, m_path, std::move(what), remedy, count);
    }

    const std::string& m_path;
    const std::string& m_crs;
    SitePlace m_place;
    bool m_withFallen;
    const Execution& m_execution;
    std::unique_ptr<OGRCoordinateTransformation> m_way;
    double m_unit = 1.0;
    bool m_degrees = false;    ///< of the layer, in a case without a system
    bool m_noDegrees = false;  ///< the file says so of coordinates that are none
    bool m_unplaced = false;   ///< a layer names no system
    bool m_projected = false;
    std::size_t m_corners = 0;
    bool m_ours = false;         ///< the layer is named as in maps of our own
    bool m_drawing = false;      ///< a DXF
    double m_drawingUnit = 1.0;  ///< m, in which it counts
    std::int64_t m_closed = 0;   ///< closed lines of a drawing
    std::int64_t m_others = 0;   ///< shapes that are no polygons
    OutlineReading m_result;
};

/// Null: the file is of none of the formats, or has no layer.
GDALDatasetUniquePtr openedOutline(const std::string& path) {
    GDALDatasetUniquePtr file(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, outlineFormats.data(), nullptr, nullptr)));
    return file && file->GetLayerCount() > 0 ? std::move(file) : nullptr;
}

}  // namespace

bool holdsOutline(const std::string& path) {
    const GdalSession session;
    return openedOutline(path) != nullptr;
}

std::optional<OutlineReading> readOutline(const std::string& path, const Frame& frame, const Site& site, bool withFallen,
                                          const Execution& execution) {
    const GdalSession session;
    const GDALDatasetUniquePtr file = openedOutline(path);
    if (!file) {
        return std::nullopt;
    }
    return PolygonReading(path, frame, site, withFallen, execution).read(*file);
}

}  // namespace rubble::io
