#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/base/error.h"
#include "core/base/same_bits.h"
#include "core/base/standard_gravity.h"
#include "core/base/unknown.h"
#include "core/selftest/collapse_scene.h"
#include "core/selftest/pile.h"
#include "core/simulation/bodies/hand_over.h"

namespace rubble::selftest {

namespace {

/// What must hold for every collapse, however odd its elements.
void checkSound(const CollapseScene& scene, Outcome& outcome, double fragments) {
    outcome.atLeast("fragments made", static_cast<double>(scene.results.fragments->size()), fragments);
    outcome.none("fragments whose place or hit is not a number", static_cast<double>(scene.notANumber()));
    outcome.none("centres below ground", static_cast<double>(scene.lost()));
    outcome.atMost("energy gained over the work of gravity", scene.result().energy.drift, 1e-3);
    outcome.atMost("fastest over sqrt(v^2 + 2 g h)", scene.speedShare(), 1.05);
}

std::vector<double> timesOf(std::size_t states, double interval) {
    std::vector<double> times;
    for (std::size_t k = 0; k < states; ++k) {
        times.push_back(interval * static_cast<double>(k));
    }
    return times;
}

void overlappingElements(const CaseSetting& setting, Outcome& outcome) {
    ElementScene scene;
    scene.times = timesOf(6, 0.1);
    int made = 0;
    for (int k = 0; k < 3; ++k) {
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i, ++made) {
                // Cubes of 1 m every 0.7 m; every third inside out, every fifth folded through itself.
                std::vector<Vec3> corners = boxCorners({0.7 * i, 0.7 * j, 0.5 + 0.7 * k}, {1, 1, 1});
                if (made % 3 == 1) {
                    std::rotate(corners.begin(), corners.begin() + 4, corners.end());
                } else if (made % 5 == 2) {
                    std::swap(corners[0], corners[6]);
                }
                scene.element(ElementShape::Hexahedron, corners, made % 2 == 0 ? "110000" : "111000");
            }
        }
    }
    CollapseScene collapse(setting);
    collapse.run(scene.result());
    checkSound(collapse, outcome, made);
    outcome.atLeast("inverted elements counted",
                    static_cast<double>(collapse.results.fragments->findings.count("fragments.inverted")), 9);
}

/// Half extents of the fragments' boxes that are below the minimum of the settings.
std::int64_t tooThin(const CollapseScene& scene) {
    const FragmentSettings& s = scene.scenario.fragments;
    return std::count_if(scene.results.fragments->list.begin(), scene.results.fragments->list.end(), [&](const Fragment& f) {
        const Vec3& half = f.box.halfExtents;
        return !(half.minCoeff() >= std::max(s.minimumHalfExtent, s.minimumThicknessRatio * half.maxCoeff()) * (1.0 - 1e-9));
    });
}

void slivers(const CaseSetting& setting, Outcome& outcome) {
    ElementScene scene;
    scene.times = timesOf(6, 0.1);
    const std::string dies = "110000";
    for (int i = 0; i < 6; ++i) {
        const Vec3 at(2.0 * i, 0, 1.0);
        // A sliver of 1 mm, a flat hexahedron, one that is a point, a needle, a plate of 2 cm, a wire of 1 cm2 and 6 m.
        scene.element(ElementShape::Tetrahedron, {at, at + Vec3(1, 0, 0), at + Vec3(0.5, 1, 0), at + Vec3(0.5, 0.5, 0.001)}, dies);
        scene.element(ElementShape::Hexahedron, boxCorners(at + Vec3(0, 2, 0), {1, 1, 0}), dies);
        scene.element(ElementShape::Hexahedron, boxCorners(at + Vec3(0, 4, 0), {0, 0, 0}), dies);
        scene.element(ElementShape::Hexahedron, boxCorners(at + Vec3(0, 6, 0), {0.001, 0.001, 1.5}), dies);
        scene.element(
            ElementShape::Quadrilateral,
            {at + Vec3(0, 8, 0.1 * i), at + Vec3(1.5, 8, 0.1 * i), at + Vec3(1.5, 9.5, 0.1 * i), at + Vec3(0, 9.5, 0.1 * i)}, dies,
            0.02);
        scene.element(ElementShape::Beam, {at + Vec3(0, 11, 0.2), at + Vec3(0, 17, 0.2)}, dies, 1e-4);
    }
    CollapseScene collapse(setting);
    collapse.run(scene.result());
    checkSound(collapse, outcome, 36);
    outcome.none("boxes thinner than the settings allow", static_cast<double>(tooThin(collapse)));
    const Findings& findings = collapse.results.fragments->findings;
    outcome.atLeast("slivers, flat and thin ones counted",
                    static_cast<double>(findings.count("fragments.collapsed") + findings.count("fragments.sliver") +
                                        findings.count("fragments.thickened")),
                    24);
}

