#include "core/simulation/run/step_rate.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

double stepRateOf(const RunDescription& description, const EffectDecisions& decisions) {
    const SimulationSettings& settings = description.scenario.simulation;
    if (settings.stepRate) {
        return *settings.stepRate;
    }
    if (settings.solver == SolverKind::Bullet) {
        return bulletRate;
    }
    std::vector<double> volumes = bodyVolumes(description, isOn(decisions, EffectKind::BreakUp));
    if (volumes.empty()) {
        return finestRate;
    }
    const auto middle = volumes.begin() + static_cast<std::ptrdiff_t>(volumes.size() / 2);
    std::nth_element(volumes.begin(), middle, volumes.end());
    const double size = std::cbrt(*middle);
    const double layers = std::cbrt(static_cast<double>(volumes.size()) / fewBodies);
    const double finest = std::clamp(finestRate * layers, finestRate, deepestRate);
    const double coarsest = description.scenario.effects.loose == LooseStructurePolicy::Fe ? coarsestRate : looseRate;
    return size > 0.0 ? std::clamp(finest * std::sqrt(finestSize / size), coarsest, finest) : finest;
}

}  // namespace rubble
