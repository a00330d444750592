#include "core/analysis/accuracy/prediction.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/analysis/accuracy/interval_fit.h"
#include "core/base/unknown.h"
#include "core/scenario/parameters.h"

namespace rubble {

namespace {

constexpr std::size_t pointsLeast = 4;
/// How far beyond the measured range of a number anything is said.
constexpr double beyond = 1.6;
/// Scatter that is likely before any point is seen, as a share. Settled on the sweeps of both arches (bench/RESULTS.md).
constexpr double likelyScatter = 0.06;
/// What a measure of 0 counts as: logarithms need something.
constexpr double smallest = 1e-6;

bool ofTime(Predicted what) {
    return what == Predicted::WallSeconds || what == Predicted::StepMeanMs || what == Predicted::Fps;
}

bool likeness(Predicted what) {
    return what == Predicted::CoreIou || what == Predicted::FootprintIou;
}

/// Logarithm of what is never negative: a cost, a departure from the reference.
double toLog(Predicted what, double value) {
    return std::log(std::max(smallest, likeness(what) ? 1.0 - value : std::abs(value)));
}

double fromLog(Predicted what, double logarithm) {
    const double value = std::exp(logarithm);
    return likeness(what) ? std::max(0.0, 1.0 - value) : value;
}

std::optional<double> positiveNumber(const ParameterValue& value) {
    double number = 0.0;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        number = static_cast<double>(*whole);
    } else if (const auto* real = std::get_if<double>(&value)) {
        number = *real;
    }
    return number > 0.0 ? std::optional(number) : std::nullopt;
}

/// The value of a parameter at a point: what it was set to, else the default; unset if it is no number above zero.
std::optional<double> numberAt(const KnownPoint& point, const std::string& key) {
    static const Scenario defaults;
    const auto set = point.parameters.find(key);
    if (set == point.parameters.end()) {
        return positiveNumber(parameterValue(defaults, key));
    }
    Scenario scenario;
    setParameterText(scenario, key, set->second);
    return positiveNumber(parameterValue(scenario, key));
}

std::string textAt(const KnownPoint& point, const std::string& key) {
    const auto set = point.parameters.find(key);
    return set == point.parameters.end() ? std::string() : set->second;
}

/// Parameters in which a point departs from the open one: numbers become coordinates, anything else parts the two for good.
bool sameKind(const KnownPoint& a, const KnownPoint& b, std::set<std::string>& numbers) {
    std::set<std::string> keys;
    for (const KnownPoint* point : {&a, &b}) {
        for (const auto& [key, value] : point->parameters) {
            keys.insert(key);
        }
    }
    std::set<std::string> differing;
    for (const std::string& key : keys) {
        if (textAt(a, key) == textAt(b, key)) {
            continue;
        }
        if (!numberAt(a, key) || !numberAt(b, key)) {
            return false;
        }
        differing.insert(key);
    }
    numbers.merge(differing);
    return true;
}

std::vector<double> coordinates(const KnownPoint& point, const std::set<std::string>& numbers) {
    std::vector<double> at{std::log(static_cast<double>(std::max<std::int64_t>(1, point.bodies)))};
    for (const std::string& key : numbers) {
        at.push_back(std::log(*numberAt(point, key)));
    }
    return at;
}

Prediction notKnown(std::string_view id, std::string_view pattern, std::vector<Argument> arguments = {}) {
    Prediction prediction;
    prediction.value = prediction.low = prediction.high = unknown;
    prediction.reason = {std::string(id), std::string(pattern), std::move(arguments)};
    return prediction;
}

/// Whether the curve of a machine says anything of a quantity.
bool onCurve(Predicted what, const KnownPoint& open, const Calibration* calibration) {
    const bool covered = what == Predicted::Fps || (what == Predicted::WallSeconds && open.span > 0.0);
    return covered && calibration && calibration->machine == open.machine && calibration->threads == open.threads;
}

/// From the curve of the machine: between what the worst second of the worst pile and the best of a typical one give.
Prediction fromCurve(Predicted what, const KnownPoint& open, const Calibration& calibration) {
    if (open.carries) {
        return notKnown(
            "prediction.carries_loose",
            "this machine was calibrated with fragments alone; here whole spans are simulated as well (loose_structure)");
    }
    if (calibration.disturbed()) {
        return notKnown("prediction.calibration_disturbed", "this machine was busy with other work when it was calibrated");
    }
    const LiveLoad load = what == Predicted::Fps ? LiveLoad::Both : LiveLoad::Physics;
    const auto typical = calibration.fps(PileKind::Typical, load, static_cast<double>(open.bodies));
    const auto worst = calibration.fps(PileKind::Worst, load, static_cast<double>(open.bodies));
    if (!typical || !worst) {
        return notKnown("prediction.outside_calibration", "{0} bodies are more or fewer than this machine was calibrated with",
                        {open.bodies});
    }
    Prediction prediction;
    prediction.fromCalibration = true;
    prediction.low = std::min(typical->low, worst->low);
    prediction.value = typical->value;
    prediction.high = typical->high;
    if (what == Predicted::WallSeconds) {
        const double slowest = prediction.low;
        prediction.low = open.span * calibration.target / prediction.high;
        prediction.high = (open.span + open.settle) * calibration.target / slowest;
        prediction.value = (open.span + 0.5 * open.settle) * calibration.target / prediction.value;
    }
    prediction.known = true;
    return prediction;
}

}  // namespace

