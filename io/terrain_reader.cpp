#include "io/terrain_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "io/case_file.h"
#include "io/files.h"
#include "io/frame_transform.h"
#include "io/terrain/height_raster.h"
#include "io/terrain/raster_file.h"

namespace rubble::io {

namespace {

/// Heights of the structure around it that fragments may reach.
constexpr double windowHeights = 10.0;
/// Nodes of a terrain at most: 64 MB of heights.
constexpr double nodesMax = 8e6;
/// m. Nothing on land is as far from the sea's level; what is, is a mark for no data that the file does not name as such.
constexpr double heightMax = 9000.0;

void checkFile(const std::string& path) {
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

/// Pixels along one axis.
struct Range {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// One axis of the raster in the local frame.
struct Axis {
    double origin;  ///< m, first pixel
    double step;    ///< m, with its sign
    std::size_t pixels;

    double low() const { return std::min(origin, origin + step * static_cast<double>(pixels - 1)); }
    double high() const { return std::max(origin, origin + step * static_cast<double>(pixels - 1)); }
    /// Pixels that span an interval, one beyond each end where there is one, two at least.
    Range around(double from, double to) const {
        const double last = static_cast<double>(pixels - 1);
        const double a = std::clamp((from - origin) / step, 0.0, last);
        const double b = std::clamp((to - origin) / step, 0.0, last);
        auto first = static_cast<std::size_t>(std::floor(std::min(a, b)));
        auto end = static_cast<std::size_t>(std::ceil(std::max(a, b)));
        if (first == end) {
            first > 0 ? --first : ++end;
        }
        return {first, end - first + 1};
    }
};

/// Turns one file into a terrain.
class TerrainReading {
public:
    TerrainReading(const std::string& path, const Frame& frame, const Aabb& around, const Execution& execution)
        : m_path(path), m_frame(frame), m_around(around), m_execution(execution), m_file(path) {}

    TerrainInput read();

private:
    void checkCrs();
    void placeAxes();
    void checkOverlap();
    HeightRaster readWindow();
    void closeGaps(HeightRaster& raster);
    void checkSite(const TerrainGrid& grid);
    void find(std::string id, std::string_view pattern, std::vector<Argument> arguments, std::string_view remedy,
              std::int64_t count = 1) {
        std::string remedyId = id + ".remedy";
        m_result.findings.add({std::move(id), std::string(pattern), std::move(arguments)},
                              {std::move(remedyId), std::string(remedy), {}}, m_path, count);
    }
    [[noreturn]] void refuse(std::string id, std::string_view pattern, std::vector<Argument> arguments, std::string_view remedy) {
        std::string remedyId = id + ".remedy";
        arguments.insert(arguments.begin(), m_path);
        throw ParseError({std::move(id), std::string(pattern), std::move(arguments)},
                         {std::move(remedyId), std::string(remedy), {}});
    }

    const std::string& m_path;
    const Frame& m_frame;
    const Aabb& m_around;
    const Execution& m_execution;
    RasterFile m_file;
    Axis m_x{};
    Axis m_y{};
    double m_heightOffset = 0.0;  ///< m
    TerrainInput m_result;
};

void TerrainReading::checkCrs() {
    m_result.crs = m_file.crsName();
    if (m_file.geographic()) {
        refuse("terrain.degrees", "{0} lies in degrees ({1}), not in metres", {m_file.crsName()},
               "Project it first, as with gdalwarp -t_srs EPSG:NUMBER -r bilinear, to the system of the FE model.");
    }
    const RasterFile::SameCrs same = m_file.sameCrs(m_frame.crs);
    if (same == RasterFile::SameCrs::No) {
        refuse("terrain.other_crs", "{0} is in \"{1}\", the case in \"{2}\"", {m_file.crsName(), m_frame.crs},
               "Project it with gdalwarp -t_srs, or correct the coordinate system of the case's frame.");
    }
    if (same == RasterFile::SameCrs::Unknown && !m_frame.crs.empty()) {
        find("terrain.crs_unknown", "the coordinate system of the terrain could not be held against that of the case", {},
             "make sure that both are in the same one");
    }
    if (m_file.bands() > 1) {
        find("terrain.bands", "the terrain has {0} bands; the first is taken as heights", {m_file.bands()},
             "give a raster with one band if that is not right");
    }
    if (m_file.metresPerHeightUnit() == 0.0) {
        if (m_file.heightUnit().empty()) {
            find("terrain.height_unit", "the terrain does not say in which unit its heights are; they are taken as metres", {},
                 "convert them first if they are feet");
        } else {
            find("terrain.height_unit_unknown", "the terrain gives its heights in \"{0}\"; they are taken as metres",
                 {m_file.heightUnit()}, "convert them first if they are not");
        }
    }
}

void TerrainReading::placeAxes() {
    const RasterPlace& place = m_file.place();
    const Vec3 shift = FrameTransform(m_frame).point(Vec3::Zero());
    const double unit = m_file.metresPerUnit();
    m_x = {unit * place.x0 + shift.x(), unit * place.dx, place.columns};
    m_y = {unit * place.y0 + shift.y(), unit * place.dy, place.rows};
    m_heightOffset = shift.z();
    if (place.columns < 2 || place.rows < 2) {
        refuse("terrain.too_few", "{0} has {1} columns and {2} rows; a surface takes two of each", {place.columns, place.rows},
               "Give a raster that covers the site.");
    }
}

void TerrainReading::checkOverlap() {
    if (m_around.isEmpty()) {
        return;
    }
    const Vec3 low = m_around.min();
    const Vec3 high = m_around.max();
    if (m_x.high() < low.x() || m_x.low() > high.x() || m_y.high() < low.y() || m_y.low() > high.y()) {
        refuse(
            "terrain.elsewhere",
            "{0} covers x = {1} to {2}, y = {3} to {4} of the local frame; the structure stands at x = {5} to {6}, y = {7} to {8}",
            {m_x.low(), {m_x.high(), "m"}, m_y.low(), {m_y.high(), "m"}, low.x(), {high.x(), "m"}, low.y(), {high.y(), "m"}},
            "Set the origin of the case's frame, in whole metres, to where the FE model's zero lies, or give the right raster.");
    }
    const double missing = std::max({m_x.low() - low.x(), high.x() - m_x.high(), m_y.low() - low.y(), high.y() - m_y.high()});
    if (missing > 0.0) {
        find("terrain.short", "the terrain ends {0} short of the outline of the structure and goes on level from there",
             {{missing, "m"}}, "give a raster that covers the whole site");
    }
}

HeightRaster TerrainReading::readWindow() {
    Range columns{0, m_x.pixels};
    Range rows{0, m_y.pixels};
    if (!m_around.isEmpty()) {
        const Vec3 size = m_around.sizes();
        const double margin = std::max({windowHeights * size.z(), size.x(), size.y()});
        columns = m_x.around(m_around.min().x() - margin, m_around.max().x() + margin);
        rows = m_y.around(m_around.min().y() - margin, m_around.max().y() + margin);
    }
    HeightRaster raster;
    raster.dx = std::abs(m_x.step);
    raster.dy = std::abs(m_y.step);
    raster.nx = columns.count;
    raster.ny = rows.count;
    const double nodes = std::max(squareNodeCount(raster.dx, raster.dy, raster.nx, raster.ny),
                                  static_cast<double>(raster.nx) * static_cast<double>(raster.ny));
    if (nodes > nodesMax) {
        const double cell = std::min(raster.dx, raster.dy) * std::sqrt(nodes / nodesMax);
        throw ParseError({"terrain.too_many",
                          "{0} has {1} heights around the structure; at most {2} can be used",
                          {m_path, static_cast<std::int64_t>(nodes), static_cast<std::int64_t>(nodesMax)}},
                         {"terrain.too_many.remedy",
                          "Make it coarser, as with gdalwarp -r average -tr SIZE SIZE and cells of {0} or more.",
                          {{cell, "m"}}});
    }
    raster.heights = m_file.values(columns.first, rows.first, columns.count, rows.count, m_execution);
    const auto lowest = [](const Axis& axis, const Range& range) {
        const std::size_t pixel = axis.step > 0.0 ? range.first : range.first + range.count - 1;
        return axis.origin + axis.step * static_cast<double>(pixel);
    };
    raster.x0 = lowest(m_x, columns);
    raster.y0 = lowest(m_y, rows);
    if (m_x.step < 0.0) {
        flipColumns(raster);
    }
    if (m_y.step < 0.0) {
        flipRows(raster);
    }
    return raster;
}

void TerrainReading::closeGaps(HeightRaster& raster) {
    const double unit = m_file.metresPerHeightUnit() > 0.0 ? m_file.metresPerHeightUnit() : 1.0;
    std::int64_t unmarked = 0;
    double example = 0.0;
    for (double& height : raster.heights) {
        height *= unit;
        if (std::abs(height) > heightMax) {
            example = unmarked == 0 ? height : example;
            ++unmarked;
            height = std::numeric_limits<double>::quiet_NaN();
        }
        height += m_heightOffset;
    }
    const std::int64_t gaps = countGaps(raster);
    const auto all = static_cast<std::int64_t>(raster.heights.size());
    if (2 * gaps > all) {
        refuse("terrain.gaps",
               gaps == all ? "{0} has no height at all around the structure ({1} of {2} have none)"
                           : "{0} has no height for {1} of {2} places around the structure",
               {gaps, all}, "Give a raster that covers the site, or fill its gaps with gdal_fillnodata.py.");
    }
    if (unmarked > 0) {
        find("terrain.no_land", "{0} heights such as {1} cannot be heights of land and were taken as gaps",
             {unmarked, {example, "m"}}, "name the value for no data with gdal_translate -a_nodata", unmarked);
    }
    if (gaps > 0) {
        find("terrain.filled", "{0} of {1} places of the terrain had no height and were filled from their neighbours", {gaps, all},
             "look at the terrain where the debris lies, or give a raster without gaps", gaps);
        fillGaps(raster);
    }
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
             "check the vertical datum, the unit of the heights and the origin of the case's frame");
    }
}

TerrainInput TerrainReading::read() {
    checkCrs();
    placeAxes();
    checkOverlap();
    HeightRaster raster = readWindow();
    closeGaps(raster);
    const double dx = raster.dx;
    const double dy = raster.dy;
    raster = withSquareCells(std::move(raster));
    if (raster.dx != dx || (raster.dy != dy && std::abs(dx - dy) > 1e-3 * dx)) {
        find("terrain.not_square", "cells of {0} by {1} were resampled to {2}", {{dx, "m"}, {dy, "m"}, {raster.dx, "m"}},
             "none is needed; heights between nodes are interpolated");
    }
    m_result.grid =
        std::make_shared<const TerrainGrid>(raster.x0, raster.y0, raster.dx, raster.nx, raster.ny, std::move(raster.heights));
    checkSite(*m_result.grid);
    m_result.path = m_path;
    m_result.sha256 = sha256OfFile(m_path);
    return std::move(m_result);
}

}  // namespace

TerrainInput openTerrain(const std::string& path, const Frame& frame, const Aabb& around, const Execution& execution) {
    checkFile(path);
    execution.check();
    return TerrainReading(path, frame, around, execution).read();
}

TerrainInput openTerrainOfCase(const Case& theCase, const std::string& casePath, const Mesh& fe, const Execution& execution) {
    const CaseInput* first = nullptr;
    std::int64_t terrains = 0;
    for (const CaseInput& input : theCase.inputs) {
        if (input.role == InputRole::Terrain) {
            first = ++terrains == 1 ? &input : first;
        }
    }
    if (first == nullptr) {
        return {};
    }
    TerrainInput terrain = openTerrain(inputPath(casePath, *first), theCase.frame, boundsAtRest(fe), execution);
    if (terrains > 1) {
        terrain.findings.add({"case.terrains", "the case has {0} terrains; the first is used", {terrains}},
                             {"case.terrains.remedy", "keep one, or merge them into one raster", {}}, terrain.path, terrains);
    }
    if (!first->sha256.empty() && terrain.sha256 != first->sha256) {
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
