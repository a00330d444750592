#include "io/fe/node_fields.h"

#include <algorithm>
#include <cassert>

#include "core/base/error.h"
#include "io/fe/mesh_builder.h"

namespace rubble::io {

void replaceUnusable(std::vector<Vec3>& values, std::size_t state, const std::string& what, const NodeUse& use,
                     const std::vector<Vec3>* instead) {
    if (std::all_of(values.begin(), values.end(), usablePlace)) {
        return;
    }
    std::vector<bool> needed(values.size(), false);
    for (std::size_t e = 0; e < use.mesh.elementCount(); ++e) {
        const auto id = idAt<ElementIndex>(e);
        if (use.activity.active(state, id)) {
            for (const std::uint32_t node : use.mesh.cornersOf(id)) {
                needed[node] = true;
            }
        }
    }
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (usablePlace(values[n])) {
            continue;
        }
        if (needed[n]) {
            throw ParseError(
                {"fe.bad_value",
                 "{0}: {1} of node {2} at state {3} is ({4}, {5}, {6})",
                 {use.path, what, use.mesh.nodeIds[n], state, values[n].x(), values[n].y(), values[n].z()}},
                {"fe.bad_value.remedy",
                 "Nodes of active elements need finite values: let the analysis write the state again, or cut the result "
                 "before it.",
                 {}});
        }
        values[n].setZero();
        if (instead != nullptr) {
            values[n] = (*instead)[n];
        }
    }
}

FieldSource::FieldSource(std::string path, std::shared_ptr<const Mesh> mesh, Activity activity, std::vector<double> times,
                         Read read)
    : m_path(std::move(path)),
      m_mesh(std::move(mesh)),
      m_activity(std::move(activity)),
      m_times(std::move(times)),
      m_read(std::move(read)) {}

FeState FieldSource::read(std::size_t k) const {
    assert(k < m_times.size());
    NodeFields fields = m_read(k);
    assert(fields.positions.size() == m_mesh->nodeCount());
    assert(fields.velocities.empty() || fields.velocities.size() == m_mesh->nodeCount());
    const NodeUse use{m_path, *m_mesh, m_activity};
    replaceUnusable(fields.positions, k, "the place", use, &m_mesh->nodes);
    replaceUnusable(fields.velocities, k, "the velocity", use, nullptr);
    FeState state;
    state.time = m_times[k];
    state.positions = std::move(fields.positions);
    state.velocities = std::move(fields.velocities);
    return state;
}

}  // namespace rubble::io
