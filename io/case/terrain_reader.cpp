#include "io/case/terrain_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/fe/frame_transform.h"
#include "io/base/file_words.h"
#include "io/case/case_file.h"
#include "io/case/mesh_terrain.h"
#include "io/fe/meshes/ply_header.h"
#include "io/fe/meshes/raw_mesh_file.h"
#include "io/site/height_reading.h"
#include "io/site/input_files.h"
#include "io/site/site_place.h"

namespace rubble::io {

namespace {

void checkTerrain(const std::string& path) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        throw WorldError({"terrain.missing", "There is no terrain file {0}", {path}},
                         {"terrain.missing.remedy", "Check the path, or leave the terrain out.", {}});
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw WorldError({"terrain.no_file", "The terrain {0} is not a file", {path}},
                         {"terrain.no_file.remedy", "Give a raster in one file, such as a GeoTIFF.", {}});
    }
    if (std::filesystem::file_size(path, error) == 0) {
        throw ParseError({"terrain.empty", "The terrain {0} is empty", {path}},
                         {"terrain.empty.remedy", "Copy it again from where it came.", {}});
    }
}

/// Marks of the nodes of a raster at the nearest nodes of another.
std::vector<std::uint8_t> nearestOf(const std::vector<std::uint8_t>& marks, const HeightGrid& from, const HeightGrid& to) {
    const auto nearest = [](double place, double first, double step, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(std::round((place - first) / step), 0.0, static_cast<double>(count - 1)));
    };
    std::vector<std::uint8_t> taken;
    taken.reserve(to.nx * to.ny);
    for (std::size_t j = 0; j < to.ny; ++j) {
        const std::size_t row = nearest(to.y0 + to.dy * static_cast<double>(j), from.y0, from.dy, from.ny);
        for (std::size_t i = 0; i < to.nx; ++i) {
            taken.push_back(marks[row * from.nx + nearest(to.x0 + to.dx * static_cast<double>(i), from.x0, from.dx, from.nx)]);
        }
    }
    return taken;
}

/// Turns the heights of one file into a terrain.
class TerrainReading {
public:
    TerrainReading(const std::string& path, const Aabb& around, HeightReading heights, const Execution& execution)
        : m_path(path),
          m_around(around),
          m_execution(execution),
          m_raster(std::move(heights.raster)),
          m_wider(std::move(heights.wider)) {
        m_result.crs = std::move(heights.crs);
        m_result.verticalDatum = std::move(heights.verticalDatum);
        m_result.findings = std::move(heights.findings);
        if (heights.missing > 0.0) {
            find("terrain.short", "the terrain ends {0} short of the outline of the structure and goes on level from there",
                 {{heights.missing, "m"}}, "give a raster that covers the whole site");
        }
    }

    TerrainInput read();

private:
    void closeGaps();
    void closeWiderGaps();
    std::shared_ptr<const TerrainGrid> withSurroundings(HeightGrid window);
    void checkSite(const TerrainGrid& grid);
    void find(std::string id, std::string_view pattern, std::vector<Argument> arguments, std::string_view remedy,
              std::int64_t count = 1) {
        addFinding(m_result.findings, m_path, {std::move(id), std::string(pattern), std::move(arguments)}, remedy, count);
    }

    const std::string& m_path;
    const Aabb& m_around;
    const Execution& m_execution;
    HeightGrid m_raster;
    WiderHeights m_wider;
    std::vector<std::uint8_t> m_ended;  ///< [nodes of the wider raster, or of the window if there is none] outerGaps()
    TerrainInput m_result;
};

void TerrainReading::closeGaps() {
    const std::int64_t gaps = countGaps(m_raster);
    const auto all = static_cast<std::int64_t>(m_raster.heights.size());
    if (2 * gaps > all) {
        throw ParseError(
            {"terrain.gaps",
             gaps == all ? "{0} has no height at all around the structure ({1} of {2} have none)"
                         : "{0} has no height for {1} of {2} places around the structure",
             {m_path, gaps, all}},
            {"terrain.gaps.remedy", "Give a raster that covers the site, or fill its gaps with gdal_fillnodata.py.", {}});
    }
    if (gaps > 0) {
        find("terrain.filled", "{0} of {1} places of the terrain had no height and were filled from their neighbours", {gaps, all},
             "look at the terrain where the debris lies, or give a raster without gaps", gaps);
        fillGaps(m_raster);
    }
}