/// A beam of 12 m that falls and turns at 25 m/s while it loses every second element to debris, seen every 0.1 s.
void coarseOutput(const CaseSetting& setting, Outcome& outcome) {
    ElementScene scene;
    scene.times = timesOf(13, 0.1);
    for (int i = 0; i < 24; ++i) {
        std::string life(13, '1');
        if (i % 2 == 0) {
            const std::size_t death = 2 + static_cast<std::size_t>(i % 9);
            std::fill(life.begin() + static_cast<std::ptrdiff_t>(death), life.end(), '0');
        }
        scene.element(ElementShape::Hexahedron, boxCorners({0.5 * i - 6.0, 0, 30.0}, {0.5, 0.6, 0.6}), life);
    }
    scene.part("ground slab");
    for (int i = 0; i < 12; ++i) {
        scene.element(ElementShape::Hexahedron, boxCorners({1.0 * i - 6.0, -1.0, 0.0}, {1.0, 2.6, 0.5}),
                      i % 2 == 0 ? "1100000000000" : std::string(13, '1'));
    }
    const auto moved = [](const Vec3& x, double t) -> Vec3 {
        if (x.z() < 2.0) {
            return x;
        }
        const Quat turn(turnAbout(Vec3::UnitY(), 1.5 * t));
        const Vec3 pivot(0, 0, 30.3);
        return pivot + turn * (x - pivot) - Vec3(0, 0, 12.0 * t + 0.5 * standardGravity * t * t);
    };
    scene.position = moved;
    CollapseScene collapse(setting);
    collapse.run(scene.result());
    outcome.atLeast("fragments made", static_cast<double>(collapse.results.fragments->size()), 18);
    outcome.none("fragments whose place or hit is not a number", static_cast<double>(collapse.notANumber()));
    outcome.none("centres below ground", static_cast<double>(collapse.lost()));
    outcome.atMost("energy gained beyond the work booked, over that of gravity", collapse.result().energy.drift, 1e-3);
    // A piece at 25 m/s may carry what it meets from below; nothing may be faster than the structure itself and a fall together.
    outcome.atMost("fastest over sqrt(v^2 + 2 g h)", collapse.speedShare(), 1.05);
    outcome.atMost("error of the momentum handed over", collapse.result().ledger.bodyMomentum, 1e-9);
}

/// A block that dies at state 2 and is back at state 5, over a slab, beside one that stays dead.
std::shared_ptr<const FeResult> revivingScene() {
    ElementScene scene;
    scene.times = timesOf(9, 0.1);
    scene.element(ElementShape::Hexahedron, boxCorners({0, 0, 4}, {1, 1, 1}), "110001111");
    scene.element(ElementShape::Hexahedron, boxCorners({3, 0, 4}, {1, 1, 1}), "110000000");
    scene.element(ElementShape::Hexahedron, boxCorners({0, 0, 0}, {4, 1, 0.5}), "111111111");
    return scene.result();
}

void revivalLatch(const CaseSetting& setting, Outcome& outcome) {
    CollapseScene collapse(setting);
    collapse.run(revivingScene());
    checkSound(collapse, outcome, 2);
    outcome.atLeast("revivals counted", static_cast<double>(collapse.results.fragments->findings.count("fragments.revived")), 1);
    const auto last = collapse.trajectory.frame(collapse.trajectory.frameCount() - 1);
    outcome.none("bodies that left although dead is dead",
                 static_cast<double>(std::count(last->states.begin(), last->states.end(), BodyState::Removed)));
}

void revivalFollow(const CaseSetting& setting, Outcome& outcome) {
    CollapseScene collapse(setting);
    collapse.scenario.fragments.revival = Revival::Follow;
    collapse.run(revivingScene());
    checkSound(collapse, outcome, 2);
    std::int64_t removed = 0;
    for (const BodyState state : frameAtTime(collapse.trajectory, 0.5).states) {
        removed += state == BodyState::Removed;
    }
    outcome.near("bodies that leave with their element's return", static_cast<double>(removed), 1.0, 0.0);
}

void revivalRefuse(const CaseSetting& setting, Outcome& outcome) {
    CollapseScene collapse(setting);
    collapse.scenario.fragments.revival = Revival::Refuse;
    double refused = 0.0;
    try {
        collapse.run(revivingScene());
    } catch (const UsageError& error) {
        refused = error.message().id == "fragments.revival_refused" && !error.remedy().empty() ? 1.0 : 0.0;
    }
    outcome.atLeast("refused with the element and a remedy", refused, 1.0);
}

