#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <span>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/engine/world/worker_pool.h"

namespace rubble {

/// A body as the substeps of a world see it: what moves, and what it takes to move it. World axes unless said otherwise.
struct MovingBody {
    BodyId id{};
    Vec3 position = Vec3::Zero();         ///< m, centre of mass
    Quat orientation = Quat::Identity();  ///< principal axes of inertia
    Vec3 velocity = Vec3::Zero();         ///< m/s
    Vec3 spin = Vec3::Zero();             ///< rad/s
    double inverseMass = 0.0;             ///< 1/kg, as its contacts take it to be; zero: immovable
    Vec3 inertia = Vec3::Zero();          ///< kg m2, principal
    Mat3 inverseInertia = Mat3::Zero();   ///< 1/(kg m2)
    OrientedBox box;                      ///< around its collision shape, in its own frame
    double volume = 0.0;                  ///< m3, of its material

    /// Changes the motion by an impulse [N s] at a point [m].
    void push(const Vec3& impulse, const Vec3& point) {
        velocity += inverseMass * impulse;
        spin += inverseInertia * (point - position).cross(impulse);
    }
};

/// Its velocity and its spin are numbers.
inline bool isNumber(const MovingBody& body) {
    return std::isfinite(body.velocity.sum() + body.spin.sum());
}

/// The bodies of one substep that move: present and not frozen, in the order of their ids.
struct SubstepBodies {
    std::span<MovingBody> moving;
    std::span<const std::int32_t> slotOf;  ///< [bodies that ever entered] index into `moving`; -1: frozen or gone
    WorkerPool* pool = nullptr;            ///< null: there is but the calling thread

    MovingBody* find(BodyId body) const {
        const std::int32_t slot = slotOf[at(body)];
        return slot < 0 ? nullptr : &moving[static_cast<std::size_t>(slot)];
    }
    /// Calls work(i) for every index into `moving`, on any thread.
    template <class Work>
    void forEach(Work&& work) const {
        const auto part = [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                work(i);
            }
        };
        pool != nullptr ? pool->loop(moving.size(), 256, part) : part(0, moving.size());
    }
};

/// @param h  length of the substep, s
using SubstepHook = std::function<void(const SubstepBodies& bodies, double h)>;

}  // namespace rubble
