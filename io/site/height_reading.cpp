#include "io/site/height_reading.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "core/base/error.h"
#include "io/base/file_words.h"
#include "io/base/native_lock.h"
#include "io/base/trial.h"
#include "io/site/clouds/height_source.h"
#include "io/site/raster_axis.h"
#include "io/site/raster_file.h"
#include "io/site/raster_sampling.h"

namespace rubble::io {

namespace {

/// m. Nothing on land is as far from the sea's level; what is, is a mark for no data that the file does not name as such.
constexpr double heightMax = 9000.0;
/// Heights; more than any number counts.
constexpr double nodesCounted = 1e18;

void addWiderUnread(Findings& findings, const std::string& path, const std::string& why) {
    addFinding(findings, path,
               {"terrain.wider_unread", "what lies beyond the window about the structure cannot be read: {0}", {why}},
               "copy the raster again from where it came; debris that runs there falls on a level guess");
}

/// Turns one file into heights.
class Reading {
public:
    /// @param opened  what is read of it: the file itself, or the grid of a cloud
    Reading(const std::string& path, const std::string& opened, const Frame& frame, const Site& site, const SiteWindow& window,
            const HeightMeaning& meaning, HeightReach reach, const Execution& execution)
        : m_path(path),
          m_frame(frame),
          m_site(site),
          m_place(frame, site),
          m_window(window),
          m_around(window.structure),
          m_withFallen(meaning.withFallen),
          m_aboveGround(meaning.aboveGround),
          m_reach(reach),
          m_alongAxes(meaning.alongAxes),
          m_execution(execution),
          m_file(opened, RasterFile::Holds::Heights, path) {}

