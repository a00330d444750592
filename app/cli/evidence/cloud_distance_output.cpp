#include "app/cli/evidence/cloud_distance_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/cli/evidence/scanned_site.h"
#include "app/cli/frame/text_output.h"
#include "core/base/csv_text.h"
#include "core/base/message.h"
#include "core/base/unknown.h"
#include "io/site/clouds/distance_files.h"

namespace rubble::cli {

namespace {

constexpr std::array<const char*, 3> sightsNames{"cloud", "asked", "above"};

/// What all measured distances are together.
struct DistanceTotals {
    std::array<std::int64_t, coreStateCount> states{};
    std::int64_t detectable = 0;  ///< with a level of detection
    std::int64_t significant = 0;
    double mean = unknown;
    double median = unknown;
    double least = unknown;
    double most = unknown;
    double deviation = unknown;
    double detection = unknown;  ///< median of the levels
};

double middleOf(std::vector<double> values) {
    if (values.empty()) {
        return unknown;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

DistanceTotals totalsOf(const io::CloudComparison& made) {
    DistanceTotals totals;
    std::vector<double> distances;
    for (const CoreDistance& core : made.distances) {
        ++totals.states[static_cast<std::size_t>(core.state)];
        if (core.state == CoreState::Measured) {
            distances.push_back(core.distance);
        }
        if (!std::isnan(core.detection)) {
            ++totals.detectable;
            totals.significant += core.significant() ? 1 : 0;
        }
    }
    totals.detection = middleDetection(made.distances);
    if (distances.empty()) {
        return totals;
    }
    double sum = 0.0;
    for (const double distance : distances) {
        sum += distance;
    }
    totals.mean = sum / static_cast<double>(distances.size());
    double squares = 0.0;
    for (const double distance : distances) {
        squares += (distance - totals.mean) * (distance - totals.mean);
    }
    totals.deviation = std::sqrt(squares / static_cast<double>(distances.size()));
    const auto [least, most] = std::minmax_element(distances.begin(), distances.end());
    totals.least = *least;
    totals.most = *most;
    totals.median = middleOf(std::move(distances));
    return totals;
}

Json known(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Json comparedJson(const io::ComparedCloud& cloud) {
    return {{"path", cloud.path},
            {"format", cloud.head.format},
            {"system", cloud.head.units.local() ? Json() : Json(cloud.head.units.name)},
            {"points", cloud.points},
            {"points_near", cloud.near}};
}

constexpr double degreesOfRadian = 180.0 / std::numbers::pi;

Json fitJson(const CloudFit& fit) {
    const auto three = [](const Vec3& of, double by) { return Json{by * of.x(), by * of.y(), by * of.z()}; };
    const Eigen::AngleAxisd turn(fit.turn);
    return {{"shift", three(fit.shift, 1.0)},
            {"turn_deg", three(turn.axis(), degreesOfRadian * turn.angle())},
            {"about", three(fit.about, 1.0)},
            {"cube", fit.cube},
            {"pairs", fit.pairs},
            {"rounds", fit.rounds},
            {"settled", fit.settled},
            {"rms_before", fit.before},
            {"rms_after", fit.after},
            {"shift_errors", three(fit.shiftError, 1.0)},
            {"turn_errors_deg", three(fit.turnError, degreesOfRadian)},
            {"unevenness", fit.unevenness},
            {"error", fit.error}};
}

/// Lengths are in the unit of the comparison.
Json pairsJson(const Registration& placed) {
    const auto three = [](const Vec3& of, double by) { return Json{by * of.x(), by * of.y(), by * of.z()}; };
    return {{"shift", three(placed.shift, 1.0)},
            {"turn_deg", three(placed.turn, degreesOfRadian)},
            {"about", three(placed.about, 1.0)},
            {"pairs", placed.pairs},
            {"rms", placed.pairsLeft},
            {"control_error", placed.control ? Json(*placed.control) : Json()},
            {"error", placed.error ? Json(*placed.error) : Json()}};
}

std::string fitText(const CloudFit& fit) {
    return "fitted to what did not move: shifted by " + englishNumber(fit.distance()) + ", turned by " +
           englishNumber(degreesOfRadian * fit.angle()) + " degrees; RMS " + englishNumber(fit.before) + " before, " +
           englishNumber(fit.after) + " after, error " + englishNumber(fit.error);
}

Json volumesJson(const CloudVolumes& volumes, double cube) {
    const auto error = [&](const CloudVolumeError& of) { return Json{known(cube * of.random), known(cube * of.systematic)}; };
    return {{"cell", volumes.cell},
            {"cells", volumes.cells},
            {"cells_measured", volumes.measured},
            {"cells_fill", volumes.fillCells},
            {"cells_cut", volumes.cutCells},
            {"fill_m3", known(cube * volumes.fill)},
            {"cut_m3", known(cube * volumes.cut)},
            {"net_m3", known(cube * volumes.net())},
            {"not_detected_m3", known(cube * volumes.undetected())},
            {"not_detected_fill_m3", known(cube * volumes.undetectedFill)},
            {"not_detected_cut_m3", known(cube * volumes.undetectedCut)},
            {"fill_errors_m3", error(volumes.fillError)},
            {"cut_errors_m3", error(volumes.cutError)},
            {"net_errors_m3", error(volumes.netError)}};
}

/// "12.5 m3 (+- 0.3 random, +- not known systematic)"
std::string cubeText(double volume, const CloudVolumeError& error, double cube) {
    const auto text = [&](double part) { return std::isfinite(part) ? englishNumber(cube * part) : std::string("not known"); };
    return englishNumber(cube * volume) + " m3 (+- " + text(error.random) + " random, +- " + text(error.systematic) +
           " systematic)";
}

std::string unitOf(const io::CloudComparison& made) {
    if (std::isnan(made.unit)) {
        return " (numbers of the file, of mixed units)";
    }
    if (made.unit == 1.0) {
        return made.metresStated ? " m" : " m (assumed)";
    }
    return " units of " + exactNumber(made.unit) + " m";
}

std::string cloudText(const io::ComparedCloud& cloud) {
    return cloud.path + ", " + englishInteger(static_cast<std::int64_t>(cloud.points)) + " points, " +
           englishInteger(static_cast<std::int64_t>(cloud.near)) + " of them near the cores";
}

FactList distanceFacts(const io::CloudComparison& made, const CloudDistanceSettings& settings) {
    const DistanceTotals totals = totalsOf(made);
    const std::string unit = unitOf(made);
    FactList facts;
    facts.add("from", cloudText(made.first));
    facts.add("to", made.againstRun ? made.second.path + ", " + englishInteger(static_cast<std::int64_t>(made.second.points)) +
                                          " points seen of it alike"
                                    : cloudText(made.second));
    facts.add("core points", englishInteger(static_cast<std::int64_t>(made.cores.size())) + " of " +
                                 (made.coresFrom.empty() ? "the first cloud, thinned" : made.coresFrom));
    facts.add("scales", "normal " + englishNumber(settings.normalRadius) + ", projection " +
                            englishNumber(settings.projectionRadius) + ", depth " + englishNumber(settings.depth) + unit);
    if (made.placed) {
        facts.add("placed by",
                  counted(made.placed->pairs, "pair", "pairs") + ", RMS " + englishNumber(made.placed->pairsLeft) + ", error " +
                      (made.placed->error ? englishNumber(*made.placed->error) + unit : std::string("not known")) +
                      (made.placed->control ? ", of which the points themselves " + englishNumber(*made.placed->control) + unit
                                            : "; how accurate the points are nobody stated: it is not in it"));
    }
    if (made.fit) {
        facts.add("registration", fitText(*made.fit) + unit);
    }
    const auto& registration = made.settings.registrationError;
    facts.add("registration error", registration ? englishNumber(*registration) + unit : "not known: nobody stated it");
    facts.add("measured",
              englishInteger(totals.states[0]) + ", " + englishInteger(totals.detectable) + " of them with a level of detection");
    if (totals.states[0] > 0) {
        facts.add("distance", "median " + englishNumber(totals.median) + ", mean " + englishNumber(totals.mean) + ", deviation " +
                                  englishNumber(totals.deviation) + ", " + englishNumber(totals.least) + " to " +
                                  englishNumber(totals.most) + unit);
    }
    if (totals.detectable > 0) {
        facts.add("level of detection",
                  "median " + englishNumber(totals.detection) + unit + (registration ? "" : ", of roughness alone") + " (95 %)");
        facts.add("significant", englishInteger(totals.significant) + " of " + englishInteger(totals.detectable));
    }
    if (made.volumes) {
        const CloudVolumes& volumes = *made.volumes;
        const auto cubes = [&](double volume) { return englishNumber(made.cubicMetres * volume); };
        if (volumes.measured == 0) {
            facts.add("volumes", "not known: no cell was measured");
        } else {
            facts.add("volumes", "fill " + cubeText(volumes.fill, volumes.fillError, made.cubicMetres) + ", cut " +
                                     cubeText(volumes.cut, volumes.cutError, made.cubicMetres) + ", net " +
                                     cubeText(volumes.net(), volumes.netError, made.cubicMetres));
            facts.add("not counted", "fill " + cubes(volumes.undetectedFill) + ", cut " + cubes(volumes.undetectedCut) + ", net " +
                                         cubes(volumes.undetectedNet()) + " m3 also lie below the level of detection");
        }
        facts.add("volume cells", englishInteger(volumes.measured) + " of " + englishInteger(volumes.cells) + " measured");
    }
    return facts;
}

}  // namespace

Json cloudDistanceJson(const io::CloudComparison& made, const CloudDistanceSettings& settings) {
    const DistanceTotals totals = totalsOf(made);
    Json object;
    object["first"] = comparedJson(made.first);
    object["second"] = comparedJson(made.second);
    object["cores"] = {{"path", made.coresFrom.empty() ? Json() : Json(made.coresFrom)}, {"points", made.cores.size()}};
    object["unit_m"] = known(made.unit);
    object["unit_stated"] = made.metresStated;
    object["normal_scale"] = settings.normalRadius;
    object["projection_scale"] = settings.projectionRadius;
    object["depth"] = settings.depth;
    const std::optional<double>& error = made.settings.registrationError;
    object["registration_error"] = error ? Json(*error) : Json();
    object["placed"] = made.placed ? pairsJson(*made.placed) : Json();
    object["registration"] = made.fit ? fitJson(*made.fit) : Json();
    object["distance"] = {{"mean", known(totals.mean)},
                          {"median", known(totals.median)},
                          {"deviation", known(totals.deviation)},
                          {"least", known(totals.least)},
                          {"most", known(totals.most)}};
    object["level_of_detection_median"] = known(totals.detection);
    object["significant"] = totals.significant;
    object["with_level_of_detection"] = totals.detectable;
    Json states;
    for (std::size_t s = 0; s < coreStateCount; ++s) {
        states[io::coreStateNames[s]] = totals.states[s];
    }
    object["states"] = std::move(states);
    object["cores_beyond"] = made.beyond;
    object["parts"] = made.parts;
    object["volumes"] = made.volumes ? volumesJson(*made.volumes, made.cubicMetres) : Json();
    object["warnings"] = findingsJson(made.findings);
    return object;
}

void printCloudDistance(std::ostream& out, const io::CloudComparison& made, const CloudDistanceSettings& settings) {
    printHeading(out, "Distance between two clouds");
    distanceFacts(made, settings).print(out);
    printFindings(out, made.findings);
}

Json runDistanceJson(const io::RunDistance& made, const CloudDistanceSettings& settings) {
    Json object = cloudDistanceJson(made.compared, settings);
    object["time_s"] = made.time;
    object["seen_from"] = sightsNames[static_cast<std::size_t>(made.sights)];
    object["scanners"] = made.scanners;
    object["points_compared"] = made.taken;
    object["points_of_plants"] = made.plants;
    object["points_beyond"] = made.beyond;
    object["one_point_in"] = made.stride;
    object["debris"] = sightedJson(made.debris);
    return object;
}

void printRunDistance(std::ostream& out, const io::RunDistance& made, const CloudDistanceSettings& settings) {
    printHeading(out, "Distance from a cloud to a run");
    FactList facts = distanceFacts(made.compared, settings);
    facts.add("time", englishNumber(made.time) + " s");
    facts.add("seen from", made.sights == io::SightsFrom::Above
                               ? std::string("straight above: where the scanners stood is not known")
                               : englishInteger(static_cast<std::int64_t>(made.scanners)) + " scanners, " +
                                     (made.sights == io::SightsFrom::Cloud ? "as the cloud says" : "as asked for"));
    facts.add("simulated debris", sightedText(made.debris));
    facts.print(out);
}

}  // namespace rubble::cli
