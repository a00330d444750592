#include "tests/core/simulation/world_scene.h"

#include <algorithm>

namespace rubble::test {

CollisionShape boxShape(const Vec3& size) {
    ConvexPart part;
    part.box.halfExtents = 0.5 * size;
    return {part};
}

NewBody boxBody(const Vec3& centre, const Vec3& size, const Vec3& velocity, const Quat& turn, const Vec3& spin) {
    NewBody body;
    body.mass = 2400.0 * size.prod();
    const Vec3 squares = size.cwiseProduct(size);
    body.inertia = body.mass / 12.0 * Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
    body.pose = {centre, turn};
    body.velocity = velocity;
    body.angularVelocity = spin;
    body.shape = boxShape(size);
    body.smallestSide = size.minCoeff();
    return body;
}

RigidWorld& WorldScene::world() {
    if (!m_world) {
        m_world = makeWorld(SolverKind::Bullet, settings);
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
    for (std::size_t i = 0; i < world().bodyCount(); ++i) {
        const BodyId id = idAt<BodyId>(i);
        energy += world().kineticEnergy(id) + world().mass(id) * settings.gravity * place(id).z();
    }
    return energy;
}

double WorldScene::maxSpeed() {
    double speed = 0.0;
    for (std::size_t i = 0; i < world().bodyCount(); ++i) {
        speed = std::max(speed, velocity(idAt<BodyId>(i)).norm());
    }
    return speed;
}

}  // namespace rubble::test
