#include "widgets/render/shapes/island_colours.h"

#include <algorithm>
#include <numeric>

namespace rubble::render {

std::vector<std::uint32_t> islandColours(const LooseStructure& loose, std::size_t colours) {
    const std::size_t states = loose.members.size();
    std::vector<std::size_t> order(loose.islands.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return loose.islands[i].elements.size(); });
    // Elements that have a colour already, by colour and state.
    std::vector<std::vector<std::size_t>> taken(colours, std::vector<std::size_t>(states, 0));
    std::vector<std::uint32_t> chosen(loose.islands.size(), 0);
    for (const std::size_t i : order) {
        const LooseIsland& island = loose.islands[i];
        std::size_t best = 0;
        std::size_t least = ~std::size_t{0};
        for (std::size_t c = 0; c < colours && least > 0; ++c) {
            const auto from = taken[c].begin() + island.from;
            const std::size_t beside = *std::max_element(from, from + (island.to - island.from + 1));
            if (beside < least) {
                best = c;
                least = beside;
            }
        }
        for (std::size_t k = island.from; k <= island.to; ++k) {
            taken[best][k] += island.elements.size();
        }
        chosen[i] = static_cast<std::uint32_t>(best);
    }
    return chosen;
}

}  // namespace rubble::render
