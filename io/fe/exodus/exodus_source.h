#pragma once

#include <memory>
#include <optional>

#include "core/fe/activity.h"
#include "core/fe/fe_result.h"
#include "io/fe/exodus/exodus_file.h"
#include "io/fe/exodus/exodus_names.h"

namespace rubble::io {

/// Reads nodal fields of an Exodus file, one state at a time, and holds none. Nodes that no active element uses may have any value:
/// those that are no usable number stand at their first place, at rest. The same at a node of an active element is a ParseError.
class ExodusSource : public StateSource {
public:
    /// Variables are nothing where the file has no such vector.
    ExodusSource(std::shared_ptr<const ExodusFile> file, std::shared_ptr<const Mesh> mesh, Activity activity,
                 std::optional<VectorVariable> displacement, std::optional<VectorVariable> velocity);

    FeState read(std::size_t k) const override;

private:
    std::vector<Vec3> readVector(std::size_t k, const VectorVariable& variable) const;

    std::shared_ptr<const ExodusFile> m_file;
    std::shared_ptr<const Mesh> m_mesh;
    Activity m_activity;
    std::optional<VectorVariable> m_displacement;
    std::optional<VectorVariable> m_velocity;
};

}  // namespace rubble::io
