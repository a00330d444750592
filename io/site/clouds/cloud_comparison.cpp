#include "io/site/clouds/cloud_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include "core/base/outline_cover.h"
#include "core/base/unknown.h"
#include "core/scenario/scope_cover.h"
#include "io/base/file_words.h"
#include "io/site/clouds/cloud_summary.h"
#include "io/site/clouds/cloud_system.h"
#include "io/site/point_pairs.h"

namespace rubble::io {

namespace {

/// Parts of the box of the cores that points are counted in before strips are cut.
constexpr std::size_t countedParts = 4096;

/// Cores between two places along the longest side of their box.
struct CoreStrip {
    double low = 0.0;
    double high = 0.0;
};

class CloudComparing {
public:
    /// @param given  core points, instead of those of a cloud; empty: none
    CloudComparing(const CloudComparisonRequest& request, const Execution& execution, std::vector<Vec3> given = {})
        : m_request(request), m_execution(execution), m_given(std::move(given)) {}

    CloudComparison compare() {
        open(m_request.first, m_made.first, "");
        open(m_request.second, m_made.second, m_made.first.head.crs);
        checkUnits(m_made.first);
        checkUnits(m_made.second);
        if (!sameSystem(m_made.first.head.crs, m_made.second.head.crs)) {
            refuseContent({"distance.other_system",
                           "{0} is in \"{1}\", {2} in \"{3}\"",
                           {m_request.first, m_made.first.head.units.name, m_request.second, m_made.second.head.units.name}},
                          "Bring both to one system, such as the UTM zone of the place.");
        }
        takeUnit();
        if (!m_request.pairs.empty()) {
            placeByPairs();
        }
        if (m_request.stable) {
            fit();
        }
        m_settings = settingsAfterFit(m_made, m_request.settings);
        readCores();
        measure();
        judgeDistances(m_made, m_settings);
        if (m_request.cell > 0.0) {
            takeVolumes();
        }
        return std::move(m_made);
    }

private:
    std::unique_ptr<PointCloud> opened(const std::string& path, const std::string& crs) const {
        CloudRequest read = m_request.read;
        auto cloud = openCloud(path, read);
        if (cloud->head().units.local() && !crs.empty()) {
            read.crs = crs;
            cloud = openCloud(path, read);
        }
        return cloud;
    }

    /// @param crs  taken where the cloud names none itself
    void open(const std::string& path, ComparedCloud& taken, const std::string& crs) {
        taken.path = path;
        taken.head = opened(path, crs)->head();
        if (taken.head.crsFrom == "asked for" && m_request.read.crs.empty()) {
            find(path, {"distance.system_taken", "the file names no coordinate system; that of the first cloud is taken", {}},
                 "make sure that both are in the same one");
        }
    }

    void checkUnits(const ComparedCloud& cloud) {
        if (cloud.head.units.degrees || cloud.head.units.geocentric) {
            refuseContent({"distance.degrees",
                           "{0} has no eastings and northings (\"{1}\"): distances would have no meaning",
                           {cloud.path, cloud.head.units.name}},
                          "Bring it to a projected system, such as the UTM zone of the place.");
        }
    }

    void takeUnit() {
        const CloudUnits& units = m_made.first.head.units;
        m_made.metresStated = units.metresStated && units.heightStated;
        m_made.unit = m_request.metres ? 1.0 : units.metres;
        if (m_request.metres) {
            m_unit = Vec3(units.metres, units.metres, units.heightMetres);
        } else if (std::abs(units.metres - units.heightMetres) > 1e-9) {
            m_made.unit = unknown;
            find(m_request.first,
                 {"distance.mixed_units",
                  "a unit of x and y is {0}, one of z {1}: distances in the numbers of the file are lengths of neither",
                  {{units.metres, "m"}, {units.heightMetres, "m"}}},
                 "ask for metres (rubble-cli cloud --metres), and give all lengths in them");
        } else if (units.metres != 1.0) {
            find(m_request.first, {"distance.in_units", "all lengths are in units of the file, each {0}", {{units.metres, "m"}}},
                 "ask for metres (rubble-cli cloud --metres), and give all lengths in them");
        }
    }

