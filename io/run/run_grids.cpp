#include "io/run/run_grids.h"

#include <vtkCellType.h>

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/fe/components.h"

namespace rubble::io {

namespace {

std::uint8_t cellTypeOf(ElementShape shape) {
    static constexpr std::array<std::uint8_t, 7> types{VTK_HEXAHEDRON, VTK_WEDGE,    VTK_PYRAMID, VTK_TETRA,
                                                       VTK_QUAD,       VTK_TRIANGLE, VTK_LINE};
    return types[static_cast<std::size_t>(shape)];
}

// Its corners are there already.
void addCell(CellGrid& grid, ElementShape shape, std::int64_t element, ComponentId component) {
    grid.offsets.push_back(static_cast<std::int64_t>(grid.connectivity.size()));
    grid.types.push_back(cellTypeOf(shape));
    grid.elements.push_back(element);
    grid.components.push_back(static_cast<std::int32_t>(at(component)));
}

/// Adds the nodes of a mesh to a grid, each once.
class NodePoints {
public:
    NodePoints(CellGrid& grid, std::size_t nodes) : m_grid(grid), m_pointOf(nodes, -1) {}

    template <class Place>
    void addCorner(std::uint32_t node, const Place& place) {
        if (m_pointOf[node] < 0) {
            m_pointOf[node] = static_cast<std::int64_t>(m_grid.points.size());
            m_grid.points.push_back(place());
        }
        m_grid.connectivity.push_back(m_pointOf[node]);
    }

private:
    CellGrid& m_grid;
    std::vector<std::int64_t> m_pointOf;
};

}  // namespace

RunGrids::RunGrids(const RunReader& run, const FeResult& fe)
    : m_run(run),
      m_fe(fe),
      m_places(run),
      m_site(run.origin().frame, run.origin().site),
      m_componentNames(run.componentNames()),
      m_elementIds(run.elementIds()),
      m_clustering(run.clustering()),
      m_islands(run.islands()),
      m_bodies(run.bodies()),
      m_carriers(run.carriers()) {
    const Scenario& scenario = run.origin().scenario;
    m_componentOf = groupComponents(fe.mesh(), scenario.regrouping, scenario.components, scenario.assumptions).of;
    for (const Fragment& fragment : m_places.fragments().list) {
        if (at(fragment.element) >= fe.mesh().elementCount()) {
            throw UsageError(
                Message{"io.series.other_fe", "The run was not made from {0}: it has fewer elements", {fe.contents().path}},
                Message{"io.series.other_fe.remedy", "Give the FE file that the run names.", {}});
        }
    }
    std::erase_if(m_islands, [&](const IslandRecord& island) {
        return std::any_of(island.elements.begin(), island.elements.end(),
                           [&](ElementIndex e) { return at(e) >= fe.mesh().elementCount(); });
    });
}

std::vector<RunInstant> RunGrids::instants() const {
    const std::vector<double>& times = m_fe.times();
    const std::size_t frames = m_run.frameCount();
    const double reached = frames ? m_run.frameTime(frames - 1) : times.front();
    std::vector<RunInstant> instants;
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (k == 0 || times[k] <= reached || m_run.complete()) {
            instants.push_back({times[k], k});
        }
    }
    const double spacing = times.size() > 1 ? (times.back() - times.front()) / static_cast<double>(times.size() - 1) : 0.0;
    for (std::size_t i = 0; i < frames; ++i) {
        const double time = m_run.frameTime(i);
        const bool far = time >= instants.back().time + 0.999 * spacing;
        if (time > times.back() && (far || i + 1 == frames)) {
            instants.push_back({time, times.size() - 1});
        }
    }
    return instants;
}

bool RunGrids::needsDoublePrecision() const {
    return m_site.toWorld(Vec3::Zero()).cwiseAbs().maxCoeff() >= 10000.0;
}

