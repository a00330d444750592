#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/fe/frame_transform.h"
#include "core/selftest/collapse_scene.h"
#include "core/selftest/killed_trajectory.h"
#include "core/selftest/pile.h"

namespace rubble::selftest {

namespace {

/// A wall of blocks that is let go layer by layer; places on a lattice of 1/64 m, so that no digit is lost far from the origin.
ElementScene fallingWall(const Vec3& origin = Vec3::Zero()) {
    ElementScene scene;
    for (int k = 0; k < 9; ++k) {
        scene.times.push_back(0.125 * k);
    }
    for (int k = 0; k < 5; ++k) {
        for (int i = 0; i < 6; ++i) {
            const std::size_t death = 2 + static_cast<std::size_t>((i + 2 * k) % 5);
            std::string life(9, '1');
            std::fill(life.begin() + static_cast<std::ptrdiff_t>(death), life.end(), '0');
            scene.element(ElementShape::Hexahedron,
                          boxCorners(origin + Vec3(0.75 * i, 0.03125 * k, 1.0 + 0.75 * k), {0.734375, 0.5, 0.734375}), life);
        }
    }
    return scene;
}

Digest hashOf(const CaseSetting& setting, std::shared_ptr<const FeResult> fe) {
    CollapseScene collapse(setting);
    return collapse.run(std::move(fe)).trajectoryHash;
}

/// Hash of everything that moves in a heap of boxes.
Digest heapHash(const CaseSetting& setting, int threads) {
    WorldScene scene(setting);
    scene.settings.threads = threads;
    Pile pile(scene);
    Sequence random(8);
    pile.addCloud(random, {-1.4, -1.4, 0.1}, {4, 4, 5}, {0.4, 0.4, 0.4}, 0.7);
    Hasher hasher;
    for (int i = 0; i < 150; ++i) {
        scene.run(scene.dt);
        for (std::size_t b = 0; b < scene.bodies(); ++b) {
            const BodyMotion motion = scene.world().motion(idAt<BodyId>(b));
            hasher.bytes(motion.pose.position.data(), 3 * sizeof(double))
                .bytes(motion.pose.orientation.coeffs().data(), 4 * sizeof(double))
                .bytes(motion.velocity.data(), 3 * sizeof(double));
        }
    }
    return hasher.finish();
}

void worldsInParallel(const CaseSetting& setting, Outcome& outcome) {
    const Digest alone = heapHash(setting, 1);
    for (const int worlds : {2, 4, 8}) {
        std::vector<Digest> hashes(static_cast<std::size_t>(worlds));
        std::vector<std::exception_ptr> failed(hashes.size());
        {
            std::vector<std::jthread> threads;
            for (std::size_t i = 0; i < hashes.size(); ++i) {
                threads.emplace_back([&, i] {
                    try {
                        hashes[i] = heapHash(setting, 1);
                    } catch (...) {
                        failed[i] = std::current_exception();
                    }
                });
            }
        }
        for (const std::exception_ptr& error : failed) {
            if (error) {
                std::rethrow_exception(error);
            }
        }
        outcome.none("worlds that differ, " + std::to_string(worlds) + " in parallel",
                     static_cast<double>(std::count_if(hashes.begin(), hashes.end(), [&](const Digest& h) { return h != alone; })));
    }
    for (const int threads : {2, 3, 4}) {
        outcome.none("a world with " + std::to_string(threads) + " threads differs", heapHash(setting, threads) != alone);
    }
}

void farFromOrigin(const CaseSetting& setting, Outcome& outcome) {
    const Digest near = hashOf(setting, fallingWall().result());
    const Vec3 far(500000, 4000000, 0);
    Frame frame;
    frame.origin = far.cast<std::int64_t>();
    const FrameTransform transform(frame);
    // The file has its nodes far away; reading takes them into the local frame, and nothing else ever sees them.
    const std::shared_ptr<const FeResult> there = fallingWall(far).result();
    ElementScene local = fallingWall();
    double largest = 0.0;
    std::size_t next = 0;
    const std::vector<Vec3>& nodes = there->mesh().nodes;
    const std::vector<Vec3> atZero = fallingWall().result()->mesh().nodes;
    for (const Vec3& node : nodes) {
        largest = std::max(largest, (transform.point(node) - atZero[next++]).cwiseAbs().maxCoeff());
    }
    outcome.none("error of the local coordinates, m", largest);
    ElementScene moved = fallingWall(far);
    moved.transformNodes([&](const Vec3& node) { return transform.point(node); });
    outcome.none("trajectory differs from the one at zero", hashOf(setting, moved.result()) != near);
}

void shuffledBirths(const CaseSetting& setting, Outcome& outcome) {
    const ElementScene scene = fallingWall();
    CollapseScene straight(setting), shuffled(setting);
    straight.run(scene.result());
    std::vector<std::size_t> order(30);
    std::iota(order.begin(), order.end(), 0);
    Sequence random(3);
    for (std::size_t i = order.size() - 1; i > 0; --i) {
        std::swap(order[i], order[static_cast<std::size_t>(random.between(0.0, static_cast<double>(i) + 0.999))]);
    }
    const std::shared_ptr<const FeResult> other = scene.reordered(order).result();
    shuffled.run(other);
    // Fragment by fragment, told by the number of its element.
    const auto placesOf = [](const CollapseScene& collapse, const Mesh& mesh) {
        std::vector<std::pair<std::int64_t, Vec3>> places;
        for (std::size_t f = 0; f < collapse.results.fragments->size(); ++f) {
            places.emplace_back(mesh.elementIds[at(collapse.results.fragments->list[f].element)],
                                collapse.result().fragments[f].finalPosition);
        }
        std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        return places;
    };
    const auto a = placesOf(straight, scene.result()->mesh());
    const auto b = placesOf(shuffled, other->mesh());
    double differ = a.size() == b.size() && a.size() == 30 ? 0.0 : 1.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        differ += a[i] != b[i];
    }
    outcome.none("fragments that end elsewhere in the last bit", differ);
    outcome.none("trajectory hash differs", straight.result().trajectoryHash != shuffled.result().trajectoryHash);
}

Digest hashOfFrames(const MemoryTrajectory& trajectory, std::size_t frames) {
    Hasher hasher;
    for (std::size_t i = 0; i < frames; ++i) {
        const auto frame = trajectory.frame(i);
        hasher.value(frame->time).values(std::span<const BodyState>(frame->states));
        for (std::size_t b = 0; b < frame->bodies(); ++b) {
            hasher.bytes(frame->positions[b].data(), 3 * sizeof(float))
                .bytes(frame->orientations[b].coeffs().data(), 4 * sizeof(float));
        }
    }
    return hasher.finish();
}

/// The latest checkpoint, after every step.
class LatestCheckpoint : public CheckpointStore {
public:
    std::optional<std::string> latest() override { return m_bytes; }
    void keep(std::string_view checkpoint) override { m_bytes = checkpoint; }
    double interval() const override { return 0.0; }

private:
    std::optional<std::string> m_bytes;
};

/// The falling wall, with nothing in common with another one of it.
RunDescription describeWall(const Scenario& scenario) {
    const Inputs inputs{fallingWall().result(), {}};
    return describeRun(inputs, scenario, rubble::run(inputs, scenario, Stage::Clusters, {}, nullptr, Execution()));
}

void killAndResume(const CaseSetting& setting, Outcome& outcome) {
    CollapseScene whole(setting);
    whole.run(fallingWall().result());
    LatestCheckpoint checkpoint;
    const Execution killer;
    KilledTrajectory killed(killer, whole.trajectory.frameCount() / 2);
    double cancelled = 0.0;
    try {
        simulate(describeWall(whole.scenario), killed, killer, &checkpoint);
    } catch (const Cancelled&) {
        cancelled = 1.0;
    }
    outcome.atLeast("killed half way", cancelled, 1.0);
    outcome.none("frames kept differ from those of the whole run",
                 hashOfFrames(killed, killed.frameCount()) != hashOfFrames(whole.trajectory, killed.frameCount()));
    MemoryTrajectory resumed;
    const SimulationResult result = simulate(describeWall(whole.scenario), resumed, setting.execution, &checkpoint);
    whole.took(result);
    // The stock solver is replayed: the frames that were kept must come again, and then the rest.
    const bool goesOn = setting.solver == SolverKind::SoftStep;
    const double from = result.checkpoints.resumedAt.value_or(result.firstTime);
    outcome.none("goes on from elsewhere than the checkpoint", result.checkpoints.resumedAt.has_value() != goesOn);
    outcome.none("begins before the last step but one", goesOn && killed.frameTime(killed.frameCount() - 1) - from > 0.1);
    outcome.none("resumed run differs in the frames that were kept",
                 hashOfFrames(resumed, killed.frameCount()) != hashOfFrames(killed, killed.frameCount()));
    outcome.none("trajectory differs from that of the whole run", resumed.mark() != whole.trajectory.mark());
    outcome.none("resumed run differs from the whole run", result.trajectoryHash != whole.result().trajectoryHash);
}

}  // namespace

std::vector<HardCase> repeatCases() {
    return {
        {"worlds-parallel", "two, four and eight worlds in parallel; a world on 2, 3, 4 threads", "share hidden state, race",
         "bit for bit the same", 4.0, worldsInParallel},
        {"far-from-origin", "coordinates at 500,000 / 4,000,000 m", "digits are lost", "bit for bit the run at zero", 0.5,
         farFromOrigin},
        {"births-shuffled", "births in another order in the file", "the order of the file reaches the result",
         "bit for bit the same", 0.5, shuffledBirths},
        {"kill-resume", "a run is killed half way and goes on: from its checkpoint with soft-step, by replay with bullet",
         "goes on differently", "bit for bit the whole run", 0.5, killAndResume},
    };
}

}  // namespace rubble::selftest