    /// Hands over each block of a cloud, in the unit of the comparison. @param tell  what was found is kept
    template <class Visit>
    CloudSummary read(const std::string& path, const std::string& crs, bool tell, const Visit& visit) {
        const std::unique_ptr<PointCloud> cloud = opened(path, crs);
        std::vector<Vec3> places;
        CloudSummary summary = summariseCloud(*cloud, m_execution, [&](const CloudBlock& block) {
            places = block.places;
            if (m_request.metres) {
                for (Vec3& place : places) {
                    place = place.cwiseProduct(m_unit);
                }
            }
            if (m_made.placed && path == m_request.second) {
                const Registration& placed = *m_made.placed;
                const Mat3 turn = placed.rotation();
                for (Vec3& place : places) {
                    place = placed.about + placed.shift + turn * (place - placed.about);
                }
            }
            if (m_made.fit && path == m_request.second) {
                for (Vec3& place : places) {
                    place = (*m_made.fit)(place);
                }
            }
            visit(places);
        });
        if (tell) {
            m_made.findings.append(summary.findings);
        }
        return summary;
    }

    /// Moves the second cloud by places that were found in both, as surveys of a case are.
    void placeByPairs() {
        PlacePairTable table = readPlacePairs(m_request.pairs);
        if (table.metres) {
            refuseContent({"pairs.of_case", "{0} has places in the system of a case, and there is none", {m_request.pairs}},
                          "Give the columns survey_x, survey_y and survey_z in numbers of the second cloud.");
        }
        std::vector<PlacePair>& pairs = table.pairs;
        for (PlacePair& pair : pairs) {
            if (m_request.metres) {
                pair.surveyed = pair.surveyed.cwiseProduct(m_unit);
                pair.placed = pair.placed.cwiseProduct(m_unit);
            }
            pair.deviation = pair.deviation ? pair.deviation : m_request.control;
            if (pair.deviation && m_request.metres) {
                *pair.deviation *= m_unit.maxCoeff();
            }
        }
        const PairFit fit = fitPairs(pairs, {});
        m_made.placed = fit.registration;
        m_made.findings.append(fit.findings);
    }

    /// Points of a cloud where nothing moved, about an origin near them.
    std::vector<Vec3> stablePoints(const std::string& path, const std::string& crs, std::optional<Vec3>& origin) {
        std::vector<Vec3> taken;
        CubeThinning thinning(0.25 * m_request.settings.normalRadius);
        read(path, crs, false, [&](const std::vector<Vec3>& places) {
            for (const Vec3& place : places) {
                const bool counts = m_request.stable->empty() || covers(*m_request.stable, place.head<2>());
                if (counts && thinning.takes(place)) {
                    if (!origin) {
                        origin = place.array().round();
                    }
                    taken.push_back(place - *origin);
                }
            }
        });
        return taken;
    }

    void fit() {
        std::optional<Vec3> origin;
        const PointIndex first(stablePoints(m_made.first.path, "", origin), m_request.settings.projectionRadius);
        const std::vector<Vec3> second = stablePoints(m_made.second.path, m_made.first.head.crs, origin);
        CloudFitSettings settings;
        settings.radius = m_request.settings.normalRadius;
        CloudFit made = fitCloud(first, second, settings, m_execution);
        made.about += origin.value_or(Vec3::Zero());
        m_made.fit = made;
    }

    void addCore(const Vec3& place) {
        if (!covers(m_request.scope, place.head<2>())) {
            ++m_made.beyond;
            return;
        }
        checkCores(m_made.cores.size() + 1);
        m_made.cores.push_back(place);
        m_box.extend(place);
    }

    void readCores() {
        m_made.coresFrom = m_request.cores;
        if (!m_given.empty()) {
            std::for_each(m_given.begin(), m_given.end(), [&](const Vec3& place) { addCore(place); });
        } else if (m_request.cores.empty()) {
            CubeThinning thinning(m_request.settings.projectionRadius);
            read(m_request.first, "", false, [&](const std::vector<Vec3>& places) {
                for (const Vec3& place : places) {
                    if (thinning.takes(place)) {
                        addCore(place);
                    }
                }
            });
        } else {
            const auto add = [&](const std::vector<Vec3>& places) {
                std::for_each(places.begin(), places.end(), [&](const Vec3& place) { addCore(place); });
            };
            read(m_request.cores, m_made.first.head.crs, true, add);
        }
        const std::string& path = m_request.cores.empty() ? m_request.first : m_request.cores;
        addBeyond(m_made.findings, path, m_made.beyond);
        if (m_made.cores.empty() && m_made.beyond > 0) {
            refuseContent({"distance.all_beyond",
                           "None of {0} core points of {1} lies within the area of interest and outside of what is left out",
                           {m_made.beyond, path}},
                          "Check the coordinate systems of the polygons and of the cloud.");
        }
        if (m_made.cores.empty()) {
            refuseContent({"distance.no_cores", "{0} has no point to measure at", {path}}, "Give a cloud with points.");
        }
        m_origin = m_box.center().array().round();
        m_box.sizes().maxCoeff(&m_axis);
    }

