#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/fe/activity.h"
#include "core/fe/fe_result.h"

namespace rubble::io {

/// Nodal fields of one state in units and axes of the file.
struct NodeFields {
    std::vector<Vec3> positions;   ///< absolute [nodes]
    std::vector<Vec3> velocities;  ///< [nodes]; empty where the file has none
};

/// Which nodes of a result must have a place and a velocity.
struct NodeUse {
    const std::string& path;  ///< named in errors
    const Mesh& mesh;
    const Activity& activity;
};
/// Replaces what is no usable number at nodes that no active element uses at a state: by the values of `instead`, or zero without.
/// @param what  says in errors what the values are
/// Throws ParseError naming the first such node that an active element uses.
void replaceUnusable(std::vector<Vec3>& values, std::size_t state, const std::string& what, const NodeUse& use,
                     const std::vector<Vec3>* instead);

/// Turns what a reader gives for a state into the state of a result. Nodes that no active element uses may have any value: those
/// that are no usable number stand at their first place, at rest. The same at a node of an active element is a ParseError.
class FieldSource : public StateSource {
public:
    using Read = std::function<NodeFields(std::size_t)>;

    /// @param path  named in errors  @param read  thread-safe; throws ParseError, WorldError
    FieldSource(std::string path, std::shared_ptr<const Mesh> mesh, Activity activity, std::vector<double> times, Read read);

    FeState read(std::size_t k) const override;

private:
    std::string m_path;
    std::shared_ptr<const Mesh> m_mesh;
    Activity m_activity;
    std::vector<double> m_times;
    Read m_read;
};

}  // namespace rubble::io
