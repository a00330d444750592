#include "core/evidence/maps/fragment_history.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "core/base/unknown.h"

namespace rubble {

namespace {

/// The carriers of a run by fragment, then time.
std::vector<Carrier> sortedCarriers(const TrajectoryReader& trajectory, std::size_t fragments) {
    std::vector<Carrier> carriers = trajectory.carriers();
    std::erase_if(carriers, [&](const Carrier& carrier) { return at(carrier.fragment) >= fragments; });
    std::stable_sort(carriers.begin(), carriers.end(), [](const Carrier& a, const Carrier& b) {
        return std::tuple(a.fragment, a.from) < std::tuple(b.fragment, b.from);
    });
    return carriers;
}

/// Distance of a fragment from where it lies, at the frame before.
struct Approach {
    double time = unknown;  ///< s
    double distance = 0.0;  ///< m
};

Message arrivalStage() {
    return {"map.stage.arrival", "Looking when debris came to where it lies", {}};
}

/// How the bodies moved between the last three frames.
class Hits {
public:
    explicit Hits(double gravity) : m_gravity(gravity) {}

    void take(const TrajectoryFrame& frame) {
        m_tracks.resize(std::max(m_tracks.size(), frame.bodies()));
        for (std::size_t b = 0; b < frame.bodies(); ++b) {
            if (frame.states[b] != BodyState::Removed) {
                take(m_tracks[b], frame.positions[b].cast<double>(), frame.time);
            }
        }
    }
    /// s; NaN of a body that was not there for three frames.
    double timeOf(std::size_t body) const { return body < m_tracks.size() ? m_tracks[body].hitTime : unknown; }
    double strengthOf(std::size_t body) const { return body < m_tracks.size() ? m_tracks[body].hardest : -1.0; }

private:
    struct Track {
        int frames = 0;
        double time = 0.0;
        Vec3 place = Vec3::Zero();
        Vec3 velocity = Vec3::Zero();  ///< m/s, in the mean up to `time`
        double mean = 0.0;             ///< s, middle of that interval
        double hardest = -1.0;         ///< m/s
        double hitTime = unknown;
    };

    void take(Track& track, const Vec3& place, double time) const {
        if (track.frames > 0 && time > track.time) {
            const Vec3 velocity = (place - track.place) / (time - track.time);
            const double mean = 0.5 * (time + track.time);
            if (track.frames > 1) {
                const Vec3 fall(0.0, 0.0, -m_gravity * (mean - track.mean));
                const double hit = (velocity - track.velocity - fall).norm();
                if (hit > track.hardest) {
                    track.hardest = hit;
                    track.hitTime = track.time;
                }
            }
            track.velocity = velocity;
            track.mean = mean;
        }
        if (track.frames == 0 || time > track.time) {
            track.place = place;
            track.time = time;
            track.frames = std::min(track.frames + 1, 2);
        }
    }

    double m_gravity;
    std::vector<Track> m_tracks;
};

}  // namespace

std::vector<double> arrivalTimes(const FragmentSet& fragments, const TrajectoryReader& trajectory, const Debris& debris,
                                 double distance, const Execution& execution) {
    assert(debris.fragments.size() == fragments.size());
    const std::vector<Carrier> carriers = sortedCarriers(trajectory, fragments.size());
    std::vector<double> arrivals(fragments.size(), unknown);
    std::vector<Approach> approach(fragments.size());
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        if (debris.fragments[f].present) {
            arrivals[f] = std::min(fragments.list[f].birthTime, debris.time);
        }
    }
    const std::size_t frames = trajectory.frameCount();
    for (std::size_t k = 0; k < frames && trajectory.frameTime(k) <= debris.time; ++k) {
        execution.report(arrivalStage(), static_cast<double>(k) / static_cast<double>(frames));
        const std::shared_ptr<const TrajectoryFrame> frame = trajectory.frame(k);
        for (const Carrier& carrier : carriers) {
            const std::size_t f = at(carrier.fragment);
            const std::size_t body = at(carrier.body);
            if (!debris.fragments[f].present || frame->time < carrier.from || frame->time >= carrier.to ||
                body >= frame->bodies()) {
                continue;
            }
            const Vec3 inBody = carrier.handOverToBody * fragments.list[f].centre;
            const Vec3 place =
                frame->positions[body].cast<double>() + frame->orientations[body].cast<double>().normalized() * inBody;
            const double away = (place - debris.fragments[f].centre).norm();
            const Approach before = approach[f];
            approach[f] = {frame->time, away};
            if (away > distance) {
                arrivals[f] = debris.time;
            } else if (before.distance > distance) {
                const double share = (before.distance - distance) / std::max(before.distance - away, 1e-300);
                arrivals[f] = before.time + std::clamp(share, 0.0, 1.0) * (frame->time - before.time);
            }
        }
    }
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        // Born on the way: nobody saw it before.
        arrivals[f] = std::max(arrivals[f], std::min(fragments.list[f].birthTime, debris.time));
    }
    execution.report(arrivalStage(), 1.0);
    return arrivals;
}

std::vector<double> hardestHitTimes(const FragmentSet& fragments, const TrajectoryReader& trajectory, double gravity,
                                    const Execution& execution) {
    const Message stage{"map.stage.hits", "Looking when debris was hit hardest", {}};
    Hits hits(gravity);
    const std::size_t frames = trajectory.frameCount();
    for (std::size_t k = 0; k < frames; ++k) {
        execution.report(stage, static_cast<double>(k) / static_cast<double>(frames));
        hits.take(*trajectory.frame(k));
    }
    std::vector<double> times(fragments.size(), unknown);
    std::vector<double> strength(fragments.size(), -1.0);
    for (const Carrier& carrier : sortedCarriers(trajectory, fragments.size())) {
        const std::size_t f = at(carrier.fragment);
        if (hits.strengthOf(at(carrier.body)) > strength[f]) {
            strength[f] = hits.strengthOf(at(carrier.body));
            times[f] = hits.timeOf(at(carrier.body));
        }
    }
    execution.report(stage, 1.0);
    return times;
}

std::vector<double> impactEnergies(const FragmentSet& fragments, const std::vector<FragmentOutcome>& outcomes) {
    assert(outcomes.size() == fragments.size());
    std::vector<double> energies;
    energies.reserve(fragments.size());
    for (std::size_t f = 0; f < fragments.size(); ++f) {
        energies.push_back(0.5 * fragments.list[f].mass * outcomes[f].impactSpeed * outcomes[f].impactSpeed);
    }
    return energies;
}

}  // namespace rubble
