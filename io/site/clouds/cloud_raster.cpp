#include "io/site/clouds/cloud_raster.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "io/base/file_words.h"
#include "io/site/clouds/cloud_grid.h"
#include "io/site/clouds/cloud_summary.h"
#include "io/site/clouds/point_cloud.h"
#include "io/site/gdal_session.h"
#include "io/site/site_place.h"
#include "io/site/system_way.h"

namespace rubble::io {

namespace {

constexpr double pointsToACell = 6.0;
constexpr double cellLeast = 0.1;  // m
constexpr double metresInADegree = 111'320.0;
constexpr std::size_t samplesMost = 200'000;
constexpr std::uint16_t groundClass = 2;

/// Points that may make the surface: how many, where, and a share of them in plan.
class PointShare {
public:
    void add(const Vec3& place) {
        m_box.extend(place);
        if (m_points++ % m_stride != 0) {
            return;
        }
        m_sample.emplace_back(place.head<2>());
        if (m_sample.size() == samplesMost) {
            for (std::size_t k = 0; 2 * k < m_sample.size(); ++k) {
                m_sample[k] = m_sample[2 * k];
            }
            m_sample.resize((samplesMost + 1) / 2);
            m_stride *= 2;
        }
    }
    std::uint64_t points() const { return m_points; }
    const Aabb& box() const { return m_box; }

    /// Points to an area of one in units of the scale, within a box; 0 where there are too few to tell.
    double density(const Eigen::AlignedBox2d& within, const Eigen::Vector2d& scale) const {
        Eigen::AlignedBox2d box;
        std::vector<Eigen::Vector2d> inside;
        for (const Eigen::Vector2d& place : m_sample) {
            if (within.contains(place)) {
                inside.push_back(place.cwiseProduct(scale));
                box.extend(inside.back());
            }
        }
        if (inside.size() < 16 || !(box.volume() > 0.0)) {
            return 0.0;
        }
        // Cells of eight samples each, if these lay evenly: those that have any are what the cloud covers.
        const double side = std::sqrt(box.volume() * 8.0 / static_cast<double>(inside.size()));
        std::set<std::pair<std::int64_t, std::int64_t>> covered;
        for (const Eigen::Vector2d& place : inside) {
            covered.emplace(static_cast<std::int64_t>((place.x() - box.min().x()) / side),
                            static_cast<std::int64_t>((place.y() - box.min().y()) / side));
        }
        return static_cast<double>(inside.size() * m_stride) / (static_cast<double>(covered.size()) * side * side);
    }

private:
    std::uint64_t m_points = 0;
    std::uint64_t m_stride = 1;
    Aabb m_box;
    std::vector<Eigen::Vector2d> m_sample;
};

class CloudLaying {
public:
    CloudLaying(const std::string& path, CloudPart part, const CloudRequest& read, const Frame& frame, const Site& site,
                const SiteWindow& window, const Execution& execution)
        : m_path(path), m_part(part), m_read(read), m_frame(frame), m_site(site), m_window(window), m_execution(execution) {}

    CloudRaster lay() {
        look();
        choose();
        CloudGrid grid = emptyGrid();
        const std::unique_ptr<PointCloud> cloud = openCloud(m_path, m_read);
        CloudBlock block;
        std::int64_t beside = 0;
        while (cloud->next(block, m_execution)) {
            for (std::size_t i = 0; i < block.size(); ++i) {
                if (counts(block, i)) {
                    beside += grid.add(block.places[i]) ? 0 : 1;
                }
            }
            m_execution.report({"cloud.gridding", "Laying the points on a grid", {}}, cloud->fraction());
        }
        if (beside > 0) {
            find({"cloud.beside", "points farther from the structure than there is room for were left out", {}},
                 "none is needed unless debris runs there", beside);
        }
        if (grid.inLine()) {
            refuseContent({"cloud.in_line", "The points of {0} lie along a line or in one spot: they make no surface", {m_path}},
                          "Hold measured points in a section or as an edge; else give points that cover an area.");
        }
        tellGrid(grid);
        write(grid);
        return std::move(m_made);
    }

private:
    bool counts(const CloudBlock& block, std::size_t i) const {
        if (block.classes.empty()) {
            return true;
        }
        return m_groundAlone ? isGround(block.classes[i]) : !isPlantOrWire(block.classes[i]);
    }

