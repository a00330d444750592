#include "core/fe/material.h"

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

Material materialOfDensity(double density) {
    if (density >= 7000.0 && density < 9000.0) {
        return Material::Steel;
    }
    if (density >= 2550.0 && density < 3500.0) {
        return Material::Stone;
    }
    return density >= 1400.0 && density < 2100.0 ? Material::Masonry : Material::Concrete;
}

bool isBodyMaterial(Material material) {
    return material != Material::Soil && material != Material::WaterBed;
}

bool fallsApart(Material material) {
    return material == Material::Stone || material == Material::Masonry;
}

}  // namespace rubble
