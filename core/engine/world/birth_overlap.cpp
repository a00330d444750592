#include "core/engine/world/birth_overlap.h"

#include <algorithm>

#include "core/engine/world/scene_rules.h"

namespace rubble {

double BirthOverlaps::offset(ColliderPair pair, double depth, bool newborn) {
    if (newborn) {
        if (depth <= 0.0) {
            return 0.0;
        }
        m_entries[pair] = {depth, m_step, 0, 0, 0.0, true};
        return depth;
    }
    const auto entry = m_entries.find(pair);
    if (entry == m_entries.end()) {
        return 0.0;
    }
    entry->second.offset = std::clamp(depth, 0.0, entry->second.offset);
    entry->second.seen = m_step;
    return entry->second.offset;
}

bool BirthOverlaps::yielded(ColliderPair pair) const {
    const auto entry = m_entries.find(pair);
    return entry != m_entries.end() && entry->second.yielded;
}

void BirthOverlaps::follow(ColliderPair pair, double depth) {
    Entry& entry = m_entries[pair];
    entry.offset = std::max(entry.offset, depth);
    entry.seen = m_step;
}

bool BirthOverlaps::pushedInVain(ColliderPair pair, double depth) {
    Entry& entry = m_entries[pair];
    entry.pushes = entry.pushed + 1 == m_step ? entry.pushes + 1 : 1;
    entry.pushed = entry.seen = m_step;
    if (!givesWayToPushes(entry.pushes)) {
        return false;
    }
    entry.yielded = true;
    entry.offset = std::max(entry.offset, depth);
    return true;
}

double BirthOverlaps::pressLeft(ColliderPair pair) const {
    const auto entry = m_entries.find(pair);
    return rubble::pressLeft(entry == m_entries.end() ? 0.0 : entry->second.pressed);
}

bool BirthOverlaps::pressed(ColliderPair pair, double depth, double speed) {
    Entry& entry = m_entries[pair];
    entry.pushed = entry.seen = m_step;
    if (!givesWayToPress(entry.pressed, speed)) {
        return false;
    }
    entry.yielded = true;
    entry.offset = std::max(entry.offset, depth);
    return true;
}

void BirthOverlaps::bleed(ColliderPair pair, double distance) {
    const auto entry = m_entries.find(pair);
    if (entry != m_entries.end()) {
        entry->second.offset -= distance;
    }
}

void BirthOverlaps::endStep() {
    std::erase_if(m_entries, [&](const auto& item) {
        return item.second.seen != m_step || (item.second.offset <= 0.0 && item.second.pushed != m_step);
    });
}

}  // namespace rubble
