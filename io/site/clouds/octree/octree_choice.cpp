#include "io/site/clouds/octree/octree_choice.h"

#include <queue>
#include <utility>

namespace rubble::io {

OctreeChoice chooseNodes(std::span<const OctreeNode> nodes, const std::function<double(std::size_t)>& pixels, std::uint64_t budget,
                         double finest) {
    std::vector<std::vector<std::size_t>> below(nodes.size());
    // The coarsest on the screen first; of equals the first of the file.
    std::priority_queue<std::pair<double, std::int64_t>> waiting;
    const auto wait = [&](std::size_t node) {
        if (const double apart = pixels(node); apart > 0.0) {
            waiting.emplace(apart, -static_cast<std::int64_t>(node));
        }
    };
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].parent) {
            below[*nodes[n].parent].push_back(n);
        }
    }
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (!nodes[n].parent) {
            wait(n);
        }
    }
    OctreeChoice choice;
    while (!waiting.empty()) {
        const double apart = waiting.top().first;
        const auto node = static_cast<std::size_t>(-waiting.top().second);
        waiting.pop();
        if (choice.points + nodes[node].points > budget) {
            choice.whole = false;
            continue;
        }
        choice.points += nodes[node].points;
        choice.nodes.push_back(node);
        for (std::size_t b = 0; b < below[node].size() && apart > finest; ++b) {
            wait(below[node][b]);
        }
    }
    return choice;
}

}  // namespace rubble::io
