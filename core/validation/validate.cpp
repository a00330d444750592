#include "core/validation/validate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "core/analysis/accuracy/world_pool.h"
#include "core/base/csv_text.h"
#include "core/base/unknown.h"
#include "core/scenario/body_scenario.h"
#include "core/scenario/parameters.h"
#include "core/validation/drop_series.h"

namespace rubble {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
/// s. Simulated beyond the last measurement.
constexpr double timeBeyond = 0.5;
/// Values of a fitted setting that are tried from end to end, each with all of the others, and again around the best.
constexpr int fitSteps = 7;
constexpr int fitRounds = 4;

/// Where a body was compared: in the axes of its table.
struct ComparedEnd {
    Pose start;
    Pose end;
    bool known = false;
};

double angleBetween(const Quat& a, const Quat& b) {
    return a.angularDistance(b) / degree;
}

/// Axis of a body that points up, with its sign: 0 to 5.
int faceUp(const Quat& turn) {
    const Vec3 up = turn.conjugate() * Vec3::UnitZ();
    Eigen::Index axis = 0;
    up.cwiseAbs().maxCoeff(&axis);
    return 2 * static_cast<int>(axis) + (up[axis] < 0.0);
}

/// Simulates one variant on some of the bodies.
class VariantRun {
public:
    /// @param options  with the repeats of the variant
    VariantRun(const ValidationSet& set, const std::vector<std::size_t>& chosen, const ValidationOptions& options) {
        for (const std::size_t i : chosen) {
            m_series.bodies.push_back(set.bodies[i]);
            m_measured.push_back(set.measured[i]);
        }
        m_series.terrain = set.terrain;
        m_series.turned = set.turned;
        m_series.lifted = set.lifted;
        m_series.apart = true;
        m_series.repeats = options.repeats.value();
        m_series.seed = options.seed;
        double latest = 0.0;
        for (std::size_t i = 0; i < m_series.bodies.size(); ++i) {
            const double after = m_measured[i].after.value_or(unknown);
            m_series.watch.asked.push_back(after);
            latest = std::isfinite(after) ? std::max(latest, m_series.bodies[i].time + after + timeBeyond) : latest;
        }
        m_series.until = latest;
    }

    /// Lets all go in every repeat. @param parameters  key and value
    void simulate(const std::vector<SetParameter>& parameters, const std::vector<SetVaried>& varied, const Execution& execution) {
        m_series.varied.clear();
        for (const SetVaried& one : varied) {
            m_series.varied.push_back(one.setting);
        }
        m_series.scenario = Scenario();
        prepareForBodies(m_series.scenario, m_series.bodies);
        for (const SetParameter& parameter : parameters) {
            setParameterText(m_series.scenario, parameter.key, parameter.value);
        }
        m_ends.assign(m_series.bodies.size(), {});
        moving = left = lost = 0;
        for (const DropRepeat& repeat : dropAll(m_series, execution)) {
            take(repeat);
        }
    }

    /// Takes over what another run simulated of some of these bodies. @param chosen  which, in its order
    void takeOver(const VariantRun& part, const std::vector<std::size_t>& chosen) {
        m_ends.resize(m_series.bodies.size());
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            m_ends[chosen[i]] = part.m_ends[i];
        }
        moving += part.moving;
        left += part.left;
        lost += part.lost;
        seconds += part.seconds;
        stepRate = part.stepRate;
        stepRateReason = part.stepRateReason;
        findings.append(part.findings);
        lifted.count += part.lifted.count;
        lifted.measure = std::max(lifted.measure, part.lifted.measure);
    }

    const std::vector<MeasuredEnd>& measured() const { return m_measured; }
    const std::vector<std::vector<ComparedEnd>>& ends() const { return m_ends; }  ///< [bodies][repeats]
    const std::vector<LooseBody>& bodies() const { return m_series.bodies; }

