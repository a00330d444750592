#include "io/exports/page/page_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/exports/gltf/body_motion.h"

namespace rubble::io {

namespace {

/// Recorded places that are held at a time, at most.
constexpr std::size_t playedBytes = std::size_t{128} << 20;
/// m, of the farthest corner, by which the steps of a turn may move it.
constexpr double turnStep = 3e-4;
constexpr int leastTurnBits = 10;
constexpr int mostTurnBits = 24;
/// m; a body without corners counts as this large.
constexpr double leastReach = 0.05;

int turnBits(double reach) {
    // Half a step in each of four numbers turns by a whole one, twice that as an angle.
    return std::clamp(static_cast<int>(std::ceil(std::log2(2.0 * reach / turnStep))), leastTurnBits, mostTurnBits);
}

/// A key in whole steps.
struct PackedKey {
    std::int64_t instant = 0;
    std::array<std::int64_t, 7> numbers{};  ///< place, then turn as x, y, z, w
};

class MotionPacker {
public:
    MotionPacker(const std::vector<double>& instants, const PagePrecision& precision)
        : m_instants(instants), m_precision(precision) {}

    /// Packs the keys of a body; the largest error at its recorded instants, m.
    double add(const std::vector<MotionKey>& recorded, double reach);

    PackedIntegers counts;
    PackedIntegers keys;
    std::size_t kept = 0;

private:
    PackedKey packed(const MotionKey& key, double turnScale) const;
    MotionKey unpacked(const PackedKey& key, double turnScale) const;

    const std::vector<double>& m_instants;
    PagePrecision m_precision;
};

PackedKey MotionPacker::packed(const MotionKey& key, double turnScale) const {
    PackedKey steps;
    steps.instant = std::lower_bound(m_instants.begin(), m_instants.end(), key.time) - m_instants.begin();
    for (int c = 0; c < 3; ++c) {
        steps.numbers[static_cast<std::size_t>(c)] = std::llround(static_cast<double>(key.position[c]) / m_precision.placeStep);
    }
    for (int c = 0; c < 4; ++c) {
        steps.numbers[3 + static_cast<std::size_t>(c)] = std::llround(static_cast<double>(key.orientation.coeffs()[c]) * turnScale);
    }
    return steps;
}

MotionKey MotionPacker::unpacked(const PackedKey& steps, double turnScale) const {
    MotionKey key;
    key.time = m_instants[static_cast<std::size_t>(steps.instant)];
    for (int c = 0; c < 3; ++c) {
        key.position[c] =
            static_cast<float>(static_cast<double>(steps.numbers[static_cast<std::size_t>(c)]) * m_precision.placeStep);
    }
    for (int c = 0; c < 4; ++c) {
        key.orientation.coeffs()[c] =
            static_cast<float>(static_cast<double>(steps.numbers[3 + static_cast<std::size_t>(c)]) / turnScale);
    }
    key.orientation.normalize();
    return key;
}

/// Largest distance of a corner from where the body's recorded place has it.
double errorOf(const std::vector<MotionKey>& played, const std::vector<MotionKey>& recorded, double reach) {
    double worst = 0.0;
    std::size_t k = 0;
    for (const MotionKey& key : recorded) {
        while (k + 1 < played.size() && played[k + 1].time <= key.time) {
            ++k;
        }
        MotionKey at = played[k];
        if (k + 1 < played.size()) {
            const auto share = static_cast<float>((key.time - played[k].time) / (played[k + 1].time - played[k].time));
            at.position += share * (played[k + 1].position - at.position);
            at.orientation = at.orientation.slerp(share, played[k + 1].orientation);
        }
        const double turn = at.orientation.cast<double>().angularDistance(key.orientation.cast<double>());
        worst = std::max(worst, (at.position - key.position).cast<double>().norm() + 2.0 * std::sin(0.5 * turn) * reach);
    }
    return worst;
}

double MotionPacker::add(const std::vector<MotionKey>& recorded, double reach) {
    const int bits = turnBits(reach);
    const double turnScale = std::ldexp(1.0, bits);
    const std::vector<MotionKey> enough = fewerKeys(recorded, {m_precision.kept, m_precision.turned / reach});
    kept += enough.size();
    std::vector<MotionKey> played;
    PackedKey before;
    counts.add(static_cast<std::int64_t>(enough.size()));
    keys.add(bits);
    for (const MotionKey& key : enough) {
        const PackedKey steps = packed(key, turnScale);
        keys.add(steps.instant - before.instant);
        for (std::size_t c = 0; c < steps.numbers.size(); ++c) {
            keys.add(steps.numbers[c] - before.numbers[c]);
        }
        before = steps;
        played.push_back(unpacked(steps, turnScale));
    }
    return errorOf(played, recorded, reach);
}

/// All instants at which something is recorded, ascending: the frames, and the entries of the bodies.
std::vector<double> instantsOf(const RunReader& run, const std::vector<BodyRecord>& bodies) {
    std::vector<double> instants;
    for (std::size_t i = 0; i < run.frameCount(); ++i) {
        instants.push_back(run.frameTime(i));
    }
    for (const BodyRecord& body : bodies) {
        instants.push_back(body.from);
    }
    std::sort(instants.begin(), instants.end());
    instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
    return instants;
}

/// When a body is gone: at its last recorded place at the latest if frames without it follow.
double endOf(const BodyRecord& body, const std::vector<MotionKey>& recorded, const RunReader& run) {
    const std::size_t frames = run.frameCount();
    if (frames == 0 || recorded.back().time >= run.frameTime(frames - 1)) {
        return body.to;
    }
    const std::size_t last = run.frameAt(recorded.back().time);
    const std::size_t next = run.frameTime(last) > recorded.back().time ? last : last + 1;
    return std::min(body.to, run.frameTime(std::min(next, frames - 1)));
}

}  // namespace

PageMotion addMotion(PageData& data, const RunReader& run, const std::vector<BodyRecord>& bodies, const std::vector<double>& reach,
                     const PagePrecision& precision, const Execution& execution) {
    const Message stage{"io.page.motion", "Packing the motion of the bodies", {}};
    const std::vector<double> instants = instantsOf(run, bodies);
    MotionPacker packer(instants, precision);
    PageMotion motion;
    const std::size_t perBody = std::max<std::size_t>(1, run.frameCount()) * sizeof(MotionKey);
    const std::size_t atOnce = std::max<std::size_t>(1, playedBytes / perBody);
    const auto all = static_cast<double>(std::max<std::size_t>(1, bodies.size()));
    for (std::size_t first = 0; first < bodies.size(); first += atOnce) {
        const std::size_t last = std::min(bodies.size(), first + atOnce);
        const auto recorded = recordedMotion(run, bodies, first, last, [&](double share) {
            execution.report(stage, (static_cast<double>(first) + share * static_cast<double>(last - first)) / all);
        });
        for (std::size_t b = first; b < last; ++b) {
            const std::vector<MotionKey>& keys = recorded[b - first];
            motion.largestError = std::max(motion.largestError, packer.add(keys, std::max(leastReach, reach[b])));
            motion.end.push_back(endOf(bodies[b], keys, run));
        }
    }
    motion.keys = packer.kept;
    data.add("instants", instants);
    data.add("keyCounts", packer.counts);
    data.add("keys", packer.keys);
    return motion;
}

}  // namespace rubble::io
