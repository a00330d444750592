#include "core/selftest/world_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/selftest/trajectory_hashes.h"

namespace rubble::selftest {

CollisionShape boxShape(const Vec3& size) {
    ConvexPart part;
    part.box.halfExtents = 0.5 * size;
    return {part};
}

NewBody boxBody(const Vec3& centre, const Vec3& size, const Vec3& velocity, const Quat& turn, const Vec3& spin, double density) {
    NewBody body;
    body.mass = density * size.prod();
    const Vec3 squares = size.cwiseProduct(size);
    body.inertia = body.mass / 12.0 * Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
    body.pose = {centre, turn};
    body.velocity = velocity;
    body.angularVelocity = spin;
    body.shape = boxShape(size);
    body.smallestSide = size.minCoeff();
    body.volume = size.prod();
    return body;
}

RigidWorld& WorldScene::world() {
    if (!m_world) {
        if (!settings.cancelled) {
            settings.cancelled = [flag = execution] { return flag.cancelled(); };
        }
        m_world = makeWorld(solver, settings);
        if (hashes) {
            m_world = TrajectoryHashes::watched(std::move(m_world), hashes);
        }
    }
    return *m_world;
}

BodyId WorldScene::box(const Vec3& centre, const Vec3& size, const Vec3& velocity, const Quat& turn, const Vec3& spin) {
    return world().addBody(boxBody(centre, size, velocity, turn, spin));
}

PieceId WorldScene::piece(const Vec3& centre, const Vec3& size, const Quat& turn) {
    return world().addPiece(boxShape(size), {centre, turn});
}

double WorldScene::energy() {
    double energy = 0.0;
    for (std::size_t i = 0; i < bodies(); ++i) {
        const BodyId id = idAt<BodyId>(i);
        if (world().state(id) != BodyState::Removed) {
            energy += world().kineticEnergy(id) + world().mass(id) * settings.gravity * place(id).z();
        }
    }
    return energy;
}

double WorldScene::maxSpeed() {
    double speed = 0.0;
    for (std::size_t i = 0; i < bodies(); ++i) {
        const double one = velocity(idAt<BodyId>(i)).norm();
        if (!(one <= speed)) {
            speed = one;
        }
        if (!std::isfinite(speed)) {
            return std::numeric_limits<double>::quiet_NaN();
        }
    }
    return speed;
}

double WorldScene::asleep() {
    std::size_t frozen = 0, present = 0;
    for (std::size_t i = 0; i < bodies(); ++i) {
        const BodyState state = world().state(idAt<BodyId>(i));
        frozen += state == BodyState::Frozen;
        present += state != BodyState::Removed;
    }
    return present > 0 ? static_cast<double>(frozen) / static_cast<double>(present) : 1.0;
}

EnergyWatch::Energies EnergyWatch::energiesOf(WorldScene& scene) {
    Energies now;
    for (std::size_t i = 0; i < scene.bodies(); ++i) {
        const BodyId id = idAt<BodyId>(i);
        if (scene.world().state(id) != BodyState::Removed) {
            now.kinetic += scene.world().kineticEnergy(id);
            now.potential += scene.world().mass(id) * scene.settings.gravity * scene.place(id).z();
        }
    }
    now.booked = scene.world().contacts().pieceWork + scene.world().contacts().overlapWork;
    return now;
}

void EnergyWatch::look(WorldScene& scene) {
    m_last = energiesOf(scene);
    const double own = m_last.own();
    if (!m_started) {
        m_started = true;
        m_least = own;
        m_firstPotential = m_last.potential;
        m_firstKinetic = m_last.kinetic;
    }
    m_least = std::min(m_least, own);
    m_gain = own == own ? std::max(m_gain, own - m_least) : own;
    // What moving pieces put in is there to be used as well.
    m_most = std::max(m_most, m_firstKinetic + std::max(0.0, m_firstPotential + m_last.booked - m_last.potential));
}

void EnergyWatch::admit(WorldScene& scene) {
    const Energies now = energiesOf(scene);
    m_firstKinetic += now.kinetic - m_last.kinetic;
    m_firstPotential += now.potential - m_last.potential;
    m_least += now.own() - m_last.own();
    m_last = now;
}

}  // namespace rubble::selftest
