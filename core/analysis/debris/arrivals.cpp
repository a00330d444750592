#include "core/analysis/debris/arrivals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/unknown.h"
#include "core/trajectory/record_archive.h"

namespace rubble {

namespace {

constexpr double nearGround = 1.0;  // m

/// s, earliest over the squares that a test takes by their middles.
template <class Takes>
double earliest(const std::vector<DebrisArrival>& squares, Takes takes) {
    double time = unknown;
    for (const DebrisArrival& square : squares) {
        if (takes(DebrisArrivals::cell * Eigen::Vector2d(square.i + 0.5, square.j + 0.5))) {
            time = std::fmin(time, square.time);
        }
    }
    return time;
}

}  // namespace

double DebrisArrivals::first() const {
    return earliest(squares, [](const Eigen::Vector2d&) { return true; });
}

double DebrisArrivals::firstIn(const Eigen::AlignedBox2d& box) const {
    return earliest(squares, [&](const Eigen::Vector2d& middle) { return box.contains(middle); });
}

double DebrisArrivals::firstWithin(const Eigen::Vector2d& middle, double radius) const {
    return earliest(squares, [&](const Eigen::Vector2d& square) {
        const Eigen::Vector2d apart = square - middle;
        return apart.norm() <= radius || apart.cwiseAbs().maxCoeff() <= 0.5 * cell;
    });
}

ArrivalRecorder::ArrivalRecorder(const RunDescription& description, TrajectorySink* next)
    : SinkRelay(next),
      m_fe(description.fe),
      m_fragments(description.fragments),
      m_ground{true, description.scenario.simulation.groundHeight, description.terrain},
      m_carriers(description.fragments->size()) {
    for (Carrier& carrier : m_carriers) {
        carrier.from = std::numeric_limits<double>::infinity();
    }
}

void ArrivalRecorder::addBodies(std::span<const BodyRecord> bodies, std::span<const Carrier> carriers) {
    for (const Carrier& carrier : carriers) {
        m_carriers[at(carrier.fragment)] = carrier;
    }
    SinkRelay::addBodies(bodies, carriers);
}

void ArrivalRecorder::addIslands(std::span<const IslandRecord> islands, const LedgerRow& ledger) {
    takeUp(islands);
    m_islands.insert(m_islands.end(), islands.begin(), islands.end());
    SinkRelay::addIslands(islands, ledger);
}

void ArrivalRecorder::takeUp(std::span<const IslandRecord> islands) {
    for (const IslandRecord& island : islands) {
        const auto then = m_fe->state(std::min<std::size_t>(island.state, m_fe->stateCount() - 1));
        for (const ElementIndex e : island.elements) {
            Aabb bounds;
            for (const std::uint32_t node : m_fe->mesh().cornersOf(e)) {
                bounds.extend(then->positions[node]);
            }
            m_structure.push_back(
                {at(island.body), island.inFe.inverse(), OrientedBox{bounds.center(), Quat::Identity(), 0.5 * bounds.sizes()}});
        }
    }
}

void ArrivalRecorder::commit(const TrajectoryFrame& frame) {
    for (std::size_t f = 0; f < m_carriers.size(); ++f) {
        const Carrier& carrier = m_carriers[f];
        if (carrier.from <= frame.time && frame.time < carrier.to) {
            look(frame, at(carrier.body), carrier.handOverToBody, m_fragments->list[f].box);
        }
    }
    for (const CarriedBox& carried : m_structure) {
        look(frame, carried.body, carried.toBody, carried.box);
    }
    SinkRelay::commit(frame);
}

void ArrivalRecorder::look(const TrajectoryFrame& frame, std::size_t body, const Pose& toBody, const OrientedBox& box) {
    // What is frozen was looked at while it came to rest.
    if (body >= frame.bodies() || frame.states[body] != BodyState::Awake) {
        return;
    }
    const Pose pose = Pose{frame.positions[body].cast<double>(), frame.orientations[body].cast<double>().normalized()} * toBody;
    const Vec3 centre = pose * box.centre;
    const Mat3 axes = (pose.orientation * box.orientation).toRotationMatrix();
    const double lowest = centre.z() - axes.row(2).cwiseAbs().dot(box.halfExtents);
    if (!centre.allFinite()) {
        return;
    }
    // Written so that what is no number is left out.
    if (!(lowest - m_ground.height(centre.x(), centre.y()) < nearGround)) {
        return;
    }
    const auto square = [](double along) { return static_cast<std::int32_t>(std::floor(along / DebrisArrivals::cell)); };
    m_reached[square(centre.y())].try_emplace(square(centre.x()), frame.time);
}

DebrisArrivals ArrivalRecorder::arrivals() const {
    DebrisArrivals arrivals;
    for (const auto& [j, row] : m_reached) {
        for (const auto& [i, time] : row) {
            arrivals.squares.push_back({j, i, time});
        }
    }
    return arrivals;
}

void ArrivalRecorder::keep(Archive& archive) {
    archive(m_carriers, m_islands, m_reached);
    if (archive.reading()) {
        m_structure.clear();
        takeUp(m_islands);
    }
}

}  // namespace rubble
