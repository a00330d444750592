#include "io/fe/meshes/raw_mesh.h"

#include <algorithm>
#include <cmath>

#include "io/base/file_words.h"
#include "io/fe/meshes/polygon_cut.h"

namespace rubble::io {

namespace {

constexpr std::size_t cornersMax = 4 * meshTrianglesMax;
/// Coordinates beyond this are no places on Earth, and their squares leave no digits.
constexpr double coordinateMax = 1e9;

}  // namespace

void MeshGathering::addPoint(const Vec3& point, std::uint64_t line) {
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > coordinateMax) {
        const std::string_view remedy = "Export the mesh anew; each coordinate must be a number in metres.";
        if (line > 0) {
            refuseContent({"surroundings.no_coordinate",
                           "{0}, line {1}: a coordinate is no number of metres",
                           {m_path, static_cast<std::int64_t>(line)}},
                          remedy);
        }
        refuseContent({"surroundings.no_place",
                       "{0}: a coordinate of point {1} is no number of metres",
                       {m_path, static_cast<std::int64_t>(points() + 1)}},
                      remedy);
    }
    if (points() >= meshPointsMax) {
        refuseContent({"surroundings.too_many_points", "{0} has more than {1} points", {m_path, meshPointsMax}},
                      "Make the mesh simpler, or cut it to the site.");
    }
    m_mesh.points.push_back(point);
}

void MeshGathering::addFace(std::span<const std::int64_t> corners, std::uint64_t line) {
    if (corners.size() < 3) {
        ++m_others;
        return;
    }
    if (corners.size() > polygonCornersMax) {
        refuseContent({"surroundings.large_face",
                       "{0}: face {1} has {2} corners; at most {3} are read",
                       {m_path, m_faces.size() + 1, corners.size(), polygonCornersMax}},
                      "Cut large faces into triangles before the mesh is exported.");
    }
    m_triangles += corners.size() - 2;
    if (m_triangles > meshTrianglesMax || m_corners.size() + corners.size() > cornersMax) {
        refuseContent({"surroundings.too_many", "{0} has more than {1} triangles", {m_path, meshTrianglesMax}},
                      "Make the mesh simpler, or cut it to the site.");
    }
    for (const std::int64_t corner : corners) {
        const bool possible = corner >= 0 && corner < static_cast<std::int64_t>(noPoint);
        m_corners.push_back(possible ? static_cast<std::uint32_t>(corner) : noPoint);
    }
    m_faces.push_back({static_cast<std::uint32_t>(m_corners.size()),
                       static_cast<std::uint32_t>(std::min<std::uint64_t>(line, std::numeric_limits<std::uint32_t>::max()))});
}

void MeshGathering::find(Message what, std::string_view remedy, std::int64_t count) {
    if (count > 0) {
        addFinding(m_mesh.findings, m_path, std::move(what), remedy, count);
    }
}

void MeshGathering::cut(const Execution& execution) {
    std::int64_t missing = 0;
    std::int64_t crossing = 0;
    std::size_t firstMissing = 0;
    std::size_t firstCrossing = 0;
    std::size_t begin = 0;
    for (std::size_t f = 0; f < m_faces.size(); ++f) {
        if (f % 4096 == 0) {
            execution.check();
        }
        const std::span<const std::uint32_t> corners(&m_corners[begin], m_faces[f].end - begin);
        begin = m_faces[f].end;
        const bool there = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t c) { return c < points(); });
        if (!there) {
            firstMissing = ++missing == 1 ? f : firstMissing;
        } else if (!cutPolygon(m_mesh.points, corners, m_mesh.triangles)) {
            firstCrossing = ++crossing == 1 ? f : firstCrossing;
        }
    }
    // Of a text the line says more than the number of the face.
    const auto line = [&](std::size_t f) { return static_cast<std::int64_t>(m_faces[f].line); };
    if (missing > 0 && line(firstMissing) > 0) {
        find({"surroundings.missing_corners_in_line",
              "{0} faces of the mesh name points that are not there, the first in line {1}; they were left out",
              {missing, line(firstMissing)}},
             "export the mesh anew; something of it is missing", missing);
    } else {
        find({"surroundings.missing_corners",
              "{0} faces of the mesh name points that are not there, the first is face {1}; they were left out",
              {missing, firstMissing + 1}},
             "export the mesh anew; something of it is missing", missing);
    }
    find({"surroundings.crossing",
          "{0} faces of the mesh cross themselves, the first is face {1}; their triangles may not cover what was meant",
          {crossing, firstCrossing + 1}},
         "cut these faces into triangles before the mesh is exported", crossing);
}

RawMesh MeshGathering::finish(const Execution& execution) && {
    if (m_faces.empty()) {
        refuseContent({"surroundings.no_faces", "{0} holds no faces, only {1} points", {m_path, points()}},
                      "Give a mesh with faces; a cloud of points has no surface.");
    }
    m_mesh.triangles.reserve(m_triangles);
    cut(execution);
    if (m_mesh.triangles.empty()) {
        refuseContent({"surroundings.no_area", "{0}: none of its {1} faces has an area", {m_path, m_faces.size()}},
                      "Export the mesh anew; its faces must have corners apart from each other.");
    }
    find({"surroundings.other_shapes", "{0} points and lines of the mesh were left out; they have no surface", {m_others}},
         "none is needed if they are marks; else export them as faces", m_others);
    find({"surroundings.curved", "{0} curved shapes of the mesh were left out; only polygons are read", {m_curved}},
         "turn curves and free-form surfaces into polygons before the mesh is exported", m_curved);
    return std::move(m_mesh);
}

double stepOfText(std::string_view text, double value) {
    const std::size_t exponent = text.find_first_of("eE");
    if (exponent == std::string_view::npos || value == 0.0) {
        return 0.0;
    }
    std::string_view digits = text.substr(0, exponent);
    const std::size_t first = digits.find_first_of("123456789");
    digits = first == std::string_view::npos ? std::string_view() : digits.substr(first);
    const auto count = std::count_if(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
    return std::pow(10.0, std::floor(std::log10(std::abs(value)) + 1e-12) + 1.0 - static_cast<double>(count));
}

double stepOfFloat(double value) {
    return std::abs(value) * std::ldexp(1.0, -24);
}

}  // namespace rubble::io
