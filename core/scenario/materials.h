#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rubble {

/// What a solid is made of, as far as contact and break-up care.
enum class Material : std::uint8_t { Stone, Concrete, Steel, Masonry, Soil, WaterBed };
inline constexpr std::size_t materialCount = 6;

/// "stone", "concrete", "steel", "masonry", "soil", "water_bed"
std::string_view materialName(Material material);

/// Contact of two materials.
struct PairProperties {
    double friction = 0.6;     ///< Coulomb coefficient
    double restitution = 0.1;  ///< normal, of rough blocks
    friend bool operator==(const PairProperties&, const PairProperties&) = default;
};

/// Friction and restitution of every pair of materials; symmetric.
class PairTable {
public:
    /// The sourced defaults (materials.cpp says where each comes from).
    PairTable();
    /// The same for every pair.
    static PairTable uniform(double friction, double restitution);

    const PairProperties& of(Material a, Material b) const { return m_pairs[index(a, b)]; }
    PairProperties& of(Material a, Material b) { return m_pairs[index(a, b)]; }
    friend bool operator==(const PairTable&, const PairTable&) = default;

private:
    static constexpr std::size_t index(Material a, Material b) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        return i < j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
    }
    std::array<PairProperties, materialCount*(materialCount + 1) / 2> m_pairs;
};

}  // namespace rubble
