#include "io/fe/exodus/exodus_source.h"

#include <algorithm>
#include <cassert>

#include "io/fe/node_fields.h"

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
    for (std::size_t axis = 0; axis < 3; ++axis) {
        m_file->readNodal(k, variable.index[axis], component);
        for (std::size_t n = 0; n < component.size(); ++n) {
            values[n][static_cast<Eigen::Index>(axis)] = component[n];
        }
    }
    replaceUnusable(values, k, variable.name, {m_file->path(), *m_mesh, m_activity}, nullptr);
    return values;
}

}  // namespace rubble::io
