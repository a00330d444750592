#include "core/engine/world/scene_world.h"

#include <chrono>
#include <limits>

#include "core/base/elapsed.h"
#include "core/engine/world/world_archive.h"

namespace rubble {

namespace {

/// What follows from its parts.
void measure(Collider& collider) {
    collider.radius = outerRadius(collider.parts);
    collider.box = boxAround(collider.parts);
}

}  // namespace

SceneWorld::SceneWorld(const WorldSettings& settings) : m_settings(settings), m_sleep(settings.freezeSpeed, settings.freezeDelay) {}

Collider& SceneWorld::enter(Colliders& list, ColliderKind kind, const CollisionShape& shape, Material material) {
    list.push_back(makeCollider());
    Collider& collider = *list.back();
    collider.kind = kind;
    collider.number = m_nextNumber++;
    collider.index = static_cast<std::uint32_t>(list.size() - 1);
    collider.parts = shape;
    collider.material = material;
    collider.entered = m_time;
    measure(collider);
    return collider;
}

BodyId SceneWorld::addBody(const NewBody& body) {
    Collider& collider = enter(m_bodies, ColliderKind::Body, body.shape, body.material);
    collider.mass = body.mass;
    collider.inertia = body.inertia;
    collider.smallestSide = body.smallestSide;
    collider.volume = body.volume;
    collider.loose = body.loose;
    const Vec3 spin = body.pose.orientation.conjugate() * body.angularVelocity;
    collider.birthEnergy =
        specificKineticEnergy(body.velocity, spin, body.inertia, body.mass) + m_settings.gravity * body.pose.position.z();
    collider.nodes = body.nodes;
    m_sleep.addBody();
    bodyEntered(collider, body);
    return idAt<BodyId>(collider.index);
}

PieceId SceneWorld::addPiece(const CollisionShape& shape, const Pose& pose, Material material,
                             std::span<const std::uint32_t> nodes) {
    Collider& collider = enter(m_pieces, ColliderKind::Piece, shape, material);
    collider.nodes.assign(nodes.begin(), nodes.end());
    pieceEntered(collider, pose);
    m_presentPieces.push_back(collider.index);
    return static_cast<PieceId>(collider.index);
}

void SceneWorld::removeBody(BodyId body) {
    leave(*m_bodies[at(body)]);
}

void SceneWorld::removePiece(PieceId piece) {
    leave(*m_pieces[at(piece)]);
}

void SceneWorld::leave(Collider& collider) {
    if (!collider.leaving) {
        collider.leaving = true;
        m_leaving.push_back(&collider);
    }
}

void SceneWorld::takeOut() {
    if (m_leaving.empty()) {
        return;
    }
    aboutToLeave();
    for (Collider* collider : m_leaving) {
        if (collider->kind == ColliderKind::Body) {
            m_sleep.forget(*collider);
        }
        left(*collider);
    }
    std::erase_if(m_presentPieces, [&](std::uint32_t i) { return m_pieces[i]->leaving; });
    m_leaving.clear();
}

void SceneWorld::wake(BodyId body) {
    if (!removed(body) && m_sleep.frozen(bodyAt(body))) {
        thaw(bodyAt(body));
    }
}

void SceneWorld::step(double dt) {
    const auto from = std::chrono::steady_clock::now();
    takeOut();
    advance(dt);
    m_time += dt;
    settlePieces();
    m_costs.total += secondsSince(from);
}

void SceneWorld::settlePieces() {
    for (const std::uint32_t i : m_presentPieces) {
        Collider& piece = *m_pieces[i];
        piece.newborn = false;
        if (piece.moving) {
            piece.moving = false;
        } else {
            stoodStill(piece);
        }
    }
}

BodyState SceneWorld::state(BodyId body) const {
    if (removed(body)) {
        return BodyState::Removed;
    }
    return m_sleep.clock().resting(at(body)) ? BodyState::Frozen : BodyState::Awake;
}

BodyMotion SceneWorld::motion(BodyId body) const {
    BodyMotion motion = motionOf(bodyAt(body));
    if (bodyAt(body).broken) {
        motion.velocity.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    return motion;
}

double SceneWorld::birthDepth(BodyId body) const {
    const Collider& collider = bodyAt(body);
    return collider.smallestSide > 0.0 ? collider.birthDepth / collider.smallestSide : 0.0;
}

double SceneWorld::birthDepthApart(BodyId body) const {
    const Collider& collider = bodyAt(body);
    return collider.smallestSide > 0.0 ? collider.birthDepthApart / collider.smallestSide : 0.0;
}

void SceneWorld::keepScene(Archive& archive) {
    keepColliders(archive, m_bodies, ColliderKind::Body);
    keepColliders(archive, m_pieces, ColliderKind::Piece);
    archive(m_time, m_presentPieces, m_nextNumber, m_costs, m_report);
    m_sleep.keep(archive, m_bodies);
    // What is about to leave, in that order.
    m_leaving.resize(archive.count(m_leaving.size()));
    for (Collider*& leaving : m_leaving) {
        ColliderKind kind = archive.reading() ? ColliderKind::Body : leaving->kind;
        std::uint32_t index = archive.reading() ? 0 : leaving->index;
        archive(kind, index);
        const Colliders& list = kind == ColliderKind::Piece ? m_pieces : m_bodies;
        if (index >= list.size()) {
            Archive::fail();
        }
        leaving = list[index].get();
    }
}

void SceneWorld::keepColliders(Archive& archive, Colliders& list, ColliderKind kind) {
    list.resize(archive.count(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (archive.reading()) {
            list[i] = std::make_unique<Collider>();
            list[i]->kind = kind;
            list[i]->index = static_cast<std::uint32_t>(i);
        }
        archive(*list[i]);
        if (archive.reading()) {
            measure(*list[i]);
        }
    }
}

}  // namespace rubble
