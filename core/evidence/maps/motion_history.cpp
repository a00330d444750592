#include "core/evidence/maps/motion_history.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "core/base/csv_text.h"

namespace rubble {

namespace {

/// The carriers of some fragments, fragment by fragment in the order of time, and how far time has got in each.
struct Riders {
    std::vector<FragmentId> fragments;
    std::vector<std::vector<Carrier>> rides;  ///< by place in `fragments`

    Riders(std::span<const FragmentId> which, std::span<const Carrier> carriers, std::size_t count)
        : fragments(which.begin(), which.end()), rides(which.size()) {
        std::vector<std::size_t> placeOf(count, which.size());
        for (std::size_t i = 0; i < which.size(); ++i) {
            placeOf[at(which[i])] = i;
        }
        for (const Carrier& carrier : carriers) {
            if (at(carrier.fragment) < count && placeOf[at(carrier.fragment)] < which.size()) {
                rides[placeOf[at(carrier.fragment)]].push_back(carrier);
            }
        }
    }

    /// The carrier that holds at a time; null before the first.
    const Carrier* holding(std::size_t place, double time) const {
        const Carrier* current = nullptr;
        for (const Carrier& ride : rides[place]) {
            if (ride.from <= time) {
                current = &ride;
            }
        }
        return current;
    }
};

/// The fragment is there: its element is dead, and a body carries it that has not left.
bool there(const Fragment& fragment, const Carrier* ride, const TrajectoryFrame& frame) {
    return ride != nullptr && frame.time < fragment.endTime && frame.time < ride->to &&
           (at(ride->body) >= frame.bodies() || frame.states[at(ride->body)] != BodyState::Removed);
}

double speedOf(const Fragment& fragment, const Carrier& ride, const TrajectoryFrame& frame) {
    return at(ride.body) < frame.speeds.size() ? static_cast<double>(frame.speeds[at(ride.body)]) : fragment.velocity.norm();
}

double heightOf(const Fragment& fragment, const Carrier& ride, const TrajectoryFrame& frame) {
    const std::size_t body = at(ride.body);
    if (body >= frame.bodies()) {
        return fragment.centre.z();
    }
    const Vec3 turned = frame.orientations[body].cast<double>().normalized() * (ride.handOverToBody * fragment.centre);
    return static_cast<double>(frame.positions[body].z()) + turned.z();
}

HistoryPoint pointOf(const FragmentSet& fragments, const Riders& riders, const TrajectoryFrame& frame, double gravity,
                     double level) {
    HistoryPoint point;
    point.time = frame.time;
    double squares = 0.0;
    double heights = 0.0;
    for (std::size_t i = 0; i < riders.fragments.size(); ++i) {
        const Fragment& fragment = fragments.list[at(riders.fragments[i])];
        const Carrier* ride = riders.holding(i, frame.time);
        if (!there(fragment, ride, frame)) {
            continue;
        }
        const double speed = speedOf(fragment, *ride, frame);
        ++point.fragments;
        point.mass += fragment.mass;
        point.topSpeed = std::max(point.topSpeed, speed);
        squares += fragment.mass * speed * speed;
        heights += fragment.mass * heightOf(fragment, *ride, frame);
    }
    if (point.mass > 0.0) {
        point.speed = std::sqrt(squares / point.mass);
        point.height = heights / point.mass;
    }
    point.kinetic = 0.5 * squares;
    point.potential = gravity * (heights - point.mass * level);
    return point;
}

}  // namespace

std::vector<double> fragmentSpeeds(const FragmentSet& fragments, std::span<const Carrier> carriers, const TrajectoryFrame& frame) {
    std::vector<const Carrier*> rides(fragments.size(), nullptr);
    for (const Carrier& carrier : carriers) {
        if (at(carrier.fragment) < rides.size() && carrier.from <= frame.time) {
            rides[at(carrier.fragment)] = &carrier;
        }
    }
    std::vector<double> speeds(fragments.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t f = 0; f < speeds.size(); ++f) {
        const Fragment& fragment = fragments.list[f];
        if (there(fragment, rides[f], frame)) {
            speeds[f] = speedOf(fragment, *rides[f], frame);
        }
    }
    return speeds;
}

std::vector<HistoryPoint> fragmentHistory(const FragmentSet& fragments, const TrajectoryReader& trajectory,
                                          std::span<const FragmentId> which, double gravity, double level,
                                          const Execution& execution) {
    const Message stage{"history.stage", "Reading the history of fragments", {}};
    const std::size_t frames = trajectory.frameCount();
    const Riders riders(which, trajectory.carriers(), fragments.size());
    std::vector<HistoryPoint> points;
    for (std::size_t k = 0; k < frames; ++k) {
        execution.check();
        execution.report(stage, static_cast<double>(k) / static_cast<double>(frames));
        const HistoryPoint point = pointOf(fragments, riders, *trajectory.frame(k), gravity, level);
        if (point.fragments > 0) {
            points.push_back(point);
        }
    }
    return points;
}

void writeHistoryCsv(std::span<const HistoryPoint> points, std::ostream& out) {
    out << "time_s,fragments,mass_kg,height_m,speed_m_s,top_speed_m_s,kinetic_energy_j,potential_energy_j\n";
    for (const HistoryPoint& point : points) {
        out << exactNumber(point.time) << ',' << point.fragments;
        for (const double figure : {point.mass, point.height, point.speed, point.topSpeed, point.kinetic, point.potential}) {
            out << ',' << exactNumber(figure);
        }
        out << '\n';
    }
}

}  // namespace rubble
