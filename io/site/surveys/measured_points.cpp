#include "io/site/surveys/measured_points.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/evidence/surveys/edge_rings.h"
#include "core/scenario/scope_cover.h"
#include "io/base/drawing_unit.h"
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

/// Points and corners of lines of a drawing, in metres.
class DrawnPoints {
public:
    /// @param unit  m, in which the drawing counts
    explicit DrawnPoints(double unit) : m_unit(unit) {}

    std::vector<Vec3> places;              ///< of all of them
    std::vector<std::vector<Vec3>> lines;  ///< of more than one corner
    std::vector<Vec3> alone;               ///< points

    void add(const OGRGeometry& shape) {
        const OGRwkbGeometryType type = wkbFlatten(shape.getGeometryType());
        if (type == wkbPoint) {
            const OGRPoint& point = *shape.toPoint();
            alone.push_back(placeOf(point));
            places.push_back(alone.back());
        } else if (type == wkbLineString) {
            addLine(*shape.toLineString());
        } else if (type == wkbPolygon) {
            for (const OGRLinearRing* ring : *shape.toPolygon()) {
                addLine(*ring);
            }
        } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
            for (const OGRGeometry* part : *shape.toGeometryCollection()) {
                add(*part);
            }
        }
    }

private:
    Vec3 placeOf(const OGRPoint& point) const { return m_unit * Vec3(point.getX(), point.getY(), point.getZ()); }
    void addLine(const OGRLineString& line) {
        std::vector<Vec3>& corners = lines.emplace_back();
        for (const OGRPoint& point : line) {
            corners.push_back(placeOf(point));
        }
        places.insert(places.end(), corners.begin(), corners.end());
    }

    double m_unit;
};

/// @return  unset: the file is no drawing
std::optional<DrawnPoints> drawnPoints(const std::string& path, Findings& findings, const Execution& execution) {
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::FromHandle(
        GDALOpenEx(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drawingFormats.data(), nullptr, nullptr)));
    if (!file || file->GetLayerCount() < 1) {
        return std::nullopt;
    }
    DrawnPoints drawn(drawingUnit(path, findings));
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
    return drawn;
}

void tellDrawing(const MeasuredRequest& request, Findings& findings) {
    if (!request.frame.crs.empty()) {
        addFinding(findings, request.path,
                   {"measured.unplaced", "a DXF names no coordinate system; it is taken to be that of the case", {}},
                   "make sure that both are in the same one");
    }
}

/// Numbers of a drawing in the local frame.
void bringToCase(const MeasuredRequest& request, std::vector<Vec3>& places) {
    const SitePlace place(request.frame, request.site);
    const Vec3 lift(0.0, 0.0, request.site.heightShift);
    std::transform(places.begin(), places.end(), places.begin(), [&](const Vec3& at) { return place.toLocal(at + lift); });
}

std::vector<Vec3> drawingPoints(const MeasuredRequest& request, std::vector<Vec3> places, Findings& findings) {
    const auto level = std::count_if(places.begin(), places.end(), [](const Vec3& place) { return place.z() == 0.0; });
    if (level > 0 && level < static_cast<std::ptrdiff_t>(places.size())) {
        addFinding(findings, request.path,
                   {"measured.level", "points of the drawing lie at height 0 while others have heights; they were left out", {}},
                   "give them their heights if they belong to the section", level);
        std::erase_if(places, [](const Vec3& place) { return place.z() == 0.0; });
    }
    tellDrawing(request, findings);
    bringToCase(request, places);
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

OutlineRing planOf(const std::vector<Vec3>& places) {
    OutlineRing plan;
    plan.reserve(places.size());
    for (const Vec3& at : places) {
        plan.push_back(at.head<2>());
    }
    return plan;
}

/// Lines of a drawing, or its points as one; of a table its rows.
std::vector<OutlineRing> edgeLines(const MeasuredRequest& request, Findings& findings, const Execution& execution) {
    std::optional<DrawnPoints> drawn = drawnPoints(request.path, findings, execution);
    if (!drawn) {
        return {planOf(cloudPoints(request, findings, execution))};
    }
    tellDrawing(request, findings);
    if (drawn->lines.empty()) {
        drawn->lines.push_back(std::move(drawn->alone));
    } else if (!drawn->alone.empty()) {
        addFinding(
            findings, request.path,
            {"measured.points_beside", "points beside the lines of the drawing are no part of its edge; they were left out", {}},
            "draw the line through them if they are", static_cast<std::int64_t>(drawn->alone.size()));
    }
    std::vector<OutlineRing> lines;
    for (std::vector<Vec3>& line : drawn->lines) {
        bringToCase(request, line);
        lines.push_back(planOf(line));
    }
    return lines;
}

void tellRings(const std::string& path, const EdgeRings& made, Findings& findings) {
    if (made.closed > 0) {
        addFinding(findings, path,
                   {"measured.closed",
                    "the measured edge is open; it was closed by straight lines, the longest over {0}",
                    {{made.longest, "m"}}},
                   "measure the edge all around, or see that the debris ends there", static_cast<std::int64_t>(made.closed));
    }
    if (made.leftOut > 0) {
        addFinding(findings, path,
                   {"measured.short_lines", "lines of fewer than three corners that meet no other were left out of the edge", {}},
                   "join them to the others, within 5 cm, if they belong to it", static_cast<std::int64_t>(made.leftOut));
    }
}

}  // namespace

std::vector<Vec3> readMeasuredPoints(const MeasuredRequest& request, Findings& findings, const Execution& execution) {
    std::optional<DrawnPoints> drawn = drawnPoints(request.path, findings, execution);
    std::vector<Vec3> places =
        drawn ? drawingPoints(request, std::move(drawn->places), findings) : cloudPoints(request, findings, execution);
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

Outline readMeasuredEdge(const MeasuredRequest& request, Findings& findings, const Execution& execution) {
    const EdgeRings made = joinedRings(edgeLines(request, findings, execution), edgeReach);
    if (made.rings.empty()) {
        refuseContent(
            {"measured.no_edge", "{0} has fewer than three places one after another: they enclose nothing", {request.path}},
            "Give the places along the edge of the debris in their order, or hold them for sections.");
    }
    Outline outline;
    for (const OutlineRing& ring : made.rings) {
        execution.check();
        if (ring.size() > edgeCornersMost) {
            refuseContent({"measured.long_edge", "The edge of {0} has more than {1} corners", {request.path, edgeCornersMost}},
                          "Thin it, or give it as polygons.");
        }
        if (crossesItself(ring)) {
            refuseContent(
                {"measured.crossed", "The edge of {0} crosses itself: its places do not follow each other", {request.path}},
                "Sort them along the edge of the debris, or hold them for sections.");
        }
        outline.polygons.push_back({ring});
    }
    tellRings(request.path, made, findings);
    return outline;
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
