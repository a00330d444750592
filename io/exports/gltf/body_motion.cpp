#include "io/exports/gltf/body_motion.h"

#include <algorithm>
#include <cmath>

namespace rubble::io {

namespace {

/// Keys looked back over at most: bounds the work for long, gentle motions.
constexpr std::size_t longestGap = 48;

bool isNumber(const MotionKey& key) {
    return key.position.allFinite() && key.orientation.coeffs().allFinite() && key.orientation.norm() > 0.5f;
}

bool samePlace(const MotionKey& a, const MotionKey& b) {
    return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs();
}

bool near(const MotionKey& a, const MotionKey& b, const MotionKey& between, const MotionTolerance& tolerance) {
    const auto share = static_cast<float>((between.time - a.time) / (b.time - a.time));
    const Eigen::Vector3f position = a.position + share * (b.position - a.position);
    return (position - between.position).norm() <= tolerance.distance &&
           a.orientation.slerp(share, b.orientation).angularDistance(between.orientation) <= tolerance.angle;
}

void addKey(std::vector<MotionKey>& keys, MotionKey key) {
    key.orientation.normalize();
    if (!keys.empty() && keys.back().orientation.dot(key.orientation) < 0.0f) {
        key.orientation.coeffs() = -key.orientation.coeffs();
    }
    keys.push_back(key);
}

}  // namespace

std::vector<std::vector<MotionKey>> recordedMotion(const TrajectoryReader& run, std::span<const BodyRecord> bodies,
                                                   std::size_t first, std::size_t last,
                                                   const std::function<void(double)>& advance) {
    std::vector<std::vector<MotionKey>> motion(last - first);
    std::vector<bool> ended(last - first, false);
    for (std::size_t b = first; b < last; ++b) {
        addKey(motion[b - first],
               {bodies[b].from, bodies[b].atBirth.position.cast<float>(), bodies[b].atBirth.orientation.cast<float>()});
    }
    const std::size_t frames = run.frameCount();
    for (std::size_t i = 0; i < frames; ++i) {
        const auto frame = run.frame(i);
        for (std::size_t b = first; b < std::min(last, frame->bodies()); ++b) {
            std::vector<MotionKey>& keys = motion[b - first];
            const MotionKey key{frame->time, frame->positions[b], frame->orientations[b]};
            if (ended[b - first] || frame->time <= keys.back().time) {
                continue;
            }
            ended[b - first] = frame->time > bodies[b].to || frame->states[b] == BodyState::Removed || !isNumber(key);
            if (!ended[b - first]) {
                addKey(keys, key);
            }
        }
        advance(static_cast<double>(i + 1) / static_cast<double>(frames));
    }
    return motion;
}

std::vector<MotionKey> fewerKeys(const std::vector<MotionKey>& keys, const MotionTolerance& tolerance) {
    // What lies still is most of a run: only the ends of each rest are looked at further.
    std::vector<MotionKey> moving;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const bool inner = i > 0 && i + 1 < keys.size();
        if (!inner || !samePlace(keys[i - 1], keys[i]) || !samePlace(keys[i], keys[i + 1])) {
            moving.push_back(keys[i]);
        }
    }
    std::vector<MotionKey> kept;
    std::size_t anchor = 0;
    for (std::size_t end = 0; end < moving.size(); ++end) {
        if (end == 0) {
            kept.push_back(moving[end]);
            continue;
        }
        const bool last = end + 1 == moving.size();
        bool reaches = !last && end + 1 - anchor <= longestGap;
        for (std::size_t k = anchor + 1; reaches && k <= end; ++k) {
            reaches = near(moving[anchor], moving[end + 1], moving[k], tolerance);
        }
        if (!reaches) {
            kept.push_back(moving[end]);
            anchor = end;
        }
    }
    return kept;
}

}  // namespace rubble::io