void notANumber(const CaseSetting& setting, Outcome& outcome) {
    ElementScene scene;
    scene.times = timesOf(6, 0.1);
    for (int i = 0; i < 16; ++i) {
        scene.element(ElementShape::Hexahedron, boxCorners({1.5 * (i % 4), 1.5 * (i / 4), 1.0}, {1, 1, 1}),
                      i == 15 ? "111111" : "110000", 0.0, i == 3 ? unknown : 2000.0);
    }
    scene.velocity = [](const Vec3&, double) { return Vec3(0.5, 0, -1); };
    scene.damage = [](std::size_t, FeState& state) {
        state.positions[8 * 5].x() = unknown;                   // a dying element without a place
        state.positions[8 * 15 + 2].z() = unknown;              // a live one
        state.velocities[8 * 7 + 1] = Vec3::Constant(unknown);  // one corner without a velocity
        for (std::size_t n = 8 * 9; n < 8 * 10; ++n) {
            state.velocities[n] = Vec3::Constant(unknown);  // a whole element without
        }
        state.positions[8 * 11].y() = std::numeric_limits<double>::infinity();
        state.velocities[8 * 12].y() = 1e300;
    };
    CollapseScene collapse(setting);
    collapse.run(scene.result());
    outcome.none("fragments whose place or hit is not a number", static_cast<double>(collapse.notANumber()));
    outcome.none("centres below ground", static_cast<double>(collapse.lost()));
    const Findings& findings = collapse.results.fragments->findings;
    outcome.near("elements without a place, counted and left out", static_cast<double>(findings.count("fragments.no_position")), 2,
                 0);
    outcome.atLeast("elements with no or part of a velocity, counted",
                    static_cast<double>(findings.count("fragments.no_velocity") + findings.count("fragments.part_velocity")), 2);
    outcome.atMost("fastest", collapse.result().maxSpeed, 1.05 * std::sqrt(1.25 + 2.0 * standardGravity * 2.0), "m/s");
    outcome.atLeast("fragments made of 15 that die", static_cast<double>(collapse.results.fragments->size()), 12);
}

void refusedBodies(const CaseSetting& setting, Outcome& outcome) {
    ElementScene scene;
    scene.times = timesOf(6, 0.1);
    for (int i = 0; i < 8; ++i) {
        scene.element(ElementShape::Hexahedron, boxCorners({1.5 * i, 0, 1.0}, {1, 1, 1}), "110000");
    }
    CollapseScene collapse(setting);
    const Inputs inputs{scene.result(), {}};
    Results results = run(inputs, collapse.scenario, Stage::Clusters, {}, nullptr, collapse.execution);
    auto clustering = std::make_shared<Clustering>(*results.clustering);
    clustering->list[0].mass = 0.0;
    clustering->list[1].mass = unknown;
    clustering->list[2].centre.x() = unknown;
    clustering->list[3].velocity.z() = std::numeric_limits<double>::infinity();
    clustering->list[4].inertia(1, 1) = -clustering->list[4].inertia(1, 1);
    auto fragments = std::make_shared<FragmentSet>(*results.fragments);
    for (const FragmentId f : clustering->membersOf(idAt<ClusterId>(5))) {
        fragments->list[at(f)].box.halfExtents.y() = unknown;
    }
    results.clustering = clustering;
    results.fragments = fragments;
    const RunDescription description = describeRun(inputs, collapse.scenario, results);
    const SimulationResult result = simulate(description, collapse.trajectory, collapse.execution);
    collapse.took(result);
    outcome.near("refused with a named warning", static_cast<double>(result.findings.count("simulation.body_refused")), 6, 0);
    outcome.near("bodies that entered", static_cast<double>(collapse.trajectory.bodies().size()), 2, 0);
    outcome.none("bodies whose place is not a number", static_cast<double>([&] {
                     const auto last = collapse.trajectory.frame(collapse.trajectory.frameCount() - 1);
                     return std::count_if(last->positions.begin(), last->positions.end(),
                                          [](const Eigen::Vector3f& p) { return !p.allFinite(); });
                 }()));
}

}  // namespace

std::vector<HardCase> elementCases() {
    const std::string_view sound = "all finite, none below ground, gain below 0.1 %, no faster than a fall";
    return {
        {"elements-inverted", "overlapping, inverted and folded elements", "explode, NaN", sound, 1.0, overlappingElements},
        {"elements-slivers", "slivers, points, needles, plates of 2 cm", "NaN, sink, spin up",
         "the same, no half extent below 2.5 % of the longest or 5 mm, counted", 1.0, slivers},
        {"coarse-output", "FE output every 0.1 s of a structure at 25 m/s", "launches debris, loses momentum",
         "the same, momentum handed over to 1e-9", 1.0, coarseOutput},
        {"revival-latch", "an element comes back to life, policy latch", "its fragment vanishes", "stays a fragment, counted", 0.3,
         revivalLatch},
        {"revival-follow", "an element comes back to life, policy follow", "its fragment stays, neighbours hang",
         "the body leaves at that state", 0.3, revivalFollow},
        {"revival-refuse", "an element comes back to life, policy refuse", "is taken silently", "refused, with a remedy", 0.1,
         revivalRefuse},
        {"nan-input", "NaN and infinite places, velocities, densities in the file", "spreads to all bodies",
         "stays with its element, counted", 0.3, notANumber},
        {"refused-bodies", "bodies of no, NaN or negative mass, place, size", "turns static, NaN", "each refused at birth by name",
         0.2, refusedBodies},
    };
}

}  // namespace rubble::selftest
