#include "widgets/render/pane_geometry.h"

namespace rubble::render {

void PaneGeometry::setFilter(const FragmentFilter& filter) {
    if (filter == m_filter) {
        return;
    }
    const bool opened = filter.empty() != m_filter.empty();
    m_filter = filter;
    m_filterSettled = false;
    if (opened && m_data.fragments) {
        makeFaces(m_carried);
    }
}

/// Brings what meets the filter to the time shown. True if that has changed.
bool PaneGeometry::settleFilter() {
    if (!m_data.fragments || (m_filterSettled && m_filter.speed.empty())) {
        return false;
    }
    m_filterSettled = true;
    std::vector<std::uint8_t> before = std::move(m_meets);
    m_meets.clear();
    if (!m_filter.empty()) {
        m_meets = meeting(m_filter, *m_data.fragments, m_data.components.get(),
                          m_filter.speed.empty() ? std::vector<double>() : speedsShown(m_data, m_carried ? &m_frame : nullptr));
    }
    return m_meets != before;
}

}  // namespace rubble::render
