#pragma once

#include <limits>

#include "core/simulation/run/simulation.h"

namespace rubble {

/// One fragment that one body carries along a path of places.
struct CarriedFragment {
    FragmentSet fragments;
    MemoryTrajectory trajectory;

    /// @param path      m, by time
    /// @param interval  s, between frames
    /// @param leaves    s, from when the body is no more
    template <class Path>
    CarriedFragment(double end, double interval, Path path, double birth = 0.0,
                    double leaves = std::numeric_limits<double>::infinity()) {
        Fragment fragment;
        fragment.mass = 10.0;
        fragment.centre = path(0.0);
        fragment.birthTime = birth;
        fragment.endTime = std::numeric_limits<double>::infinity();
        fragments.list.push_back(fragment);
        trajectory.begin({});
        BodyRecord body;
        body.atBirth.position = fragment.centre;
        const Carrier carrier{
            FragmentId{0}, BodyId{0}, 0.0, std::numeric_limits<double>::infinity(), {-fragment.centre, Quat::Identity()}};
        trajectory.addBodies(std::span(&body, 1), std::span(&carrier, 1));
        for (int k = 0; k * interval <= end + 1e-9; ++k) {
            TrajectoryFrame frame;
            frame.time = k * interval;
            frame.positions = {path(frame.time).template cast<float>()};
            frame.orientations = {Eigen::Quaternionf::Identity()};
            frame.speeds = {0.0f};
            frame.states = {frame.time < leaves ? BodyState::Awake : BodyState::Removed};
            trajectory.commit(frame);
        }
        trajectory.finish({});
    }
};

}  // namespace rubble
