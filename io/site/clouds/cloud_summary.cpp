#include "io/site/clouds/cloud_summary.h"

#include <algorithm>
#include <cmath>

#include "io/base/file_words.h"
#include "io/site/clouds/scans/scanner_check.h"

namespace rubble::io {

namespace {

/// m. Coordinates that are kept less finely are a finding.
constexpr double coarseCoordinates = 0.01;

/// Counts what has few values in a table before it is put into a map.
template <class Value, std::size_t Values>
class ValueCount {
public:
    void add(const std::vector<Value>& column) {
        for (const Value value : column) {
            ++m_counts[std::min<std::size_t>(value, Values - 1)];
        }
    }
    void put(std::map<Value, std::uint64_t>& map) const {
        for (std::size_t v = 0; v < Values; ++v) {
            if (m_counts[v] > 0) {
                map[static_cast<Value>(v)] = m_counts[v];
            }
        }
    }

private:
    std::vector<std::uint64_t> m_counts = std::vector<std::uint64_t>(Values);
};

/// Gathers the summary block by block.
class CloudTally {
public:
    explicit CloudTally(const CloudHead& head) : m_scanners(head) { m_summary.scans.resize(head.scans.size()); }

    void add(const CloudBlock& block) {
        for (const Vec3& place : block.places) {
            m_summary.bounds.extend(place);
        }
        for (const auto intensity : block.intensity) {
            if (std::isfinite(intensity)) {
                m_summary.intensityLeast = m_intensity ? std::min(m_summary.intensityLeast, intensity) : intensity;
                m_summary.intensityMost = m_intensity ? std::max(m_summary.intensityMost, intensity) : intensity;
                m_intensity = true;
            }
        }
        for (const auto& colour : block.colours) {
            m_summary.colourMost = std::max({m_summary.colourMost, colour[0], colour[1], colour[2]});
        }
        for (const std::uint16_t scan : block.scans) {
            ++m_summary.scans[scan];
        }
        for (const double time : block.times) {
            m_timeless += std::isfinite(time) ? 0 : 1;
        }
        m_classes.add(block.classes);
        m_returns.add(block.returns);
        m_scanners.add(block);
    }

    CloudSummary finish(const PointCloud& cloud) {
        m_classes.put(m_summary.classes);
        m_returns.put(m_summary.returns);
        m_summary.fates = cloud.fates();
        if (m_summary.scans.size() == 1 && !cloud.head().columns.scans) {
            m_summary.scans.front() = m_summary.points();
        }
        m_summary.findings = cloud.findings();
        const CloudUnits& units = cloud.head().units;
        if (!units.degrees && !m_summary.bounds.isEmpty()) {
            const Vec3 metres(units.metres, units.metres, units.heightMetres);
            m_summary.metres = Aabb(m_summary.bounds.min().cwiseProduct(metres), m_summary.bounds.max().cwiseProduct(metres));
        }
        judge(cloud.path(), cloud.head());
        return std::move(m_summary);
    }

private:
    void find(const std::string& path, Message what, std::string_view remedy, std::int64_t count = 1) {
        addFinding(m_summary.findings, path, std::move(what), remedy, count);
    }

    void judge(const std::string& path, const CloudHead& head) {
        const double step = head.step * (head.units.degrees ? 0.0 : head.units.metres);
        if (step > coarseCoordinates) {
            find(path, {"cloud.coarse", "the file keeps coordinates to {0} only", {Argument(step, "m")}},
                 "have it written in double precision, or about an origin near the site");
        }
        if (head.columns.colour && head.fullColour > 255.0 && m_summary.colourMost > 0 && m_summary.colourMost <= 255) {
            find(path,
                 {"cloud.colours_of_8_bits",
                  "colours reach {0} of 65,535: they are taken as colours of 8 bits",
                  {int{m_summary.colourMost}}},
                 "none is needed if the picture is as bright as it should be");
        }
        if (m_timeless > 0) {
            find(path, {"cloud.time_no_number", "times of points are no finite numbers", {}},
                 "the points are taken; do not part this cloud by time", m_timeless);
        }
        judgeClasses(path);
        judgePlaces(path, head);
        judgePoses(path, head);
    }

    void judgePoses(const std::string& path, const CloudHead& head) {
        m_summary.posed = m_scanners.posed();
        std::int64_t unknown = 0;
        for (std::size_t s = 0; s < head.scans.size(); ++s) {
            unknown += head.scans[s].pose.stated && !m_summary.posed[s] ? 1 : 0;
        }
        if (unknown > 0) {
            find(path,
                 {"cloud.pose_unknown",
                  "scans state a pose at which no scanner can have stood, by how their points lie about it; it is taken as not "
                  "stated",
                  {}},
                 "name the places of the scanners (rubble-cli cloud --scanner), or export the scans with their poses", unknown);
        }
    }

    void judgeClasses(const std::string& path) {
        std::uint64_t plants = 0;
        for (std::uint16_t kind = 3; kind <= 5; ++kind) {
            const auto found = m_summary.classes.find(kind);
            plants += found != m_summary.classes.end() ? found->second : 0;
        }
        if (plants > 0 && plants == m_summary.points()) {
            find(
                path,
                {"cloud.vegetation_only", "every point is of a class of vegetation: the cloud shows neither ground nor debris", {}},
                "give the cloud with its ground, or without classes if they are wrong");
        }
    }

    void judgePlaces(const std::string& path, const CloudHead& head) {
        const Aabb& box = m_summary.bounds;
        const bool fine = head.scale && head.scale->head<2>().cwiseAbs().maxCoeff() < 1e-5;
        const bool onGlobe =
            !box.isEmpty() && box.min().x() >= -180.0 && box.max().x() <= 180.0 && box.min().y() >= -90.0 && box.max().y() <= 90.0;
        if (head.units.local() && !head.metresByFormat && fine && onGlobe) {
            find(path, {"cloud.perhaps_degrees", "x and y are as small and as fine as degrees are, but are taken as metres", {}},
                 "name the system, such as EPSG:4326, if they are degrees");
        }
    }

    CloudSummary m_summary;
    ScannerCheck m_scanners;
    ValueCount<std::uint16_t, 65'536> m_classes;
    ValueCount<std::uint8_t, 256> m_returns;
    std::int64_t m_timeless = 0;
    bool m_intensity = false;
};

}  // namespace

CloudSummary summariseCloud(PointCloud& cloud, const Execution& execution, const std::function<void(const CloudBlock&)>& visit) {
    CloudTally tally(cloud.head());
    CloudBlock block;
    while (cloud.next(block, execution)) {
        tally.add(block);
        if (visit) {
            visit(block);
        }
        execution.report({"cloud.reading", "Reading the points", {}}, cloud.fraction());
    }
    return tally.finish(cloud);
}

}  // namespace rubble::io
