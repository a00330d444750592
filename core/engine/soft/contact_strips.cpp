#include "core/engine/soft/contact_strips.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/engine/soft/soft_solver.h"

namespace rubble {

namespace {

/// Groups; a body with more contacts than this puts the rest into the ordered group.
constexpr std::uint32_t mostColours = 63;
/// Contacts that the cuts are found from, about.
constexpr std::size_t sampleSize = 2048;

double variance(const std::vector<double>& values) {
    double sum = 0.0, squares = 0.0;
    for (const double x : values) {
        sum += x - values.front();
        squares += (x - values.front()) * (x - values.front());
    }
    const auto n = static_cast<double>(values.size());
    return squares / n - sum * sum / (n * n);
}

/// Axis across which the site is cut, and where.
std::pair<int, std::vector<double>> cutsOf(std::span<const SolverContact> contacts, std::size_t count) {
    std::array<std::vector<double>, 2> along;
    for (std::size_t i = 0; i < contacts.size(); i += contacts.size() / sampleSize + 1) {
        if (std::isfinite(contacts[i].x) && std::isfinite(contacts[i].y)) {
            along[0].push_back(contacts[i].x);
            along[1].push_back(contacts[i].y);
        }
    }
    if (along[0].empty()) {
        return {};
    }
    const int axis = variance(along[0]) >= variance(along[1]) ? 0 : 1;
    std::vector<double>& sample = along[static_cast<std::size_t>(axis)];
    std::sort(sample.begin(), sample.end());
    std::vector<double> cuts;
    for (std::size_t k = 1; k < count; ++k) {
        cuts.push_back(sample[k * sample.size() / count]);
    }
    return {axis, cuts};
}

}  // namespace

void colourContacts(std::span<const std::pair<std::uint32_t, std::uint32_t>> ends, std::size_t movable, ContactColours& colours) {
    std::vector<std::uint64_t> used(movable, 0);
    std::vector<std::uint8_t> colour(ends.size());
    std::vector<std::uint32_t> counts(mostColours + 2, 0);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const auto [a, b] = ends[i];
        const std::uint64_t taken = (a < movable ? used[a] : 0) | (b < movable ? used[b] : 0);
        const auto free = std::min<std::uint32_t>(static_cast<std::uint32_t>(std::countr_one(taken)), mostColours);
        if (free < mostColours) {
            const std::uint64_t bit = std::uint64_t{1} << free;
            if (a < movable) {
                used[a] |= bit;
            }
            if (b < movable) {
                used[b] |= bit;
            }
        }
        colour[i] = static_cast<std::uint8_t>(free);
        ++counts[free + 1];
    }
    colours.lastInOrder = counts[mostColours + 1] > 0;
    for (std::uint32_t k = 0; k <= mostColours; ++k) {
        counts[k + 1] += counts[k];
    }
    colours.first.assign(counts.begin(), counts.end());
    colours.order.resize(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i) {
        colours.order[counts[colour[i]]++] = static_cast<std::uint32_t>(i);
    }
    while (colours.first.size() > 1 && colours.first[colours.first.size() - 2] == colours.first.back()) {
        colours.first.pop_back();
    }
}

void cutIntoStrips(std::span<const SolverContact> contacts, std::size_t movable, std::size_t count, std::size_t loose,
                   ContactStrips& strips) {
    strips.count = count;
    strips.strip.assign(contacts.size(), 0);
    strips.border.assign(contacts.size(), 0);
    if (count == 1) {
        return;
    }
    const auto [axis, cuts] = cutsOf(contacts, count);
    constexpr std::uint16_t nowhere = 0xffff, several = 0xfffe;
    std::vector<std::uint16_t> stripOf(movable, nowhere);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const SolverContact& c = contacts[i];
        const double where = axis == 0 ? c.x : c.y;
        const auto strip = static_cast<std::uint16_t>(
            i < loose ? std::count_if(cuts.begin(), cuts.end(), [&](double cut) { return where >= cut; }) : 0);
        strips.strip[i] = strip;
        for (const std::uint32_t body : {c.a, c.b}) {
            if (body < movable) {
                stripOf[body] = stripOf[body] == nowhere || stripOf[body] == strip ? strip : several;
            }
        }
    }
    const auto isCommon = [&](std::uint32_t body) { return body < movable && stripOf[body] == several; };
    std::transform(contacts.begin(), contacts.end(), strips.border.begin(),
                   [&](const SolverContact& c) -> char { return isCommon(c.a) || isCommon(c.b); });
}

}  // namespace rubble
