#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/fe/frame.h"
#include "core/scenario/registration.h"
#include "core/scenario/site.h"
#include "io/site/clouds/cloud_place.h"
#include "io/site/clouds/octree/cloud_octree.h"

namespace rubble::io {

/// The octree of a cloud as it lies in a case. To be used from one thread at a time.
class PlacedOctree {
public:
    /// Opens the octree of a cloud, or makes it first. Throws as openOctree() and CloudPlace.
    /// @param read    how the cloud is read
    /// @param placed  by which it is moved once its coordinates were brought to the case; unset: not at all
    PlacedOctree(const std::string& cloud, const CloudRequest& read, const Frame& frame, const Site& site,
                 const std::optional<Registration>& placed, const Execution& execution);

    const CloudOctree& octree() const { return *m_opened.octree; }
    /// The octree was made just now.
    bool made() const { return m_opened.made; }
    /// m, local, about the points of each node.
    const std::vector<Aabb>& boxes() const { return m_boxes; }
    /// The points of a node in m, local; those without a place in the system of the case are left out. Throws as CloudOctree.
    CloudBlock read(std::size_t node) const;
    /// What was assumed on the way to the case.
    const Findings& findings() const { return m_findings; }

private:
    void bring(std::vector<Vec3>& places) const;

    OpenedOctree m_opened;
    Findings m_findings;
    std::unique_ptr<PointCloud> m_cloud;
    std::unique_ptr<CloudPlace> m_place;
    std::optional<Registration> m_placed;
    std::vector<Aabb> m_boxes;
};

}  // namespace rubble::io
