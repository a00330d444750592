#include "core/scenario/materials.h"

namespace rubble {

std::string_view materialName(Material material) {
    static constexpr std::array<std::string_view, materialCount> names{"stone",   "concrete", "steel",
                                                                       "masonry", "soil",     "water_bed"};
    return names[static_cast<std::size_t>(material)];
}

PairTable::PairTable() {
    using enum Material;
    // Ranges of Wyllie (2014) and Asteriou & Tsiambaos (2018) for blocks; the middle of each.
    for (PairProperties& pair : m_pairs) {
        pair = {0.65, 0.15};
    }
    for (const Material solid : {Stone, Concrete, Masonry}) {
        of(solid, Steel) = {0.45, 0.2};
        of(solid, Soil) = {0.55, 0.1};
        of(solid, WaterBed) = {0.5, 0.05};
    }
    of(Steel, Steel) = {0.4, 0.3};
    of(Steel, Soil) = {0.45, 0.1};
    of(Steel, WaterBed) = {0.4, 0.05};
}

PairTable PairTable::uniform(double friction, double restitution) {
    PairTable table;
    for (PairProperties& pair : table.m_pairs) {
        pair = {friction, restitution};
    }
    return table;
}

}  // namespace rubble