    std::int64_t moving = 0;
    std::int64_t left = 0;
    std::int64_t lost = 0;
    double seconds = 0.0;  ///< wall time of all simulations, added up
    double stepRate = 0.0;
    Message stepRateReason;
    ReleaseCount lifted;
    Findings findings;  ///< of all simulations

private:
    void take(const DropRepeat& repeat) {
        seconds += repeat.seconds;
        moving += repeat.result.count(Ending::Moving);
        left += repeat.result.count(Ending::Left);
        stepRate = repeat.result.results.simulation->stepRate;
        stepRateReason = repeat.result.results.simulation->stepRateReason;
        findings.append(repeat.result.results.simulation->findings);
        lost += repeat.result.count(Ending::Lost) + repeat.result.count(Ending::Refused);
        lifted.count += repeat.lifted.count;
        lifted.measure = std::max(lifted.measure, repeat.lifted.measure);
        for (std::size_t i = 0; i < repeat.bodies.size(); ++i) {
            const DropOutcome& body = repeat.result.bodies[i];
            ComparedEnd end{repeat.bodies[i].pose, {}, body.ending == Ending::AtRest};
            if (m_measured[i].after) {
                end.known = body.ending == Ending::AtRest || (body.ending == Ending::Moving && body.trace.asked);
            }
            end.end = placed(repeat.bodies[i], body, body.trace.asked.value_or(body.trace.latest));
            m_ends[i].push_back(end);
        }
    }

    DropSeries m_series;
    std::vector<MeasuredEnd> m_measured;
    std::vector<std::vector<ComparedEnd>> m_ends;
};

bool placesMeasured(const std::vector<MeasuredEnd>& ends) {
    return std::all_of(ends.begin(), ends.end(), [](const MeasuredEnd& end) { return end.place.has_value(); });
}

bool turnsMeasured(const std::vector<MeasuredEnd>& ends) {
    return std::all_of(ends.begin(), ends.end(), [](const MeasuredEnd& end) { return end.turn.has_value(); });
}

double runOut(const Vec3& from, const Vec3& to) {
    return (to - from).head<2>().norm();
}

/// Each simulated end through a function of body and end; what is not known is no number.
template <class Of>
std::vector<std::vector<double>> valuesOf(const VariantRun& run, Of of) {
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < run.ends().size(); ++i) {
        values.emplace_back();
        for (const ComparedEnd& end : run.ends()[i]) {
            values.back().push_back(end.known ? of(i, end) : unknown);
        }
    }
    return values;
}

template <class Of>
std::vector<double> measuredOf(const VariantRun& run, Of of) {
    std::vector<double> values;
    for (std::size_t i = 0; i < run.measured().size(); ++i) {
        values.push_back(of(i));
    }
    return values;
}

std::vector<std::vector<double>> placeErrors(const VariantRun& run) {
    return valuesOf(run,
                    [&](std::size_t i, const ComparedEnd& end) { return (end.end.position - *run.measured()[i].place).norm(); });
}

std::vector<std::vector<double>> turnErrors(const VariantRun& run) {
    return valuesOf(
        run, [&](std::size_t i, const ComparedEnd& end) { return angleBetween(end.end.orientation, *run.measured()[i].turn); });
}

std::vector<std::vector<double>> rightFaces(const VariantRun& run) {
    return valuesOf(run, [&](std::size_t i, const ComparedEnd& end) {
        return faceUp(end.end.orientation) == faceUp(*run.measured()[i].turn) ? 1.0 : 0.0;
    });
}

/// What a fit makes small: the squares of the place's errors. Rotation and face are not fitted, so they judge what was found.
double misfit(const VariantRun& run) {
    double squares = 0.0;
    for (const std::vector<double>& repeats : placeErrors(run)) {
        for (const double error : repeats) {
            squares += error * error;
        }
    }
    // Whoever is lost has no place: such a setting fits nothing.
    return std::isfinite(squares) ? squares : std::numeric_limits<double>::infinity();
}

/// Four decimals: what is fitted is not known better.
std::string shortNumber(double number) {
    return exactNumber(std::round(number * 1e4) / 1e4);
}

/// Values of the fitted settings, in their order, and how badly each fits.
using Misfits = std::map<std::vector<double>, double>;