std::string_view predictedKey(Predicted what) {
    static constexpr std::array<std::string_view, predictedCount> keys{
        "wall_s",   "ms_per_step_mean", "fps",          "mass_map_difference",
        "core_iou", "footprint_iou",    "height_rms_m", "mean_height_error_m"};
    return keys[static_cast<std::size_t>(what)];
}

Digest sceneDigest(const WorldOrigin& reference, DebrisInstant instant) {
    return Hasher().text("scene").digest(reference.key).value(instant).finish();
}

KnownPoint openPoint(const Digest& scene, const std::string& machine, int threads, const Scenario& scenario, std::int64_t fragments,
                     std::int64_t bodies) {
    // The grid decides the bodies and nothing else, so it is left out; so is what does not reach the debris.
    static const std::set<std::string_view> left{
        "multiple", "grid_l", "grid_w", "grid_h", "bodies_max", "awake_time", "fps_target", "one_body_per_fragment", "frame_rate"};
    static const Scenario defaults;
    KnownPoint point;
    point.scene = scene;
    point.machine = machine;
    point.threads = threads;
    point.fragments = fragments;
    point.bodies = bodies;
    point.settle = scenario.simulation.settleTime;
    point.carries = scenario.effects.loose != LooseStructurePolicy::Fe;
    point.values.fill(unknown);
    for (const Parameter& row : parameterTable()) {
        if (row.stage < Stage::Fragments || row.keyed() || left.contains(row.key)) {
            continue;
        }
        const ParameterValue value = row.get(scenario, "");
        if (value != row.get(defaults, "")) {
            point.parameters[std::string(row.key)] = valueText(value);
        }
    }
    return point;
}

KnownPoint openPoint(const StudyTask& task, const std::string& machine, int threads) {
    KnownPoint point =
        openPoint(sceneDigest(task.reference, DebrisInstant::AtRest), machine, threads, task.scenario, task.fragments, task.bodies);
    point.span = task.span;
    point.carries = task.carries;
    return point;
}

std::vector<KnownPoint> pointsBut(const KnownPoint& setting, std::span<const KnownPoint> known) {
    std::vector<KnownPoint> others(known.begin(), known.end());
    std::erase_if(others, [&](const KnownPoint& point) {
        return point.scene == setting.scene && point.bodies == setting.bodies && point.parameters == setting.parameters;
    });
    return others;
}

KnownPoint knownPoint(const AccuracyPoint& point, const AccuracyReport& report) {
    KnownPoint known = openPoint(sceneDigest(report.reference.origin, report.instant), point.origin.machine, point.cost.threads,
                                 point.scenario, point.fragments, point.bodies);
    known.setting = point.setting;
    known.span = report.span;
    known.carries = known.carries && report.comesLoose;
    const auto set = [&known](Predicted what, double value) { known.values[static_cast<std::size_t>(what)] = value; };
    // What was timed beside other work says what the other work was.
    if (!point.cost.disturbed()) {
        set(Predicted::WallSeconds, point.cost.wallSeconds);
        set(Predicted::StepMeanMs, point.cost.stepMeanMs);
        set(Predicted::Fps, point.cost.fps);
    }
    // The reference is at no distance from itself: that says nothing of any other setting.
    if (point.done && point.setting != referenceSetting) {
        set(Predicted::MassMap, point.difference.of(Measure::MassMap));
        set(Predicted::CoreIou, point.difference.of(Measure::CoreIou));
        set(Predicted::FootprintIou, point.difference.of(Measure::FootprintIou));
        set(Predicted::HeightRms, point.difference.of(Measure::HeightRms));
        set(Predicted::MeanHeight, point.difference.departure(Measure::MeanHeight));
    }
    return known;
}

