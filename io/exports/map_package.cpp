#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>

#include "core/analysis/debris/box_outline.h"
#include "core/evidence/maps/footprint.h"
#include "core/evidence/maps/height_contours.h"
#include "io/base/files.h"
#include "io/exports/exports.h"
#include "io/exports/map_files.h"
#include "io/site/gdal_memory.h"
#include "io/site/gdal_session.h"
#include "io/site/map_place.h"

namespace rubble::io {

namespace {

struct Field {
    const char* name;
    OGRFieldType type;
};

/// A layer under construction: features are added one by one.
class PackageLayer {
public:
    PackageLayer(GDALDataset& file, const MapPlace& place, const char* name, OGRwkbGeometryType type, std::span<const Field> fields,
                 const std::string& path)
        : m_path(path) {
        m_layer = file.CreateLayer(name, const_cast<OGRSpatialReference*>(&place.system()), type, nullptr);
        if (m_layer == nullptr) {
            failGdal(path);
        }
        for (const Field& field : fields) {
            OGRFieldDefn definition(field.name, field.type);
            if (m_layer->CreateField(&definition) != OGRERR_NONE) {
                failGdal(path);
            }
        }
    }

    /// @param set  gives the fields; unknown numbers stay unset
    template <class Set>
    void add(const OGRGeometry& geometry, Set set) {
        OGRFeature feature(m_layer->GetLayerDefn());
        feature.SetGeometry(&geometry);
        set(feature);
        if (m_layer->CreateFeature(&feature) != OGRERR_NONE) {
            failGdal(m_path);
        }
    }

private:
    std::string m_path;
    OGRLayer* m_layer = nullptr;
};

void setNumber(OGRFeature& feature, const char* name, double value) {
    if (std::isfinite(value)) {
        feature.SetField(name, value);
    }
}

void addPoint(OGRLineString& line, const MapPlace& place, const Eigen::Vector2d& local) {
    const Eigen::Vector2d at = place(local);
    line.addPoint(at.x(), at.y());
}

void addRing(OGRPolygon& polygon, const MapPlace& place, const FootprintRing& ring, double cell) {
    OGRLinearRing line;
    for (const MapCell& corner : ring) {
        addPoint(line, place, cell * Eigen::Vector2d(corner.i, corner.j));
    }
    line.closeRings();
    polygon.addRing(&line);
}

/// The cells that a layer has a value for.
std::vector<MapCell> coveredCells(const DebrisMap& map, MapLayer layer) {
    std::vector<MapCell> cells;
    for (std::size_t c = 0; c < map.layer(layer).size(); ++c) {
        if (!std::isnan(map.layer(layer)[c])) {
            cells.push_back(map.cells[c]);
        }
    }
    return cells;
}

void writeFootprint(GDALDataset& file, const MapPlace& place, const DebrisMap& map, const std::string& path) {
    static constexpr std::array<Field, 2> fields{{{"of", OFTString}, {"area_m2", OFTReal}}};
    PackageLayer layer(file, place, "footprint", wkbPolygon, fields, path);
    const auto add = [&](MapLayer of, const char* name) {
        for (const FootprintPolygon& part : footprintOf(coveredCells(map, of))) {
            OGRPolygon polygon;
            addRing(polygon, place, part.outer, map.cell);
            double area = signedArea(part.outer);
            for (const FootprintRing& hole : part.holes) {
                addRing(polygon, place, hole, map.cell);
                area += signedArea(hole);
            }
            layer.add(polygon, [&](OGRFeature& feature) {
                feature.SetField("of", name);
                feature.SetField("area_m2", area * map.cell * map.cell);
            });
        }
    };
    add(MapLayer::Mass, "fragments");
    add(MapLayer::LiveMass, "live structure");
}

void writeContours(GDALDataset& file, const MapPlace& place, const DebrisMap& map, double spacing, const std::string& path) {
    static constexpr std::array<Field, 1> fields{{{"height_m", OFTReal}}};
    PackageLayer layer(file, place, "contours", wkbLineString, fields, path);
    for (const HeightContour& contour : heightContours(map.cells, map.layer(MapLayer::Height), map.cell, spacing)) {
        OGRLineString line;
        for (const Eigen::Vector2d& corner : contour.corners) {
            addPoint(line, place, corner);
        }
        addPoint(line, place, contour.corners.front());
        layer.add(line, [&](OGRFeature& feature) { feature.SetField("height_m", contour.level); });
    }
}

constexpr double leastSide = 1e-3;  ///< m, of what has no outline: a layer holds shapes of one kind

/// The outline of a box, or a tiny square about its centre where it has none.
OGRPolygon outlineShape(const MapPlace& place, const DebrisFragment& lies) {
    SmallPolygon outline = outlineOf(lies.box);
    if (!(outline.area() > 0.0)) {
        const Eigen::Vector2d at = lies.centre.head<2>();
        const double half = 0.5 * leastSide;
        outline.size = 0;
        for (const auto& [x, y] :
             {std::pair(-half, -half), std::pair(half, -half), std::pair(half, half), std::pair(-half, half)}) {
            outline.add(at + Eigen::Vector2d(x, y));
        }
    }
    OGRPolygon polygon;
    OGRLinearRing ring;
    for (std::size_t k = 0; k < outline.size; ++k) {
        addPoint(ring, place, outline.corners[k]);
    }
    ring.closeRings();
    polygon.addRing(&ring);
    return polygon;
}

void writeFragments(GDALDataset& file, const MapPlace& place, const DebrisMap& map, const MapFragments& fragments,
                    const std::string& path, const Execution& execution) {
    static constexpr std::array<Field, 10> fields{{{"fragment_id", OFTInteger64},
                                                   {"element_id", OFTInteger64},
                                                   {"component", OFTString},
                                                   {"mass_kg", OFTReal},
                                                   {"volume_m3", OFTReal},
                                                   {"centre_z_m", OFTReal},
                                                   {"top_z_m", OFTReal},
                                                   {"birth_time_s", OFTReal},
                                                   {"arrival_s", OFTReal},
                                                   {"impact_energy_j", OFTReal}}};
    PackageLayer layer(file, place, "fragments", wkbPolygon, fields, path);
    const std::size_t count = fragments.set->size();
    for (std::size_t f = 0; f < count; ++f) {
        if (f % 1024 == 0) {
            execution.check();
        }
        const DebrisFragment& lies = fragments.debris->fragments[f];
        if (!lies.present) {
            continue;
        }
        const Fragment& fragment = fragments.set->list[f];
        layer.add(outlineShape(place, lies), [&](OGRFeature& feature) {
            feature.SetField("fragment_id", static_cast<GIntBig>(f));
            if (f < fragments.elementIds.size()) {
                feature.SetField("element_id", static_cast<GIntBig>(fragments.elementIds[f]));
            }
            if (at(fragment.component) < map.components.size()) {
                feature.SetField("component", map.components[at(fragment.component)].c_str());
            }
            setNumber(feature, "mass_kg", lies.mass);
            setNumber(feature, "volume_m3", lies.volume);
            setNumber(feature, "centre_z_m", lies.centre.z() + place.zeroHeight());
            setNumber(feature, "top_z_m", BoxTop(lies.box).highest() + place.zeroHeight());
            setNumber(feature, "birth_time_s", fragment.birthTime);
            setNumber(feature, "arrival_s", fragments.arrivals[f]);
            setNumber(feature, "impact_energy_j", fragments.energies.empty() ? NAN : fragments.energies[f]);
        });
    }
}

/// Files say when they were written; the same map gives the same bytes all the same.
class NoDate {
public:
    NoDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z"); }
    ~NoDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }
    NoDate(const NoDate&) = delete;
    NoDate& operator=(const NoDate&) = delete;
};

}  // namespace

void writeMapPackage(const std::string& path, const DebrisMap& map, const MapFragments& fragments, double contourSpacing,
                     const MapOrigin& origin, const Execution& execution) {
    const Message stage{"io.export.map", "Writing {0}", {path}};
    execution.report(stage, 0.0);
    const MapPlace place(origin.frame, origin.site);
    const GdalMemoryFile memory(".gpkg");
    {
        const GdalSession session;
        const NoDate noDate;
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
        GDALDatasetUniquePtr file(driver == nullptr ? nullptr
                                                    : driver->Create(memory.name().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
        if (!file) {
            failGdal(path);
        }
        // One transaction: each feature in its own takes a hundred times longer.
        file->StartTransaction();
        for (const auto& [key, value] : origin.facts) {
            file->SetMetadataItem(key.c_str(), value.c_str());
        }
        writeFootprint(*file, place, map, path);
        writeContours(*file, place, map, contourSpacing, path);
        writeFragments(*file, place, map, fragments, path, execution);
        if (file->CommitTransaction() != OGRERR_NONE) {
            failGdal(path);
        }
    }
    memory.save(path);
    writeProvenance(path, withCoordinates(origin.provenance, place.words()));
    execution.report(stage, 1.0);
}

}  // namespace rubble::io
