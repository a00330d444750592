#include "core/engine/soft/sleeping_contacts.h"

#include <algorithm>

namespace rubble {

void SleepingContacts::put(const SoftContact& contact) {
    std::vector<SoftContact>& contacts = m_pairs[contact.pair];
    if (contacts.empty()) {
        m_turned.insert(turned(contact.pair));
    }
    contacts.push_back(contact);
}

const std::vector<SoftContact>* SleepingContacts::of(ColliderPair pair) const {
    const auto found = m_pairs.find(pair);
    return found == m_pairs.end() ? nullptr : &found->second;
}

void SleepingContacts::remove(ColliderPair pair, std::uint32_t part) {
    const auto found = m_pairs.find(pair);
    if (found == m_pairs.end()) {
        return;
    }
    std::erase_if(found->second, [&](const SoftContact& c) { return c.part == part; });
    if (found->second.empty()) {
        m_turned.erase(turned(pair));
        m_pairs.erase(found);
    }
}

}  // namespace rubble
