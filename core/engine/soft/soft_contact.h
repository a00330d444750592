#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/archive.h"
#include "core/engine/world/birth_overlap.h"
#include "core/engine/world/collider.h"
#include "core/engine/world/contact_patch.h"

namespace rubble {

/// A contact between parts of two colliders as it is found in a step.
struct FoundContact {
    Collider* a = nullptr;  ///< entered first
    Collider* b = nullptr;
    std::uint32_t part = 0;  ///< which parts of the two shapes, and which patch of theirs
    ContactPatch patch;
};

/// What a contact carries from step to step as a whole.
struct SoftContactState {
    ColliderPair pair = 0;
    std::uint32_t part = 0;  ///< as found
    Collider* a = nullptr;   ///< entered first
    Collider* b = nullptr;
    Vec3 normal = Vec3::UnitZ();  ///< from a to b
    int count = 0;
    double depth = 0.0;            ///< m, of the two solids in each other along the normal
    double yield = 1.0;            ///< share of the lighter one's inverse mass that the impulses were found with
    Vec3 load = Vec3::Zero();      ///< N, on b, mean of the last steps
    Vec3 restLoad = Vec3::Zero();  ///< N, the same when one of the two froze
    double offset = 0.0;           ///< m, rest offset: overlap at birth that is left, or what a piece that gave way has entered
    double correctedFor = 0.0;     ///< s, in which the two were brought apart by position
    double approach = 0.0;         ///< m/s, of a moving piece towards its body
    double pressed = 0.0;          ///< m/s, by which a pressing piece has changed its body's speed
    double jammedFor = 0.0;        ///< s, that a body has been deeper in a piece or another body than it ought to be
    int pushes = 0;                ///< of a carrying piece in vain, in a row
    bool fresh = true;             ///< not there in the step before
    bool yielded = false;          ///< the piece of this contact has given way
    bool yielding = false;         ///< and goes on into the body now
    bool pressing = false;         ///< it strikes from above or from the side
    bool passing = false;          ///< the piece lets a loose part of the structure pass for as long as they meet
    bool aside = false;            ///< put to those that sleep

    bool pieceIsA() const { return a->kind == ColliderKind::Piece; }
    /// Of a piece and a body.
    Collider& piece() const { return pieceIsA() ? *a : *b; }
    Collider& body() const { return pieceIsA() ? *b : *a; }
    /// The piece is below the body.
    bool carries() const;
};

/// A contact between parts of two colliders and what it carries from step to step.
struct SoftContact : SoftContactState {
    struct Point {
        Vec3 position = Vec3::Zero();
        double separation = 0.0;
        std::uint32_t feature = 0;
        double impulse = 0.0;          ///< N s in a substep, along the normal
        Vec3 friction = Vec3::Zero();  ///< N s in a substep, on b
        double push = 0.0;             ///< kg m in a step, along the normal, by position only

        void keep(Archive& archive) { archive(position, separation, feature, impulse, friction, push); }
    };
    /// As many as are counted; the others are never looked at. Last, so that a contact of few points ends sooner.
    std::array<Point, 4> points;

    /// Bytes of one with so many points that are ever looked at.
    static constexpr std::size_t bytes(std::size_t points) { return sizeof(SoftContact) - (4 - points) * sizeof(Point); }
    std::pair<ColliderPair, std::uint32_t> key() const { return {pair, part}; }
    /// All but a and b, which the pair names; none that is put aside.
    void keep(Archive& archive);
};

/// Makes it the contact that was found, which carries nothing yet.
void take(const FoundContact& found, SoftContact& contact);

/// Hands on what a contact carries to the one found in its place a step later. Points are matched by feature, then by nearness.
/// @param byAngle  what is matched by nearness alone takes what acts along its own normal: in a thin body that may be the other way
void carryOver(const SoftContact& from, SoftContact& to, bool byAngle);

}  // namespace rubble