/// As for the window, but told in one: what lies out here matters to few.
void TerrainReading::closeWiderGaps() {
    HeightGrid& wider = m_wider.raster;
    removeSpikes(wider);
    m_ended = outerGaps(wider);
    std::int64_t mended = 0;
    for (std::size_t k = 0; k < wider.heights.size(); ++k) {
        const std::size_t i = k % wider.nx;
        const std::size_t j = k / wider.nx;
        const bool inWindow =
            i >= m_wider.column && i < m_wider.column + m_raster.nx && j >= m_wider.row && j < m_wider.row + m_raster.ny;
        mended += !inWindow && std::isnan(wider.heights[k]) && (m_ended.empty() || m_ended[k] == 0);
    }
    if (mended > 0) {
        find("terrain.wider_filled",
             "{0} places beyond the window about the structure had no height, or one that stands out, and were filled from their "
             "neighbours",
             {mended}, "look at the terrain if debris runs there", mended);
    }
    fillGaps(wider);
}

/// The window, and around it what else was read of the raster, on nodes that go on from those of the window.
std::shared_ptr<const TerrainGrid> TerrainReading::withSurroundings(HeightGrid window) {
    TerrainExtent extent;
    extent.x0 = window.x0;
    extent.y0 = window.y0;
    extent.columns = window.nx;
    extent.rows = window.ny;
    extent.unread = m_wider.unread;
    const HeightGrid& wider = m_wider.raster;
    if (wider.heights.empty()) {
        if (m_ended.size() == window.heights.size()) {
            extent.missing = std::move(m_ended);
        }
        return std::make_shared<const TerrainGrid>(std::move(window), std::move(extent));
    }
    const double cell = window.dx;
    const auto nodes = [cell](double metres) { return static_cast<std::size_t>(std::max(0.0, std::floor(metres / cell + 1e-6))); };
    const auto end = [](double first, double step, std::size_t n) { return first + step * static_cast<double>(n - 1); };
    extent.column = nodes(window.x0 - wider.x0);
    extent.row = nodes(window.y0 - wider.y0);
    HeightGrid all{window.x0 - cell * static_cast<double>(extent.column),
                   window.y0 - cell * static_cast<double>(extent.row),
                   cell,
                   cell,
                   0,
                   0,
                   {}};
    all.nx = extent.column + window.nx + nodes(end(wider.x0, wider.dx, wider.nx) - end(window.x0, cell, window.nx));
    all.ny = extent.row + window.ny + nodes(end(wider.y0, wider.dy, wider.ny) - end(window.y0, cell, window.ny));
    if (all.nx == wider.nx && all.ny == wider.ny && squareCells(wider)) {
        all.heights = wider.heights;
        extent.missing = std::move(m_ended);
    } else {
        sampleAt(all, wider);
        if (!m_ended.empty()) {
            extent.missing = nearestOf(m_ended, wider, all);
        }
    }
    for (std::size_t j = 0; j < window.ny; ++j) {
        std::copy_n(&window.heights[j * window.nx], window.nx, &all.heights[(j + extent.row) * all.nx + extent.column]);
    }
    return std::make_shared<const TerrainGrid>(std::move(all), std::move(extent));
}

