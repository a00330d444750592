#include "core/simulation/soft_step_world.h"
#include "core/simulation/value_archive.h"

namespace rubble {

void SoftStepWorld::keep(Archive& archive, std::span<const std::unique_ptr<Collider>> bodies,
                         std::span<const std::unique_ptr<Collider>> pieces) {
    archive(m_report, m_freeze, m_substepLength, m_justThawed, m_still);
    keepSolids(archive, m_bodies, bodies);
    keepSolids(archive, m_pieces, pieces);
    for (std::uint32_t i = 0; archive.reading() && i < m_pieces.size(); ++i) {
        if (m_pieces[i].collider != nullptr) {
            m_standing.push_back(i);
        }
    }
    std::erase_if(m_contacts, [](const SoftContact& c) { return c.aside; });
    keepContacts(archive, m_contacts);
    m_asleep.keep(archive, [this](Archive& to, std::vector<SoftContact>& contacts) { keepContacts(to, contacts); });
    if (m_still.size() != m_bodies.size() || m_freeze.size() != m_bodies.size()) {
        Archive::fail();
    }
}

void SoftStepWorld::keepSolids(Archive& archive, std::vector<Solid>& solids, std::span<const std::unique_ptr<Collider>> colliders) {
    if (archive.reading()) {
        solids.resize(colliders.size());
    }
    for (std::size_t i = 0; i < solids.size(); ++i) {
        Solid& solid = solids[i];
        bool there = solid.collider != nullptr;
        archive(there, solid);
        if (!archive.reading() || !there) {
            continue;
        }
        Collider& collider = *colliders[i];
        solid.collider = &collider;
        enter(collider);
        if (!collider.newborn) {
            place(solid);
            m_entries[collider.number].swept = solid.swept;
            m_boxes.set(collider.number, solid.swept);
        }
    }
}

/// Null: there is none, or no longer.
Collider* SoftStepWorld::colliderNumbered(std::uint32_t number) {
    if (number == m_ground.number) {
        return &m_ground;
    }
    return number < m_entries.size() ? m_entries[number].collider : nullptr;
}

void SoftStepWorld::keepContacts(Archive& archive, std::vector<SoftContact>& contacts) {
    archive(contacts);
    if (!archive.reading()) {
        return;
    }
    for (SoftContact& contact : contacts) {
        contact.a = colliderNumbered(firstOf(contact.pair));
        contact.b = colliderNumbered(secondOf(contact.pair));
        if (contact.a == nullptr || contact.b == nullptr) {
            Archive::fail();
        }
    }
}

}  // namespace rubble
