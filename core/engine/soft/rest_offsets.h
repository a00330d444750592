#pragma once

#include <span>

#include "core/engine/soft/contact_finder.h"
#include "core/engine/soft/soft_bodies.h"
#include "core/engine/soft/soft_contact.h"
#include "core/engine/world/scene_rules.h"

namespace rubble {

/// What contacts of the soft-step world rest on: overlap at birth, which becomes the rest offset of its pair, and pieces, which go
/// only so far into a body. Any number of threads may look at different pairs at once.
class RestOffsets {
public:
    RestOffsets(const SoftBodies& bodies, const ContactFinder& finder, const Sleep& sleep, ContactReport& report)
        : m_bodies(bodies), m_finder(finder), m_sleep(sleep), m_report(report) {}

    /// Looks at the contacts of a pair when they are found.
    void find(std::span<SoftContact> pair, double dt) const;
    /// N s per point and substep that a moving piece may act with on the body of this contact.
    double pieceLimit(const SoftContact& contact, int substeps, double dt) const;
    /// What a moving piece did to its body in this step; it gives way where that was in vain.
    /// @param pushed  N s along the normal, in the whole step
    /// @param most    N s that it may have pushed with
    /// @param left    m/s of closing speed that a carrying piece has left
    void accountForPiece(SoftContact& contact, double pushed, double most, double left) const;

private:
    bool passes(const SoftContact& contact) const;
    void limitPiece(SoftContact& contact) const;
    void giveWayToJam(SoftContact& contact, double dt) const;
    void giveWay(SoftContact& contact) const;

    const SoftBodies& m_bodies;
    const ContactFinder& m_finder;
    const Sleep& m_sleep;
    ContactReport& m_report;
};

/// m, of what a contact overlaps from birth that is to be brought apart now: all of it for its time, then none, so that a pile
/// comes to rest with what it cannot get rid of.
/// @param now  s, of the world's own time
double overlapToPart(const SoftContact& contact, const WorldSettings& settings, double now);

}  // namespace rubble
