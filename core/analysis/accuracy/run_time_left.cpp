#include "core/analysis/accuracy/run_time_left.h"

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr double knownFrom = 0.02;     // of the work: before, nothing is said
constexpr double wallFrom = 1.0;       // s, likewise
constexpr double recentShare = 0.2;    // of the work done: what it cost lately counts
constexpr double bodiesForAStep = 20;  // what a step costs without any body, in bodies
// As recorded on the sample cases: a body costs most while it falls and comes to rest, about half of that afterwards.
constexpr double movesFor = 4.0;   // s
constexpr double restCosts = 0.5;  // of a body that moves

}  // namespace

RunTimeLeft::RunTimeLeft(Course course) : m_course(std::move(course)) {
    std::sort(m_course.births.begin(), m_course.births.end());
    m_allWork = workUntil(m_course.end);
}

RunTimeLeft RunTimeLeft::of(const Clustering& clustering, double feEnd, const Scenario& scenario) {
    Course course;
    course.first = feEnd;
    for (const Cluster& cluster : clustering.list) {
        course.births.push_back(cluster.handOverTime);
        course.first = std::min(course.first, cluster.handOverTime);
    }
    course.end = feEnd + scenario.simulation.settleTime;
    return RunTimeLeft(std::move(course));
}

double RunTimeLeft::workUntil(double time) const {
    double work = bodiesForAStep * std::max(0.0, std::min(time, m_course.end) - m_course.first);
    for (const double birth : m_course.births) {
        if (birth >= time) {
            break;
        }
        const double age = std::min(time, m_course.end) - birth;
        work += std::min(age, movesFor) + restCosts * std::max(0.0, age - movesFor);
    }
    return work;
}

void RunTimeLeft::reached(double time, double wall) {
    const double done = workUntil(time);
    if (!(done > 0.0) || !(m_allWork > 0.0)) {
        return;
    }
    if (!m_seen.empty() && (done <= m_seen.back().first || wall <= m_seen.back().second)) {
        return;
    }
    m_seen.emplace_back(done, wall);
    if (done < knownFrom * m_allWork || wall < wallFrom) {
        return;
    }
    const auto recent = std::lower_bound(m_seen.begin(), m_seen.end(), (1.0 - recentShare) * done,
                                         [](const auto& seen, double work) { return seen.first < work; });
    const std::pair<double, double> from = recent == m_seen.begin() ? std::pair(0.0, 0.0) : *std::prev(recent);
    const double cost = (wall - from.second) / (done - from.first);
    const double left = cost * std::max(0.0, m_allWork - done);
    m_left = m_left ? std::min(*m_left, left) : left;
}

}  // namespace rubble
