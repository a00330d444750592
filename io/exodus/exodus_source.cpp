#include "io/exodus/exodus_source.h"

#include <algorithm>
#include <cassert>

#include "core/base/error.h"
#include "io/mesh_builder.h"

namespace rubble::io {

ExodusSource::ExodusSource(std::shared_ptr<const ExodusFile> file, std::shared_ptr<const Mesh> mesh, Activity activity,
                           std::optional<VectorVariable> displacement, std::optional<VectorVariable> velocity)
    : m_file(std::move(file)),
      m_mesh(std::move(mesh)),
      m_activity(std::move(activity)),
      m_displacement(std::move(displacement)),
      m_velocity(std::move(velocity)) {}

FeState ExodusSource::read(std::size_t k) const {
    assert(k < m_file->times().size());
    FeState state;
    state.time = m_file->times()[k];
    state.positions = m_mesh->nodes;
    if (m_displacement) {
        const std::vector<Vec3> displacement = readVector(k, *m_displacement);
        for (std::size_t n = 0; n < displacement.size(); ++n) {
            state.positions[n] += displacement[n];
        }
    }
    if (m_velocity) {
        state.velocities = readVector(k, *m_velocity);
    }
    return state;
}

std::vector<Vec3> ExodusSource::readVector(std::size_t k, const VectorVariable& variable) const {
    std::vector<Vec3> values(m_mesh->nodeCount());
    std::vector<double> component(m_mesh->nodeCount());
    bool sound = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_file->readNodal(k, variable.index[axis], component);
        for (std::size_t n = 0; n < component.size(); ++n) {
            values[n][static_cast<Eigen::Index>(axis)] = component[n];
            sound &= usableLength(component[n]);
        }
    }
    if (!sound) {
        mend(k, variable, values);
    }
    return values;
}

void ExodusSource::mend(std::size_t k, const VectorVariable& variable, std::vector<Vec3>& values) const {
    std::vector<bool> needed(values.size(), false);
    for (std::size_t e = 0; e < m_mesh->elementCount(); ++e) {
        const ElementIndex id = idAt<ElementIndex>(e);
        if (m_activity.active(k, id)) {
            for (const std::uint32_t node : m_mesh->cornersOf(id)) {
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
                {"exodus.bad_value",
                 "{0}: {1} of node {2} at state {3} is ({4}, {5}, {6})",
                 {m_file->path(), variable.name, m_mesh->nodeIds[n], k, values[n].x(), values[n].y(), values[n].z()}},
                {"exodus.bad_value.remedy",
                 "Nodes of active elements need finite values: let the analysis write the state again, or cut the file before it.",
                 {}});
        }
        values[n].setZero();
    }
}

}  // namespace rubble::io
