#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace rubble {

/// What a solid is made of, as far as contact and break-up care.
enum class Material : std::uint8_t { Stone, Concrete, Steel, Masonry, Soil, WaterBed };
inline constexpr std::size_t materialCount = 6;

/// "stone", "concrete", "steel", "masonry", "soil", "water_bed"
std::string_view materialName(Material material);
std::optional<Material> materialNamed(std::string_view name);

/// A guess where nobody says what a component is made of: from 7,000 to 9,000 kg/m3 steel, from 2,550 to 3,500 stone (granite,
/// limestone, sandstone: 2,550 to 2,800), from 1,400 to 2,100 masonry (brickwork), anything else concrete (2,200 to 2,500, or a
/// slab that carries the mass of something else).
Material materialOfDensity(double density);

/// Whether that guess fits, or no density is known. Nothing fits tungsten, lead or timber: such a component meets others as
/// concrete does, and nobody should be told that it is concrete.
bool someMaterialFits(double density);

inline constexpr double leastMaterialDensity = 25.0;        ///< kg/m3: foam
inline constexpr double greatestMaterialDensity = 22000.0;  ///< kg/m3: heavier than lead
/// Whether anything that is built has this density, kg/m3. Outside of it a file is hardly read in its units.
bool isMaterialDensity(double density);

/// Whether a body may be made of it; soil and water bed are only ground.
bool isBodyMaterial(Material material);

/// Whether a cluster of it falls apart on a hard hit: stone and masonry. Concrete and steel hold together.
bool fallsApart(Material material);

}  // namespace rubble
