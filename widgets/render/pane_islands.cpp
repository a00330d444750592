#include <algorithm>
#include <map>

#include "widgets/render/basics/colour_choice.h"
#include "widgets/render/pane_geometry.h"
#include "widgets/render/shapes/island_colours.h"

namespace rubble::render {

/// The looks of loose islands, after those of the structure that stands, and which of them each element has at a time. True if that
/// has changed.
bool PaneGeometry::settleIslands(double time, ColourBy colourBy, const ColourScale& scale) {
    m_status.islandsKnown = m_data.loose != nullptr;
    m_firstIslandLook = static_cast<std::uint32_t>(m_looks.size());
    if (colourBy != ColourBy::Island || !m_data.loose) {
        const bool changed = !m_islandOf.empty();
        m_islandOf.clear();
        m_islandColours.clear();
        m_status.islands.clear();
        return changed;
    }
    const std::vector<std::uint32_t> categories = colour_choice::unlikeFragments(scale.colours);
    for (const std::uint32_t category : categories) {
        m_looks.push_back(colour_choice::category(scale.colours, category));
    }
    const std::vector<double>& times = m_data.fe->times();
    const auto after = std::upper_bound(times.begin(), times.end(), time) - times.begin();
    const std::size_t state = after > 0 ? static_cast<std::size_t>(after) - 1 : 0;
    if (m_islandOf.empty() || m_islandCategories != categories.size()) {
        m_islandCategories = categories.size();
        m_islandColours = islandColours(*m_data.loose, categories.size());
    } else if (state == m_islandState) {
        return false;
    }
    m_islandState = state;
    m_islandOf.assign(m_data.fe->mesh().elementCount(), inNoIsland);
    std::map<std::uint32_t, std::size_t> counts;
    for (const LooseStructure::Member& member : m_data.loose->members[state]) {
        m_islandOf[at(member.element)] = member.island;
        ++counts[member.island];
    }
    m_status.islands.clear();
    for (const auto& [island, elements] : counts) {
        m_status.islands.push_back({island, elements, categories[m_islandColours[island]]});
    }
    std::ranges::stable_sort(m_status.islands, std::greater<>(), &ShownIsland::elements);
    return true;
}

std::uint32_t PaneGeometry::lookOf(ElementIndex element) const {
    const std::uint32_t island = m_islandOf.empty() ? inNoIsland : m_islandOf[at(element)];
    return island != inNoIsland ? m_firstIslandLook + m_islandColours[island] : m_lookOf[componentOf(element)];
}

}  // namespace rubble::render
