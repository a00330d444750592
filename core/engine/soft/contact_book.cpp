#include "core/engine/soft/contact_book.h"

#include <algorithm>

#include "core/base/prefetch.h"

namespace rubble {

namespace {

bool isBefore(const SoftContact& x, const Found& y) {
    return x.pair != y.pair ? x.pair < y.pair : x.part < y.part;
}

}  // namespace

void ContactBook::take(std::span<const Found> found, const std::function<void(std::size_t, std::size_t)>& pairTaken) {
    m_previous.swap(m_contacts);
    m_contacts.resize(found.size());
    constexpr std::size_t grain = 256;
    m_recalled.resize(std::max(m_recalled.size(), found.size() / grain + 1));
    m_pool.loop(found.size(), grain, [&](std::size_t first, std::size_t last) {
        std::vector<Key>& recalled = m_recalled[first / grain];
        recalled.clear();
        // A pair belongs to the part in which it begins.
        while (first > 0 && first < last && found[first].pair == found[first - 1].pair) {
            ++first;
        }
        takeRange(found, first, last, recalled, pairTaken);
    });
    for (std::size_t part = 0; part * grain < found.size(); ++part) {
        for (const auto& [pair, which] : m_recalled[part]) {
            m_asleep.remove(pair, which);
        }
    }
}

void ContactBook::takeRange(std::span<const Found> found, std::size_t first, std::size_t last, std::vector<Key>& recalled,
                            const std::function<void(std::size_t, std::size_t)>& pairTaken) {
    if (first == last) {
        return;
    }
    auto before = std::lower_bound(m_previous.begin(), m_previous.end(), found[first], isBefore);
    while (first < last) {
        const ColliderPair pair = found[first].pair;
        std::size_t end = first;
        for (; end < found.size() && found[end].pair == pair; ++end) {
            if (end + recordsAhead < found.size()) {
                prefetch(*found[end + recordsAhead].contact);
            }
            SoftContact& contact = m_contacts[end];
            rubble::take(*found[end].contact, contact);
            while (before != m_previous.end() && isBefore(*before, found[end])) {
                ++before;
            }
            if (before != m_previous.end() && before->key() == contact.key() && !before->aside) {
                carryOver(*before, contact, m_byAngle);
            } else if (recall(contact)) {
                recalled.push_back(contact.key());
            }
        }
        pairTaken(first, end);
        first = end;
    }
}

/// A contact that was not there in the step before may have been put aside when both of its bodies came to rest.
bool ContactBook::recall(SoftContact& contact) const {
    const std::vector<SoftContact>* const kept = m_asleep.of(contact.pair);
    if (kept == nullptr) {
        return false;
    }
    const auto same = std::find_if(kept->begin(), kept->end(), [&](const SoftContact& c) { return c.part == contact.part; });
    if (same == kept->end()) {
        return false;
    }
    carryOver(*same, contact, m_byAngle);
    return true;
}

void ContactBook::putAside(const Sleep& sleep, const std::vector<char>& froze) {
    const auto frozeNow = [&](const Collider& c) { return c.kind == ColliderKind::Body && froze[c.index] != 0; };
    m_pool.loop(m_contacts.size(), 512, [&](std::size_t first, std::size_t last) {
        for (SoftContact& contact : std::span(m_contacts).subspan(first, last - first)) {
            if (frozeNow(*contact.a) || frozeNow(*contact.b)) {
                contact.restLoad = contact.load;
            }
            contact.aside = !sleep.stirs(*contact.a) && !sleep.stirs(*contact.b);
        }
    });
    for (const SoftContact& contact : m_contacts) {
        if (contact.aside) {
            m_asleep.put(contact);
        }
    }
}

void ContactBook::dropLeaving() {
    const auto gone = [](const SoftContact& c) { return c.a->leaving || c.b->leaving; };
    std::erase_if(m_contacts, gone);
    m_asleep.removeIf(gone);
}

void ContactBook::keep(Archive& archive, const std::function<Collider*(std::uint32_t)>& colliderNumbered) {
    const auto keepContacts = [&](Archive& to, std::vector<SoftContact>& contacts) {
        to(contacts);
        for (SoftContact& contact : contacts) {
            if (!to.reading()) {
                break;
            }
            contact.a = colliderNumbered(firstOf(contact.pair));
            contact.b = colliderNumbered(secondOf(contact.pair));
            if (contact.a == nullptr || contact.b == nullptr) {
                Archive::fail();
            }
        }
    };
    std::erase_if(m_contacts, [](const SoftContact& c) { return c.aside; });
    keepContacts(archive, m_contacts);
    m_asleep.keep(archive, keepContacts);
}

}  // namespace rubble
