#pragma once

#include <cstdint>
#include <vector>

#include "core/engine/soft/contact_book.h"
#include "core/engine/soft/contact_finder.h"
#include "core/engine/soft/pair_finder.h"
#include "core/engine/soft/soft_bodies.h"
#include "core/engine/world/rigid_world.h"
#include "core/engine/world/sleep.h"
#include "core/engine/world/worker_pool.h"

namespace rubble {

/// What contacts are searched in.
struct SearchedScene {
    const WorldSettings& settings;
    SoftBodies& solids;
    Sleep& sleep;
    PairFinder& pairs;
    ContactFinder& finder;
    const ContactBook& contacts;
    WorkerPool& pool;
};

/// The begin of a step: what moves sets off, broad and narrow phase find its contacts, and what they wake takes part from the
/// start.
class ContactSearch {
public:
    explicit ContactSearch(const SearchedScene& scene) : m_scene(scene) {}

    /// What moves in this step of dt [s] gets a slot, a place and a box around its way.
    void setOff(double dt);
    /// Finds its contacts, which the finder then holds. Adds the time of each kind to the costs and takes it from that of motion.
    void find(double dt, StepCosts& costs);

private:
    void setOffPiece(SoftBody& piece, double dt);
    void findOf(const std::vector<std::uint32_t>& woken, double dt, StepCosts& costs);

    SearchedScene m_scene;
};

}  // namespace rubble
