#include "core/selftest/trajectory_hashes.h"

#include <algorithm>

#include "core/engine/world/forwarding_world.h"

namespace rubble::selftest {

namespace {

class HashedWorld : public ForwardingWorld {
public:
    HashedWorld(std::unique_ptr<RigidWorld> world, std::shared_ptr<TrajectoryHashes> hashes)
        : ForwardingWorld(std::move(world)), m_hashes(std::move(hashes)) {}
    HashedWorld(const HashedWorld&) = delete;
    HashedWorld& operator=(const HashedWorld&) = delete;
    ~HashedWorld() override { m_hashes->add(m_hasher.finish()); }

    void step(double dt) override {
        ForwardingWorld::step(dt);
        for (std::size_t i = 0; i < bodyCount(); ++i) {
            const BodyId id = idAt<BodyId>(i);
            const BodyState now = state(id);
            m_hasher.value(now);
            if (now == BodyState::Removed) {
                continue;
            }
            const BodyMotion moves = motion(id);
            for (const Vec3& v : {moves.pose.position, moves.velocity, moves.angularVelocity}) {
                m_hasher.bytes(v.data(), 3 * sizeof(double));
            }
            m_hasher.bytes(moves.pose.orientation.coeffs().data(), 4 * sizeof(double));
        }
    }

private:
    std::shared_ptr<TrajectoryHashes> m_hashes;
    Hasher m_hasher;
};

}  // namespace

void TrajectoryHashes::add(const Digest& trajectory) {
    const std::scoped_lock lock(m_mutex);
    m_all.push_back(trajectory);
}

Digest TrajectoryHashes::finish() const {
    const std::scoped_lock lock(m_mutex);
    std::vector<Digest> sorted = m_all;
    std::ranges::sort(sorted);
    Hasher hasher;
    for (const Digest& one : sorted) {
        hasher.digest(one);
    }
    return hasher.finish();
}

std::unique_ptr<RigidWorld> TrajectoryHashes::watched(std::unique_ptr<RigidWorld> world, std::shared_ptr<TrajectoryHashes> hashes) {
    return std::make_unique<HashedWorld>(std::move(world), std::move(hashes));
}

}  // namespace rubble::selftest
