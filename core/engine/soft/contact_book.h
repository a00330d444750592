#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/engine/soft/contact_finder.h"
#include "core/engine/soft/sleeping_contacts.h"
#include "core/engine/soft/soft_contact.h"
#include "core/engine/world/worker_pool.h"

namespace rubble {

/// The contacts of the step at hand in the order of pairs and parts, with what they carry from step to step, and those that were
/// put aside with the bodies that sleep.
class ContactBook {
public:
    /// @param byAngle  see carryOver()
    ContactBook(WorkerPool& pool, bool byAngle) : m_pool(pool), m_byAngle(byAngle) {}

    SoftContact& operator[](std::size_t i) { return m_contacts[i]; }
    const SoftContact& operator[](std::size_t i) const { return m_contacts[i]; }
    std::size_t size() const { return m_contacts.size(); }

    /// Puts the contacts found in place of those before, and hands on to each what it carried in the step before or when it was put
    /// aside.
    /// @param found     in order
    /// @param pairTaken (first, last) called for each pair with its contacts as soon as they are there, so that memory is gone
    /// through
    ///                  once; from any thread
    void take(std::span<const Found> found, const std::function<void(std::size_t, std::size_t)>& pairTaken);
    /// Puts aside the contacts of what no longer stirs.
    /// @param froze  [bodies] in this step: their contacts keep the loads that they came to rest under
    void putAside(const Sleep& sleep, const std::vector<char>& froze);
    /// Drops the contacts of what is marked as leaving.
    void dropLeaving();

    /// Calls visit(contact) for the contacts of the latest step, but for those that were put aside.
    template <class Visit>
    void forEach(Visit visit) const {
        for (const SoftContact& contact : m_contacts) {
            if (!contact.aside) {
                visit(contact);
            }
        }
    }
    const SleepingContacts& asleep() const { return m_asleep; }
    /// @param colliderNumbered  null: there is none of this number
    void keep(Archive& archive, const std::function<Collider*(std::uint32_t)>& colliderNumbered);

private:
    using Key = std::pair<ColliderPair, std::uint32_t>;
    bool recall(SoftContact& contact) const;
    void takeRange(std::span<const Found> found, std::size_t first, std::size_t last, std::vector<Key>& recalled,
                   const std::function<void(std::size_t, std::size_t)>& pairTaken);

    WorkerPool& m_pool;
    bool m_byAngle;
    std::vector<SoftContact> m_contacts, m_previous;
    SleepingContacts m_asleep;
    std::vector<std::vector<Key>> m_recalled;  ///< keys of contacts that slept, by parts of the loop
};

}  // namespace rubble
