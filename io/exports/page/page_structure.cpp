#include "io/exports/page/page_structure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace rubble::io {

namespace {

/// States that the run reached, thinned so that their places stay below what a browser holds; first and last are kept.
std::vector<std::size_t> keptStates(std::size_t reached, std::size_t nodes, std::size_t placesMost) {
    const std::size_t perState = std::max<std::size_t>(1, 3 * nodes);
    const std::size_t most = std::max<std::size_t>(2, placesMost / perState);
    // The last one comes on top where the stride misses it.
    const std::size_t stride = reached <= most ? 1 : (reached - 1 + most - 2) / (most - 1);
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < reached; k += stride) {
        kept.push_back(k);
    }
    if (kept.back() + 1 != reached) {
        kept.push_back(reached - 1);
    }
    return kept;
}

std::size_t reachedStates(const RunReader& run, const FeResult& fe) {
    const std::vector<double>& times = fe.times();
    if (run.complete() || run.frameCount() == 0) {
        return run.complete() ? times.size() : 1;
    }
    const double last = run.frameTime(run.frameCount() - 1);
    const auto past = std::upper_bound(times.begin(), times.end(), last);
    return std::max<std::size_t>(1, static_cast<std::size_t>(past - times.begin()));
}

void addMesh(PageData& data, const Mesh& mesh, const std::vector<ComponentId>& componentOf) {
    std::vector<std::uint8_t> shapes;
    PackedIntegers components;
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        shapes.push_back(static_cast<std::uint8_t>(mesh.shapes[e]));
        components.add(static_cast<std::int64_t>(at(componentOf[e])));
    }
    PackedIntegers corners;
    corners.addSteps(std::vector<std::int64_t>(mesh.corners.begin(), mesh.corners.end()));
    PackedIntegers ids;
    ids.addSteps(mesh.elementIds);
    data.add("shapes", shapes);
    data.add("corners", corners);
    data.add("components", components);
    data.add("elementIds", ids);
}

void addActivity(PageData& data, const FeResult& fe, const std::vector<std::size_t>& kept) {
    const std::size_t elements = fe.mesh().elementCount();
    const std::size_t row = (elements + 7) / 8;
    std::vector<std::uint8_t> bits(row * kept.size(), 0);
    for (std::size_t k = 0; k < kept.size(); ++k) {
        for (std::size_t e = 0; e < elements; ++e) {
            if (fe.activity().active(kept[k], idAt<ElementIndex>(e))) {
                bits[k * row + e / 8] |= static_cast<std::uint8_t>(1u << (e % 8));
            }
        }
    }
    data.add("activity", bits);
}

/// Nodes of elements of which something holds.
std::vector<bool> nodesWhere(const FeResult& fe, const std::function<bool(ElementIndex)>& holds) {
    const Mesh& mesh = fe.mesh();
    std::vector<bool> used(mesh.nodeCount(), false);
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        if (holds(idAt<ElementIndex>(e))) {
            for (const std::uint32_t node : mesh.cornersOf(idAt<ElementIndex>(e))) {
                used[node] = true;
            }
        }
    }
    return used;
}

/// Packs places state by state against a straight way on, as runs; what no active element uses costs nothing.
class NodePacker {
public:
    NodePacker(std::size_t nodes, double step) : m_step(step), m_now(3 * nodes, 0), m_before(3 * nodes, 0) {}

    void add(const std::vector<Vec3>& places, const std::vector<bool>& used);

    /// Largest distance of a node from where the page has it at a state between the last two that were added.
    /// @param share  of the way from one to the other
    /// @param onWay  nodes that the page moves on the straight way
    /// @param still  nodes that it leaves where the first of the two has them
    void play(const std::vector<Vec3>& places, double share, const std::vector<bool>& onWay, const std::vector<bool>& still);

    PackedIntegers numbers;
    double largestError = 0.0;         ///< at the states that were added
    double largestErrorBetween = 0.0;  ///< at those that were played

private:
    static Vec3 placeIn(const std::vector<std::int64_t>& places, std::size_t n) {
        const std::size_t nodes = places.size() / 3;
        return {static_cast<double>(places[n]), static_cast<double>(places[nodes + n]), static_cast<double>(places[2 * nodes + n])};
    }

    double m_step;
    std::vector<std::int64_t> m_now;
    std::vector<std::int64_t> m_before;
    std::size_t m_states = 0;
};

