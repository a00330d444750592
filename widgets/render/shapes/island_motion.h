#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/fe/fe_result.h"
#include "core/trajectory/trajectory.h"

namespace rubble::render {

/// Islands of live structure as drawn: their nodes ride on the bodies that carry them, each for as long as its body is there. At
/// one instant islands share no nodes; at another one a node may ride on another body, or on none. Where the nodes lay when the
/// engine took an island over is read once and kept, for what is left of it as well.
class IslandMotion {
public:
    static constexpr std::uint32_t none = 0xffffffffu;

    explicit IslandMotion(std::shared_ptr<const FeResult> fe) : m_fe(std::move(fe)) {}

    /// Learns which islands there are; to be called again with the whole lists when a run has grown. Islands that name what does
    /// not exist are left out.
    void bind(std::vector<IslandRecord> islands, std::span<const BodyRecord> bodies);
    /// Moves to a frame. Bodies that are not in it stand where they entered.
    /// Throws what reading a state throws; everything stays as it was then.
    void moveTo(const TrajectoryFrame& frame, double time);

    /// Goes up whenever nodes have changed over to other islands.
    std::uint64_t version() const { return m_version; }
    /// Elements of the islands that are there now.
    std::size_t elements() const { return m_elements; }
    /// The island that a node rides on now, or `none`.
    std::uint32_t of(std::uint32_t node) const { return m_there.empty() ? none : m_rides[node].island; }
    /// Where a node lies that rides on one, m.
    Eigen::Vector3f place(std::uint32_t node) const {
        const Ride& ride = m_rides[node];
        const Motion& motion = m_there[ride.island].motion;
        return motion.turn * (ride.held - motion.pivot) + motion.position;
    }

private:
    struct Island {
        std::size_t body = 0;
        double from = 0.0;  ///< s
        double to = 0.0;    ///< s
        std::size_t state = 0;
        Pose inFe;
        Pose atBirth;
        std::vector<ElementIndex> elements;
    };
    struct Motion {
        Eigen::Vector3f pivot = Eigen::Vector3f::Zero();     ///< m, centre of mass among the places held
        Eigen::Matrix3f turn = Eigen::Matrix3f::Identity();  ///< since then
        Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< m, of the centre of mass
    };
    struct There {
        std::size_t island = 0;  ///< index into m_islands
        Motion motion;
    };
    struct Ride {
        std::uint32_t island = none;                     ///< index into m_there
        Eigen::Vector3f held = Eigen::Vector3f::Zero();  ///< m, at the island's state
    };
    /// Places of the nodes of all islands with one state.
    struct Held {
        std::vector<std::uint32_t> nodes;  ///< ascending
        std::vector<Eigen::Vector3f> places;

        const Eigen::Vector3f* find(std::uint32_t node) const;
    };
    void changeOver(double time);
    bool ride(std::vector<Ride>& rides, const Island& island, std::uint32_t index) const;
    void hold(std::size_t state);

    std::shared_ptr<const FeResult> m_fe;
    std::vector<Island> m_islands;
    std::vector<double> m_events;  ///< s, ascending: islands enter or leave
    std::size_t m_slot = ~std::size_t{0};
    std::map<std::size_t, Held> m_held;  ///< by state; read when first shown
    std::vector<There> m_there;
    std::vector<Ride> m_rides;  ///< [nodes]
    std::size_t m_elements = 0;
    std::uint64_t m_version = 0;
};

}  // namespace rubble::render
