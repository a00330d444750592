#include "core/scenario/materials.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/nearest_names.h"

namespace rubble {

namespace {

// Friction.
constexpr std::string_view quarried = "NAVFAC DM 7.02 (1986): dressed rock on dressed rock 0.55-0.70";
constexpr std::string_view hardened = "ACI 318 (2019): concrete on hardened concrete that was not roughened 0.6";
constexpr std::string_view onSoil = "NAVFAC DM 7.02 (1986): concrete or masonry on gravel and coarse sand 0.55-0.60";
constexpr std::string_view onBed =
    "NAVFAC DM 7.02 (1986): concrete or masonry on silty sand or gravel 0.45-0.55, on fine silty sand 0.35-0.45";
constexpr std::string_view steelOn =
    "Baltay & Gjelsvik (1990): sliding about 0.47; Rabbat & Russell (1985): cast on, at rest, 0.57-0.70";
constexpr std::string_view steelOnSteel =
    "NAVFAC DM 7.02 (1986): sheet pile interlocks 0.30; Avallone & Baumeister (1996): sliding, dry, 0.42-0.57";
constexpr std::string_view steelOnSoil = "NAVFAC DM 7.02 (1986): steel sheet piles on gravel 0.40, on sand 0.30";
constexpr std::string_view steelOnBed = "NAVFAC DM 7.02 (1986): steel sheet piles on silty sand 0.25, on silt 0.20";
// Restitution.
constexpr std::string_view hard =
    "Wyllie (2014): about 0.2 for normal impacts in the field on rock and concrete; laboratory 0.3-0.5, Asteriou & Tsiambaos "
    "(2018)";
constexpr std::string_view steel = "lower end of the laboratory values for hard blocks, 0.3-0.5, Asteriou & Tsiambaos (2018)";
constexpr std::string_view soft = "lower half of the range for soil and rubble, 0.05-0.3, Wyllie (2014)";
constexpr std::string_view bed = "lower end of the range for soil, 0.05-0.3, Wyllie (2014)";

}  // namespace

const std::vector<PairSource>& pairSources() {
    using enum Material;
    static const std::vector<PairSource> rows{
        {{Stone, Stone}, {0.65, 0.2}, quarried, hard},      {{Stone, Concrete}, {0.65, 0.2}, quarried, hard},
        {{Stone, Steel}, {0.45, 0.2}, steelOn, hard},       {{Stone, Masonry}, {0.65, 0.2}, quarried, hard},
        {{Stone, Soil}, {0.55, 0.1}, onSoil, soft},         {{Stone, WaterBed}, {0.45, 0.05}, onBed, bed},
        {{Concrete, Concrete}, {0.6, 0.2}, hardened, hard}, {{Concrete, Steel}, {0.45, 0.2}, steelOn, hard},
        {{Concrete, Masonry}, {0.6, 0.2}, hardened, hard},  {{Concrete, Soil}, {0.55, 0.1}, onSoil, soft},
        {{Concrete, WaterBed}, {0.45, 0.05}, onBed, bed},   {{Steel, Steel}, {0.4, 0.3}, steelOnSteel, steel},
        {{Steel, Masonry}, {0.45, 0.2}, steelOn, hard},     {{Steel, Soil}, {0.4, 0.1}, steelOnSoil, soft},
        {{Steel, WaterBed}, {0.25, 0.05}, steelOnBed, bed}, {{Masonry, Masonry}, {0.65, 0.2}, quarried, hard},
        {{Masonry, Soil}, {0.55, 0.1}, onSoil, soft},       {{Masonry, WaterBed}, {0.45, 0.05}, onBed, bed},
    };
    return rows;
}

const std::vector<MaterialPair>& materialPairs() {
    static const std::vector<MaterialPair> pairs = [] {
        std::vector<MaterialPair> all;
        for (const PairSource& row : pairSources()) {
            all.push_back(row.pair);
        }
        return all;
    }();
    return pairs;
}

std::string pairName(MaterialPair pair) {
    return std::string(materialName(pair.first)) + "," + std::string(materialName(pair.second));
}

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? std::string_view() : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

[[noreturn]] void refuseMaterial(std::string_view name) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < materialCount; ++i) {
        names.emplace_back(materialName(static_cast<Material>(i)));
    }
    throw UsageError({"material.unknown", "There is no material \"{0}\".", {name}},
                     {"material.near", "Did you mean one of {0}?", {quotedList(nearestNames(name, names, 3))}});
}

}  // namespace

std::optional<MaterialPair> pairNamed(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) {
        return std::nullopt;
    }
    const auto a = materialNamed(trimmed(text.substr(0, comma))), b = materialNamed(trimmed(text.substr(comma + 1)));
    if (!a || !b || !(isBodyMaterial(*a) || isBodyMaterial(*b))) {
        return std::nullopt;
    }
    return std::minmax(*a, *b);
}

MaterialPair pairFrom(std::string_view text) {
    if (const auto pair = pairNamed(text)) {
        return *pair;
    }
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) {
        throw UsageError({"material.no_pair", "\"{0}\" is not a pair of materials.", {text}},
                         {"material.no_pair.remedy", "Give two materials with a comma between them, such as stone,soil.", {}});
    }
    for (const std::string_view name : {trimmed(text.substr(0, comma)), trimmed(text.substr(comma + 1))}) {
        if (!materialNamed(name)) {
            refuseMaterial(name);
        }
    }
    throw UsageError({"material.no_body", "\"{0}\" never meet: no body is made of either.", {text}},
                     {"material.no_body.remedy", "One of the two is stone, concrete, steel or masonry.", {}});
}

PairTable::PairTable() {
    for (const PairSource& row : pairSources()) {
        of(row.pair.first, row.pair.second) = row.value;
    }
}

PairTable PairTable::uniform(double friction, double restitution) {
    return PairTable().overriddenBy(friction, restitution);
}

PairTable PairTable::overriddenBy(std::optional<double> friction, std::optional<double> restitution) const {
    PairTable table = *this;
    for (PairProperties& pair : table.m_pairs) {
        pair = {friction.value_or(pair.friction), restitution.value_or(pair.restitution)};
    }
    return table;
}

}  // namespace rubble
