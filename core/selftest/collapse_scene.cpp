#include "core/selftest/collapse_scene.h"

#include <algorithm>
#include <cmath>

#include "core/selftest/trajectory_hashes.h"

namespace rubble::selftest {

CollapseScene::CollapseScene(const CaseSetting& setting) : execution(setting.execution), hashes(setting.hashes) {
    scenario.simulation.solver = setting.solver;
    scenario.simulation.settleTime = 4.0;
    scenario.grid.oneBodyPerFragment = true;
}

const SimulationResult& CollapseScene::run(std::shared_ptr<const FeResult> fe) {
    results = rubble::run({std::move(fe), frame}, scenario, Stage::Simulation, {}, &trajectory, execution);
    took(*results.simulation);
    return *results.simulation;
}

void CollapseScene::took(const SimulationResult& run) const {
    if (hashes) {
        hashes->add(run.trajectoryHash);
    }
}

std::int64_t CollapseScene::lost() const {
    return std::count_if(result().fragments.begin(), result().fragments.end(),
                         [&](const FragmentOutcome& f) { return !(f.finalPosition.z() > scenario.simulation.groundHeight); });
}

std::int64_t CollapseScene::notANumber() const {
    return std::count_if(result().fragments.begin(), result().fragments.end(),
                         [](const FragmentOutcome& f) { return !f.finalPosition.allFinite() || !std::isfinite(f.impactSpeed); });
}

double CollapseScene::speedShare() const {
    double speed = 0.0, height = 0.0;
    for (const Fragment& fragment : results.fragments->list) {
        speed = std::max(speed, fragment.velocity.norm());
        height = std::max(height, fragment.bounds.max().z() - scenario.simulation.groundHeight);
    }
    return result().maxSpeed / std::sqrt(speed * speed + 2.0 * scenario.simulation.gravity * height);
}

std::vector<Vec3> boxCorners(const Vec3& low, const Vec3& size) {
    std::vector<Vec3> corners;
    for (const double z : {0.0, 1.0}) {
        for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
            corners.push_back(low + size.cwiseProduct(Vec3(x, y, z)));
        }
    }
    return corners;
}

}  // namespace rubble::selftest
