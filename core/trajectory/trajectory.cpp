#include "core/trajectory/trajectory.h"

#include <algorithm>

namespace rubble {

std::size_t TrajectoryReader::frameAt(double time) const {
    std::size_t low = 0;
    std::size_t high = frameCount();
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (frameTime(middle) <= time) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low == 0 ? 0 : low - 1;
}

void endReplaced(std::vector<BodyRecord>& bodies, std::vector<Carrier>& carriers) {
    constexpr std::size_t nobody = ~std::size_t{0};
    std::vector<std::size_t> latest;               // carrier of each fragment
    std::vector<std::size_t> left(bodies.size());  // fragments that a body still carries
    for (std::size_t c = 0; c < carriers.size(); ++c) {
        const std::size_t fragment = at(carriers[c].fragment);
        latest.resize(std::max(latest.size(), fragment + 1), nobody);
        if (at(carriers[c].body) < left.size()) {
            ++left[at(carriers[c].body)];
        }
        if (latest[fragment] != nobody) {
            Carrier& before = carriers[latest[fragment]];
            before.to = std::min(before.to, carriers[c].from);
            if (at(before.body) < left.size() && --left[at(before.body)] == 0) {
                bodies[at(before.body)].to = std::min(bodies[at(before.body)].to, carriers[c].from);
            }
        }
        latest[fragment] = c;
    }
}

namespace {

// How far an instant lies on the way from one time to a later one, [0, 1].
float fractionOf(double from, double to, double time) {
    return to > from ? static_cast<float>(std::clamp((time - from) / (to - from), 0.0, 1.0)) : 1.0f;
}

Eigen::Quaternionf between(const Eigen::Quaternionf& a, const Eigen::Quaternionf& b, float fraction) {
    return a.slerp(fraction, b).normalized();
}

// Bodies that entered after `before`: on the straight way from their birth place to where the later frame has them.
void addNewcomers(TrajectoryFrame& frame, const std::vector<BodyRecord>& bodies, std::size_t known, const TrajectoryFrame& after) {
    std::size_t entered = known;
    const std::size_t last = std::min(bodies.size(), after.bodies());
    for (std::size_t b = known; b < last; ++b) {
        if (bodies[b].from <= frame.time) {
            entered = b + 1;
        }
    }
    for (std::size_t b = known; b < entered; ++b) {
        const BodyRecord& body = bodies[b];
        const float fraction = fractionOf(body.from, after.time, std::max(frame.time, body.from));
        const Eigen::Vector3f birth = body.atBirth.position.cast<float>();
        frame.positions.push_back(birth + fraction * (after.positions[b] - birth));
        frame.orientations.push_back(between(body.atBirth.orientation.cast<float>(), after.orientations[b], fraction));
        frame.speeds.push_back(after.speeds[b]);
        frame.states.push_back(BodyState::Awake);
    }
}

}  // namespace

TrajectoryFrame frameAtTime(const TrajectoryReader& reader, double time) {
    TrajectoryFrame frame;
    frame.time = time;
    const std::size_t count = reader.frameCount();
    if (count == 0 || !(time >= reader.frameTime(0))) {
        return frame;
    }
    const std::size_t index = std::min(reader.frameAt(time), count - 1);
    const std::shared_ptr<const TrajectoryFrame> before = reader.frame(index);
    if (before->time == time || index + 1 >= count) {
        return *before;
    }
    const std::shared_ptr<const TrajectoryFrame> after = reader.frame(index + 1);
    const float fraction = fractionOf(before->time, after->time, time);
    frame.kind = FrameKind::Interpolated;
    const std::size_t known = std::min(before->bodies(), after->bodies());
    frame.states.assign(before->states.begin(), before->states.begin() + static_cast<std::ptrdiff_t>(known));
    frame.positions.reserve(after->bodies());
    frame.orientations.reserve(after->bodies());
    frame.speeds.reserve(after->bodies());
    for (std::size_t b = 0; b < known; ++b) {
        frame.positions.push_back(before->positions[b] + fraction * (after->positions[b] - before->positions[b]));
        frame.orientations.push_back(between(before->orientations[b], after->orientations[b], fraction));
        frame.speeds.push_back(before->speeds[b] + fraction * (after->speeds[b] - before->speeds[b]));
    }
    if (after->bodies() > known) {
        addNewcomers(frame, reader.bodies(), known, *after);
    }
    return frame;
}

}  // namespace rubble