    bool isGround(std::uint16_t kind) const {
        const std::vector<std::uint16_t>& asked = m_site.groundClasses;
        return asked.empty() ? kind == groundClass : std::find(asked.begin(), asked.end(), kind) != asked.end();
    }

    /// "2, 9"
    std::string groundText() const {
        std::string text;
        for (const std::uint16_t kind : m_site.groundClasses) {
            text += (text.empty() ? "" : ", ") + std::to_string(kind);
        }
        return text.empty() ? std::to_string(groundClass) : text;
    }

    void look() {
        const std::unique_ptr<PointCloud> cloud = openCloud(m_path, m_read);
        const bool classes = cloud->head().columns.classes;
        const CloudSummary summary = summariseCloud(*cloud, m_execution, [&](const CloudBlock& block) {
            for (std::size_t i = 0; i < block.size(); ++i) {
                const std::uint16_t kind = classes ? block.classes[i] : 0;
                if (classes && isGround(kind)) {
                    m_ground.add(block.places[i]);
                }
                if (isPlantOrWire(kind)) {
                    ++m_plants;
                } else {
                    m_all.add(block.places[i]);
                }
                ++m_points;
            }
        });
        m_head = cloud->head();
        m_classes = classes;
        m_made.findings = summary.findings;
        if (m_head.units.geocentric) {
            refuseContent({"cloud.no_plan", "{0} counts its places from the centre of the Earth", {m_path}},
                          "Bring it to a projected system, such as the UTM zone of the place.");
        }
        if (m_part == CloudPart::Ground && m_points > 0 && m_ground.points() == 0 && !m_site.groundClasses.empty()) {
            refuseContent(
                {"cloud.no_class", "{0} has no point of the classes that are to be the ground: {1}", {m_path, groundText()}},
                "Ask for classes that it has; rubble-cli cloud tells them.");
        }
        if (m_part == CloudPart::Ground && m_ground.points() > 0) {
            return;
        }
        if (m_all.points() == 0 && m_plants > 0) {
            refuseContent({"cloud.plants_alone",
                           "{0} holds vegetation and wires alone ({1} points): neither ground nor debris",
                           {m_path, static_cast<std::int64_t>(m_plants)}},
                          "Give the cloud with its ground, or without classes if they are wrong.");
        }
        if (m_all.points() == 0) {
            refuseContent({"cloud.no_points", "{0} has no point that counts", {m_path}}, "Give a cloud with points.");
        }
    }

    void choose() {
        m_groundAlone = m_part == CloudPart::Ground && m_ground.points() > 0;
        const auto count = [](std::uint64_t points) { return static_cast<std::int64_t>(points); };
        if (m_groundAlone) {
            find({"cloud.ground",
                  "points of class {1} are the ground; {0} of other classes were left out",
                  {count(m_points - m_ground.points()), groundText()}},
                 "none is needed", count(m_ground.points()));
        } else if (m_part == CloudPart::Ground) {
            find(m_classes
                     ? Message{"cloud.no_ground", "no point is of class 2: all but vegetation and wires are taken as ground", {}}
                     : Message{"cloud.no_ground", "the cloud has no classes: all its points are taken as ground", {}},
                 "classify the ground in a program for point clouds, if trees, vehicles or houses stand there");
        }
        if (!m_groundAlone && m_plants > 0) {
            find({"cloud.plants", "points of vegetation and wires were left out", {}}, "give them another class if they are debris",
                 count(m_plants));
        }
    }

    const PointShare& taken() const { return m_groundAlone ? m_ground : m_all; }