    /// How far points count from a core.
    double reach() const {
        const CloudDistanceSettings& settings = m_request.settings;
        return std::max(settings.normalRadius, std::hypot(settings.projectionRadius, settings.depth)) * (1.0 + 1e-9);
    }

    bool isNear(const Vec3& place) const {
        return ((place - m_box.min()).array() >= -reach()).all() && ((m_box.max() - place).array() >= -reach()).all();
    }

    /// Counts what lies near the cores, along their longest side.
    std::vector<std::uint64_t> countNear() {
        std::vector<std::uint64_t> counts(countedParts);
        const double low = m_box.min()[m_axis] - reach();
        const double share = static_cast<double>(countedParts) / (m_box.sizes()[m_axis] + 2.0 * reach());
        const auto countOf = [&](ComparedCloud& cloud, const std::string& crs) {
            Aabb all;
            const CloudSummary summary = read(cloud.path, crs, true, [&](const std::vector<Vec3>& places) {
                for (const Vec3& place : places) {
                    all.extend(place);
                    if (isNear(place)) {
                        ++cloud.near;
                        ++counts[std::min(countedParts - 1, static_cast<std::size_t>((place[m_axis] - low) * share))];
                    }
                }
            });
            cloud.points = summary.points();
            checkMeeting(cloud, all);
        };
        countOf(m_made.first, "");
        countOf(m_made.second, m_made.first.head.crs);
        return counts;
    }

    void checkMeeting(const ComparedCloud& cloud, const Aabb& all) const {
        if (cloud.points == 0) {
            refuseContent({"distance.empty", "{0} has no point that counts", {cloud.path}}, "Give a cloud with points.");
        }
        if (cloud.near == 0) {
            const double apart = all.exteriorDistance(m_box);
            refuseContent({"distance.elsewhere", "{0} lies {1} units away from the core points", {cloud.path, apart}},
                          "Check the coordinate systems, or give clouds of one site.");
        }
    }

