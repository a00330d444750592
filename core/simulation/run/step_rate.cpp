#include "core/simulation/run/step_rate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/same_bits.h"
#include "core/simulation/effects/effect_run.h"

namespace rubble {

namespace {

constexpr double bulletRate = 60.0;   ///< 1/s
constexpr double finestRate = 40.0;   ///< 1/s, of few bodies
constexpr double deepestRate = 60.0;  ///< 1/s, of many: deep piles are pressed into themselves at longer steps
constexpr double fewBodies = 10000.0;
constexpr double coarsestRate = 20.0;  ///< 1/s
constexpr double looseRate = 40.0;     ///< 1/s, at least, where whole spans fall on debris
constexpr double finestSize = 0.3;     ///< m, of bodies that get the finest rate
/// Of a cube that falls over its edge, times sqrt(g / side): its centre comes down by 0.207 sides, about an inertia of 2/3 m d^2.
constexpr double turningOverEdge = 0.788;
constexpr double turnPerStep = 0.75 * std::numbers::pi / 180.0;  ///< rad
/// 1/s, at most: of 285 tosses of a 0.1 m cube as many end on the right face and in their place as at 1,000 or 1,400.
constexpr double tumblingRate = 480.0;
constexpr double mostParts = 32.0;
constexpr double fallingShare = 0.02;  ///< of the bodies present
constexpr double fallingSpeed = 3.0;   ///< m/s

/// m3, of each body's elements at rest.
/// @param apart  clusters break up
std::vector<double> bodyVolumes(const RunDescription& description, bool apart) {
    const auto volumeOf = [&](FragmentId f) {
        return description.components->volume[at(description.fragments->list[at(f)].element)];
    };
    std::vector<double> volumes;
    for (std::size_t c = 0; c < description.clustering->list.size(); ++c) {
        double together = 0.0;
        for (const FragmentId f : description.clustering->membersOf(idAt<ClusterId>(c))) {
            together += volumeOf(f);
            if (apart) {
                volumes.push_back(volumeOf(f));
            }
        }
        if (!apart) {
            volumes.push_back(together);
        }
    }
    return volumes;
}

}  // namespace

StepRate chosenStepRate(const RunDescription& description, const EffectDecisions& decisions) {
    const auto throughout = [](double rate, Message reason) { return StepRate{rate, rate, std::move(reason)}; };
    const SimulationSettings& settings = description.scenario.simulation;
    if (settings.stepRate) {
        return throughout(*settings.stepRate, {"simulation.step_rate.set", "set by step_rate", {}});
    }
    if (settings.solver == SolverKind::Bullet) {
        return throughout(
            bulletRate,
            {"simulation.step_rate.bullet", "at longer steps piles of Bullet's solver are pressed into themselves", {}});
    }
    std::vector<double> volumes = bodyVolumes(description, isOn(decisions, EffectKind::BreakUp));
    if (volumes.empty()) {
        return throughout(finestRate, {"simulation.step_rate.none", "there are no bodies", {}});
    }
    const auto middle = volumes.begin() + static_cast<std::ptrdiff_t>(volumes.size() / 2);
    std::nth_element(volumes.begin(), middle, volumes.end());
    const double size = cubeRootOf(*middle);
    const double layers = cubeRootOf(static_cast<double>(volumes.size()) / fewBodies);
    const double finest = std::clamp(finestRate * layers, finestRate, deepestRate);
    if (description.fe->contents().looseBodies && size > 0.0) {
        const double tumbling = turningOverEdge * std::sqrt(settings.gravity / size) / turnPerStep;
        return throughout(
            std::clamp(tumbling, finest, tumblingRate),
            {"simulation.step_rate.tumbling",
             "bodies of {0}: one that falls over its edge turns by 0.75 degrees in a step (at least {1}, at most {2} a second)",
             {{size, "m"}, finest, tumblingRate}});
    }
    const double bySize = size > 0.0 ? std::clamp(finest * std::sqrt(finestSize / size), coarsestRate, finest) : finest;
    const bool fe = description.scenario.effects.loose == LooseStructurePolicy::Fe;
    return {fe ? bySize : std::max(bySize, looseRate),
            bySize,
            {"simulation.step_rate.size", "by size and number of the bodies, {0} and {1}", {{size, "m"}, volumes.size()}}};
}

bool stillFalling(const RigidWorld& world, std::int64_t present) {
    std::int64_t falling = 0;
    for (std::size_t i = 0; i < world.bodyCount(); ++i) {
        const BodyId body = idAt<BodyId>(i);
        falling += world.state(body) == BodyState::Awake && world.motion(body).velocity.norm() > fallingSpeed;
    }
    return static_cast<double>(falling) > fallingShare * static_cast<double>(present);
}

int partsOfStep(double spin, double dt) {
    return static_cast<int>(std::clamp(std::ceil(spin * dt / turnPerStep - 1e-9), 1.0, mostParts));
}

double stepRateOf(const RunDescription& description, const EffectDecisions& decisions) {
    return chosenStepRate(description, decisions).perSecond;
}

}  // namespace rubble