Prediction predict(Predicted what, const KnownPoint& open, std::span<const KnownPoint> known, const Calibration* calibration) {
    std::vector<const KnownPoint*> alike;
    std::set<std::string> numbers;
    for (const KnownPoint& point : known) {
        const bool valued = std::isfinite(point.of(what)) && point.bodies > 0;
        if (valued && point.scene == open.scene &&
            (!ofTime(what) || (point.machine == open.machine && point.threads == open.threads)) && sameKind(point, open, numbers)) {
            alike.push_back(&point);
        }
    }
    if (alike.size() < pointsLeast || alike.size() < 3 + numbers.size()) {
        return onCurve(what, open, calibration)
                   ? fromCurve(what, open, *calibration)
                   : notKnown("prediction.few_points", "{0} earlier points with the same settings but for numbers; {1} are needed",
                              {alike.size(), std::max(pointsLeast, 3 + numbers.size())});
    }
    std::vector<FitSample> samples;
    for (const KnownPoint* point : alike) {
        samples.push_back({coordinates(*point, numbers), toLog(what, point->of(what))});
    }
    const std::vector<double> at = coordinates(open, numbers);
    for (std::size_t d = 0; d < at.size(); ++d) {
        const auto [least, most] = std::minmax_element(samples.begin(), samples.end(),
                                                       [d](const FitSample& a, const FitSample& b) { return a.at[d] < b.at[d]; });
        const bool outside = at[d] < least->at[d] - std::log(beyond) || at[d] > most->at[d] + std::log(beyond);
        // A number that never changed says nothing of its change.
        const bool changed = most->at[d] - least->at[d] > 1e-9 || std::abs(at[d] - least->at[d]) < 1e-9;
        if (outside || !changed) {
            return notKnown("prediction.outside", "it lies too far outside the {0} earlier points", {alike.size()});
        }
    }
    const FitInterval found = IntervalFit(std::move(samples), likelyScatter).predict(at, predictionChance);
    Prediction prediction;
    prediction.points = alike.size();
    prediction.value = fromLog(what, found.value);
    prediction.low = std::min(fromLog(what, found.low), fromLog(what, found.high));
    prediction.high = std::max(fromLog(what, found.low), fromLog(what, found.high));
    prediction.known = prediction.halfWidth() <= 1.0;
    if (!prediction.known) {
        Prediction wide = notKnown("prediction.wide", "{0} earlier points scatter too much: it may be anything from {1} to {2}",
                                   {alike.size(), prediction.low, prediction.high});
        wide.points = alike.size();
        return wide;
    }
    return prediction;
}

Prediction wallSecondsAgain(double seconds) {
    constexpr double spread = 1.5;  // a machine that does other things beside
    Prediction prediction;
    prediction.known = true;
    prediction.fromRun = true;
    prediction.low = seconds / spread;
    prediction.value = seconds;
    prediction.high = seconds * spread;
    return prediction;
}

std::vector<PredictionCheck> checkPredictions(std::span<const KnownPoint> known) {
    std::vector<PredictionCheck> checks;
    for (std::size_t w = 0; w < predictedCount; ++w) {
        PredictionCheck check;
        check.what = static_cast<Predicted>(w);
        std::vector<double> halfWidths;
        for (std::size_t i = 0; i < known.size(); ++i) {
            if (!std::isfinite(known[i].of(check.what))) {
                continue;
            }
            ++check.points;
            const Prediction prediction = predict(check.what, known[i], pointsBut(known[i], known), nullptr);
            if (!prediction.known) {
                ++check.unknown;
                continue;
            }
            const double value = likeness(check.what) ? known[i].of(check.what) : std::abs(known[i].of(check.what));
            check.held += value >= prediction.low && value <= prediction.high;
            halfWidths.push_back(prediction.halfWidth());
        }
        std::sort(halfWidths.begin(), halfWidths.end());
        const std::size_t half = halfWidths.size() / 2;
        check.halfWidth = halfWidths.empty()           ? unknown
                          : halfWidths.size() % 2 == 1 ? halfWidths[half]
                                                       : 0.5 * (halfWidths[half - 1] + halfWidths[half]);
        checks.push_back(check);
    }
    return checks;
}

}  // namespace rubble
