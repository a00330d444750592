#include "widgets/render/shown_counts.h"

#include <algorithm>
#include <cmath>

namespace rubble::render {

ElementCounts::ElementCounts(const ShowTimes& times) {
    std::vector<std::pair<double, std::int64_t>> changes;
    for (const TimeSpan& span : times.spans) {
        if (!(span.from < span.to)) {
            continue;
        }
        if (std::isinf(span.from)) {
            ++m_before;
        } else {
            changes.emplace_back(span.from, 1);
        }
        if (!std::isinf(span.to)) {
            changes.emplace_back(span.to, -1);
        }
    }
    std::sort(changes.begin(), changes.end());
    std::int64_t count = m_before;
    for (const auto& [time, change] : changes) {
        count += change;
        if (m_times.empty() || m_times.back() != time) {
            m_times.push_back(time);
            m_counts.push_back(count);
        } else {
            m_counts.back() = count;
        }
    }
}

std::size_t ElementCounts::at(double time) const {
    const auto after = std::upper_bound(m_times.begin(), m_times.end(), time);
    return static_cast<std::size_t>(after == m_times.begin() ? m_before
                                                             : m_counts[static_cast<std::size_t>(after - m_times.begin()) - 1]);
}

FragmentSlots::FragmentSlots(const FragmentSet& fragments, const Clustering* clusters, std::size_t components, bool carried)
    : m_fragments(fragments), m_clusters(clusters), m_bornInCluster(clusters ? clusters->list.size() : 0, 0) {
    m_counts.bornByComponent.assign(components, 0);
    for (const Fragment& f : fragments.list) {
        m_events.insert(m_events.end(), {carried ? f.handOverTime : f.birthTime, f.birthTime, f.endTime});
    }
    std::sort(m_events.begin(), m_events.end());
    m_events.erase(std::unique(m_events.begin(), m_events.end()), m_events.end());
    m_offsets.assign(m_events.size() + 2, 0);
    const auto slotOf = [this](double time) { return static_cast<std::uint32_t>(slotAt(time)); };
    std::vector<std::pair<std::uint32_t, std::uint32_t>> changes;
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        const Fragment& fragment = fragments.list[f];
        const Span span{slotOf(carried ? fragment.handOverTime : fragment.birthTime), slotOf(fragment.birthTime),
                        slotOf(fragment.endTime)};
        m_spans.push_back(span);
        for (const std::uint32_t slot : {span.drawn, span.birth, span.end}) {
            changes.emplace_back(slot, static_cast<std::uint32_t>(f));
        }
    }
    std::sort(changes.begin(), changes.end());
    changes.erase(std::unique(changes.begin(), changes.end()), changes.end());
    for (const auto& [slot, fragment] : changes) {
        ++m_offsets[slot + 1];
        m_changing.push_back(fragment);
    }
    for (std::size_t slot = 1; slot < m_offsets.size(); ++slot) {
        m_offsets[slot] += m_offsets[slot - 1];
    }
    // Slot 0 lies before every event, where nothing is drawn.
}

std::size_t FragmentSlots::slotAt(double time) const {
    return static_cast<std::size_t>(std::upper_bound(m_events.begin(), m_events.end(), time) - m_events.begin());
}

/// Counts a fragment in or out as what it is in a slot.
void FragmentSlots::count(std::uint32_t fragment, std::size_t slot, bool in) {
    const auto change = [in](auto& number) { in ? ++number : --number; };
    if (!born(fragment, slot)) {
        if (drawn(fragment, slot)) {
            change(m_counts.onTheWay);
        }
        return;
    }
    change(m_counts.born);
    const std::size_t component = rubble::at(m_fragments.list[fragment].component);
    if (component < m_counts.bornByComponent.size()) {
        change(m_counts.bornByComponent[component]);
    }
    if (m_clusters) {
        std::uint32_t& own = m_bornInCluster[rubble::at(m_clusters->of[fragment])];
        const bool was = own > 0;
        change(own);
        if (was != (own > 0)) {
            change(m_counts.clusters);
        }
    }
}

const FragmentSlots::Counts& FragmentSlots::countsAt(std::size_t slot) {
    while (m_slot != slot) {
        const std::size_t to = m_slot < slot ? m_slot + 1 : m_slot - 1;
        const std::size_t boundary = std::max(m_slot, to);
        for (std::size_t i = m_offsets[boundary]; i < m_offsets[boundary + 1]; ++i) {
            count(m_changing[i], m_slot, false);
            count(m_changing[i], to, true);
        }
        m_slot = to;
    }
    return m_counts;
}

}  // namespace rubble::render