/// Where one round of a fit looks: every combination of values around a middle.
std::vector<std::vector<double>> combinationsAround(const std::vector<double>& middle, const std::vector<double>& width,
                                                    const std::vector<FittedParameter>& fitted) {
    auto count = std::size_t{1};
    for (std::size_t p = 0; p < middle.size(); ++p) {
        count *= fitSteps;
    }
    std::vector<std::vector<double>> combinations;
    for (std::size_t combination = 0; combination < count; ++combination) {
        std::vector<double> at;
        std::size_t rest = combination;
        for (std::size_t p = 0; p < middle.size(); ++p) {
            const double step = static_cast<double>(rest % fitSteps) / (fitSteps - 1) - 0.5;
            at.push_back(std::clamp(middle[p] + width[p] * step, fitted[p].low, fitted[p].high));
            rest /= fitSteps;
        }
        combinations.push_back(std::move(at));
    }
    return combinations;
}

/// Finds the fitted settings together, over their ranges, then around the best: one that makes up for another hides the best from a
/// search along one at a time. Several values are tried at once where there are threads for it.
/// @param run     of the bodies to fit; only the time of its simulations grows
/// @param source  of the values found
/// @return the settings of the variant and those found after them
std::vector<SetParameter> fit(VariantRun& run, const SetVariant& variant, const char* source, const Execution& execution) {
    std::vector<SetParameter> all = variant.parameters;
    const std::size_t first = all.size();
    std::vector<double> best, width;
    for (const FittedParameter& fitted : variant.fitted) {
        best.push_back(0.5 * (fitted.low + fitted.high));
        width.push_back(fitted.high - fitted.low);
        all.push_back({fitted.key, shortNumber(best.back()), source});
    }
    const auto take = [&](const std::vector<double>& at, std::vector<SetParameter>& into) {
        for (std::size_t p = 0; p < at.size(); ++p) {
            into[first + p].value = shortNumber(at[p]);
        }
    };
    Misfits tried;
    for (int round = 0; round < fitRounds; ++round) {
        const std::vector<std::vector<double>> combinations = combinationsAround(best, width, variant.fitted);
        std::vector<Misfits::value_type*> open;
        for (const std::vector<double>& at : combinations) {
            const auto [trial, isNew] = tried.emplace(at, 0.0);
            if (isNew) {
                open.push_back(&*trial);
            }
        }
        std::vector<double> seconds(open.size(), 0.0);
        runInParallel(open.size(), {},
                      {"validation.fit", "fitting: {0} values tried, round {1} of {2}", {tried.size(), round + 1, fitRounds}},
                      execution, [&](std::size_t i, const Execution& own) {
                          std::vector<SetParameter> trial = all;
                          take(open[i]->first, trial);
                          VariantRun trying = run;
                          trying.seconds = 0.0;
                          trying.simulate(trial, variant.varied, own);
                          open[i]->second = misfit(trying);
                          seconds[i] = trying.seconds;
                      });
        run.seconds += std::accumulate(seconds.begin(), seconds.end(), 0.0);
        // The middle is one of them.
        for (const std::vector<double>& at : combinations) {
            if (tried.at(at) < tried.at(best)) {
                best = at;
            }
        }
        for (double& one : width) {
            one *= 0.4;
        }
    }
    take(best, all);
    return all;
}

/// Turns the ends of a variant into comparisons and figures.
class VariantReport {
public:
    VariantReport(VariantResult& result, const VariantRun& run, const ValidationOptions& options)
        : m_result(result), m_run(run), m_options(options) {}

