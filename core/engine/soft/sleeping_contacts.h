#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/base/archive.h"
#include "core/engine/soft/soft_contact.h"

namespace rubble {

/// Contacts of pairs that no longer stir, kept apart from those that are looked at in every step, until one of the two stirs again.
class SleepingContacts {
public:
    bool empty() const { return m_pairs.empty(); }
    void put(const SoftContact& contact);
    /// Those of a pair; null: none. Any number of threads.
    const std::vector<SoftContact>* of(ColliderPair pair) const;
    /// Takes out one, if it is there.
    void remove(ColliderPair pair, std::uint32_t part);
    /// Takes out every pair whose contacts this is true of.
    template <class Gone>
    void removeIf(Gone gone) {
        std::erase_if(m_pairs, [&](const auto& entry) {
            const bool goes = gone(entry.second.front());
            if (goes) {
                m_turned.erase(turned(entry.first));
            }
            return goes;
        });
    }
    /// Calls visit(contact) with one contact of every pair, in the order of the pairs.
    template <class Visit>
    void forEachPair(Visit visit) const {
        for (const auto& [pair, contacts] : m_pairs) {
            visit(contacts.front());
        }
    }
    /// The same of every pair that the collider of this number belongs to.
    template <class Visit>
    void forEachPairOf(std::uint32_t number, Visit visit) const {
        const ColliderPair begin = ColliderPair{number} << 32;
        for (auto i = m_turned.lower_bound(begin); i != m_turned.end() && firstOf(*i) == number; ++i) {
            visit(m_pairs.find(turned(*i))->second.front());
        }
        for (auto i = m_pairs.lower_bound(begin); i != m_pairs.end() && firstOf(i->first) == number; ++i) {
            visit(i->second.front());
        }
    }
    /// Visits the contacts of each pair in order. @param keepContacts  (archive, contacts): all members, a and b included
    template <class KeepContacts>
    void keep(Archive& archive, KeepContacts keepContacts) {
        const std::size_t pairs = archive.count(m_pairs.size());
        auto next = m_pairs.begin();
        for (std::size_t i = 0; i < pairs; ++i) {
            if (!archive.reading()) {
                keepContacts(archive, (next++)->second);
                continue;
            }
            std::vector<SoftContact> contacts;
            keepContacts(archive, contacts);
            if (contacts.empty()) {
                Archive::fail();
            }
            const ColliderPair pair = contacts.front().pair;
            m_turned.insert(turned(pair));
            m_pairs.emplace_hint(m_pairs.end(), pair, std::move(contacts));
        }
    }

private:
    /// The later one first.
    static ColliderPair turned(ColliderPair pair) { return pair << 32 | pair >> 32; }

    std::map<ColliderPair, std::vector<SoftContact>> m_pairs;
    std::set<ColliderPair> m_turned;  ///< the same pairs, to be found by the later of the two
};

}  // namespace rubble
