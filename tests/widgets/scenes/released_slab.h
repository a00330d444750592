#pragma once

#include <memory>

#include "core/simulation/run/simulation.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/widgets/scenes/ballistic_run.h"

namespace rubble::scenes {

/// A slab in the air, a pier and a block that dies. The FE result ends at 0.3 s; a run by hand turns the slab by a quarter about y
/// over 1 s, and lets it sink by 2 m, from then on.
struct ReleasedSlab {
    std::shared_ptr<const FeResult> fe;
    render::SceneData data;
    std::size_t slabElements = 6;
    Vec3 centre;
    std::shared_ptr<MemoryTrajectory> trajectory = std::make_shared<MemoryTrajectory>();

    ReleasedSlab() {
        Block slab;
        slab.name = "slab";
        slab.low = Vec3(10, 0, 20);
        slab.size = Vec3(3, 2, 1);
        slab.cells = {3, 2, 1};
        slab.velocity = Vec3(0, 0, -1);
        Block pier;
        pier.name = "pier";
        pier.size = Vec3(1, 1, 3);
        pier.cells = {1, 1, 3};
        Block dies;
        dies.name = "dies";
        dies.low = Vec3(30, 0, 5);
        dies.deathState = [](std::size_t) { return std::size_t{2}; };
        fe = makeScene({slab, pier, dies}, 4, 0.1);
        data = withoutRun(fe);
        data.trajectory = trajectory;
        centre = Vec3(11.5, 1, 20.2);
        trajectory->begin({});
    }
    TrajectoryFrame frameAt(double time, std::size_t bodies) const {
        TrajectoryFrame frame;
        frame.time = time;
        frame.positions.assign(bodies, data.fragments->list.front().centre.cast<float>());
        frame.orientations.assign(bodies, Eigen::Quaternionf::Identity());
        frame.speeds.assign(bodies, 0.0f);
        frame.states.assign(bodies, BodyState::Awake);
        if (bodies > 1) {
            const double share = time - 0.3;
            frame.positions[1] = Vec3(centre - 2.0 * share * Vec3::UnitZ()).cast<float>();
            frame.orientations[1] = Quat(Eigen::AngleAxisd(0.5 * M_PI * share, Vec3::UnitY())).cast<float>();
        }
        return frame;
    }
    void runToFeEnd() {
        const Fragment& f = data.fragments->list.front();
        const BodyRecord body{BodyId{0}, ClusterId{0}, f.handOverTime, f.endTime, f.mass, {f.centre, Quat::Identity()}, {}, false};
        const Carrier carrier{FragmentId{0}, BodyId{0}, f.handOverTime, f.endTime, {-f.centre, Quat::Identity()}};
        trajectory->addBodies(std::span(&body, 1), std::span(&carrier, 1));
        trajectory->commit(frameAt(0.1, 1));
        trajectory->commit(frameAt(0.2, 1));
    }
    void release() {
        BodyRecord body;
        body.body = BodyId{1};
        body.cluster = noCluster;
        body.from = 0.3;
        body.atBirth.position = body.inFe.position = centre;
        trajectory->addBodies(std::span(&body, 1), {});
        IslandRecord island{BodyId{1}, atLastState, body.inFe, {}};
        for (std::size_t e = 0; e < slabElements; ++e) {
            island.elements.push_back(idAt<ElementIndex>(e));
        }
        trajectory->addIslands(std::span(&island, 1), {});
        trajectory->commit(frameAt(0.3, 2));
        trajectory->commit(frameAt(1.3, 2));
        trajectory->finish({});
    }
};

}  // namespace rubble::scenes
