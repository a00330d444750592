#include "core/scenario/materials.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/nearest_names.h"

namespace rubble {

namespace {

// Friction.
constexpr std::string_view quarried = "NAVFAC DM 7.02 (1986): dressed rock on dressed rock 0.55-0.70";
constexpr std::string_view hardened = "ACI 318 (2019): concrete on hardened concrete that was not roughened 0.6";
constexpr std::string_view onSoil =
    "NAVFAC DM 7.02 (1986): concrete or masonry on gravel and coarse sand 0.55-0.60, on silty sand or gravel 0.45-0.55, on fine "
    "silty sand 0.35-0.45, on silt and soft clay 0.30-0.35";
constexpr std::string_view onBed =
    "NAVFAC DM 7.02 (1986): concrete or masonry on silty sand or gravel 0.45-0.55, on fine silty sand 0.35-0.45";
constexpr std::string_view steelOn =
    "Baltay & Gjelsvik (1990): sliding about 0.47; Rabbat & Russell (1985): cast on, at rest, 0.57-0.70";
constexpr std::string_view steelOnSteel =
    "NAVFAC DM 7.02 (1986): sheet pile interlocks 0.30; Avallone & Baumeister (1996): sliding, dry, 0.42-0.57";
constexpr std::string_view steelOnSoil =
    "NAVFAC DM 7.02 (1986): steel sheet piles on gravel 0.40, on sand 0.30, on silty sand 0.25, on silt 0.20";
constexpr std::string_view steelOnBed = "NAVFAC DM 7.02 (1986): steel sheet piles on silty sand 0.25, on silt 0.20";
// Restitution.
constexpr std::string_view hard =
    "Wyllie (2014): about 0.2 for normal impacts in the field on rock and concrete; laboratory 0.3-0.5, Asteriou & Tsiambaos "
    "(2018)";
constexpr std::string_view steel = "lower end of the laboratory values for hard blocks, 0.3-0.5, Asteriou & Tsiambaos (2018)";
constexpr std::string_view soft = "lower half of the range for soil and rubble, 0.05-0.3, Wyllie (2014)";
constexpr std::string_view bed = "lower end of the range for soil, 0.05-0.3, Wyllie (2014)";

// Ranges of these sources. Assumed: the source has one number, or those of another pair.
constexpr CoefficientRange quarriedRange{0.55, 0.70};
constexpr CoefficientRange quarriedForOthers{0.55, 0.70, true};
constexpr CoefficientRange hardenedRange{0.5, 0.7, true};
constexpr CoefficientRange onSoilRange{0.30, 0.60};
constexpr CoefficientRange onBedRange{0.35, 0.55};
constexpr CoefficientRange steelOnRange{0.4, 0.57, true};
constexpr CoefficientRange steelOnSteelRange{0.30, 0.57};
constexpr CoefficientRange steelOnSoilRange{0.20, 0.40};
constexpr CoefficientRange steelOnBedRange{0.20, 0.25};
constexpr CoefficientRange hardRange{0.2, 0.5};
constexpr CoefficientRange hardForOthers{0.2, 0.5, true};
constexpr CoefficientRange steelRange{0.3, 0.5, true};
constexpr CoefficientRange softRange{0.05, 0.3};
constexpr CoefficientRange softForOthers{0.05, 0.3, true};

}  // namespace

const std::vector<PairSource>& pairSources() {
    using enum Material;
    static const std::vector<PairSource> rows{
        {{Stone, Stone}, {0.65, 0.2}, quarried, hard, quarriedRange, hardRange},
        {{Stone, Concrete}, {0.65, 0.2}, quarried, hard, quarriedForOthers, hardRange},
        {{Stone, Steel}, {0.45, 0.2}, steelOn, hard, steelOnRange, hardForOthers},
        {{Stone, Masonry}, {0.65, 0.2}, quarried, hard, quarriedForOthers, hardForOthers},
        {{Stone, Soil}, {0.55, 0.1}, onSoil, soft, onSoilRange, softRange},
        {{Stone, WaterBed}, {0.45, 0.05}, onBed, bed, onBedRange, softForOthers},
        {{Concrete, Concrete}, {0.6, 0.2}, hardened, hard, hardenedRange, hardRange},
        {{Concrete, Steel}, {0.45, 0.2}, steelOn, hard, steelOnRange, hardForOthers},
        {{Concrete, Masonry}, {0.6, 0.2}, hardened, hard, hardenedRange, hardForOthers},
        {{Concrete, Soil}, {0.55, 0.1}, onSoil, soft, onSoilRange, softForOthers},
        {{Concrete, WaterBed}, {0.45, 0.05}, onBed, bed, onBedRange, softForOthers},
        {{Steel, Steel}, {0.4, 0.3}, steelOnSteel, steel, steelOnSteelRange, steelRange},
        {{Steel, Masonry}, {0.45, 0.2}, steelOn, hard, steelOnRange, hardForOthers},
        {{Steel, Soil}, {0.4, 0.1}, steelOnSoil, soft, steelOnSoilRange, softForOthers},
        {{Steel, WaterBed}, {0.25, 0.05}, steelOnBed, bed, steelOnBedRange, softForOthers},
        {{Masonry, Masonry}, {0.65, 0.2}, quarried, hard, quarriedForOthers, hardForOthers},
        {{Masonry, Soil}, {0.55, 0.1}, onSoil, soft, onSoilRange, softForOthers},
        {{Masonry, WaterBed}, {0.45, 0.05}, onBed, bed, onBedRange, softForOthers},
    };
    return rows;
}

Message rangeText(const CoefficientRange& range) {
    // As texts: digits beyond those of the source say nothing.
    const std::string low = englishNumber(range.low), high = englishNumber(range.high);
    return range.assumed ? Message{"material.range_assumed", "{0} to {1}, assumed", {low, high}}
                         : Message{"material.range", "{0} to {1}", {low, high}};
}

const PairSource* pairSource(MaterialPair pair) {
    const auto& rows = pairSources();
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const PairSource& row) { return row.pair == pair; });
    return found != rows.end() ? &*found : nullptr;
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

PairTable PairTable::atLevels(std::optional<double> friction, std::optional<double> restitution) const {
    const auto move = [](double& value, double byDefault, const CoefficientRange& range, std::optional<double> level) {
        if (level && value == byDefault) {
            value = range.low + *level * (range.high - range.low);
        }
    };
    PairTable table = *this;
    for (const PairSource& row : pairSources()) {
        PairProperties& pair = table.of(row.pair.first, row.pair.second);
        move(pair.friction, row.value.friction, row.frictionRange, friction);
        move(pair.restitution, row.value.restitution, row.restitutionRange, restitution);
    }
    return table;
}

PairTable PairTable::overriddenBy(std::optional<double> friction, std::optional<double> restitution) const {
    PairTable table = *this;
    for (PairProperties& pair : table.m_pairs) {
        pair = {friction.value_or(pair.friction), restitution.value_or(pair.restitution)};
    }
    return table;
}

}  // namespace rubble