    HeightReading read();

private:
    void checkOurs();
    void checkCrs();
    void checkDatum();
    void checkUnit();
    void checkOverlap(const Eigen::Vector2d& low, const Eigen::Vector2d& high);
    void readUpright();
    /// Rows that are turned or projected: as they are, with their lattice.
    void readTurned();
    /// The same, interpolated to nodes along x and y.
    void readResampled();
    void readWider();
    void turn(HeightGrid& raster) const;
    HeightGrid widerUpright(const GridSides& sides) const;
    GridSides aroundUpright() const;
    GridSides aroundResampled() const;
    void toMetres(std::vector<double>& heights, bool tell = true);
    std::pair<Eigen::Vector2d, Eigen::Vector2d> windowOf(Eigen::Vector2d low, Eigen::Vector2d high) const;
    /// Makes gaps of spikes. @param raster  m; @param placeOf  m, local, of a node
    void takeOutSpikes(HeightGrid& raster, const std::function<Eigen::Vector2d(std::size_t)>& placeOf);
    void sayTurned();
    void sayResampled(const RasterSampling& sampling, const RasterWindow& window, const std::vector<double>& values);
    /// Makes gaps of what is no height in values of a window, before they are interpolated. @return  them in metres
    std::vector<double> clean(const RasterSampling& sampling, const RasterWindow& window, std::vector<double>& values, bool tell);
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
    const SiteWindow& m_window;
    const Aabb& m_around;  ///< the structure
    bool m_withFallen;
    bool m_aboveGround;
    HeightReach m_reach;
    bool m_alongAxes;
    const Execution& m_execution;
    RasterFile m_file;
    bool m_upright = true;
    RasterAxis m_x{}, m_y{};       ///< of an upright raster
    PixelRange m_columns, m_rows;  ///< of it that the window takes
    std::size_t m_factor = 1;      ///< pixels that are put together
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
    m_result.debrisMap = m_aboveGround = true;
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
    // Control points that only shift and scale leave rows along the axes.
    m_upright = m_place.transform().angle == 0.0 && !m_file.turned() && same != RasterFile::SameCrs::No;
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
            find("terrain.height_unit", "the raster {0} does not say in which unit its heights are; they are taken as metres",
                 {std::filesystem::path(m_path).filename().string()}, "convert them first if they are feet");
        } else {
            find("terrain.height_unit_unknown", "the raster {0} gives its heights in \"{1}\"; they are taken as metres",
                 {std::filesystem::path(m_path).filename().string(), m_file.heightUnit()}, "convert them first if they are not");
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
    if (!least.allFinite() || !most.allFinite()) {
        refuse("terrain.nowhere", "The edges of {0} have no place in \"{1}\", the system of the case", {m_frame.crs},
               "Check the coordinate system of the raster and that of the case.");
    }
    if (m_around.isEmpty()) {
        return;
    }
    const Vec3 low = m_around.min();
    const Vec3 high = m_around.max();
    const Eigen::Vector2d shift = m_place.transform().shift;
    const auto meets = [&](double unit) {
        const Eigen::Vector2d from = unit * (least + shift) - shift;
        const Eigen::Vector2d to = unit * (most + shift) - shift;
        return (to.array() >= low.head<2>().array()).all() && (from.array() <= high.head<2>().array()).all();
    };
    if (!meets(1.0)) {
        constexpr double foot = 0.3048;
        const bool feet = m_file.metresPerUnit() == 1.0 && m_place.upright() && meets(foot);
        const char* remedy =
            feet
                ? "Its numbers seem to be feet: give it with its coordinate system, or in metres."
                : "Tie the FE model to the coordinate system by control points (Site… in the Case menu), or give the right raster.";
        refuse(
            "terrain.elsewhere",
            "{0} covers x = {1} to {2}, y = {3} to {4} of the local frame; the structure stands at x = {5} to {6}, y = {7} to {8}",
            {least.x(), {most.x(), "m"}, least.y(), {most.y(), "m"}, low.x(), {high.x(), "m"}, low.y(), {high.y(), "m"}}, remedy);
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
    const SiteFit& site = m_place.transform();
    const RasterAxis x{(unit * place.x0 - site.shift.x()) / site.scale, unit * place.dx / site.scale, place.columns};
    const RasterAxis y{(unit * place.y0 - site.shift.y()) / site.scale, unit * place.dy / site.scale, place.rows};
    checkOverlap({x.low(), y.low()}, {x.high(), y.high()});
    PixelRange columns{0, x.pixels};
    PixelRange rows{0, y.pixels};
    if (!m_around.isEmpty()) {
        const Eigen::AlignedBox2d plan = m_window.plan();
        columns = x.around(plan.min().x(), plan.max().x());
        rows = y.around(plan.min().y(), plan.max().y());
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
    toMetres(raster.heights);
    takeOutSpikes(raster, [&](std::size_t node) {
        const std::size_t column = node % raster.nx;
        const std::size_t row = node / raster.nx;
        return Eigen::Vector2d(raster.x0 + raster.dx * static_cast<double>(column),
                               raster.y0 + raster.dy * static_cast<double>(row));
    });
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

std::pair<Eigen::Vector2d, Eigen::Vector2d> Reading::windowOf(Eigen::Vector2d low, Eigen::Vector2d high) const {
    if (!m_around.isEmpty()) {
        const Eigen::AlignedBox2d plan = m_window.plan();
        low = low.cwiseMax(plan.min());
        high = high.cwiseMin(plan.max());
    }
    return {low, high};
}

void Reading::takeOutSpikes(HeightGrid& raster, const std::function<Eigen::Vector2d(std::size_t)>& placeOf) {
    // A block that lies alone is no spike of a height above the ground.
    const std::vector<HeightSpike> spikes = m_aboveGround ? std::vector<HeightSpike>() : removeSpikes(raster);
    if (!spikes.empty()) {
        const HeightSpike& first = spikes.front();
        const Eigen::Vector2d place = placeOf(first.node);
        find("terrain.spikes",
             "{0} heights stand out from all around them, such as {1} at x = {2}, y = {3}, and were taken as gaps",
             {spikes.size(), {first.height, "m"}, {place.x(), "m"}, {place.y(), "m"}},
             "look at these places; make the raster without poles, birds and marks of no data",
             static_cast<std::int64_t>(spikes.size()));
    }
}

void Reading::sayTurned() {
    std::vector<double> steps;
    const HeightGrid& raster = m_result.raster;
    for (std::size_t k = 0; k + 1 < raster.heights.size(); ++k) {
        const double step = std::abs(raster.heights[k + 1] - raster.heights[k]);
        if ((k + 1) % raster.nx != 0 && std::isfinite(step)) {
            steps.push_back(step);
        }
    }
    if (steps.empty()) {
        return;
    }
    std::sort(steps.begin(), steps.end());
    find("terrain.turned",
         "rows of the raster do not run along x and y: its heights are kept, and laid on the cells as they lie; neighbours differ "
         "by {0} "
         "at most, 95 % of them by less than {1}",
         {{steps.back(), "m"}, {steps[steps.size() - 1 - steps.size() / 20], "m"}},
         "none is needed; what lies between two heights is not known better");
}

void Reading::readTurned() {
    const RasterSampling sampling(m_file, m_frame.crs, m_place);
    const auto [least, most] = sampling.bounds();
    checkOverlap(least, most);
    auto [low, high] = windowOf(least, most);
    const double pixel = sampling.pixelSize(0.5 * (low + high));
    const Eigen::Vector2d size = high - low;
    const std::size_t factor = factorFor((size.x() / pixel + 1.0) * (size.y() / pixel + 1.0), pixel);
    const double cell = pixel * static_cast<double>(factor);
    // A pixel reaches half a side around its middle.
    low.array() -= 0.5 * cell;
    high.array() += 0.5 * cell;
    RasterLattice lattice = sampling.lattice(low, high, cell);
    const RasterWindow window = sampling.windowAround(lattice.pixels, factor);
    if (!m_aboveGround && (window.width() < 2 || window.height() < 2)) {
        refuse("terrain.coarse", "{0} has cells of {1}, larger than what it shares with the site", {{cell, "m"}},
               "Give a raster with finer cells, or one that covers more of the site.");
    }
    HeightGrid& raster = m_result.raster;
    raster.nx = window.width();
    raster.ny = window.height();
    raster.heights = window.width() > 0 && window.height() > 0 ? m_file.values(window, m_execution) : std::vector<double>();
    toMetres(raster.heights);
    // Spikes are told by the size of a pixel.
    raster.dx = raster.dy = cell;
    takeOutSpikes(raster, [&](std::size_t node) { return sampling.placesOf(window, {node}).front(); });
    raster.dx = raster.dy = 1.0;
    RasterSampling::countWithin(window, lattice);
    m_result.lattice = std::move(lattice);
    if (!m_aboveGround) {
        sayTurned();
    }
}

void Reading::readResampled() {
    const RasterSampling sampling(m_file, m_frame.crs, m_place);
    const auto [least, most] = sampling.bounds();
    checkOverlap(least, most);
    const auto [low, high] = windowOf(least, most);
    double cell = sampling.pixelSize(0.5 * (low + high));
    const Eigen::Vector2d size = high - low;
    const double nodes = (size.x() / cell + 1.0) * (size.y() / cell + 1.0);
    const std::size_t factor = m_factor = factorFor(nodes, cell);
    cell *= static_cast<double>(factor);
    HeightGrid& raster = m_result.raster;
    raster.dx = raster.dy = cell;
    raster.x0 = low.x();
    raster.y0 = low.y();
    raster.nx = static_cast<std::size_t>(std::floor(size.x() / cell + 1e-9)) + 1;
    raster.ny = static_cast<std::size_t>(std::floor(size.y() / cell + 1e-9)) + 1;
    if (raster.nx < 2 || raster.ny < 2) {
        refuse("terrain.coarse", "{0} has cells of {1}, larger than what it shares with the site", {{cell, "m"}},
               "Give a raster with finer cells, or one that covers more of the site.");
    }
    RasterWindow read;
    std::vector<double> inMetres;
    const auto look = [&](const RasterWindow& window, std::vector<double>& values) {
        inMetres = clean(sampling, window, values, true);
        read = window;
    };
    raster.heights = sampling.heights(raster, factor, look, m_execution);
    toMetres(raster.heights);
    sayResampled(sampling, read, inMetres);
}

std::vector<double> Reading::clean(const RasterSampling& sampling, const RasterWindow& window, std::vector<double>& values,
                                   bool tell) {
    const double cell = m_result.raster.dx;
    HeightGrid own{0.0, 0.0, cell, cell, window.width(), window.height(), values};
    toMetres(own.heights, tell);
    if (tell) {
        takeOutSpikes(own, [&](std::size_t node) { return sampling.placesOf(window, {node}).front(); });
    } else {
        removeSpikes(own);
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = std::isnan(own.heights[k]) ? own.heights[k] : values[k];
    }
    return std::move(own.heights);
}

void Reading::sayResampled(const RasterSampling& sampling, const RasterWindow& window, const std::vector<double>& values) {
    constexpr std::size_t looksMost = 50'000;
    std::vector<std::size_t> which;
    const std::size_t stride = values.size() / looksMost + 1;
    for (std::size_t k = 0; k < values.size(); k += stride) {
        if (std::isfinite(values[k])) {
            which.push_back(k);
        }
    }
    const std::vector<Eigen::Vector2d> places = sampling.placesOf(window, which);
    const HeightGrid& raster = m_result.raster;
    std::vector<double> off;
    for (std::size_t k = 0; k < which.size(); ++k) {
        const double height = heightOn(raster, places[k]);
        if (std::isfinite(height)) {
            off.push_back(std::abs(height - values[which[k]]));
        }
    }
    if (off.empty()) {
        return;
    }
    std::sort(off.begin(), off.end());
    find("terrain.resampled",
         "rows of the raster do not run along x and y: its heights were interpolated once, to cells of {0}; of {1} heights of the "
         "file "
         "that were looked at the surface then lies {2} off at most, 95 % are within {3}",
         {{raster.dx, "m"}, off.size(), {off.back(), "m"}, {off[off.size() - 1 - off.size() / 20], "m"}},
         "give a finer raster, or turn the local frame by control points so that its axes run along the rows, if that is too much");
}

void Reading::toMetres(std::vector<double>& heights, bool tell) {
    const double unit = m_file.metresPerHeightUnit() > 0.0 ? m_file.metresPerHeightUnit() : 1.0;
    const double offset = m_aboveGround ? 0.0 : m_place.toLocal(Vec3::Zero()).z() + m_site.heightShift;
    std::int64_t unmarked = 0;
    double example = 0.0;
    for (double& height : heights) {
        height *= unit;
        if (std::abs(height) > heightMax) {
            example = unmarked == 0 ? height : example;
            ++unmarked;
            height = std::numeric_limits<double>::quiet_NaN();
        }
        height += offset;
    }
    const bool otherUnit = tell && example > 0.0;  // below zero it is a mark for no data
    if (otherUnit && std::none_of(heights.begin(), heights.end(), [](double height) { return std::isfinite(height); })) {
        refuseContent({"terrain.no_land_all", "None of the heights of {0} can be one of land: {1}, say", {m_path, {example, "m"}}},
                      "Name their unit (gdal_edit.py -a_offset and -a_scale, or the band's unit): cm or mm look so.");
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
    const PixelRange columns = m_x.widened(m_columns, sides[0], sides[1], m_factor);
    const PixelRange rows = m_y.widened(m_rows, sides[2], sides[3], m_factor);
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
            wider.raster.heights = sampling.heights(
                wider.raster, m_factor,
                [&](const RasterWindow& window, std::vector<double>& values) { clean(sampling, window, values, false); },
                m_execution);
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
    toMetres(wider.raster.heights, false);
}

HeightReading Reading::read() {
    checkOurs();
    checkCrs();
    if (!m_aboveGround) {
        checkDatum();
    }
    checkUnit();
    if (m_upright) {
        readUpright();
    } else if (m_alongAxes && !m_aboveGround) {
        readResampled();
    } else {
        readTurned();
    }
    if (m_reach == HeightReach::Whole && !m_aboveGround && !m_around.isEmpty()) {
        readWider();
    }
    return std::move(m_result);
}

}  // namespace

HeightReading readHeights(const std::string& path, const Frame& frame, const Site& site, const SiteWindow& window,
                          const Execution& execution, const HeightMeaning& meaning, HeightReach reach) {
    const HeightSource source(path, meaning.surface ? CloudPart::Surface : CloudPart::Ground, meaning.read, frame, site, window,
                              execution);
    bool alive = false;
    bool windowOnly = false;
    {
        const std::scoped_lock lock(nativeLibraries());
        const auto survives = [&](HeightReach tried) {
            return survivesTrial([&] { Reading(path, source.opened(), frame, site, window, meaning, tried, Execution{}).read(); });
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
    HeightReading heights =
        Reading(path, source.opened(), frame, site, window, meaning, windowOnly ? HeightReach::Window : reach, execution).read();
    if (windowOnly) {
        addWiderUnread(heights.findings, path, "the library that reads rasters fails on it");
    }
    Findings all = source.findings();
    all.append(heights.findings);
    heights.findings = std::move(all);
    return heights;
}

}  // namespace rubble::io
