#include "core/simulation/birth_overlap.h"

#include <algorithm>

namespace rubble {

double BirthOverlaps::offset(ColliderPair pair, double depth, bool newborn) {
    if (newborn) {
        if (depth <= 0.0) {
            return 0.0;
        }
        m_entries[pair] = {depth, m_step, 0};
        return depth;
    }
    const auto entry = m_entries.find(pair);
    if (entry == m_entries.end()) {
        return 0.0;
    }
    entry->second.offset = std::min(entry->second.offset, depth);
    if (entry->second.offset > 0.0) {
        entry->second.seen = m_step;
        return entry->second.offset;
    }
    return 0.0;
}

bool BirthOverlaps::yield(ColliderPair pair, double depth) {
    Entry& entry = m_entries[pair];
    const bool first = entry.yielded + 1 < m_step || entry.yielded == 0;
    entry.offset = std::max(entry.offset, depth);
    entry.seen = m_step;
    entry.yielded = m_step;
    return first;
}

bool BirthOverlaps::yielded(ColliderPair pair) const {
    const auto entry = m_entries.find(pair);
    return entry != m_entries.end() && entry->second.yielded != 0 && entry->second.yielded + 1 >= m_step;
}

void BirthOverlaps::bleed(ColliderPair pair, double distance) {
    const auto entry = m_entries.find(pair);
    if (entry != m_entries.end()) {
        entry->second.offset -= distance;
    }
}

void BirthOverlaps::endStep() {
    std::erase_if(m_entries, [&](const auto& item) { return item.second.seen != m_step || item.second.offset <= 0.0; });
}

}  // namespace rubble