    /// m, of a unit along x and y; of degrees about the middle of the cloud.
    Eigen::Vector2d scale() const {
        if (!m_head.units.degrees) {
            return Eigen::Vector2d::Constant(m_head.units.metres);
        }
        const double latitude = taken().box().center().y() * std::numbers::pi / 180.0;
        return {metresInADegree * std::max(0.01, std::cos(latitude)), metresInADegree};
    }

    /// What is read at least, in units of the cloud; the whole plane where that cannot be told.
    Eigen::AlignedBox2d window() const {
        Eigen::AlignedBox2d plane(Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity()),
                                  Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()));
        if (m_window.whole()) {
            return plane;
        }
        const Eigen::AlignedBox2d local = m_window.plan();
        const SitePlace place(m_frame, m_site);
        Eigen::AlignedBox2d box;
        constexpr int steps = 16;
        std::vector<Eigen::Vector2d> places;
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; j <= steps; ++j) {
                const Eigen::Vector2d share(static_cast<double>(i) / steps, static_cast<double>(j) / steps);
                places.push_back(place.planToWorld(local.min() + share.cwiseProduct(local.sizes())));
            }
        }
        if (!toCloud(places)) {
            return plane;
        }
        for (const Eigen::Vector2d& at : places) {
            box.extend(at);
        }
        return box.sizes().allFinite() ? box : plane;
    }

    /// From metres of the case's system to units of the cloud. @return false: there is no way
    bool toCloud(std::vector<Eigen::Vector2d>& places) const {
        const GdalSession session;
        OGRSpatialReference own;
        OGRSpatialReference ofCase;
        if (m_head.units.local() || !setFromText(own, m_head.crs) || !setFromText(ofCase, m_frame.crs)) {
            for (Eigen::Vector2d& place : places) {
                place /= m_head.units.degrees ? std::numeric_limits<double>::quiet_NaN() : m_head.units.metres;
            }
            return !m_head.units.degrees;
        }
        own.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        ofCase.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        own.StripVertical();
        ofCase.StripVertical();
        const std::unique_ptr<OGRCoordinateTransformation> way(OGRCreateCoordinateTransformation(&ofCase, &own));
        const double unit = ofCase.IsProjected() != 0 ? ofCase.GetLinearUnits() : 1.0;
        bool all = way != nullptr;
        for (Eigen::Vector2d& place : places) {
            place /= unit;
            all = all && way->Transform(1, &place.x(), &place.y()) != 0;
        }
        return all;
    }

    CloudGrid emptyGrid() {
        const Eigen::Vector2d perUnit = scale();
        const Aabb& box = taken().box();
        Eigen::AlignedBox2d whole(box.min().head<2>(), box.max().head<2>());
        Eigen::AlignedBox2d inner = window().intersection(whole);
        if (inner.isEmpty()) {
            inner = whole;  // that it lies elsewhere is said where it is brought to the case
        }
        double density = taken().density(inner, perUnit);
        density = density > 0.0 ? density : taken().density(whole, perUnit);
        const auto nodesOf = [&](const Eigen::AlignedBox2d& area, double side) {
            return ((area.sizes().cwiseProduct(perUnit) / side).array() + 2.0).prod();
        };
        double side = density > 0.0 ? std::sqrt(pointsToACell / density) : 1.0;
        side = std::max(side, cellLeast);
        // Two digits, upwards: a spacing is told, and should be the same for a cloud with a few points more.
        const double digit = std::pow(10.0, std::floor(std::log10(side)) - 1.0);
        side = std::ceil(side / digit - 1e-9) * digit;
        while (nodesOf(inner, side) > cloudCellsMost) {
            side *= 1.25;
        }
        // Around the window as much as there is room for.
        Eigen::AlignedBox2d area = inner;
        for (double grown = 0.05; grown < 1e4 && !area.contains(whole); grown *= 1.25) {
            const Eigen::Vector2d margin = grown * inner.sizes();
            const Eigen::AlignedBox2d wider = Eigen::AlignedBox2d(inner.min() - margin, inner.max() + margin).intersection(whole);
            if (nodesOf(wider, side) > cloudCellsMost) {
                break;
            }
            area = wider;
        }
        const Eigen::Vector2d step = Eigen::Vector2d::Constant(side).cwiseQuotient(perUnit);
        const Eigen::Vector2d first = area.min().cwiseQuotient(step).array().floor();
        const Eigen::Vector2d last = area.max().cwiseQuotient(step).array().floor();
        m_side = side;
        return CloudGrid(first.cwiseProduct(step), step, static_cast<std::size_t>(last.x() - first.x()) + 1,
                         static_cast<std::size_t>(last.y() - first.y()) + 1);
    }

    void tellGrid(const CloudGrid& grid) {
        const auto cells = static_cast<double>(grid.columns() * grid.rows());
        const double share = 100.0 * (1.0 - static_cast<double>(grid.covered()) / cells);
        find(
            {"cloud.gridded",
             "{0} points were laid on cells of {1}, {2} to a cell in the median; {3} % of the cells have none",
             {static_cast<std::int64_t>(taken().points()), {m_side, "m"}, static_cast<std::int64_t>(grid.pointsInMedian()), share}},
            "what is smaller than a cell is averaged; a denser cloud gets finer cells");
    }

    void write(const CloudGrid& grid) {
        const GdalSession session;
        m_made.file = std::make_unique<GdalMemoryFile>(".tif");
        const double across = m_head.units.degrees || !m_head.units.local() ? 1.0 : m_head.units.metres;
        const auto columns = static_cast<int>(grid.columns());
        const auto rows = static_cast<int>(grid.rows());
        GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
        const GDALDatasetUniquePtr file(
            driver != nullptr ? driver->Create(m_made.file->name().c_str(), columns, rows, 1, GDT_Float64, nullptr) : nullptr);
        if (!file) {
            failGdal(m_path);
        }
        std::array<double, 6> place{
            across * grid.low().x(),  across * grid.step().x(), 0.0, across * (grid.low().y() + grid.step().y() * rows), 0.0,
            -across * grid.step().y()};
        file->SetGeoTransform(place.data());
        OGRSpatialReference system;
        if (!m_head.units.local() && setFromText(system, m_head.crs)) {
            system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
            file->SetSpatialRef(&system);
        }
        GDALRasterBand* band = file->GetRasterBand(1);
        band->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
        // What was assumed of the unit is among the findings of the cloud.
        band->SetUnitType("metre");
        std::vector<double> heights = grid.heights();
        for (double& height : heights) {
            height *= m_head.units.heightMetres;
        }
        for (int row = 0; row < rows; ++row) {
            double* line = &heights[static_cast<std::size_t>(rows - 1 - row) * grid.columns()];
            if (band->RasterIO(GF_Write, 0, row, columns, 1, line, columns, 1, GDT_Float64, 0, 0, nullptr) != CE_None) {
                failGdal(m_path);
            }
        }
    }

    void find(Message what, std::string_view remedy, std::int64_t count = 1) {
        addFinding(m_made.findings, m_path, std::move(what), remedy, count);
    }

    const std::string& m_path;
    CloudPart m_part;
    const CloudRequest& m_read;
    const Frame& m_frame;
    const Site& m_site;
    const SiteWindow& m_window;
    const Execution& m_execution;
    CloudHead m_head;
    bool m_classes = false;
    bool m_groundAlone = false;
    std::uint64_t m_points = 0;
    std::uint64_t m_plants = 0;
    PointShare m_all;  ///< but vegetation and wires
    PointShare m_ground;
    double m_side = 0.0;  ///< m
    CloudRaster m_made;
};

}  // namespace

CloudRaster cloudRaster(const std::string& path, CloudPart part, const CloudRequest& read, const Frame& frame, const Site& site,
                        const SiteWindow& window, const Execution& execution) {
    return CloudLaying(path, part, read, frame, site, window, execution).lay();
}

}  // namespace rubble::io
