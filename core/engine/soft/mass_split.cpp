#include "core/engine/soft/mass_split.h"

#include <algorithm>

namespace rubble {

namespace {

/// Contacts of a body from which on it is split. Fewer: more copies, which share a load in more passes.
constexpr std::uint32_t contactsOfOne = 48;
/// Contacts of each copy, at most. What its contacts meet has contacts of its own.
constexpr std::uint32_t contactsOfCopy = 24;

}  // namespace

void MassSplit::clear() {
    m_bodies.clear();
    m_added = 0;
}

void MassSplit::split(std::span<std::pair<std::uint32_t, std::uint32_t>> ends, std::size_t movable) {
    clear();
    std::vector<std::uint32_t> contacts(movable, 0);
    for (const auto& [a, b] : ends) {
        for (const std::uint32_t slot : {a, b}) {
            if (slot < movable) {
                ++contacts[slot];
            }
        }
    }
    constexpr std::uint32_t whole = 0xffffffffu;
    std::vector<std::uint32_t> splitOf(movable, whole);
    for (std::uint32_t slot = 0; slot < movable; ++slot) {
        if (contacts[slot] > contactsOfOne) {
            splitOf[slot] = static_cast<std::uint32_t>(m_bodies.size());
            const std::uint32_t copies = (contacts[slot] + contactsOfCopy - 1) / contactsOfCopy;
            m_bodies.push_back({slot, static_cast<std::uint32_t>(movable) + m_added, copies});
            m_added += copies - 1;
        }
    }
    if (m_bodies.empty()) {
        return;
    }
    // In turn, so that each copy is held where the whole body is.
    std::vector<std::uint32_t> next(m_bodies.size(), 0);
    const auto copyOf = [&](std::uint32_t slot) {
        if (slot >= movable) {
            return slot + m_added;
        }
        if (splitOf[slot] == whole) {
            return slot;
        }
        const SplitBody& body = m_bodies[splitOf[slot]];
        const std::uint32_t copy = next[splitOf[slot]]++ % body.copies;
        return copy == 0 ? slot : body.firstCopy + copy - 1;
    };
    for (auto& [a, b] : ends) {
        a = copyOf(a);
        b = copyOf(b);
    }
}

namespace {

/// Puts the mean of the first three of four numbers of each copy into all of them.
template <class Record, class Number>
void takeMean(const SplitBody& body, std::span<Record> records, Number (Record::*member)[4]) {
    for (std::size_t k = 0; k < 3; ++k) {
        Number sum = (records[body.slot].*member)[k];
        forEachCopy({&body, 1}, [&](std::size_t, std::size_t copy) { sum += (records[copy].*member)[k]; });
        const Number mean = sum / static_cast<Number>(body.copies);
        (records[body.slot].*member)[k] = mean;
        forEachCopy({&body, 1}, [&](std::size_t, std::size_t copy) { (records[copy].*member)[k] = mean; });
    }
}

}  // namespace

void joinVelocities(std::span<const SplitBody> split, std::span<LaneBody> bodies) {
    for (const SplitBody& body : split) {
        takeMean(body, bodies, &LaneBody::velocity);
        takeMean(body, bodies, &LaneBody::spin);
        // A contact has acted on the body if on any copy.
        double acted = bodies[body.slot].velocity[3];
        forEachCopy({&body, 1}, [&](std::size_t, std::size_t copy) { acted = std::max(acted, bodies[copy].velocity[3]); });
        bodies[body.slot].velocity[3] = acted;
    }
}

void joinWays(std::span<const SplitBody> split, std::span<LaneWay> ways) {
    for (const SplitBody& body : split) {
        takeMean(body, ways, &LaneWay::moved);
        takeMean(body, ways, &LaneWay::turned);
    }
}

}  // namespace rubble
