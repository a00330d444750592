#include "core/scenario/ensemble.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <numeric>
#include <set>

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/normal_distribution.h"
#include "core/scenario/parameters.h"

namespace rubble {

namespace {

/// m, as in the repeat floor: rigid piles are chaotic, and members that are given the same values differ by this.
constexpr double leastShift = 1e-6;
/// Members that draw together, each from another stratum.
constexpr std::int64_t ensembleBlock = 8;
constexpr std::int64_t seedMax = 4294967295;

std::vector<std::string> splitAt(std::string_view text, char mark) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    while (true) {
        const std::size_t to = text.find(mark, from);
        parts.emplace_back(text.substr(from, to - from));
        if (to == std::string_view::npos) {
            return parts;
        }
        from = to + 1;
    }
}

[[noreturn]] void refuse(std::string_view key, std::string_view text, std::string_view wanted) {
    throw UsageError({"ensemble.distribution", "{0} cannot be varied as \"{1}\".", {key, text}},
                     {"ensemble.distribution.remedy", "Give {0}.", {wanted}});
}

bool readNumber(const std::string& text, double& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

/// Six digits: what is drawn can be written down and given to --set.
std::string drawnText(double value) {
    std::array<char, 32> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
    return {text.data(), result.ptr};
}

std::uint64_t bitsOf(const Hasher& hasher) {
    const Digest digest = hasher.finish();
    std::uint64_t bits = 0;
    std::memcpy(&bits, digest.bytes.data(), sizeof bits);
    return bits;
}

/// Above 0 and below 1, from all that decides it. A stratum can be added to it without rounding.
double unitNumber(std::int64_t seed, std::int64_t member, const std::string& key) {
    Hasher hasher;
    hasher.text("ensemble").value(seed).value(member).text(key).value(0);
    return (static_cast<double>(bitsOf(hasher) >> 16) + 0.5) * 0x1p-48;
}

/// Which eighth of a distribution a member draws from: members of one block have one each, in an order of the block's own.
std::int64_t stratumOf(std::int64_t seed, std::int64_t member, const std::string& key) {
    Hasher hasher;
    hasher.text("ensemble.strata").value(seed).value(member / ensembleBlock).text(key);
    std::uint64_t left = bitsOf(hasher);
    std::array<std::int64_t, ensembleBlock> order{};
    std::iota(order.begin(), order.end(), std::int64_t{0});
    for (std::size_t i = order.size() - 1; i > 0; --i) {
        std::swap(order[i], order[left % (i + 1)]);
        left /= i + 1;
    }
    return order[static_cast<std::size_t>(member % ensembleBlock)];
}

/// Values that a row takes, as far as numbers go.
struct Range {
    double low;
    double high;
    bool whole;
};

Range rangeOf(const std::string& key) {
    const Parameter& row = *findParameter(key).first;
    return {row.low, row.high, row.kind == ParameterKind::Integer};
}

std::string drawn(const VariedSetting& varied, std::int64_t seed, std::int64_t member) {
    const auto stratum = static_cast<double>(stratumOf(seed, member, varied.key));
    const double u = (stratum + unitNumber(seed, member, varied.key)) / ensembleBlock;
    if (varied.distribution == Distribution::Choice) {
        const auto count = static_cast<double>(varied.choices.size());
        return varied.choices[std::min(varied.choices.size() - 1, static_cast<std::size_t>(u * count))];
    }
    const Range range = rangeOf(varied.key);
    // A whole number stands for all that rounds to it, those at the ends too.
    const double beyond = range.whole ? 0.5 : 0.0;
    double low = varied.first, high = varied.second;
    double value = low - beyond + u * (high - low + 2.0 * beyond);
    if (varied.distribution == Distribution::Normal) {
        low = range.low;
        high = range.high;
        // Ranges are checked as they are told: a mean may lie beyond its end by a last digit.
        const double first = std::min(0.0, (low - beyond - varied.first) / varied.second);
        const double last = std::max(0.0, (high + beyond - varied.first) / varied.second);
        value = varied.first + varied.second * cutNormalPlace(first, last, u);
    }
    return drawnText(std::clamp(range.whole ? std::round(value) : value, low, high));
}

void checkKey(const std::string& key, std::string_view text) {
    const Parameter& row = *findParameter(key).first;
    if (row.stage == Stage::Import) {
        throw UsageError({"ensemble.import", "{0} says how the FE file is read and cannot be varied.", {key}},
                         {"ensemble.import.remedy", "Make a scenario for each and vary scenario.", {}});
    }
    if (key == "seed") {
        refuse(key, text, "another parameter: every member has a seed of its own");
    }
}

void checkNumbers(const VariedSetting& varied, std::string_view text) {
    const Parameter& row = *findParameter(varied.key).first;
    const bool number = row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer;
    const bool normal = varied.distribution == Distribution::Normal;
    if (!number) {
        refuse(varied.key, text, "the values to choose from: choice:A:B");
    }
    if (!std::isfinite(varied.first) || !std::isfinite(varied.second) ||
        (normal ? varied.second <= 0.0 : varied.second <= varied.first)) {
        refuse(varied.key, text, normal ? "a mean and a standard deviation above zero" : "two numbers, the lesser first");
    }
    const std::vector<double> ends = normal ? std::vector{varied.first} : std::vector{varied.first, varied.second};
    for (const double end : ends) {
        Scenario scratch;
        setParameterText(scratch, varied.key, drawnText(end));
    }
}

}  // namespace

std::vector<VariedSetting> usualVariations() {
    return {{"friction_level", Distribution::Uniform, 0.0, 1.0, {}},
            {"restitution_level", Distribution::Uniform, 0.0, 1.0, {}},
            {"birth_shift", Distribution::Uniform, 0.0, 0.02, {}}};
}

VariedSetting variationFrom(std::string_view key, std::string_view text) {
    VariedSetting varied;
    varied.key = std::string(key);
    std::vector<std::string> parts = splitAt(text, ':');
    const std::string kind = parts.front();
    parts.erase(parts.begin());
    if (kind == "choice") {
        varied.distribution = Distribution::Choice;
        varied.choices = std::move(parts);
    } else if ((kind == "uniform" || kind == "normal") && parts.size() == 2) {
        varied.distribution = kind == "uniform" ? Distribution::Uniform : Distribution::Normal;
        if (!readNumber(parts[0], varied.first) || !readNumber(parts[1], varied.second)) {
            refuse(key, text, "numbers with a point as decimal sign, such as uniform:0.4:0.8");
        }
    } else {
        refuse(key, text, "uniform:LEAST:GREATEST, normal:MEAN:DEVIATION or choice:A:B");
    }
    EnsembleSettings one;
    one.varied.push_back(varied);
    checkEnsemble(one);
    return varied;
}

std::string variationText(const VariedSetting& varied) {
    if (varied.distribution == Distribution::Choice) {
        std::string text = "choice";
        for (const std::string& choice : varied.choices) {
            text += ':' + choice;
        }
        return text;
    }
    const std::string name = varied.distribution == Distribution::Uniform ? "uniform" : "normal";
    return name + ':' + valueText(ParameterValue(varied.first)) + ':' + valueText(ParameterValue(varied.second));
}

void checkEnsemble(const EnsembleSettings& settings) {
    if (settings.members < 1 || settings.members > ensembleMembersMax || settings.seed < 0 || settings.seed > seedMax) {
        throw UsageError(
            {"ensemble.members", "An ensemble of {0} members with seed {1} cannot be made.", {settings.members, settings.seed}},
            {"ensemble.members.remedy", "Members go from 1 to 10,000, seeds from 0 to 4,294,967,295.", {}});
    }
    std::set<std::string> keys;
    for (const VariedSetting& varied : settings.varied) {
        const std::string text = variationText(varied);
        if (!keys.insert(varied.key).second) {
            throw UsageError({"ensemble.twice", "{0} is varied twice.", {varied.key}},
                             {"ensemble.twice.remedy", "Leave one of the two out.", {}});
        }
        const bool choice = varied.distribution == Distribution::Choice;
        if (choice && (varied.choices.empty() || std::any_of(varied.choices.begin(), varied.choices.end(),
                                                             [](const std::string& each) { return each.empty(); }))) {
            refuse(varied.key, text, "the values to choose from: choice:A:B");
        }
        if (varied.key == scenarioKey) {
            if (!choice) {
                refuse(varied.key, text, "the ids of scenarios of the case: choice:scenario-1:scenario-2");
            }
            continue;
        }
        checkKey(varied.key, text);
        if (!choice) {
            checkNumbers(varied, text);
        }
        for (const std::string& value : varied.choices) {
            Scenario scratch;
            setParameterText(scratch, varied.key, value);
        }
    }
}

DrawnValues drawnValues(const EnsembleSettings& settings, std::int64_t member) {
    DrawnValues values;
    for (const VariedSetting& varied : settings.varied) {
        values.emplace_back(varied.key, drawn(varied, settings.seed, member));
    }
    return values;
}

Scenario memberScenario(const Scenario& scenario, const EnsembleSettings& settings, std::int64_t member) {
    Scenario made = scenario;
    for (const auto& [key, value] : drawnValues(settings, member)) {
        if (key != scenarioKey) {
            setParameterText(made, key, value);
        }
    }
    made.fragments.seed = (scenario.fragments.seed + 7919 * settings.seed + member) % (seedMax + 1);
    made.fragments.birthShift = std::max(made.fragments.birthShift, leastShift);
    return made;
}

}  // namespace rubble
