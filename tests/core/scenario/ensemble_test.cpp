#include "core/scenario/ensemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include "core/base/error.h"
#include "core/scenario/parameters.h"

namespace rubble {
namespace {

constexpr std::int64_t ensembleBlock = 8;

EnsembleSettings varying(const std::string& key, const std::string& text) {
    EnsembleSettings settings;
    settings.varied.push_back(variationFrom(key, text));
    return settings;
}

double drawnNumber(const EnsembleSettings& settings, std::int64_t member) {
    return std::stod(drawnValues(settings, member).front().second);
}

TEST(Ensemble, TextOfAVariationIsReadToTheSame) {
    for (const auto& [key, text] : {std::pair{"friction", "uniform:0.4:0.8"},
                                    {"restitution", "normal:0.1:0.05"},
                                    {"grouping", "choice:nested:axes"},
                                    {"scenario", "choice:scenario-1:scenario-2"},
                                    {"pair[stone,soil].friction", "uniform:0.5:0.7"}}) {
        const VariedSetting varied = variationFrom(key, text);
        EXPECT_EQ(variationText(varied), text);
        EXPECT_EQ(variationFrom(key, variationText(varied)), varied);
    }
}

TEST(Ensemble, WhatCannotBeDrawnIsRefused) {
    for (const auto& [key, text] : {std::pair{"friction", "uniform:0.8:0.4"},
                                    {"friction", "uniform:0.4:11"},
                                    {"friction", "normal:0.5:0"},
                                    {"friction", "normal:0.5"},
                                    {"friction", "uniform:a:b"},
                                    {"friction", "uniform:nan:1"},
                                    {"friction", "gamma:1:2"},
                                    {"friction", ""},
                                    {"fricton", "uniform:0:1"},
                                    {"grouping", "uniform:0:1"},
                                    {"grouping", "choice:nested:other"},
                                    {"grouping", "choice:"},
                                    {"units", "choice:auto"},
                                    {"seed", "uniform:1:9"},
                                    {"scenario", "uniform:0:1"}}) {
        EXPECT_THROW(variationFrom(key, text), UsageError) << key << '=' << text;
    }
    EnsembleSettings twice = varying("friction", "uniform:0.4:0.8");
    twice.varied.push_back(twice.varied.front());
    EXPECT_THROW(checkEnsemble(twice), UsageError);
    EnsembleSettings none;
    none.members = 0;
    EXPECT_THROW(checkEnsemble(none), UsageError);
    EXPECT_NO_THROW(checkEnsemble(EnsembleSettings{usualVariations()}));
}

TEST(Ensemble, AMemberIsTheSameHoweverManyThereAre) {
    EnsembleSettings few{usualVariations(), 3, 5};
    EnsembleSettings many{usualVariations(), 300, 5};
    many.varied.insert(many.varied.begin(), variationFrom("settle_time", "uniform:1:2"));
    for (std::int64_t member = 0; member < 3; ++member) {
        const DrawnValues a = drawnValues(few, member);
        const DrawnValues b = drawnValues(many, member);
        EXPECT_EQ(a, DrawnValues(b.begin() + 1, b.end())) << "what else is varied changes no draw";
    }
    EnsembleSettings other{usualVariations(), 3, 6};
    EXPECT_NE(drawnValues(few, 0), drawnValues(other, 0));
}

/// Which eighth of a uniform distribution the members of a block draw from.
std::vector<int> strataOf(const std::string& key, std::int64_t seed, std::int64_t block) {
    EnsembleSettings settings = varying(key, "uniform:0:0.8");
    settings.seed = seed;
    std::vector<int> strata;
    for (std::int64_t member = ensembleBlock * block; member < ensembleBlock * (block + 1); ++member) {
        strata.push_back(static_cast<int>(10.0 * drawnNumber(settings, member)));
    }
    return strata;
}

TEST(Ensemble, EveryEighthOfADistributionIsDrawnOnceInABlock) {
    const std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7};
    std::set<std::vector<int>> orders;
    int firsts[ensembleBlock] = {};
    constexpr int blocks = 400;
    int alike = 0;
    for (int block = 0; block < blocks; ++block) {
        const std::vector<int> friction = strataOf("friction", 1, block);
        const std::vector<int> restitution = strataOf("restitution", 1, block);
        alike += friction == restitution || friction == strataOf("friction", 2, block) ? 1 : 0;
        ++firsts[friction.front()];
        orders.insert(friction);
        for (std::vector<int> strata : {friction, restitution}) {
            std::sort(strata.begin(), strata.end());
            ASSERT_EQ(strata, all) << "block " << block;
        }
    }
    EXPECT_LE(alike, 2) << "of keys and of seeds, where one in 40,320 is by chance";
    EXPECT_GT(orders.size(), blocks - 10u) << "every block has an order of its own";
    for (const int count : firsts) {
        EXPECT_NEAR(count, blocks / 8.0, 4.0 * std::sqrt(blocks * 7.0 / 64.0));
    }
}

TEST(Ensemble, EighthsOfACutNormalDistributionAreOfWhatIsLeft) {
    const double ends[] = {0.0, 0.1573107, 0.3186394, 0.4887764, 0.6744898, 0.8871466, 1.1503494, 1.5341205, 100.0};
    const EnsembleSettings cut = varying("restitution", "normal:0:0.01");
    for (std::int64_t member = 0; member < 800; member += ensembleBlock) {
        std::set<std::size_t> strata;
        for (std::int64_t i = 0; i < ensembleBlock; ++i) {
            const double place = drawnNumber(cut, member + i) / 0.01;
            EXPECT_GE(place, 0.0);
            strata.insert(static_cast<std::size_t>(std::upper_bound(std::begin(ends), std::end(ends), place) - std::begin(ends)));
        }
        EXPECT_EQ(strata.size(), 8u) << "from member " << member;
    }
}

TEST(Ensemble, TheMeanOfABlockIsNearThatOfTheDistribution) {
    const EnsembleSettings settings = varying("friction", "uniform:0:1");
    double squares = 0.0;
    constexpr int blocks = 200;
    for (int block = 0; block < blocks; ++block) {
        double sum = 0.0;
        for (std::int64_t i = 0; i < ensembleBlock; ++i) {
            sum += drawnNumber(settings, ensembleBlock * block + i);
        }
        squares += std::pow(sum / ensembleBlock - 0.5, 2);
    }
    // An eighth of the deviation that independent draws would have.
    const double independent = std::sqrt(1.0 / 12.0 / ensembleBlock);
    EXPECT_NEAR(std::sqrt(squares / blocks), independent / 8.0, 0.2 * independent / 8.0);
}

TEST(Ensemble, DrawsFollowTheirDistributions) {
    constexpr int count = 4000;
    const EnsembleSettings uniform = varying("friction", "uniform:0.4:0.8");
    const EnsembleSettings normal = varying("friction", "normal:0.6:0.1");
    const EnsembleSettings cut = varying("restitution", "normal:0:0.2");
    double sums[2] = {};
    double squares[2] = {};
    for (int member = 0; member < count; ++member) {
        const double values[2] = {drawnNumber(uniform, member), drawnNumber(normal, member)};
        EXPECT_GE(values[0], 0.4);
        EXPECT_LE(values[0], 0.8);
        for (int k = 0; k < 2; ++k) {
            sums[k] += values[k];
            squares[k] += values[k] * values[k];
        }
        const double restitution = drawnNumber(cut, member);
        EXPECT_GE(restitution, 0.0);
        EXPECT_LE(restitution, 1.0);
    }
    // Four standard errors of the mean, 5 % of the deviation.
    const double deviations[2] = {0.4 / std::sqrt(12.0), 0.1};
    for (int k = 0; k < 2; ++k) {
        const double mean = sums[k] / count;
        EXPECT_NEAR(mean, 0.6, 4.0 * deviations[k] / std::sqrt(count));
        EXPECT_NEAR(std::sqrt(squares[k] / count - mean * mean), deviations[k], 0.05 * deviations[k]);
    }
}

TEST(Ensemble, WholeNumbersAreEquallyLikelyAtTheEndsToo) {
    EnsembleSettings settings;
    settings.varied = {variationFrom("iterations", "uniform:1:4")};
    constexpr int members = 8'000;
    std::map<std::string, int> counts;
    for (int m = 0; m < members; ++m) {
        ++counts[drawnValues(settings, m).front().second];
    }
    ASSERT_EQ(counts.size(), 4U);
    for (const auto& [value, count] : counts) {
        // Strata leave less chance than free draws.
        EXPECT_NEAR(count, members / 4, 3.0 * std::sqrt(members * 0.25 * 0.75)) << value;
    }
    // What a normal distribution has beyond half a step from the end of the range is not in it: the end has a whole step too.
    settings.varied = {variationFrom("iterations", "normal:1:1")};
    counts.clear();
    for (int m = 0; m < members; ++m) {
        ++counts[drawnValues(settings, m).front().second];
    }
    const auto below = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
    EXPECT_NEAR(counts["1"], members * (below(0.5) - below(-0.5)) / (1.0 - below(-0.5)), 3.0 * std::sqrt(members * 0.25));
}

TEST(Ensemble, ChoicesAreEquallyLikely) {
    const EnsembleSettings two = varying("pieces", "choice:none:surface");
    for (std::int64_t first = 0; first < 80; first += ensembleBlock) {
        int surfaces = 0;
        for (std::int64_t i = 0; i < ensembleBlock; ++i) {
            surfaces += drawnValues(two, first + i).front().second == "surface" ? 1 : 0;
        }
        EXPECT_EQ(surfaces, 4) << "half of a block";
    }
    const EnsembleSettings settings = varying("pieces", "choice:none:grid_boxes:surface");
    std::map<std::string, int> counts;
    for (int member = 0; member < 3000; ++member) {
        ++counts[drawnValues(settings, member).front().second];
    }
    ASSERT_EQ(counts.size(), 3u);
    for (const auto& [choice, count] : counts) {
        EXPECT_NEAR(count, 1000, 4.0 * std::sqrt(3000.0 * 2.0 / 9.0)) << choice;
    }
}

TEST(Ensemble, MembersDrawByDefaultFromTheRangesOfTheMaterials) {
    const EnsembleSettings settings{usualVariations(), 40, 1};
    const PairSource& row = *pairSource({Material::Stone, Material::Soil});
    double least = 1.0, most = 0.0;
    for (std::int64_t member = 0; member < settings.members; ++member) {
        const PairProperties pair = actingPairs(memberScenario({}, settings, member)).of(Material::Soil, Material::Stone);
        EXPECT_GE(pair.friction, row.frictionRange.low);
        EXPECT_LE(pair.friction, row.frictionRange.high);
        EXPECT_GE(pair.restitution, row.restitutionRange.low);
        EXPECT_LE(pair.restitution, row.restitutionRange.high);
        least = std::min(least, pair.friction);
        most = std::max(most, pair.friction);
    }
    EXPECT_GT(most - least, 0.8 * (row.frictionRange.high - row.frictionRange.low));
    EXPECT_EQ(actingPairs(Scenario()), PairTable()) << "a single run takes the numbers of the table";
}

TEST(Ensemble, MembersHaveWhatWasDrawnAndASeedOfTheirOwn) {
    const EnsembleSettings settings{usualVariations(), 8, 1};
    Scenario scenario;
    std::set<std::int64_t> seeds;
    for (std::int64_t member = 0; member < 8; ++member) {
        const Scenario made = memberScenario(scenario, settings, member);
        for (const auto& [key, value] : drawnValues(settings, member)) {
            Scenario expected = made;
            setParameterText(expected, key, value);
            EXPECT_EQ(expected, made) << key;
        }
        EXPECT_GE(made.fragments.birthShift, 1e-6);
        seeds.insert(made.fragments.seed);
    }
    EXPECT_EQ(seeds.size(), 8u);
}

}  // namespace
}  // namespace rubble
