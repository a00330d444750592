#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/message.h"
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
    /// The table at one level of the ranges of its sources, 0 the least of each and 1 the greatest; pairs that are not as by
    /// default stay as they are.
    PairTable atLevels(std::optional<double> friction, std::optional<double> restitution) const;
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

/// What is known of a coefficient: each number from the least to the greatest is as likely.
struct CoefficientRange {
    double low = 0.0;
    double high = 0.0;
    bool assumed = false;  ///< no source has this range for this pair
};
/// "0.35 to 0.6", of an assumed one "0.5 to 0.7, assumed".
Message rangeText(const CoefficientRange& range);

/// Where a default value of the table comes from.
struct PairSource {
    MaterialPair pair;
    PairProperties value;
    std::string_view friction;          ///< author, year, range
    std::string_view restitution;       ///< the same
    CoefficientRange frictionRange;     ///< holds the value
    CoefficientRange restitutionRange;  ///< the same
};
/// One row for each of materialPairs().
const std::vector<PairSource>& pairSources();
/// The row of a pair of materialPairs(); null for another.
const PairSource* pairSource(MaterialPair pair);

}  // namespace rubble
