#include "core/fe/material.h"

#include <algorithm>
#include <array>

namespace rubble {

std::string_view materialName(Material material) {
    static constexpr std::array<std::string_view, materialCount> names{"stone",   "concrete", "steel",
                                                                       "masonry", "soil",     "water_bed"};
    return names[static_cast<std::size_t>(material)];
}

std::optional<Material> materialNamed(std::string_view name) {
    for (std::size_t i = 0; i < materialCount; ++i) {
        if (materialName(static_cast<Material>(i)) == name) {
            return static_cast<Material>(i);
        }
    }
    return std::nullopt;
}

bool isMaterialDensity(double density) {
    return density >= leastMaterialDensity && density <= greatestMaterialDensity;
}

namespace {

/// kg/m3, from the least on and below the greatest.
struct DensityRange {
    Material material;
    double least;
    double below;
    bool holds(double density) const { return density >= least && density < below; }
};
constexpr std::array densityRanges{DensityRange{Material::Steel, 7000.0, 9000.0}, DensityRange{Material::Stone, 2550.0, 3500.0},
                                   DensityRange{Material::Masonry, 1400.0, 2100.0},
                                   DensityRange{Material::Concrete, 2100.0, 2550.0}};

}  // namespace

Material materialOfDensity(double density) {
    const auto found = std::find_if(densityRanges.begin(), densityRanges.end(),
                                    [density](const DensityRange& range) { return range.holds(density); });
    return found != densityRanges.end() ? found->material : Material::Concrete;
}

bool someMaterialFits(double density) {
    return !(density > 0.0) || std::any_of(densityRanges.begin(), densityRanges.end(),
                                           [density](const DensityRange& range) { return range.holds(density); });
}

bool isBodyMaterial(Material material) {
    return material != Material::Soil && material != Material::WaterBed;
}

bool fallsApart(Material material) {
    return material == Material::Stone || material == Material::Masonry;
}

}  // namespace rubble
