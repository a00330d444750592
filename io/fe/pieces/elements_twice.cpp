#include "io/fe/pieces/elements_twice.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace rubble::io {

namespace {

using NodeSet = std::vector<std::uint32_t>;

// Shape first, then the nodes in ascending order.
NodeSet nodeSetOf(const Mesh& mesh, std::uint32_t e) {
    const auto corners = mesh.cornersOf(idAt<ElementIndex>(e));
    NodeSet nodes{static_cast<std::uint32_t>(mesh.shapes[e])};
    nodes.insert(nodes.end(), corners.begin(), corners.end());
    std::sort(nodes.begin() + 1, nodes.end());
    return nodes;
}

bool bothActive(const Activity& activity, std::uint32_t a, std::uint32_t b) {
    for (std::size_t k = 0; k < activity.states(); ++k) {
        if (activity.active(k, idAt<ElementIndex>(a)) && activity.active(k, idAt<ElementIndex>(b))) {
            return true;
        }
    }
    return false;
}

// Solids whose lowest node and sum of nodes are those of another: so are those of twins, and of few others.
std::vector<std::uint32_t> candidatesOf(const Mesh& mesh) {
    std::vector<std::tuple<std::uint32_t, std::uint64_t, std::uint32_t>> marks;
    for (std::uint32_t e = 0; e < mesh.elementCount(); ++e) {
        if (isSolid(mesh.shapes[e])) {
            const auto corners = mesh.cornersOf(idAt<ElementIndex>(e));
            std::uint64_t sum = 0;
            for (const std::uint32_t corner : corners) {
                sum += corner;
            }
            marks.emplace_back(*std::min_element(corners.begin(), corners.end()), sum, e);
        }
    }
    std::sort(marks.begin(), marks.end());
    std::vector<std::uint32_t> candidates;
    const auto alike = [&](std::size_t i, std::size_t j) {
        return std::get<0>(marks[i]) == std::get<0>(marks[j]) && std::get<1>(marks[i]) == std::get<1>(marks[j]);
    };
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if ((i > 0 && alike(i - 1, i)) || (i + 1 < marks.size() && alike(i, i + 1))) {
            candidates.push_back(std::get<2>(marks[i]));
        }
    }
    return candidates;
}

}  // namespace

void noteElementsTwice(const Mesh& mesh, const Activity& activity, Findings& findings) {
    if (findings.count("fe.elements_twice") > 0) {
        // A copy of a result has the findings of the result.
        return;
    }
    std::vector<std::pair<NodeSet, std::uint32_t>> sets;
    for (const std::uint32_t e : candidatesOf(mesh)) {
        sets.emplace_back(nodeSetOf(mesh, e), e);
    }
    std::sort(sets.begin(), sets.end());
    for (std::size_t i = 1; i < sets.size(); ++i) {
        for (std::size_t j = i; j-- > 0 && sets[j].first == sets[i].first;) {
            if (bothActive(activity, sets[j].second, sets[i].second)) {
                findings.add({"fe.elements_twice",
                              "Solids stand on the same nodes as others that live with them: their mass "
                              "counts twice",
                              {}},
                             {"fe.elements_twice.remedy",
                              "Take one of them out of the model; if both are meant, give them densities that add up.",
                              {}},
                             "elements " + englishInteger(mesh.elementIds[sets[j].second]) + " and " +
                                 englishInteger(mesh.elementIds[sets[i].second]));
                break;
            }
        }
    }
}

}  // namespace rubble::io
