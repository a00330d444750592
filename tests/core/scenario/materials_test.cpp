#include "core/scenario/materials.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "core/base/error.h"
#include "core/base/message.h"
#include "core/fe/components.h"
#include "tests/scenes/fe_scenes.h"
#include "tests/support/places.h"

namespace rubble {
namespace {

TEST(Materials, HaveNamesThatReadBack) {
    for (std::size_t i = 0; i < materialCount; ++i) {
        const auto material = static_cast<Material>(i);
        EXPECT_EQ(materialNamed(materialName(material)), material);
    }
    EXPECT_FALSE(materialNamed("timber"));
    EXPECT_FALSE(materialNamed(""));
}

TEST(Materials, AreGuessedFromDensityEitherSideOfTheStatedLimits) {
    for (const auto& [density, material] :
         {std::pair(7850.0, Material::Steel), std::pair(8999.0, Material::Steel), std::pair(9000.0, Material::Concrete),
          std::pair(7000.0, Material::Steel), std::pair(6999.0, Material::Concrete), std::pair(3500.0, Material::Concrete),
          std::pair(3499.0, Material::Stone), std::pair(2550.0, Material::Stone), std::pair(2549.0, Material::Concrete),
          std::pair(2100.0, Material::Concrete), std::pair(2099.0, Material::Masonry), std::pair(1400.0, Material::Masonry),
          std::pair(1399.0, Material::Concrete), std::pair(0.0, Material::Concrete),
          std::pair(std::numeric_limits<double>::quiet_NaN(), Material::Concrete)}) {
        EXPECT_EQ(materialOfDensity(density), material) << density;
    }
}

TEST(Materials, FitADensityOrNoneDoes) {
    for (const double density : {7850.0, 2700.0, 1800.0, 2400.0, 0.0}) {
        EXPECT_TRUE(someMaterialFits(density)) << density;
    }
    for (const double density : {17'600.0, 11'340.0, 9000.0, 5000.0, 600.0}) {
        EXPECT_FALSE(someMaterialFits(density)) << density;
        EXPECT_EQ(materialOfDensity(density), Material::Concrete) << "contacts of concrete all the same: " << density;
    }
}

TEST(Materials, OfAComponentAreTheUsersWordOrTheGuess) {
    scenes::Block block;
    block.name = "pier";
    block.density = 2700.0;
    const auto fe = scenes::makeScene({block}, 2, 0.1);
    EXPECT_EQ(groupComponents(fe->mesh(), {}, {}, {}).list[0].material, Material::Stone);
    EXPECT_FALSE(groupComponents(fe->mesh(), {}, {}, {}).list[0].reinforced);
    ComponentSettings settings;
    settings.material = Material::Concrete;
    settings.reinforced = true;
    const Component component = groupComponents(fe->mesh(), {}, {{"pier", settings}}, {}).list[0];
    EXPECT_EQ(component.material, Material::Concrete);
    EXPECT_TRUE(component.reinforced);
}

TEST(PairTable, IsSymmetricAndEveryDefaultHasItsSource) {
    const PairTable table;
    std::set<std::string> names;
    for (const PairSource& row : pairSources()) {
        const auto [a, b] = row.pair;
        EXPECT_LE(a, b);
        EXPECT_TRUE(names.insert(pairName(row.pair)).second);
        EXPECT_EQ(table.of(a, b), row.value);
        EXPECT_EQ(table.of(b, a), row.value);
        EXPECT_NE(row.friction.find_first_of("12", row.friction.find('(')), std::string_view::npos)
            << pairName(row.pair) << " names no year";
        EXPECT_NE(row.restitution.find("(20"), std::string_view::npos) << pairName(row.pair) << " names no year";
        // Published ranges: friction of steel on a bed of sand 0.2 to rock on rock 0.75, normal restitution 0.05 to 0.5.
        EXPECT_GE(row.value.friction, 0.2);
        EXPECT_LE(row.value.friction, 0.75);
        EXPECT_GE(row.value.restitution, 0.05);
        EXPECT_LE(row.value.restitution, 0.5);
    }
    // 6 materials make 21 pairs; 3 of them are of ground alone.
    EXPECT_EQ(names.size(), 18u);
}

std::string decimals(double value) {
    std::string text = std::to_string(value).substr(0, 4);
    return text.back() == '0' ? text.substr(0, 3) : text;
}

TEST(PairTable, EveryCoefficientHasARangeThatItsSourceNamesOrThatIsAssumed) {
    int published = 0;
    for (const PairSource& row : pairSources()) {
        const auto check = [&](double value, const CoefficientRange& range, std::string_view source) {
            EXPECT_LT(range.low, range.high) << pairName(row.pair);
            EXPECT_GE(value, range.low) << pairName(row.pair);
            EXPECT_LE(value, range.high) << pairName(row.pair);
            if (!range.assumed) {
                ++published;
                EXPECT_NE(source.find(decimals(range.low)), std::string_view::npos) << pairName(row.pair) << ' ' << source;
                EXPECT_NE(source.find(decimals(range.high)), std::string_view::npos) << pairName(row.pair) << ' ' << source;
            }
        };
        check(row.value.friction, row.frictionRange, row.friction);
        check(row.value.restitution, row.restitutionRange, row.restitution);
        EXPECT_EQ(pairSource(row.pair), &row);
    }
    EXPECT_GT(published, 10);
    EXPECT_EQ(pairSource({Material::Soil, Material::Soil}), nullptr);
    EXPECT_EQ(englishText(rangeText({0.5, 0.7, true})), "0.5 to 0.7, assumed");
    EXPECT_EQ(englishText(rangeText({0.35, 0.6})), "0.35 to 0.6");
}

TEST(PairTable, MovesAlongItsRangesButForWhatWasSet) {
    PairTable table;
    table.of(Material::Stone, Material::Stone).friction = 0.31;
    EXPECT_EQ(table.atLevels({}, {}), table);
    const PairTable least = table.atLevels(0.0, {}), most = table.atLevels({}, 1.0), middle = table.atLevels(0.5, {});
    EXPECT_DOUBLE_EQ(least.of(Material::Soil, Material::Stone).friction, 0.30);
    EXPECT_DOUBLE_EQ(middle.of(Material::Stone, Material::Soil).friction, 0.45);
    EXPECT_EQ(least.of(Material::Stone, Material::Soil).restitution, 0.1) << "the other coefficient stays";
    EXPECT_DOUBLE_EQ(most.of(Material::Stone, Material::Soil).restitution, 0.3);
    EXPECT_EQ(least.of(Material::Stone, Material::Stone).friction, 0.31) << "set by somebody";
}

TEST(PairTable, OneNumberTakesThePlaceOfAll) {
    const PairTable table = PairTable().overriddenBy(0.7, std::nullopt);
    EXPECT_EQ(table.of(Material::Steel, Material::Soil).friction, 0.7);
    EXPECT_EQ(table.of(Material::Steel, Material::Soil).restitution, PairTable().of(Material::Steel, Material::Soil).restitution);
    EXPECT_EQ(PairTable().overriddenBy({}, {}), PairTable());
    EXPECT_EQ(PairTable::uniform(0.7, 0.1), table.overriddenBy({}, 0.1));
}

TEST(PairTable, IsPrintedInTheManualWithItsSources) {
    std::ifstream file(sourcePath("resources/manual/effects.md"));
    const std::string manual{std::istreambuf_iterator<char>(file), {}};
    for (const PairSource& row : pairSources()) {
        const std::string line = "| `" + pairName(row.pair) + "` | " + englishNumber(row.value.friction) + " | " +
                                 englishText(rangeText(row.frictionRange)) + " | " + std::string(row.friction) + " | " +
                                 englishNumber(row.value.restitution) + " | " + englishText(rangeText(row.restitutionRange)) +
                                 " | " + std::string(row.restitution) + " |";
        EXPECT_NE(manual.find(line), std::string::npos) << "not in the manual: " << line;
    }
}

TEST(PairNames, AreTakenInEitherOrderAndRefusedWithARemedy) {
    for (const MaterialPair& pair : materialPairs()) {
        const std::string turned = std::string(materialName(pair.second)) + " , " + std::string(materialName(pair.first));
        EXPECT_EQ(pairFrom(pairName(pair)), pair);
        EXPECT_EQ(pairFrom(turned), pair) << turned;
    }
    for (const char* text : {"", ",", "stone", "stone,", "stone,stone,stone", "Stone,soil", "soil,soil", "water_bed,soil"}) {
        EXPECT_FALSE(pairNamed(text)) << text;
        try {
            pairFrom(text);
            FAIL() << text;
        } catch (const UsageError& error) {
            EXPECT_FALSE(error.remedy().empty());
        }
    }
}

}  // namespace
}  // namespace rubble
