#include "io/fe/d3plot/d3plot_adaptive.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace rubble::io {

namespace {

int kindOf(ElementShape shape) {
    return isSolid(shape) ? 0 : isShell(shape) ? 1 : 2;
}

std::vector<std::int64_t> nodeNumbers(const Mesh& mesh, std::size_t e) {
    std::vector<std::int64_t> numbers;
    for (const std::uint32_t corner : mesh.cornersOf(idAt<ElementIndex>(e))) {
        numbers.push_back(mesh.nodeIds[corner]);
    }
    return numbers;
}

std::vector<std::int64_t> sorted(std::vector<std::int64_t> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

Vec3 centre(const Mesh& mesh, std::size_t e) {
    Vec3 sum = Vec3::Zero();
    const auto corners = mesh.cornersOf(idAt<ElementIndex>(e));
    for (const std::uint32_t corner : corners) {
        sum += mesh.nodes[corner];
    }
    return sum / static_cast<double>(corners.size());
}

// A mesh without elements, with the nodes and parts of another.
Mesh emptied(const Mesh& mesh) {
    Mesh result;
    result.nodeIds = mesh.nodeIds;
    result.nodes = mesh.nodes;
    result.parts = mesh.parts;
    result.offsets.push_back(0);
    return result;
}

void append(Mesh& mesh, const Mesh& from, std::size_t e, const std::vector<std::uint32_t>& corners, std::uint32_t part) {
    mesh.elementIds.push_back(from.elementIds[e]);
    mesh.shapes.push_back(from.shapes[e]);
    mesh.part.push_back(part);
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    mesh.density.push_back(from.density[e]);
    mesh.section.push_back(from.section[e]);
}

/// Finds which elements of a new mesh took the place of those of the mesh before.
class Refinement {
public:
    Refinement(const Mesh& before, const Mesh& now) : m_before(before), m_now(now) {
        std::map<std::pair<int, std::int64_t>, std::size_t> numbers;
        for (std::size_t e = 0; e < now.elementCount(); ++e) {
            numbers.emplace(std::pair(kindOf(now.shapes[e]), now.elementIds[e]), e);
        }
        m_fresh.assign(now.elementCount(), true);
        std::vector<std::size_t> missing;
        for (std::size_t e = 0; e < before.elementCount(); ++e) {
            const auto found = numbers.find({kindOf(before.shapes[e]), before.elementIds[e]});
            const bool same = found != numbers.end() && sorted(nodeNumbers(before, e)) == sorted(nodeNumbers(now, found->second));
            if (same) {
                m_fresh[found->second] = false;
            } else {
                missing.push_back(e);
            }
        }
        for (std::size_t e = 0; e < now.elementCount(); ++e) {
            for (const std::int64_t node : m_fresh[e] ? nodeNumbers(now, e) : std::vector<std::int64_t>{}) {
                m_freshAt[node].push_back(e);
            }
        }
        findParents(missing);
        assignChildren();
    }

    bool fresh(std::size_t e) const { return m_fresh[e]; }
    bool child(std::size_t e) const { return m_children.contains(e); }
    /// Elements before, each with those that took its place.
    const std::map<std::size_t, std::vector<std::uint32_t>>& parents() const { return m_parents; }

private:
    // Fresh elements of its part stand at all of its corners.
    void findParents(const std::vector<std::size_t>& missing) {
        for (const std::size_t e : missing) {
            const std::int64_t part = m_before.parts[m_before.part[e]].fileId;
            const std::vector<std::int64_t> corners = nodeNumbers(m_before, e);
            const bool covered = std::all_of(corners.begin(), corners.end(), [&](std::int64_t node) {
                const auto there = m_freshAt.find(node);
                return there != m_freshAt.end() && std::any_of(there->second.begin(), there->second.end(), [&](std::size_t c) {
                           return m_now.parts[m_now.part[c]].fileId == part &&
                                  kindOf(m_now.shapes[c]) == kindOf(m_before.shapes[e]);
                       });
            });
            if (covered) {
                m_parents[e] = {};
            }
        }
    }

    // To the parent whose centre is nearest among those at whose corners it stands, else to one around its centre.
    void assignChildren() {
        std::map<std::int64_t, std::vector<std::size_t>> parentsAt;
        for (const auto& [parent, unused] : m_parents) {
            for (const std::int64_t node : nodeNumbers(m_before, parent)) {
                parentsAt[node].push_back(parent);
            }
        }
        for (std::size_t e = 0; e < m_now.elementCount(); ++e) {
            if (!m_fresh[e]) {
                continue;
            }
            double nearest = std::numeric_limits<double>::infinity();
            std::size_t parent = m_before.elementCount();
            for (const std::int64_t node : nodeNumbers(m_now, e)) {
                const auto there = parentsAt.find(node);
                for (const std::size_t p : there != parentsAt.end() ? there->second : std::vector<std::size_t>{}) {
                    const double apart = (centre(m_before, p) - centre(m_now, e)).norm();
                    if (apart < nearest) {
                        nearest = apart;
                        parent = p;
                    }
                }
            }
            for (auto around = m_parents.begin(); parent == m_before.elementCount() && around != m_parents.end(); ++around) {
                if (holds(around->first, e)) {
                    parent = around->first;
                }
            }
            if (parent < m_before.elementCount()) {
                m_parents[parent].push_back(static_cast<std::uint32_t>(e));
                m_children.insert(e);
            }
        }
        std::erase_if(m_parents, [](const auto& parent) { return parent.second.empty(); });
    }

    bool holds(std::size_t parent, std::size_t e) const {
        Aabb box;
        for (const std::uint32_t corner : m_before.cornersOf(idAt<ElementIndex>(parent))) {
            box.extend(m_before.nodes[corner]);
        }
        const Vec3 margin = Vec3::Constant(1e-3 * box.diagonal().norm());
        box.extend(Vec3(box.max() + margin));
        box.extend(Vec3(box.min() - margin));
        return box.contains(centre(m_now, e)) && m_before.parts[m_before.part[parent]].fileId == m_now.parts[m_now.part[e]].fileId;
    }

    const Mesh& m_before;
    const Mesh& m_now;
    std::vector<bool> m_fresh;
    std::unordered_map<std::int64_t, std::vector<std::size_t>> m_freshAt;  // by number of node
    std::map<std::size_t, std::vector<std::uint32_t>> m_parents;
    std::set<std::size_t> m_children;
};

}  // namespace

bool AdaptiveSeries::joinable(const std::vector<FeResult::Contents>& families) {
    return std::all_of(families.begin(), families.end(), [](const FeResult::Contents& family) {
        const std::vector<std::int64_t>& numbers = family.mesh->nodeIds;
        return std::set<std::int64_t>(numbers.begin(), numbers.end()).size() == numbers.size();
    });
}

AdaptiveSeries::AdaptiveSeries(std::vector<FeResult::Contents> families) : m_families(std::move(families)) {
    m_facts.hasVelocity = true;
    for (std::size_t f = 0; f < m_families.size(); ++f) {
        const FeResult::Contents& family = m_families[f];
        m_facts.hasVelocity = m_facts.hasVelocity && family.hasVelocity;
        m_facts.findings.append(family.findings);
        while (!m_facts.times.empty() && m_facts.times.back() >= family.times.front()) {
            m_facts.times.pop_back();
            m_states.pop_back();
        }
        for (std::size_t k = 0; k < family.times.size(); ++k) {
            m_facts.times.push_back(family.times[k]);
            m_states.push_back({f, k});
        }
    }
    m_facts.flag.name = m_families.front().activityFrom;
    m_facts.flag.activeByName = 1;
    m_facts.findings.add(
        {"d3plot.adaptive", "Meshes of an adaptive run were joined: what was refined keeps its first elements", {}},
        {"d3plot.adaptive.remedy", "Nothing to do; deaths of parts of a refined element show when all have died.", {}},
        m_families.back().mesh ? englishInteger(static_cast<std::int64_t>(m_families.size())) + " meshes" : "",
        static_cast<std::int64_t>(m_families.size()));
}

void AdaptiveSeries::refine(std::size_t family, const Level& before) {
    const Mesh& now = *m_families[family].mesh;
    Level level{emptied(now), {}};
    const Refinement refinement(before.mesh, now);
    for (std::size_t e = 0; e < now.elementCount(); ++e) {
        if (refinement.fresh(e) && refinement.child(e)) {
            continue;
        }
        const auto corners = now.cornersOf(idAt<ElementIndex>(e));
        append(level.mesh, now, e, {corners.begin(), corners.end()}, now.part[e]);
        level.sources.push_back({static_cast<std::uint32_t>(e)});
    }
    std::unordered_map<std::int64_t, std::uint32_t> nodes;
    for (std::size_t n = 0; n < now.nodeCount(); ++n) {
        nodes.emplace(now.nodeIds[n], static_cast<std::uint32_t>(n));
    }
    for (const auto& [parent, children] : refinement.parents()) {
        std::vector<std::uint32_t> corners;
        for (const std::int64_t number : nodeNumbers(before.mesh, parent)) {
            corners.push_back(nodes.at(number));
        }
        append(level.mesh, before.mesh, parent, corners, now.part[children.front()]);
        level.sources.push_back(children);
    }
    m_level = std::move(level);
}

SeriesStep AdaptiveSeries::step(std::size_t k) {
    const auto [family, state] = m_states[k];
    const FeResult::Contents& contents = m_families[family];
    SeriesStep step;
    if (k == 0 || m_states[k - 1].family != family) {
        const Level before = std::exchange(m_level, {});
        refine(family, k == 0 ? Level{emptied(*contents.mesh), {}} : before);
        step.mesh = m_level.mesh;
    }
    for (const std::vector<std::uint32_t>& sources : m_level.sources) {
        const bool active = std::any_of(sources.begin(), sources.end(),
                                        [&](std::uint32_t e) { return contents.activity.active(state, idAt<ElementIndex>(e)); });
        step.flags.push_back(active ? 1.0 : 0.0);
    }
    return step;
}

SeriesFields AdaptiveSeries::fields(std::size_t k) const {
    const auto [family, state] = m_states[k];
    FeState read = m_families[family].source->read(state);
    return {std::move(read.positions), m_facts.hasVelocity ? std::move(read.velocities) : std::vector<Vec3>{}};
}

}  // namespace rubble::io
