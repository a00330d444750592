#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/fe/material.h"

namespace rubble {

/// Contact of two materials.
struct PairProperties {
    double friction = 0.6;     ///< Coulomb coefficient
    double restitution = 0.1;  ///< normal, of rough blocks
    friend bool operator==(const PairProperties&, const PairProperties&) = default;
};

/// Two materials, the lower one first.
using MaterialPair = std::pair<Material, Material>;

/// Every pair of which at least one can be a body, in the order of the materials.
const std::vector<MaterialPair>& materialPairs();
/// "stone,soil"
std::string pairName(MaterialPair pair);
/// "stone,soil" or "soil, stone" as a pair; nothing if it names none.
std::optional<MaterialPair> pairNamed(std::string_view text);
/// The same, or a UsageError naming the nearest materials.
MaterialPair pairFrom(std::string_view text);

/// Friction and restitution of every pair of materials; symmetric.
class PairTable {
public:
    /// The sourced defaults (pairSources()).
    PairTable();
    /// The same for every pair.
    static PairTable uniform(double friction, double restitution);

    const PairProperties& of(Material a, Material b) const { return m_pairs[index(a, b)]; }
    PairProperties& of(Material a, Material b) { return m_pairs[index(a, b)]; }
    /// The table with one number in every pair where one is given.
    PairTable overriddenBy(std::optional<double> friction, std::optional<double> restitution) const;
    friend bool operator==(const PairTable&, const PairTable&) = default;

private:
    static constexpr std::size_t index(Material a, Material b) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        return i < j ? j * (j + 1) / 2 + i : i * (i + 1) / 2 + j;
    }
    std::array<PairProperties, materialCount*(materialCount + 1) / 2> m_pairs;
};

/// Where a default value of the table comes from.
struct PairSource {
    MaterialPair pair;
    PairProperties value;
    std::string_view friction;     ///< author, year, range
    std::string_view restitution;  ///< the same
};
/// One row for each of materialPairs().
const std::vector<PairSource>& pairSources();

}  // namespace rubble
