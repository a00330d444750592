#include "io/site/height_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "io/base/native_lock.h"
#include "io/fe/exodus/trial.h"
#include "io/site/file_words.h"
#include "io/site/raster_file.h"
#include "io/site/raster_sampling.h"

namespace rubble::io {

namespace {

/// m. Nothing on land is as far from the sea's level; what is, is a mark for no data that the file does not name as such.
constexpr double heightMax = 9000.0;
/// Heights; more than any number counts.
constexpr double nodesCounted = 1e18;

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
    /// Pixels that span an interval, one beyond each end where there is one, two at least if there are as many.
    Range around(double from, double to) const {
        if (pixels == 1) {
            return {0, 1};
        }
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
    /// Groups of pixels put together around a range of them: below and above it in the local frame.
    std::pair<std::size_t, std::size_t> groupsAround(const Range& range, std::size_t factor) const {
        const std::size_t before = range.first / factor;
        const std::size_t after = (pixels - range.first - range.count) / factor;
        return step > 0.0 ? std::pair(before, after) : std::pair(after, before);
    }
    /// A range with so many groups more below and above it.
    Range widened(const Range& range, std::size_t below, std::size_t above, std::size_t factor) const {
        const std::size_t before = step > 0.0 ? below : above;
        return {range.first - before * factor, range.count + (below + above) * factor};
    }
    /// Place of the lowest of pixels put together.
    double lowest(const Range& range, std::size_t factor) const {
        const auto half = 0.5 * static_cast<double>(factor - 1);
        const std::size_t groups = range.count / factor;
        const std::size_t first = step > 0.0 ? range.first : range.first + (groups - 1) * factor;
        return origin + step * (static_cast<double>(first) + half);
    }
};

void addWiderUnread(Findings& findings, const std::string& path, const std::string& why) {
    addFinding(findings, path,
               {"terrain.wider_unread", "what lies beyond the window about the structure cannot be read: {0}", {why}},
               "copy the raster again from where it came; debris that runs there falls on a level guess");
}

/// Turns one file into heights.
class Reading {
public:
    Reading(const std::string& path, const Frame& frame, const Site& site, const Aabb& around, const HeightMeaning& meaning,
            HeightReach reach, const Execution& execution)
        : m_path(path),
          m_frame(frame),
          m_site(site),
          m_place(frame, site),
          m_around(around),
          m_withFallen(meaning.withFallen),
          m_aboveGround(meaning.aboveGround),
          m_reach(reach),
          m_execution(execution),
          m_file(path) {}

    HeightReading read();

private:
    void checkOurs();
    void checkCrs();
    void checkDatum();
    void checkUnit();
    void checkOverlap(const Eigen::Vector2d& low, const Eigen::Vector2d& high);
    void readUpright();
    void readResampled();
    void readWider();
    void turn(HeightGrid& raster) const;
    HeightGrid widerUpright(const GridSides& sides) const;
    GridSides aroundUpright() const;
    GridSides aroundResampled() const;
    void toMetres(HeightGrid& raster, bool tell);
    std::size_t factorFor(double nodes, double cell);
    void find(std::string id, std::string_view pattern, std::vector<Argument> arguments, std::string_view remedy,
              std::int64_t count = 1) {
        addFinding(m_result.findings, m_path, {std::move(id), std::string(pattern), std::move(arguments)}, remedy, count);
    }
    [[noreturn]] void refuse(std::string id, std::string_view pattern, std::vector<Argument> arguments, std::string_view remedy) {
        arguments.insert(arguments.begin(), m_path);
        refuseContent({std::move(id), std::string(pattern), std::move(arguments)}, remedy);
    }