CellGrid RunGrids::fragments(const std::vector<FragmentPlaces::Place>& shown) const {
    CellGrid grid;
    const FragmentSet& fragments = m_places.fragments();
    for (const FragmentPlaces::Place& place : shown) {
        const std::size_t f = at(place.fragment);
        for (const Vec3& vertex : fragments.verticesOf(place.fragment)) {
            grid.connectivity.push_back(static_cast<std::int64_t>(grid.points.size()));
            grid.points.push_back(m_site.toWorld(place.fromHandOver * vertex));
        }
        addCell(grid, fragments.solid[f], m_elementIds[f], fragments.list[f].component);
        const bool clustered = m_clustering && f < m_clustering->of.size();
        grid.fragments.push_back(static_cast<std::int32_t>(f));
        grid.clusters.push_back(clustered ? static_cast<std::int32_t>(at(m_clustering->of[f])) : -1);
        grid.speeds.push_back(place.speed);
    }
    return grid;
}

std::vector<CarriedIsland> RunGrids::carriedAt(double time) const {
    if (m_islands.empty() || m_run.frameCount() == 0) {
        return {};
    }
    const TrajectoryFrame frame = frameAtTime(m_run, time);
    std::vector<CarriedIsland> carried = carriedIslands(m_islands, m_bodies, frame);
    std::ranges::copy(leftIslands(m_places.fragments(), m_islands, m_carriers, frame), std::back_inserter(carried));
    return carried;
}

CellGrid RunGrids::structure(const RunInstant& instant, const std::vector<FragmentPlaces::Place>& shown) const {
    const Mesh& mesh = m_fe.mesh();
    std::vector<bool> left(mesh.elementCount(), false);
    for (const FragmentPlaces::Place& place : shown) {
        left[at(m_places.fragments().list[at(place.fragment)].element)] = true;
    }
    for (const CarriedIsland& island : carriedAt(instant.time)) {
        for (const ElementIndex e : island.elements) {
            left[at(e)] = true;
        }
    }
    const std::shared_ptr<const FeState> positions = m_fe.state(instant.state);
    CellGrid grid;
    NodePoints nodes(grid, mesh.nodeCount());
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const ElementIndex element = idAt<ElementIndex>(e);
        if (left[e] || !m_fe.activity().active(instant.state, element)) {
            continue;
        }
        for (const std::uint32_t node : mesh.cornersOf(element)) {
            nodes.addCorner(node, [&] { return m_site.toWorld(positions->positions[node]); });
        }
        addCell(grid, mesh.shapes[e], mesh.elementIds[e], m_componentOf[e]);
    }
    return grid;
}

bool RunGrids::hasReleased(const RunInstant& instant) const {
    return !carriedAt(instant.time).empty();
}

// The islands where their bodies are. No two share a node; what has just left one is drawn with nodes of its own.
CellGrid RunGrids::released(const RunInstant& instant) const {
    const Mesh& mesh = m_fe.mesh();
    CellGrid grid;
    NodePoints nodes(grid, mesh.nodeCount());
    const TrajectoryFrame frame = frameAtTime(m_run, instant.time);
    const auto add = [&](const CarriedIsland& island, bool apart) {
        const auto then = m_fe.state(std::min<std::size_t>(island.state, m_fe.stateCount() - 1));
        for (const ElementIndex e : island.elements) {
            for (const std::uint32_t node : mesh.cornersOf(e)) {
                const auto place = [&] { return m_site.toWorld(island.moved * then->positions[node]); };
                if (apart) {
                    grid.connectivity.push_back(static_cast<std::int64_t>(grid.points.size()));
                    grid.points.push_back(place());
                } else {
                    nodes.addCorner(node, place);
                }
            }
            addCell(grid, mesh.shapes[at(e)], mesh.elementIds[at(e)], m_componentOf[at(e)]);
        }
    };
    for (const CarriedIsland& island : carriedIslands(m_islands, m_bodies, frame)) {
        add(island, false);
    }
    for (const CarriedIsland& element : leftIslands(m_places.fragments(), m_islands, m_carriers, frame)) {
        add(element, true);
    }
    return grid;
}

}  // namespace rubble::io
