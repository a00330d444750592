#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "core/base/hash.h"
#include "core/engine/world/rigid_world.h"

namespace rubble::selftest {

/// Hashes of all that moved in a case: the same bits of every place and speed in every step give the same hash, others another.
/// Worlds may end in any order and on any thread.
class TrajectoryHashes {
public:
    /// A run of the pipeline, by its own hash.
    void add(const Digest& trajectory);
    /// One hash of all that has ended so far.
    Digest finish() const;

    /// The same world; what moves in it is hashed after each step, and added as the world ends.
    static std::unique_ptr<RigidWorld> watched(std::unique_ptr<RigidWorld> world, std::shared_ptr<TrajectoryHashes> hashes);

private:
    mutable std::mutex m_mutex;
    std::vector<Digest> m_all;
};

}  // namespace rubble::selftest