void NodePacker::add(const std::vector<Vec3>& places, const std::vector<bool>& used) {
    std::vector<std::int64_t> next(m_now.size());
    std::vector<std::int64_t> steps(m_now.size());
    const std::size_t nodes = places.size();
    for (int c = 0; c < 3; ++c) {
        for (std::size_t n = 0; n < nodes; ++n) {
            const std::size_t i = static_cast<std::size_t>(c) * nodes + n;
            std::int64_t expected = m_states > 1 ? 2 * m_now[i] - m_before[i] : m_now[i];
            if (m_states == 0 && n > 0) {
                expected = next[i - 1];
            }
            const bool known = (used[n] || m_states == 0) && std::isfinite(places[n][c]);
            // What nobody sees stays where it was.
            next[i] = known ? std::llround(places[n][c] / m_step) : m_now[i];
            steps[i] = known || m_states == 0 ? next[i] - expected : m_now[i] - expected;
        }
    }
    numbers.addRuns(steps);
    for (std::size_t n = 0; n < nodes; ++n) {
        if (used[n] && places[n].allFinite()) {
            largestError = std::max(largestError, (m_step * placeIn(next, n) - places[n]).norm());
        }
    }
    m_before = std::move(m_now);
    m_now = std::move(next);
    ++m_states;
}

void NodePacker::play(const std::vector<Vec3>& places, double share, const std::vector<bool>& onWay,
                      const std::vector<bool>& still) {
    for (std::size_t n = 0; n < places.size(); ++n) {
        if (!places[n].allFinite()) {
            continue;
        }
        const Vec3 before = m_step * placeIn(m_before, n);
        if (onWay[n]) {
            const Vec3 shown = before + share * (m_step * placeIn(m_now, n) - before);
            largestErrorBetween = std::max(largestErrorBetween, (shown - places[n]).norm());
        }
        if (still[n]) {
            largestErrorBetween = std::max(largestErrorBetween, (before - places[n]).norm());
        }
    }
}

/// Plays the states between two that are kept, by the rule of the page: an element goes on its straight way if it is active at
/// both, else it waits.
void playLeftOut(NodePacker& packer, const FeResult& fe, std::size_t first, std::size_t last, const Execution& execution) {
    const std::vector<double>& times = fe.times();
    const Activity& activity = fe.activity();
    for (std::size_t k = first + 1; k < last; ++k) {
        execution.check();
        const auto seen = [&](ElementIndex e) { return activity.active(k, e) && activity.active(first, e); };
        const double share = (times[k] - times[first]) / (times[last] - times[first]);
        packer.play(fe.state(k)->positions, share,
                    nodesWhere(fe, [&](ElementIndex e) { return seen(e) && activity.active(last, e); }),
                    nodesWhere(fe, [&](ElementIndex e) { return seen(e) && !activity.active(last, e); }));
    }
}

}  // namespace

void addStructure(PageScene& scene, const RunReader& run, const FeResult& fe, const std::vector<ComponentId>& componentOf,
                  const PagePrecision& precision, const Execution& execution) {
    const Message stage{"io.page.structure", "Packing the states of the FE result", {}};
    const std::size_t reached = reachedStates(run, fe);
    const std::vector<std::size_t> kept = keptStates(reached, fe.mesh().nodeCount(), precision.placesMost);
    addMesh(scene.data, fe.mesh(), componentOf);
    addActivity(scene.data, fe, kept);
    NodePacker packer(fe.mesh().nodeCount(), precision.nodeStep);
    std::vector<double> times;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        execution.report(stage, static_cast<double>(k) / static_cast<double>(kept.size()));
        const std::size_t state = kept[k];
        packer.add(fe.state(state)->positions, nodesWhere(fe, [&](ElementIndex e) { return fe.activity().active(state, e); }));
        if (k > 0) {
            playLeftOut(packer, fe, kept[k - 1], state, execution);
        }
        times.push_back(fe.times()[kept[k]]);
    }
    scene.data.add("nodes", packer.numbers);
    scene.data.add("stateTimes", times);
    scene.nodeError = packer.largestError;
    scene.nodeErrorBetween = packer.largestErrorBetween;
    scene.statesKept = kept.size();
    scene.statesThere = reached;
    scene.about["nodeCount"] = fe.mesh().nodeCount();
    scene.about["elementCount"] = fe.mesh().elementCount();
    scene.about["nodeStep"] = precision.nodeStep;
}

}  // namespace rubble::io
