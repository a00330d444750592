#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/clusters/clustering.h"
#include "core/scenario/scenario.h"

namespace rubble {

/// How long a run still takes, from how far it has got and from the births to come: what moves costs time, and how much will move
/// at each instant of the collapse is known before. What has been said never grows; a run that comes to rest early ends before it.
class RunTimeLeft {
public:
    /// What is known of a collapse before it is simulated.
    struct Course {
        std::vector<double> births;  ///< s, hand-over of each body, in any order
        double first = 0.0;          ///< s, first step
        double end = 0.0;            ///< s, latest end
    };
    RunTimeLeft() = default;
    explicit RunTimeLeft(Course course);
    /// Of a run of these clusters. @param feEnd  s, last FE state
    static RunTimeLeft of(const Clustering& clustering, double feEnd, const Scenario& scenario);

    /// Body seconds of the whole run: what it costs is about proportional to them.
    double work() const { return m_allWork; }
    /// The run has come to an instant of the collapse [s] after so much wall time [s].
    void reached(double time, double wall);
    /// s of wall time; nothing while too little was simulated to say anything.
    std::optional<double> left() const { return m_left; }

private:
    /// Bodies that move, over the time from the first step up to an instant: body seconds.
    double workUntil(double time) const;

    Course m_course;
    double m_allWork = 0.0;
    std::vector<std::pair<double, double>> m_seen;  ///< work done and wall time [s], ascending
    std::optional<double> m_left;
};

}  // namespace rubble
