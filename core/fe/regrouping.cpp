#include "core/fe/regrouping.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "core/base/error.h"
#include "core/base/nearest_names.h"

namespace rubble {

namespace {

Vec3 centreAtRest(const Mesh& mesh, ElementIndex e) {
    Vec3 sum = Vec3::Zero();
    const auto corners = mesh.cornersOf(e);
    for (const std::uint32_t node : corners) {
        sum += mesh.nodes[node];
    }
    return sum / static_cast<double>(corners.size());
}

/// Applies one step after the other to the list of groups.
class Regrouper {
public:
    Regrouper(const Mesh& mesh, Findings& findings) : m_mesh(mesh), m_findings(findings) {
        groups.resize(mesh.parts.size());
        for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
            groups[p].name = mesh.parts[p].name;
        }
        for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
            groups[mesh.part[e]].elements.push_back(idAt<ElementIndex>(e));
        }
        std::erase_if(groups, [](const ElementGroup& group) { return group.elements.empty(); });
    }

    void operator()(const SplitByConnectivity& step) {
        const std::size_t source = find(step.component);
        std::vector<ElementGroup> pieces = piecesOf(groups[source]);
        if (pieces.size() < 2) {
            nothingMoved(step.component);
            return;
        }
        groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(source));
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            pieces[i].name = step.component + " " + std::to_string(i + 1);
            requireFree(pieces[i].name);
        }
        groups.insert(groups.begin() + static_cast<std::ptrdiff_t>(source), std::make_move_iterator(pieces.begin()),
                      std::make_move_iterator(pieces.end()));
    }

    void operator()(const SplitByBox& step) {
        const Aabb box(step.low.cwiseMin(step.high), step.low.cwiseMax(step.high));
        splitOff(step.component, step.newName, [&](ElementIndex e) { return box.contains(centreAtRest(m_mesh, e)); });
    }

    void operator()(const SplitByPlane& step) {
        if (!(step.normal.squaredNorm() > 0.0) || !step.normal.allFinite() || !step.point.allFinite()) {
            throw UsageError({"regroup.plane", "The plane that splits \"{0}\" has no direction", {step.component}},
                             {"regroup.plane.remedy", "Give a normal that is not zero and a point of finite coordinates.", {}});
        }
        splitOff(step.component, step.newName,
                 [&](ElementIndex e) { return step.normal.dot(centreAtRest(m_mesh, e) - step.point) > 0.0; });
    }

    void operator()(const MergeComponents& step) {
        if (step.components.empty()) {
            throw UsageError({"regroup.merge_none", "Nothing to merge into \"{0}\"", {step.newName}},
                             {"regroup.merge_none.remedy", "Name the components that are to become one.", {}});
        }
        std::vector<std::size_t> sources;
        for (const std::string& name : step.components) {
            sources.push_back(find(name));
        }
        const std::size_t target = sources.front();
        std::sort(sources.begin(), sources.end());
        sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
        std::vector<ElementIndex> joined;
        for (const std::size_t source : sources) {
            joined.insert(joined.end(), groups[source].elements.begin(), groups[source].elements.end());
            groups[source].elements.clear();
            groups[source].name.clear();
        }
        std::sort(joined.begin(), joined.end());
        requireFree(step.newName);
        groups[target] = {step.newName, std::move(joined)};
        std::erase_if(groups, [](const ElementGroup& group) { return group.elements.empty(); });
    }

    void operator()(const RenameComponent& step) {
        const std::size_t source = find(step.component);
        if (step.newName != step.component) {
            requireFree(step.newName);
            groups[source].name = step.newName;
        }
    }

    std::vector<ElementGroup> groups;

