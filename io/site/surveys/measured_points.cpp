#include "io/site/surveys/measured_points.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/scenario/scope_cover.h"
#include "io/base/file_words.h"
#include "io/base/files.h"
#include "io/site/clouds/cloud_comparison.h"
#include "io/site/clouds/cloud_place.h"
#include "io/site/clouds/cloud_summary.h"
#include "io/site/gdal_session.h"
#include "io/site/outline_file.h"
#include "io/site/surveys/named_points.h"

namespace rubble::io {

namespace {

constexpr std::array<const char*, 2> drawingFormats{"DXF", nullptr};

[[noreturn]] void refuseMany(const std::string& path) {
    refuseContent({"measured.many", "{0} has more than {1} points", {path, measuredMost}}, "Thin it, or cut out what is needed.");
}

/// Points and corners of lines of a drawing, in its numbers.
class DrawnPoints {
public:
    std::vector<Vec3> places;

    void add(const OGRGeometry& shape) {
        const OGRwkbGeometryType type = wkbFlatten(shape.getGeometryType());
        if (type == wkbPoint) {
            const OGRPoint& point = *shape.toPoint();
            places.emplace_back(point.getX(), point.getY(), point.getZ());
        } else if (type == wkbLineString) {
            for (const OGRPoint& point : *shape.toLineString()) {
                places.emplace_back(point.getX(), point.getY(), point.getZ());
            }
        } else if (type == wkbPolygon) {
            for (const OGRLinearRing* ring : *shape.toPolygon()) {
                for (const OGRPoint& point : *ring) {
                    places.emplace_back(point.getX(), point.getY(), point.getZ());
                }
            }
        } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
            for (const OGRGeometry* part : *shape.toGeometryCollection()) {
                add(*part);
            }
        }
    }
};

/// @return  unset: the file is no drawing
std::optional<std::vector<Vec3>> drawnPoints(const std::string& path, const Execution& execution) {
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drawingFormats.data(), nullptr, nullptr)));
    if (!file || file->GetLayerCount() < 1) {
        return std::nullopt;
    }
    DrawnPoints drawn;
    for (int l = 0; l < file->GetLayerCount(); ++l) {
        OGRLayer& layer = *file->GetLayer(l);
        layer.ResetReading();
        while (const OGRFeatureUniquePtr feature{layer.GetNextFeature()}) {
            execution.check();
            if (const OGRGeometry* shape = feature->GetGeometryRef()) {
                drawn.add(*shape);
            }
            if (drawn.places.size() > measuredMost) {
                refuseMany(path);
            }
        }
    }
    return std::move(drawn.places);
}

std::vector<Vec3> drawingPoints(const MeasuredRequest& request, std::vector<Vec3> places, Findings& findings) {
    const auto level = std::count_if(places.begin(), places.end(), [](const Vec3& place) { return place.z() == 0.0; });
    if (level > 0 && level < static_cast<std::ptrdiff_t>(places.size())) {
        addFinding(findings, request.path,
                   {"measured.level", "points of the drawing lie at height 0 while others have heights; they were left out", {}},
                   "give them their heights if they belong to the section", level);
        std::erase_if(places, [](const Vec3& place) { return place.z() == 0.0; });
    }
    if (!request.frame.crs.empty()) {
        addFinding(findings, request.path,
                   {"measured.unplaced", "a DXF names no coordinate system; it is taken to be that of the case, in metres", {}},
                   "make sure that both are in the same one");
    }
    const SitePlace place(request.frame, request.site);
    const Vec3 lift(0.0, 0.0, request.site.heightShift);
    std::transform(places.begin(), places.end(), places.begin(), [&](const Vec3& at) { return place.toLocal(at + lift); });
    return places;
}

std::vector<Vec3> cloudPoints(const MeasuredRequest& request, Findings& findings, const Execution& execution) {
    const std::unique_ptr<PointCloud> cloud = openCloud(request.path, request.read);
    const CloudPlace place(*cloud, request.frame, request.site, findings);
    std::vector<Vec3> all;
    std::vector<Vec3> places;
    std::int64_t plants = 0;
    const CloudSummary summary = summariseCloud(*cloud, execution, [&](const CloudBlock& block) {
        places = block.places;
        place.toLocal(places);
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!block.classes.empty() && isPlantOrWire(block.classes[i])) {
                ++plants;
            } else if (places[i].allFinite()) {
                all.push_back(places[i]);
            }
        }
        if (all.size() > measuredMost) {
            refuseMany(request.path);
        }
    });
    findings.append(summary.findings);
    if (plants > 0) {
        addFinding(findings, request.path, {"distance.plants", "points of vegetation and wires were left out", {}},
                   "none is needed", plants);
    }
    return all;
}

}  // namespace

std::vector<Vec3> readMeasuredPoints(const MeasuredRequest& request, Findings& findings, const Execution& execution) {
    std::optional<std::vector<Vec3>> drawn = drawnPoints(request.path, execution);
    std::vector<Vec3> places =
        drawn ? drawingPoints(request, std::move(*drawn), findings) : cloudPoints(request, findings, execution);
    if (places.empty()) {
        refuseContent({"measured.none", "{0} has no point that counts", {request.path}}, "Give points with heights.");
    }
    if (request.placed) {
        const Registration& placed = *request.placed;
        const Mat3 turn = placed.rotation();
        for (Vec3& at : places) {
            at = placed.about + placed.shift + turn * (at - placed.about);
        }
    }
    addBeyond(findings, request.path, std::erase_if(places, [&](const Vec3& at) { return !covers(request.scope, at.head<2>()); }));
    return places;
}

bool holdsMeasuredPoints(const std::string& path) {
    if (!hasEnding(path, ".dxf")) {
        return namesStationPoints(path);
    }
    try {
        readOutline(path, {}, {}, false, Execution());
    } catch (const ParseError& error) {
        return error.message().id == "survey.no_polygon";
    }
    return false;
}

}  // namespace rubble::io
