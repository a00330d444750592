#include "tests/widgets/scenes/ballistic_run.h"

#include <algorithm>

#include "core/simulation/run/simulation.h"

namespace rubble::scenes {
namespace {

constexpr double frameInterval = 0.04;
constexpr double gravity = 9.81;

/// Where a cluster is at a time after its hand-over.
Pose poseAt(const Cluster& cluster, double time) {
    const double dt = time - cluster.handOverTime;
    Pose pose;
    pose.position = cluster.centre + dt * cluster.velocity - Vec3(0, 0, 0.5 * gravity * dt * dt);
    pose.position.z() = std::max(pose.position.z(), 0.0);
    pose.orientation = Quat(Eigen::AngleAxisd(dt, Vec3::UnitY()));
    return pose;
}

}  // namespace

render::SceneData withoutRun(std::shared_ptr<const FeResult> fe, const FragmentSettings& settings) {
    const Execution execution;
    render::SceneData data;
    auto components = std::make_shared<Components>(groupComponents(fe->mesh(), {}, {}, {}));
    auto fragments = std::make_shared<FragmentSet>(makeFragments(*fe, *components, settings, execution));
    data.clustering =
        std::make_shared<Clustering>(makeClusters(*fragments, fe->mesh(), BasicGrid{2.0, 2.0, 2.0}, GridSettings{}, execution));
    data.components = std::move(components);
    data.fragments = std::move(fragments);
    data.fe = std::move(fe);
    return data;
}

render::SceneData ballisticRun(std::shared_ptr<const FeResult> fe, double until, bool complete, const FragmentSettings& settings) {
    render::SceneData data = withoutRun(std::move(fe), settings);
    auto trajectory = std::make_shared<MemoryTrajectory>();
    RunDescription description;
    description.fe = data.fe;
    description.components = data.components;
    description.fragments = data.fragments;
    description.clustering = data.clustering;
    trajectory->begin(description);
    const auto& clusters = data.clustering->list;
    std::size_t entered = 0;
    const int frames = static_cast<int>(until / frameInterval + 0.5);
    for (int i = 0; i <= frames; ++i) {
        TrajectoryFrame frame;
        frame.time = i * frameInterval;
        for (; entered < clusters.size() && clusters[entered].handOverTime <= frame.time; ++entered) {
            const Cluster& cluster = clusters[entered];
            const BodyRecord body{idAt<BodyId>(entered),
                                  idAt<ClusterId>(entered),
                                  cluster.handOverTime,
                                  cluster.endTime,
                                  cluster.mass,
                                  {cluster.centre, Quat::Identity()},
                                  {},
                                  false};
            std::vector<Carrier> carriers;
            for (const FragmentId f : data.clustering->membersOf(idAt<ClusterId>(entered))) {
                carriers.push_back({f, body.body, body.from, body.to, {-cluster.centre, Quat::Identity()}});
            }
            trajectory->addBodies(std::span(&body, 1), carriers);
        }
        for (std::size_t c = 0; c < entered; ++c) {
            const Pose pose = poseAt(clusters[c], frame.time);
            frame.positions.push_back(pose.position.cast<float>());
            frame.orientations.push_back(pose.orientation.cast<float>());
            frame.speeds.push_back(static_cast<float>(clusters[c].velocity.norm() + frame.time));
            frame.states.push_back(BodyState::Awake);
        }
        trajectory->commit(frame);
    }
    if (complete) {
        trajectory->finish({});
    }
    data.trajectory = trajectory;
    return data;
}

}  // namespace rubble::scenes
