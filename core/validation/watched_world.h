#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/engine/world/forwarding_world.h"

namespace rubble {

/// Where a body was at an instant.
struct TracePoint {
    double time = 0.0;  ///< s
    Pose pose;
    double speed = 0.0;  ///< m/s
};

/// What a body did from its entry on.
struct BodyTrace {
    double from = 0.0;  ///< s
    Pose start;
    Pose latest;
    double path = 0.0;          ///< m, way of its centre
    std::int64_t contacts = 0;  ///< times that it came to touch something
    double topSpeed = 0.0;      ///< m/s
    double movedLast = 0.0;     ///< s, end of the last step in which it was awake
    bool touching = false;
    std::optional<Pose> asked;  ///< at the time that was asked for
    std::vector<TracePoint> points;
};

/// What is wanted of the way of each body.
struct TraceRequest {
    double samplesPerSecond = 0.0;  ///< 0: none
    /// s after its entry, at which the place of a body is wanted; not a number: none. By the order of entry; empty: of none.
    std::vector<double> asked;
};

/// A world as the run makes it, whose bodies are followed from step to step. It changes nothing: a run in it gives the same bits.
class WatchedWorld : public ForwardingWorld {
public:
    /// @param begin    s, at which the first step begins
    /// @param traces   [bodies that ever entered]; must outlive the world
    WatchedWorld(std::unique_ptr<RigidWorld> world, double begin, TraceRequest request, std::vector<BodyTrace>& traces);

    BodyId addBody(const NewBody& body) override;
    void step(double dt) override;

private:
    void follow(std::size_t i, double before);
    void sample(BodyTrace& trace, std::size_t i, double before, const Pose& now, double speed) const;

    double m_time;
    TraceRequest m_request;
    std::vector<BodyTrace>& m_traces;
};

}  // namespace rubble