    /// Strips of cores, the points that may count for each of which fit into memory; a strip is at least as wide as points reach.
    std::vector<CoreStrip> strips(const std::vector<std::uint64_t>& counts) const {
        const double low = m_box.min()[m_axis] - reach();
        const double width = (m_box.sizes()[m_axis] + 2.0 * reach()) / static_cast<double>(countedParts);
        const auto around = static_cast<std::size_t>(std::ceil(reach() / width)) + 1;
        std::vector<CoreStrip> cut{{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};
        std::vector<std::uint64_t> until(countedParts + 1);
        std::partial_sum(counts.begin(), counts.end(), until.begin() + 1);
        std::size_t first = 0;
        for (std::size_t part = 1; part < countedParts; ++part) {
            const std::size_t from = first > around ? first - around : 0;
            const std::size_t to = std::min(countedParts, part + 1 + around);
            if (until[to] - until[from] > m_request.heldPoints && part - first >= around) {
                cut.back().high = low + static_cast<double>(part) * width;
                cut.push_back({cut.back().high, std::numeric_limits<double>::infinity()});
                first = part;
            }
        }
        return cut;
    }

    std::vector<Vec3> held(const ComparedCloud& cloud, const std::string& crs, const CoreStrip& strip) {
        std::vector<Vec3> places;
        read(cloud.path, crs, false, [&](const std::vector<Vec3>& block) {
            for (const Vec3& place : block) {
                if (isNear(place) && place[m_axis] >= strip.low - reach() && place[m_axis] <= strip.high + reach()) {
                    places.push_back(place - m_origin);
                }
            }
        });
        return places;
    }

    void measure() {
        const std::vector<CoreStrip> cut = strips(countNear());
        m_made.distances.resize(m_made.cores.size());
        for (const CoreStrip& strip : cut) {
            std::vector<std::size_t> which;
            std::vector<Vec3> cores;
            for (std::size_t k = 0; k < m_made.cores.size(); ++k) {
                const double at = m_made.cores[k][m_axis];
                if (at >= strip.low && at < strip.high) {
                    which.push_back(k);
                    cores.push_back(m_made.cores[k] - m_origin);
                }
            }
            if (which.empty()) {
                continue;
            }
            std::vector<Vec3> firstPlaces = held(m_made.first, "", strip);
            std::vector<Vec3> secondPlaces = held(m_made.second, m_made.first.head.crs, strip);
            const double radius = m_request.settings.projectionRadius;
            const auto indexOf = [radius](std::vector<Vec3>& places) {
                // Files go line by line, which is near from point to point, but not from line to line.
                orderByCubes(places, radius);
                return PointIndex(std::move(places), radius);
            };
            std::future<PointIndex> building = std::async(std::launch::async, [&] { return indexOf(secondPlaces); });
            const PointIndex first = indexOf(firstPlaces);
            const PointIndex second = building.get();
            const std::vector<std::uint32_t> before = orderByCubes(cores, radius);
            const std::vector<CoreDistance> made = cloudDistances(cores, first, second, m_settings, m_execution);
            for (std::size_t k = 0; k < which.size(); ++k) {
                m_made.distances[which[before[k]]] = made[k];
            }
            ++m_made.parts;
        }
    }

    /// A core at the middle of each cell that a cloud has points in, as high as those of the first are in the mean.
    std::vector<Vec3> middlesOfCells() {
        CellMiddles middles(m_request.cell);
        const auto add = [&](const ComparedCloud& cloud, const std::string& crs, std::size_t which) {
            read(cloud.path, crs, false, [&](const std::vector<Vec3>& places) { middles.add(places, which); });
        };
        add(m_made.first, "", 0);
        add(m_made.second, m_made.first.head.crs, 1);
        std::vector<Vec3> places = middles.places();
        std::erase_if(places, [&](const Vec3& place) { return !covers(m_request.scope, place.head<2>()); });
        return places;
    }

    /// Straight up at each cell, in a cylinder of its area.
    void takeVolumes() {
        CloudComparisonRequest cells = m_request;
        cells.cell = 0.0;
        cells.stable.reset();
        cells.pairs.clear();
        cells.settings = volumeSettings(m_settings, m_request.cell);
        std::vector<CoreDistance> measured;
        // An area of interest narrower than a cell may hold the middle of none.
        if (std::vector<Vec3> middles = middlesOfCells(); !middles.empty()) {
            CloudComparing comparing(cells, m_execution, std::move(middles));
            comparing.m_made.placed = m_made.placed;
            comparing.m_made.fit = m_made.fit;
            measured = comparing.compare().distances;
        }
        m_made.volumes = cloudVolumes(measured, m_request.cell, m_settings.registrationError);
        const CloudUnits& units = m_made.first.head.units;
        m_made.cubicMetres = m_request.metres ? 1.0 : units.metres * units.metres * units.heightMetres;
        addCellsLeft(m_made);
    }

    void find(Message what, std::string_view remedy, std::int64_t count = 1) { find("", std::move(what), remedy, count); }
    void find(const std::string& path, Message what, std::string_view remedy, std::int64_t count = 1) {
        if (count > 0) {
            addFinding(m_made.findings, path, std::move(what), remedy, count);
        }
    }

    const CloudComparisonRequest& m_request;
    const Execution& m_execution;
    std::vector<Vec3> m_given;
    CloudComparison m_made;
    CloudDistanceSettings m_settings;
    Vec3 m_unit = Vec3::Ones();
    Aabb m_box;  ///< of the cores
    Vec3 m_origin = Vec3::Zero();
    Eigen::Index m_axis = 0;
};

}  // namespace

void addBeyond(Findings& findings, const std::string& path, std::uint64_t points) {
    if (points > 0) {
        addFinding(findings, path,
                   {"distance.beyond", "points beyond the area of interest, or within what is left out, were not compared", {}},
                   "none is needed", static_cast<std::int64_t>(points));
    }
}

void checkCores(std::size_t count) {
    if (count > coresMost) {
        throw UsageError({"distance.cores", "There are more than {0} core points", {coresMost}},
                         {"distance.cores.remedy", "Give a file with fewer of them, or a greater projection radius.", {}});
    }
}

void CellMiddles::add(const std::vector<Vec3>& places, std::size_t which) {
    for (const Vec3& place : places) {
        Cell& cell = m_cells[{std::llround(std::floor(place.x() / m_side)), std::llround(std::floor(place.y() / m_side))}];
        cell.sums[which] += place.z();
        ++cell.counts[which];
    }
    checkCores(m_cells.size());
}

std::vector<Vec3> CellMiddles::places() const {
    std::vector<Vec3> middles;
    for (const auto& [at, cell] : m_cells) {
        const std::size_t which = cell.counts[0] > 0 ? 0 : 1;
        middles.emplace_back((static_cast<double>(at.first) + 0.5) * m_side, (static_cast<double>(at.second) + 0.5) * m_side,
                             cell.sums[which] / cell.counts[which]);
    }
    return middles;
}

CloudDistanceSettings volumeSettings(CloudDistanceSettings settings, double cell) {
    settings.upwards = true;
    settings.projectionRadius = cell / std::sqrt(std::numbers::pi);
    return settings;
}

void addCellsLeft(CloudComparison& made) {
    const std::int64_t left = made.volumes->cells - made.volumes->measured;
    if (left > 0) {
        addFinding(made.findings, "",
                   {"distance.cells_left",
                    "cells are in no volume: a cloud has fewer than {0} points there within the depth",
                    {std::size_t{roughnessPoints}}},
                   "give greater cells or a greater depth; the clouds may end or have holes there", left);
    }
}

void addFitFindings(Findings& findings, const CloudFit& fit, double radius) {
    if (fit.cube > radius) {
        addFinding(
            findings, "",
            {"fit.thinned", "what did not move has too many points for a fit: one to each cube of side {0} was taken", {fit.cube}},
            "none is needed: they lie everywhere; name a smaller area to fit every part of it");
    }
    if (!fit.settled) {
        addFinding(findings, "", {"fit.not_settled", "the fit had not settled after {0} rounds", {std::int64_t{fit.rounds}}},
                   "give a greater normal scale, or clouds that lie nearer to each other");
    }
}

CloudDistanceSettings settingsAfterFit(CloudComparison& made, const CloudDistanceSettings& settings) {
    made.settings = settings;
    if (!made.fit && made.placed && !settings.registrationError) {
        made.settings.registrationError = made.placed->error;
    }
    if (!made.fit) {
        return made.settings;
    }
    const CloudFit& fit = *made.fit;
    const auto find = [&](Message what, std::string_view remedy) { addFinding(made.findings, "", std::move(what), remedy); };
    if (!settings.registrationError) {
        made.settings.registrationError = fit.error;
    } else if (*settings.registrationError < fit.error) {
        find({"fit.better_stated",
              "the stated registration error, {0}, is less than that of the fit, {1}; the stated one was taken",
              {*settings.registrationError, fit.error}},
             "leave it out, unless control points tell it better than the fit");
    }
    addFitFindings(made.findings, fit, settings.normalRadius);
    return made.settings;
}

void judgeDistances(CloudComparison& made, const CloudDistanceSettings& settings) {
    const auto find = [&](Message what, std::string_view remedy, std::int64_t count) {
        if (count > 0) {
            addFinding(made.findings, "", std::move(what), remedy, count);
        }
    };
    std::array<std::int64_t, coreStateCount> states{};
    std::int64_t few = 0;
    std::int64_t deep = 0;
    for (const CoreDistance& core : made.distances) {
        ++states[static_cast<std::size_t>(core.state)];
        const bool measured = core.state == CoreState::Measured;
        few += measured && std::isnan(core.detection) ? 1 : 0;
        const auto cut = [&](const CoreSide& side) { return std::abs(side.mean) + side.roughness > settings.depth; };
        deep += measured && (cut(core.first) || cut(core.second)) ? 1 : 0;
    }
    const auto count = [&](CoreState state) { return states[static_cast<std::size_t>(state)]; };
    find({"distance.no_normal", "core points have no normal: fewer than three points of the first cloud lie about them", {}},
         "give a greater normal scale, or cores on the first cloud", count(CoreState::NoNormal));
    find({"distance.no_first", "core points have no distance: no point of the first cloud lies in their cylinder", {}},
         "give cores on the first cloud, or a greater projection scale", count(CoreState::NoFirst));
    const std::int64_t unseen = count(CoreState::NoSecond);
    if (made.againstRun) {
        find({"distance.not_seen",
              "core points have no distance: the scan would not have seen the simulated site within the depth",
              {}},
             "give a greater depth if the surfaces are farther apart; else something simulated hides the place", unseen);
    } else {
        find({"distance.no_second", "core points have no distance: no point of the second cloud lies in their cylinder", {}},
             "give a greater depth if the surface moved farther; else the second cloud has a hole there", unseen);
    }
    find({"distance.no_point", "core points have no distance: no point of either cloud lies in their cylinder", {}},
         "give cores on the first cloud, or a greater projection scale", count(CoreState::NoPoint));
    find({"distance.few_points",
          "distances have no level of detection: fewer than {0} points of a cloud lie in their cylinder",
          {std::size_t{roughnessPoints}}},
         "give a greater projection scale; these distances are not called significant", few);
    find({"distance.deep", "distances may be too short: a surface in the cylinder reaches its end", {}}, "give a greater depth",
         deep);
    if (!settings.registrationError) {
        find({"distance.registration_unknown",
              "nobody stated how well one cloud lies against the other: the level of detection holds their roughness alone",
              {}},
             "state the registration error (--registration-error), 0 only if it is known to be none", 1);
    }
}

CloudComparison compareClouds(const CloudComparisonRequest& request, const Execution& execution) {
    return CloudComparing(request, execution).compare();
}

}  // namespace rubble::io
