#include "core/evidence/maps/fragment_path.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr double hitChange = 1.0;      // m/s
constexpr double restDistance = 0.05;  // m

std::vector<Carrier> carriersOf(const TrajectoryReader& trajectory, FragmentId fragment) {
    std::vector<Carrier> own;
    for (const Carrier& carrier : trajectory.carriers()) {
        if (carrier.fragment == fragment) {
            own.push_back(carrier);
        }
    }
    std::stable_sort(own.begin(), own.end(), [](const Carrier& a, const Carrier& b) { return a.from < b.from; });
    return own;
}

/// Where a frame has the fragment; nothing if no body carries it then.
std::optional<Vec3> placeIn(const TrajectoryFrame& frame, const std::vector<Carrier>& carriers, const Fragment& fragment) {
    const auto after = std::find_if(carriers.begin(), carriers.end(), [&](const Carrier& c) { return c.from > frame.time; });
    if (after == carriers.begin() || frame.time >= fragment.endTime) {
        return std::nullopt;
    }
    const Carrier& carrier = *(after - 1);
    const std::size_t body = at(carrier.body);
    if (body >= frame.bodies() || frame.time >= carrier.to || frame.states[body] == BodyState::Removed) {
        return std::nullopt;
    }
    return frame.positions[body].cast<double>() +
           frame.orientations[body].cast<double>().normalized() * (carrier.handOverToBody * fragment.centre);
}

/// Changes of velocity at the inner points; neighbours in time that are all hits become one.
std::vector<FragmentImpact> impactsOf(const std::vector<PathPoint>& points, double mass, double gravity) {
    std::vector<FragmentImpact> impacts;
    bool within = false;
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        const double before = points[k].time - points[k - 1].time;
        const double after = points[k + 1].time - points[k].time;
        const Vec3 was = (points[k].place - points[k - 1].place) / before;
        const Vec3 is = (points[k + 1].place - points[k].place) / after;
        const double change = (is - was - Vec3(0.0, 0.0, -gravity * 0.5 * (before + after))).norm();
        if (!(change > hitChange)) {
            within = false;
            continue;
        }
        if (!within) {
            impacts.push_back({points[k].time, was.norm(), change, 0.5 * mass * was.squaredNorm()});
        } else if (change > impacts.back().change) {
            impacts.back().time = points[k].time;
            impacts.back().change = change;
        }
        within = true;
    }
    return impacts;
}

double restTimeOf(const std::vector<PathPoint>& points) {
    std::size_t k = points.size();
    while (k > 0 && (points[k - 1].place - points.back().place).norm() <= restDistance) {
        --k;
    }
    return points.empty() ? 0.0 : points[std::min(k, points.size() - 1)].time;
}

}  // namespace

FragmentPath fragmentPath(const FragmentSet& fragments, const TrajectoryReader& trajectory, FragmentId fragment, double gravity,
                          const Execution& execution) {
    const Message stage{"path.stage", "Following a fragment", {}};
    const Fragment& own = fragments.list[at(fragment)];
    const std::vector<Carrier> carriers = carriersOf(trajectory, fragment);
    FragmentPath path;
    const std::size_t frames = trajectory.frameCount();
    for (std::size_t k = carriers.empty() ? frames : trajectory.frameAt(own.handOverTime); k < frames; ++k) {
        execution.report(stage, static_cast<double>(k) / static_cast<double>(frames));
        const std::shared_ptr<const TrajectoryFrame> frame = trajectory.frame(k);
        const double time = frame->time;
        const std::optional<Vec3> found = placeIn(*frame, carriers, own);
        path.removed = !found && !path.points.empty();
        if (!found) {
            continue;
        }
        const Vec3& place = *found;
        const PathPoint* last = path.points.empty() ? nullptr : &path.points.back();
        if (last == nullptr || time > last->time) {
            path.points.push_back({time, place, last == nullptr ? 0.0 : (place - last->place).norm() / (time - last->time)});
        }
    }
    path.impacts = impactsOf(path.points, own.mass, gravity);
    path.restTime = restTimeOf(path.points);
    execution.report(stage, 1.0);
    return path;
}

std::optional<Vec3> fragmentPlace(const FragmentSet& fragments, const TrajectoryReader& trajectory, FragmentId fragment,
                                  double time) {
    return placeIn(frameAtTime(trajectory, time), carriersOf(trajectory, fragment), fragments.list[at(fragment)]);
}

}  // namespace rubble
