#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/fe/site_surface.h"
#include "core/trajectory/sink_relay.h"

namespace rubble {

/// When debris first lay in a square of the ground.
struct DebrisArrival {
    std::int32_t j = 0;  ///< row, of squares of DebrisArrivals::cell from y = 0 on
    std::int32_t i = 0;  ///< column, from x = 0 on
    double time = 0.0;   ///< s, on the file's clock

    friend bool operator==(const DebrisArrival&, const DebrisArrival&) = default;
};

/// When debris first lay where. Debris are fragments from hand-over on and what the engine carries of the structure, each of its
/// elements. It lies where its centre is as soon as its lowest point is within a metre of the ground. Times are those of frames.
struct DebrisArrivals {
    static constexpr double cell = 1.0;  ///< m

    std::vector<DebrisArrival> squares;  ///< by j, then i

    /// s, first of all; NaN where nothing came down.
    double first() const;
    /// s, first in the squares whose middle lies in a box; NaN where there is none.
    double firstIn(const Eigen::AlignedBox2d& box) const;
    /// s, first in the squares whose middle lies within a circle, or that hold its middle; NaN where there is none.
    double firstWithin(const Eigen::Vector2d& middle, double radius) const;

    friend bool operator==(const DebrisArrivals&, const DebrisArrivals&) = default;
};

/// Notes when debris first lay where, and hands everything on. It changes nothing: a run with it gives the same bits.
class ArrivalRecorder : public SinkRelay {
public:
    ArrivalRecorder(const RunDescription& description, TrajectorySink* next);

    void addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) override;
    void addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) override;
    void commit(const TrajectoryFrame& frame) override;
    DebrisArrivals arrivals() const;

private:
    struct CarriedBox {
        std::size_t body = 0;
        Pose toBody;
        OrientedBox box;
    };

    void keep(Archive& archive) override;
    void takeUp(std::span<const IslandRecord> islands);
    void look(const TrajectoryFrame& frame, std::size_t body, const Pose& toBody, const OrientedBox& box);

    std::shared_ptr<const FeResult> m_fe;
    std::shared_ptr<const FragmentSet> m_fragments;
    SiteSurface m_ground;
    std::vector<Carrier> m_carriers;      ///< [fragments] the latest one; with an infinite `from` where there is none yet
    std::vector<IslandRecord> m_islands;  ///< all that were released
    std::vector<CarriedBox> m_structure;  ///< their elements
    std::map<std::int32_t, std::map<std::int32_t, double>> m_reached;  ///< s, by j and i
};

}  // namespace rubble