    void fill() {
        if (!placesMeasured(m_run.measured())) {
            return;
        }
        const auto& measured = m_run.measured();
        const auto& bodies = m_run.bodies();
        addQuantity(
            "run_out_m", "run-out", "m", [&](std::size_t i) { return runOut(bodies[i].pose.position, *measured[i].place); },
            [](std::size_t, const ComparedEnd& end) { return runOut(end.start.position, end.end.position); });
        addQuantity(
            "fall_m", "fall", "m", [&](std::size_t i) { return bodies[i].pose.position.z() - measured[i].place->z(); },
            [](std::size_t, const ComparedEnd& end) { return end.start.position.z() - end.end.position.z(); });
        addCentroid();
        addDeposits();
        if (turnsMeasured(measured)) {
            addQuantity(
                "rotation_deg", "net rotation", "deg",
                [&](std::size_t i) { return angleBetween(bodies[i].pose.orientation, *measured[i].turn); },
                [](std::size_t, const ComparedEnd& end) { return angleBetween(end.start.orientation, end.end.orientation); });
            addErrors("rotation_error_deg", "deg", turnErrors(m_run));
            addFigure("right_face_share", "", intervalOf(rightFaces(m_run), Statistic::Mean, m_options.resamplings));
            addErrors("position_error_m", "m", placeErrors(m_run));
        }
    }

private:
    void addFigure(const std::string& key, const std::string& unit, const ConfidenceInterval& value) {
        m_result.figures.push_back({key, unit, value});
    }

    void addErrors(const std::string& key, const std::string& unit, const std::vector<std::vector<double>>& errors) {
        addFigure(key + ".median", unit, intervalOf(errors, Statistic::Median, m_options.resamplings));
        addFigure(key + ".ninetieth", unit, intervalOf(errors, Statistic::Ninetieth, m_options.resamplings));
    }

    void addOne(QuantityComparison quantity) {
        quantity.comparison = compareSamples(quantity.values, m_options.resamplings);
        const SampleComparison& c = quantity.comparison;
        addFigure(quantity.key + ".measured", quantity.unit, {c.measured.mean, unknown, unknown});
        addFigure(quantity.key + ".simulated", quantity.unit, {c.simulated.mean, unknown, unknown});
        addFigure(quantity.key + ".error", quantity.unit, c.error);
        addFigure(quantity.key + ".scatter_ratio", "", c.scatterRatio);
        addFigure(quantity.key + ".area", quantity.unit, {c.area, unknown, unknown});
        m_result.quantities.push_back(std::move(quantity));
    }

    template <class OfMeasured, class OfEnd>
    void addQuantity(const std::string& key, const std::string& title, const std::string& unit, OfMeasured ofMeasured,
                     OfEnd ofEnd) {
        const PairedValues all{measuredOf(m_run, ofMeasured), valuesOf(m_run, ofEnd)};
        addOne({key, title, unit, all, {}});
        std::set<std::string> groups;
        for (const MeasuredEnd& end : m_run.measured()) {
            groups.insert(end.group);
        }
        groups.erase("");
        for (const std::string& group : groups) {
            PairedValues some;
            for (std::size_t i = 0; i < all.measured.size(); ++i) {
                if (m_run.measured()[i].group == group) {
                    some.measured.push_back(all.measured[i]);
                    some.simulated.push_back(all.simulated[i]);
                }
            }
            addOne({key + "[" + group + "]", title + ", " + group, unit, std::move(some), {}});
        }
    }

    void addDeposits() {
        for (std::size_t i = 0; i < m_run.measured().size(); ++i) {
            Deposit deposit{*m_run.measured()[i].place, {}};
            for (const ComparedEnd& end : m_run.ends()[i]) {
                if (end.known) {
                    deposit.simulated.push_back(end.end.position);
                }
            }
            m_result.deposits.push_back(std::move(deposit));
        }
    }

    void addCentroid() {
        Vec3 off = Vec3::Zero();
        for (Eigen::Index axis = 0; axis < 2; ++axis) {
            const auto place = measuredOf(m_run, [&](std::size_t i) { return (*m_run.measured()[i].place)[axis]; });
            const auto ends = valuesOf(m_run, [axis](std::size_t, const ComparedEnd& end) { return end.end.position[axis]; });
            off[axis] = intervalOf(ends, Statistic::Mean, 0).value - meanAndScatter(place).mean;
        }
        addFigure("centroid_offset_m", "m", {off.norm(), unknown, unknown});
    }

    VariantResult& m_result;
    const VariantRun& m_run;
    const ValidationOptions& m_options;
};

