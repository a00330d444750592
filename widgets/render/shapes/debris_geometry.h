#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/clusters/clustering.h"
#include "core/fragments/fragment_set.h"
#include "core/trajectory/trajectory.h"

namespace rubble::render {

/// The fragments as drawn: rigid groups (the fragments of a cluster that the same bodies carry) with welded vertices, without the
/// faces that two fragments of a group share. Vertices are kept relative to the group's centre in single precision.
class DebrisGeometry {
public:
    static constexpr std::uint32_t none = 0xffffffffu;

    struct Vertex {
        Eigen::Vector3f local;     ///< m, from the group's centre, at hand-over
        FragmentId fragment{};     ///< whose colour it takes
        std::uint32_t corner = 0;  ///< of that fragment's solid
    };
    /// Triangle (fourth `none`) or quadrilateral seen from outside.
    struct Face {
        std::array<std::uint32_t, 4> vertices{};
        FragmentId fragment{};
    };
    struct Group {
        std::uint32_t firstVertex = 0;
        std::uint32_t vertexCount = 0;
        FragmentId first{};
        Vec3 centre = Vec3::Zero();  ///< m, at hand-over
    };

    /// @param clusters   may be null: every fragment is its own group then
    /// @param hideInner  false keeps the faces inside groups
    /// @param hidden     [fragments], 1 for those that are left out, or empty; their neighbours show the faces towards them
    DebrisGeometry(const FragmentSet& fragments, const Clustering* clusters, bool hideInner = true,
                   std::span<const std::uint8_t> hidden = {});

    /// Learns which body carries which fragment when; to be called again with the whole list when it has grown. Groups whose
    /// fragments part company are split.
    void bind(std::span<const Carrier> carriers);

    /// The same groups with less detail: vertices of a group in one cell are one, faces that vanish are left out, and a group that
    /// is narrower than two cells is a box in its axes at hand-over with the volume of its fragments, so that none vanishes. To be
    /// made anew after bind().
    /// @param cell  edge of a cell, m
    DebrisGeometry simplified(double cell) const;

    std::span<const Vertex> vertices() const { return m_vertices; }
    std::span<const Face> faces() const { return m_faces; }
    /// In the order of their first fragments.
    std::span<const Group> groups() const { return m_groups; }

    /// Writes the positions of the first `count` groups at a time, xyz by vertex. Groups without a body, or whose body is not in
    /// the

    /// frame yet, stand where they were handed over; groups whose last body has left shrink to a point.
    /// @param out  room for 3 floats a vertex of these groups
    void place(const TrajectoryFrame& frame, double time, std::size_t count, float* out) const;
    /// Where a fragment's centre of mass lies at a time, m; nothing if its last body has left, or if it is hidden.
    std::optional<Vec3> centreOf(FragmentId fragment, const TrajectoryFrame& frame, double time) const;
    /// Speed of each of the first `count` groups in a frame, m/s; 0 without a body.
    std::vector<float> speeds(const TrajectoryFrame& frame, double time, std::size_t count) const;

private:
    struct Ride {
        std::uint32_t body = 0;
        double from = 0.0;
        double to = 0.0;
        Pose handOverToBody;
    };
    const Ride* rideAt(std::size_t group, double time) const;
    void noteGroups();
    void build(const std::vector<std::vector<FragmentId>>& members);
    void addGroup(std::span<const FragmentId> members);
    void addBox(const Eigen::AlignedBox3f& box, FragmentId fragment);
    void addJoined(std::span<const Vertex> vertices, std::span<const Face> faces, std::uint32_t first,
                   const std::vector<std::uint32_t>& joined);

    const FragmentSet& m_fragments;
    const Clustering* m_clusters;
    bool m_hideInner;
    std::vector<Vertex> m_vertices;
    std::vector<Face> m_faces;
    std::vector<Group> m_groups;
    std::vector<std::vector<FragmentId>> m_members;
    std::vector<std::vector<Ride>> m_rides;  ///< by group
    std::vector<std::uint32_t> m_groupOf;    ///< by fragment; `none` of hidden ones
};

}  // namespace rubble::render