void TerrainReading::checkSite(const TerrainGrid& grid) {
    if (m_around.isEmpty()) {
        return;
    }
    const Vec3 low = m_around.min();
    const Vec3 high = m_around.max();
    const Vec3 size = m_around.sizes();
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    constexpr int samples = 64;
    for (int j = 0; j <= samples; ++j) {
        for (int i = 0; i <= samples; ++i) {
            const double height = grid.height(low.x() + size.x() * i / samples, low.y() + size.y() * j / samples);
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
    }
    const double apart = std::max(lowest - high.z(), low.z() - highest);
    if (lowest > high.z() || low.z() - highest > windowHeights * std::max(size.z(), 1.0)) {
        find("terrain.far_off", "the terrain lies {0} {1} the whole structure",
             {{apart, "m"}, lowest > high.z() ? "above" : "below"},
             "check the vertical datum, the unit of the heights and the height shift of the site");
    }
}

TerrainInput TerrainReading::read() {
    if (m_wider.raster.heights.empty()) {
        m_ended = outerGaps(m_raster);
    } else {
        closeWiderGaps();
    }
    const HeightGrid before{m_raster.x0, m_raster.y0, m_raster.dx, m_raster.dy, m_raster.nx, m_raster.ny, {}};
    closeGaps();
    const double dx = m_raster.dx;
    const double dy = m_raster.dy;
    HeightGrid raster = withSquareCells(std::move(m_raster));
    if (raster.dx != dx || (raster.dy != dy && std::abs(dx - dy) > 1e-3 * dx)) {
        find("terrain.not_square", "cells of {0} by {1} were resampled to {2}", {{dx, "m"}, {dy, "m"}, {raster.dx, "m"}},
             "none is needed; heights between nodes are interpolated");
    }
    if (m_wider.raster.heights.empty() && !m_ended.empty() && m_ended.size() != raster.heights.size()) {
        m_ended = nearestOf(m_ended, before, raster);
    }
    m_result.grid = withSurroundings(std::move(raster));
    checkSite(*m_result.grid);
    m_result.path = m_path;
    InputDigest digest = digestOfInput(m_path, InputRole::Terrain, m_execution);
    m_result.sha256 = std::move(digest.sha256);
    m_result.fileSha256 = std::move(digest.fileSha256);
    return std::move(m_result);
}

/// The first input of a role; counts them.
const CaseInput* firstOf(const Case& theCase, InputRole role, std::int64_t& count) {
    const CaseInput* first = nullptr;
    count = 0;
    for (const CaseInput& input : theCase.inputs) {
        if (input.role == role) {
            first = ++count == 1 ? &input : first;
        }
    }
    return first;
}

}  // namespace

TerrainInput openTerrain(const std::string& path, const Frame& frame, const Aabb& around, const Execution& execution,
                         const Site& site, const CloudRequest& read) {
    checkTerrain(path);
    execution.check();
    HeightReading heights =
        isMeshPath(path) && !isPlyOfPoints(path)
            ? heightsOfMesh(path, frame, site, execution)
            : readHeights(path, frame, site, around, execution, {.alongAxes = true, .read = read}, HeightReach::Whole);
    if (heights.debrisMap) {
        throw ParseError(
            {"terrain.debris_map", "{0} is a debris map: its heights are above the ground, not those of a ground", {path}},
            {"terrain.debris_map.remedy", "Take it as a survey, or give a height model of the site.", {}});
    }
    TerrainInput terrain = TerrainReading(path, around, std::move(heights), execution).read();
    terrain.fit = SitePlace(frame, site).fit();
    terrain.read = read;
    return terrain;
}

TerrainInput openTerrainOfCase(const Case& theCase, const std::string& casePath, const Mesh& fe, const Execution& execution) {
    std::int64_t terrains = 0;
    const CaseInput* first = firstOf(theCase, InputRole::Terrain, terrains);
    if (first == nullptr) {
        TerrainInput none;
        none.fit = SitePlace(theCase.frame, theCase.site).fit();
        return none;
    }
    TerrainInput terrain =
        openTerrain(inputPath(casePath, *first), theCase.frame, boundsAtRest(fe), execution, theCase.site, first->read);
    if (terrains > 1) {
        terrain.findings.add({"case.terrains", "the case has {0} terrains; the first is used", {terrains}},
                             {"case.terrains.remedy", "keep one, or merge them into one raster", {}}, terrain.path, terrains);
    }
    if (!first->sha256.empty() && !InputDigest{terrain.sha256, terrain.fileSha256}.is(first->sha256)) {
        terrain.findings.add(
            {"case.terrain_changed", "the terrain is not the one the case was saved with", {}},
            {"case.terrain_changed.remedy", "find the file with the SHA-256 of the case, or save the case anew", {}}, terrain.path);
    }
    return terrain;
}

Aabb boundsAtRest(const Mesh& mesh) {
    Aabb bounds;
    for (const Vec3& node : mesh.nodes) {
        if (node.allFinite()) {
            bounds.extend(node);
        }
    }
    return bounds;
}

}  // namespace rubble::io