std::vector<std::size_t> every(std::size_t step, std::size_t first, std::size_t count) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = first; i < count; i += step) {
        chosen.push_back(i);
    }
    return chosen;
}

/// Fits on each half of the bodies and simulates the other with what was found, so that each is judged by a fit without it.
void simulateFitted(VariantRun& run, VariantResult& result, const ValidationSet& set, const ValidationOptions& options,
                    const Execution& execution) {
    static constexpr std::array sources{"fitted on one half, judged on the other", "fitted on the other half, judged on the one"};
    for (std::size_t half = 0; half < sources.size(); ++half) {
        const std::vector<std::size_t> judged = every(2, 1 - half, set.bodies.size());
        VariantRun fitting(set, every(2, half, set.bodies.size()), options);
        const std::vector<SetParameter> found = fit(fitting, result.variant, sources[half], execution);
        VariantRun judging(set, judged, options);
        judging.simulate(found, result.variant.varied, execution);
        run.takeOver(judging, judged);
        run.seconds += fitting.seconds;
        result.used.insert(result.used.end(), found.begin() + static_cast<std::ptrdiff_t>(result.variant.parameters.size()),
                           found.end());
    }
}

VariantResult runVariant(const ValidationSet& set, const SetVariant& variant, ValidationOptions options, const Execution& execution,
                         ReleaseCount& lifted, Findings& findings) {
    options.repeats = options.repeats.value_or(variant.repeats.value_or(set.repeats));
    VariantResult result;
    result.variant = variant;
    result.used = variant.parameters;
    for (const SetVaried& varied : variant.varied) {
        result.used.push_back({varied.setting.key, variationText(varied.setting), varied.source});
    }
    VariantRun run(set, every(1, 0, set.bodies.size()), options);
    if (variant.fitted.empty()) {
        run.simulate(variant.parameters, variant.varied, execution);
    } else {
        simulateFitted(run, result, set, options, execution);
    }
    result.bodies = static_cast<std::int64_t>(run.bodies().size());
    for (const auto& repeats : run.ends()) {
        result.simulated += static_cast<std::int64_t>(repeats.size());
    }
    result.moving = run.moving;
    result.left = run.left;
    result.lost = run.lost;
    result.stepRate = run.stepRate;
    result.stepRateReason = run.stepRateReason;
    lifted.count += run.lifted.count;
    lifted.measure = std::max(lifted.measure, run.lifted.measure);
    findings.append(run.findings);
    VariantReport(result, run, options).fill();
    judge(result, set);
    result.seconds = run.seconds;
    return result;
}

}  // namespace

double VariantResult::figure(const std::string& key) const {
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const SetFigure& figure) { return figure.key == key; });
    return found != figures.end() ? found->value.value : unknown;
}

void judge(VariantResult& result, const ValidationSet& set) {
    for (const SetCriterion& criterion : set.criteria) {
        if (criterion.variant != result.variant.name) {
            continue;
        }
        SetVerdict verdict{criterion, result.figure(criterion.figure), unknown, false};
        verdict.within = verdict.value >= criterion.low && verdict.value <= criterion.high;
        if (!criterion.below.empty()) {
            verdict.limit = result.figure(criterion.below);
            verdict.within = verdict.within && verdict.value < verdict.limit;
        }
        result.verdicts.push_back(std::move(verdict));
    }
}

SetResult validate(const ValidationSet& set, const ValidationOptions& options, const Execution& execution) {
    SetResult result;
    result.set = &set;
    result.findings = set.findings;
    ReleaseCount lifted;
    for (const SetVariant& variant : set.variants) {
        result.variants.push_back(runVariant(set, variant, options, execution, lifted, result.findings));
    }
    if (lifted.count > 0) {
        result.findings.add(
            {"validation.lifted",
             "{0} falls began in the surface and were lifted out of it, at most by {1}",
             {lifted.count, {lifted.measure, "m"}}},
            {"validation.lifted.remedy", "none is needed where that is less than a side; else look at heights and terrain", {}},
            set.id, lifted.count);
    }
    return result;
}

}  // namespace rubble