private:
    std::size_t find(const std::string& name) const {
        for (std::size_t i = 0; i < groups.size(); ++i) {
            if (groups[i].name == name) {
                return i;
            }
        }
        std::vector<std::string> names;
        for (const ElementGroup& group : groups) {
            names.push_back(group.name);
        }
        throwUnknownComponent(name, names);
    }

    void requireFree(const std::string& name) const {
        const bool taken = std::any_of(groups.begin(), groups.end(), [&](const ElementGroup& g) { return g.name == name; });
        if (taken || name.empty()) {
            throw UsageError({"regroup.name_taken", "\"{0}\" cannot be the name of a regrouped component", {name}},
                             {"regroup.name_taken.remedy", "Give a name that is not empty and that no other component has.", {}});
        }
    }

    void nothingMoved(const std::string& component) {
        m_findings.add({"regroup.nothing_moved", "A regrouping step moved no elements", {}},
                       {"regroup.nothing_moved.remedy", "Check the step's box, plane or component, or remove the step.", {}},
                       "component \"" + component + "\"");
    }

    void splitOff(const std::string& component, const std::string& newName, const std::function<bool(ElementIndex)>& moves) {
        const std::size_t source = find(component);
        requireFree(newName);
        ElementGroup& from = groups[source];
        const auto first =
            std::stable_partition(from.elements.begin(), from.elements.end(), [&](ElementIndex e) { return !moves(e); });
        ElementGroup moved{newName, {first, from.elements.end()}};
        from.elements.erase(first, from.elements.end());
        if (moved.elements.empty()) {
            nothingMoved(component);
        } else if (from.elements.empty()) {
            from = std::move(moved);
        } else {
            groups.insert(groups.begin() + static_cast<std::ptrdiff_t>(source) + 1, std::move(moved));
        }
    }

    std::vector<ElementGroup> piecesOf(const ElementGroup& group) const {
        constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
        std::vector<std::uint32_t> parent(group.elements.size());
        std::iota(parent.begin(), parent.end(), 0u);
        const auto root = [&](std::uint32_t i) {
            while (parent[i] != i) {
                i = parent[i] = parent[parent[i]];
            }
            return i;
        };
        std::vector<std::uint32_t> firstAtNode(m_mesh.nodeCount(), none);
        for (std::uint32_t i = 0; i < group.elements.size(); ++i) {
            for (const std::uint32_t node : m_mesh.cornersOf(group.elements[i])) {
                if (firstAtNode[node] == none) {
                    firstAtNode[node] = i;
                    continue;
                }
                // The lower index becomes the root, so that a piece is named by its first element.
                const std::uint32_t a = root(firstAtNode[node]), b = root(i);
                parent[std::max(a, b)] = std::min(a, b);
            }
        }
        std::vector<ElementGroup> pieces;
        std::vector<std::uint32_t> pieceOfRoot(group.elements.size(), none);
        for (std::uint32_t i = 0; i < group.elements.size(); ++i) {
            std::uint32_t& piece = pieceOfRoot[root(i)];
            if (piece == none) {
                piece = static_cast<std::uint32_t>(pieces.size());
                pieces.emplace_back();
            }
            pieces[piece].elements.push_back(group.elements[i]);
        }
        std::stable_sort(pieces.begin(), pieces.end(),
                         [](const ElementGroup& a, const ElementGroup& b) { return a.elements.size() > b.elements.size(); });
        return pieces;
    }

    const Mesh& m_mesh;
    Findings& m_findings;
};

}  // namespace

std::vector<ElementGroup> regroup(const Mesh& mesh, const std::vector<RegroupStep>& steps, Findings& findings) {
    Regrouper regrouper(mesh, findings);
    for (const RegroupStep& step : steps) {
        std::visit(regrouper, step);
    }
    return std::move(regrouper.groups);
}

void throwUnknownComponent(const std::string& name, const std::vector<std::string>& existing) {
    const std::vector<std::string> near = nearestNames(name, existing, 5);
    throw UsageError(
        {"components.unknown", "There is no component \"{0}\" among {1}", {name, existing.size()}},
        {"components.unknown.remedy", "Names that come near: {0}. `rubble-cli inspect` lists all.", {quotedList(near)}});
}

}  // namespace rubble