    const std::string& m_path;
    const Frame& m_frame;
    const Site& m_site;
    SitePlace m_place;
    const Aabb& m_around;
    bool m_withFallen;
    bool m_aboveGround;
    HeightReach m_reach;
    const Execution& m_execution;
    RasterFile m_file;
    bool m_upright = true;
    Axis m_x{}, m_y{};         ///< of an upright raster
    Range m_columns, m_rows;   ///< of it that the window takes
    std::size_t m_factor = 1;  ///< pixels that are put together
    HeightReading m_result;
};

void Reading::checkOurs() {
    if (m_file.entry("RUBBLE_CLASS").empty()) {
        return;
    }
    const std::vector<std::string> names = m_file.bandNames();
    std::vector<int> bands;
    for (int b = 0; b < m_file.bands(); ++b) {
        const std::string& name = names[static_cast<std::size_t>(b)];
        if (name == "height" || name == "height_p50" || (m_withFallen && name == "live_height")) {
            bands.push_back(b);
        }
    }
    if (bands.empty()) {
        refuse("terrain.our_map", "{0} is a map that Rubble made, and none of its bands holds heights", {},
               "Give a height model of the site, or a map with the layer height.");
    }
    m_file.take(bands);
    m_result.debrisMap = true;
    m_aboveGround = true;
}

void Reading::checkCrs() {
    m_result.crs = m_file.crsName();
    if (m_file.geographic() && m_frame.crs.empty()) {
        refuse("terrain.degrees", "{0} lies in degrees ({1}), and the case does not say where on Earth it is", {m_file.crsName()},
               "Give the case the coordinate system of its site, such as EPSG:25832: the raster is then projected to it.");
    }
    const Vec3 middle = m_around.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(m_around.center());
    m_file.checkWay(m_frame.crs, m_place.planToWorld(middle.head<2>()), m_result.findings);
    const RasterFile::SameCrs same = m_file.sameCrs(m_frame.crs);
    m_upright = m_place.upright() && !m_file.turned() && same != RasterFile::SameCrs::No;
    if (same == RasterFile::SameCrs::Unknown && m_file.geographic()) {
        refuse("terrain.degrees_unknown", "{0} lies in degrees ({1}); \"{2}\" of the case is no system it could be projected to",
               {m_file.crsName(), m_frame.crs}, "Give the case a projected system in metres, such as EPSG:25832.");
    }
    if (same == RasterFile::SameCrs::Unknown && !m_frame.crs.empty()) {
        find("terrain.crs_unknown",
             "the coordinate system of the raster could not be held against that of the case; both are taken as one", {},
             "make sure that both are in the same one");
    }
    if (same == RasterFile::SameCrs::No) {
        find("terrain.projected", "the raster was projected from \"{0}\" to the system of the case", {m_file.crsName()},
             "none is needed; heights are interpolated between those of the file");
    }
    if (m_file.bands() > 1 && !m_result.debrisMap) {
        find("terrain.bands", "the raster has {0} bands; the first is taken as heights", {m_file.bands()},
             "give a raster with one band if that is not right");
    }
}

void Reading::checkDatum() {
    m_result.verticalDatum = m_file.verticalDatum();
    const std::string ofCase = RasterFile::verticalDatum(m_frame.crs);
    if (!m_result.verticalDatum.empty() && !ofCase.empty() && m_result.verticalDatum != ofCase && m_site.heightShift == 0.0) {
        find("terrain.other_datum",
             "heights of the raster count from \"{0}\", those of the case from \"{1}\"; they were not converted",
             {m_result.verticalDatum, ofCase}, "set the height shift of the site to the difference there");
    } else if (!m_result.verticalDatum.empty() && ofCase.empty() && !m_frame.crs.empty() && m_site.heightShift == 0.0) {
        find("terrain.datum_kept",
             "heights of the raster count from \"{0}\", and the case names no vertical datum; they were not converted",
             {m_result.verticalDatum}, "make sure that all heights of the case count from it, or set the height shift of the site");
    }
}

void Reading::checkUnit() {
    if (m_file.metresPerHeightUnit() == 0.0) {
        if (m_file.heightUnit().empty()) {
            find("terrain.height_unit", "the raster does not say in which unit its heights are; they are taken as metres", {},
                 "convert them first if they are feet");
        } else {
            find("terrain.height_unit_unknown", "the raster gives its heights in \"{0}\"; they are taken as metres",
                 {m_file.heightUnit()}, "convert them first if they are not");
        }
    }
    const RasterPlace& place = m_file.place();
    const std::size_t least = m_aboveGround ? 1 : 2;
    if (place.columns < least || place.rows < least) {
        refuse("terrain.too_few", "{0} has {1} columns and {2} rows; a surface takes two of each", {place.columns, place.rows},
               "Give a raster that covers the site.");
    }
}

void Reading::checkOverlap(const Eigen::Vector2d& least, const Eigen::Vector2d& most) {
    if (m_around.isEmpty()) {
        return;
    }
    const Vec3 low = m_around.min();
    const Vec3 high = m_around.max();
    if (!(most.x() >= low.x() && least.x() <= high.x() && most.y() >= low.y() && least.y() <= high.y())) {
        refuse(
            "terrain.elsewhere",
            "{0} covers x = {1} to {2}, y = {3} to {4} of the local frame; the structure stands at x = {5} to {6}, y = {7} to {8}",
            {least.x(), {most.x(), "m"}, least.y(), {most.y(), "m"}, low.x(), {high.x(), "m"}, low.y(), {high.y(), "m"}},
            "Tie the FE model to the coordinate system by control points (Site… in the Case menu), or give the right raster.");
    }
    m_result.missing =
        std::max({least.x() - low.x(), high.x() - most.x(), least.y() - low.y(), high.y() - most.y(), m_result.missing});
}

std::size_t Reading::factorFor(double nodes, double cell) {
    // Cells of no width beside others, or the edge of a projection, ask for more than any number counts.
    if (!(nodes < nodesCounted)) {
        refuse("terrain.strip", "{0} is too long and narrow around the structure to be made coarser", {},
               "Resample it to square cells with gdalwarp.");
    }
    const auto factor = static_cast<std::size_t>(std::max(1.0, std::ceil(std::sqrt(nodes / terrainNodesMax) - 1e-9)));
    if (factor > 1) {
        find("terrain.reduced", "{0} heights around the structure are more than can be used: cells of {1} were averaged to {2}",
             {static_cast<std::int64_t>(nodes), {cell, "m"}, {cell * static_cast<double>(factor), "m"}},
             "cut the raster to the site if finer heights are needed there");
    }
    return factor;
}

void Reading::readUpright() {
    const RasterPlace& place = m_file.place();
    const double unit = m_file.metresPerUnit();
    const Axis x{unit * place.x0 - m_place.transform().shift.x(), unit * place.dx, place.columns};
    const Axis y{unit * place.y0 - m_place.transform().shift.y(), unit * place.dy, place.rows};
    checkOverlap({x.low(), y.low()}, {x.high(), y.high()});
    Range columns{0, x.pixels};
    Range rows{0, y.pixels};
    if (!m_around.isEmpty()) {
        const Vec3 size = m_around.sizes();
        const double margin = std::max({windowHeights * size.z(), size.x(), size.y()});
        columns = x.around(m_around.min().x() - margin, m_around.max().x() + margin);
        rows = y.around(m_around.min().y() - margin, m_around.max().y() + margin);
    }
    HeightGrid& raster = m_result.raster;
    raster.dx = std::abs(x.step);
    raster.dy = std::abs(y.step);
    const double nodes = std::max(squareNodeCount(raster.dx, raster.dy, columns.count, rows.count),
                                  static_cast<double>(columns.count) * static_cast<double>(rows.count));
    const std::size_t factor = m_factor = factorFor(nodes, std::min(raster.dx, raster.dy));
    columns.count -= columns.count % factor;
    rows.count -= rows.count % factor;
    const std::size_t least = m_aboveGround ? factor : 2 * factor;
    if (columns.count < least || rows.count < least) {
        refuse("terrain.strip", "{0} is too long and narrow around the structure to be made coarser", {},
               "Resample it to square cells with gdalwarp.");
    }
    m_x = x;
    m_y = y;
    m_columns = columns;
    m_rows = rows;
    const RasterWindow window{columns.first, rows.first, columns.count, rows.count, factor};
    raster.nx = window.width();
    raster.ny = window.height();
    raster.dx *= static_cast<double>(factor);
    raster.dy *= static_cast<double>(factor);
    raster.heights = m_file.values(window, m_execution);
    raster.x0 = x.lowest(columns, factor);
    raster.y0 = y.lowest(rows, factor);
    turn(raster);
}

/// Columns to the east and rows to the north.
void Reading::turn(HeightGrid& raster) const {
    if (m_x.step < 0.0) {
        flipColumns(raster);
    }
    if (m_y.step < 0.0) {
        flipRows(raster);
    }
}

void Reading::readResampled() {
    const RasterSampling sampling(m_file, m_frame.crs, m_place);
    const auto [least, most] = sampling.bounds();
    checkOverlap(least, most);
    Eigen::Vector2d low = least;
    Eigen::Vector2d high = most;
    if (!m_around.isEmpty()) {
        const Vec3 size = m_around.sizes();
        const double margin = std::max({windowHeights * size.z(), size.x(), size.y()});
        low = low.cwiseMax(Eigen::Vector2d(m_around.min().head<2>().array() - margin));
        high = high.cwiseMin(Eigen::Vector2d(m_around.max().head<2>().array() + margin));
    }
    double cell = sampling.pixelSize(0.5 * (low + high));
    const Eigen::Vector2d size = high - low;
    const double nodes = (size.x() / cell + 1.0) * (size.y() / cell + 1.0);
    const std::size_t factor = m_factor = factorFor(nodes, cell);
    cell *= static_cast<double>(factor);
    HeightGrid& raster = m_result.raster;
    raster.dx = raster.dy = cell;
    raster.x0 = low.x();
    raster.y0 = low.y();
    // Of a map in a turned frame the last cells lie on the edge, but for rounding.
    const double rounding = m_aboveGround ? 1e-3 : 1e-9;
    raster.nx = static_cast<std::size_t>(std::floor(size.x() / cell + rounding)) + 1;
    raster.ny = static_cast<std::size_t>(std::floor(size.y() / cell + rounding)) + 1;
    if (!m_aboveGround && (raster.nx < 2 || raster.ny < 2)) {
        refuse("terrain.coarse", "{0} has cells of {1}, larger than what it shares with the site", {{cell, "m"}},
               "Give a raster with finer cells, or one that covers more of the site.");
    }
    const auto pick = m_aboveGround ? RasterSampling::Pick::Nearest : RasterSampling::Pick::Between;
    raster.heights = sampling.heights(raster, factor, pick, m_execution);
}

void Reading::toMetres(HeightGrid& raster, bool tell) {
    const double unit = m_file.metresPerHeightUnit() > 0.0 ? m_file.metresPerHeightUnit() : 1.0;
    const double offset = m_aboveGround ? 0.0 : m_place.toLocal(Vec3::Zero()).z() + m_site.heightShift;
    std::int64_t unmarked = 0;
    double example = 0.0;
    for (double& height : raster.heights) {
        height *= unit;
        if (std::abs(height) > heightMax) {
            example = unmarked == 0 ? height : example;
            ++unmarked;
            height = std::numeric_limits<double>::quiet_NaN();
        }
        height += offset;
    }
    if (tell && unmarked > 0) {
        find("terrain.no_land", "{0} heights such as {1} cannot be heights of land and were taken as gaps",
             {unmarked, {example, "m"}}, "name the value for no data with gdal_translate -a_nodata", unmarked);
    }
}

/// Nodes that the file has around the window.
GridSides Reading::aroundUpright() const {
    const auto [west, east] = m_x.groupsAround(m_columns, m_factor);
    const auto [south, north] = m_y.groupsAround(m_rows, m_factor);
    return {west, east, south, north};
}

GridSides Reading::aroundResampled() const {
    const HeightGrid& raster = m_result.raster;
    const auto [least, most] = RasterSampling(m_file, m_frame.crs, m_place).bounds();
    const auto nodes = [&](double metres) {
        return metres > 0.0 ? static_cast<std::size_t>(std::min(metres / raster.dx, terrainNodesMax)) : std::size_t{0};
    };
    return {nodes(raster.x0 - least.x()), nodes(most.x() - raster.x0 - raster.dx * static_cast<double>(raster.nx - 1)),
            nodes(raster.y0 - least.y()), nodes(most.y() - raster.y0 - raster.dy * static_cast<double>(raster.ny - 1))};
}

HeightGrid Reading::widerUpright(const GridSides& sides) const {
    const Range columns = m_x.widened(m_columns, sides[0], sides[1], m_factor);
    const Range rows = m_y.widened(m_rows, sides[2], sides[3], m_factor);
    const RasterWindow window{columns.first, rows.first, columns.count, rows.count, m_factor};
    HeightGrid wider{
        0.0, 0.0, m_result.raster.dx, m_result.raster.dy, window.width(), window.height(), m_file.values(window, m_execution)};
    turn(wider);
    return wider;
}

void Reading::readWider() {
    const HeightGrid& raster = m_result.raster;
    const GridSides there = m_upright ? aroundUpright() : aroundResampled();
    const auto nodes = [&](std::size_t columns, std::size_t rows) {
        return std::max(squareNodeCount(raster.dx, raster.dy, columns, rows),
                        static_cast<double>(columns) * static_cast<double>(rows));
    };
    const GridSides sides = roomAround(raster.nx, raster.ny, there, terrainNodesMax, nodes);
    WiderHeights& wider = m_result.wider;
    wider.unread = there;
    if (std::all_of(sides.begin(), sides.end(), [](std::size_t side) { return side == 0; })) {
        return;
    }
    try {
        if (m_upright) {
            wider.raster = widerUpright(sides);
        } else {
            wider.raster.dx = wider.raster.dy = raster.dx;
            wider.raster.nx = raster.nx + sides[0] + sides[1];
            wider.raster.ny = raster.ny + sides[2] + sides[3];
        }
        wider.raster.x0 = raster.x0 - raster.dx * static_cast<double>(sides[0]);
        wider.raster.y0 = raster.y0 - raster.dy * static_cast<double>(sides[2]);
        if (!m_upright) {
            const RasterSampling sampling(m_file, m_frame.crs, m_place);
            wider.raster.heights = sampling.heights(wider.raster, m_factor, RasterSampling::Pick::Between, m_execution);
        }
    } catch (const ParseError& error) {
        wider.raster = {};
        addWiderUnread(m_result.findings, m_path, englishText(error.message()));
        return;
    }
    wider.column = sides[0];
    wider.row = sides[2];
    for (std::size_t side = 0; side < sides.size(); ++side) {
        wider.unread[side] -= sides[side];
    }
    toMetres(wider.raster, false);
}

HeightReading Reading::read() {
    checkOurs();
    checkCrs();
    if (!m_aboveGround) {
        checkDatum();
    }
    checkUnit();
    m_upright ? readUpright() : readResampled();
    toMetres(m_result.raster, true);
    if (m_reach == HeightReach::Whole && !m_aboveGround && !m_around.isEmpty()) {
        readWider();
    }
    return std::move(m_result);
}

}  // namespace

HeightReading readHeights(const std::string& path, const Frame& frame, const Site& site, const Aabb& around,
                          const Execution& execution, const HeightMeaning& meaning, HeightReach reach) {
    bool alive = false;
    bool windowOnly = false;
    {
        const std::scoped_lock lock(nativeLibraries());
        const auto survives = [&](HeightReach tried) {
            return survivesTrial([&] { Reading(path, frame, site, around, meaning, tried, Execution{}).read(); });
        };
        alive = survives(reach);
        if (!alive && reach == HeightReach::Whole) {
            alive = survives(HeightReach::Window);
            windowOnly = alive;
        }
    }
    if (!alive) {
        throw ParseError({"terrain.crash", "{0} is damaged so that the library that reads rasters fails on it", {path}},
                         {"terrain.empty.remedy", "Copy it again from where it came.", {}});
    }
    if (!windowOnly) {
        return Reading(path, frame, site, around, meaning, reach, execution).read();
    }
    HeightReading heights = Reading(path, frame, site, around, meaning, HeightReach::Window, execution).read();
    addWiderUnread(heights.findings, path, "the library that reads rasters fails on it");
    return heights;
}

}  // namespace rubble::io
