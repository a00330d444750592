#include "core/evidence/surveys/edge_rings.h"

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

using PlanPoint = Eigen::Vector2d;

/// Twice the area of a triangle, above zero counter-clockwise, m2.
double turnOf(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
    const PlanPoint along = b - a;
    const PlanPoint across = c - a;
    return along.x() * across.y() - along.y() * across.x();
}

bool sidesCross(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, const PlanPoint& d) {
    return turnOf(a, b, c) * turnOf(a, b, d) < 0.0 && turnOf(c, d, a) * turnOf(c, d, b) < 0.0;
}

/// The line that goes on nearest to the end of another, turned to begin there; empty: none does.
OutlineRing takeNext(std::vector<OutlineRing>& lines, const PlanPoint& end, double reach) {
    auto nearest = lines.end();
    bool turned = false;
    double least = reach;
    for (auto line = lines.begin(); line != lines.end(); ++line) {
        if (line->size() > 2 && (line->back() - line->front()).norm() <= reach) {
            continue;  // it is a ring of its own
        }
        for (const bool back : {false, true}) {
            const double away = ((back ? line->back() : line->front()) - end).norm();
            if (away <= least && (nearest == lines.end() || away < least)) {
                nearest = line;
                turned = back;
                least = away;
            }
        }
    }
    if (nearest == lines.end()) {
        return {};
    }
    OutlineRing next = std::move(*nearest);
    lines.erase(nearest);
    if (turned) {
        std::reverse(next.begin(), next.end());
    }
    return next;
}

}  // namespace

EdgeRings joinedRings(std::vector<OutlineRing> lines, double reach) {
    EdgeRings made;
    for (OutlineRing& line : lines) {
        line.erase(std::unique(line.begin(), line.end()), line.end());
    }
    std::erase_if(lines, [](const OutlineRing& line) { return line.empty(); });
    while (!lines.empty()) {
        OutlineRing ring = std::move(lines.front());
        lines.erase(lines.begin());
        // A line that was drawn closed takes in no other.
        const auto isClosed = [&] { return ring.size() > 2 && (ring.back() - ring.front()).norm() <= reach; };
        for (const bool backwards : {false, true}) {
            if (backwards) {
                std::reverse(ring.begin(), ring.end());
            }
            while (!isClosed()) {
                const OutlineRing next = takeNext(lines, ring.back(), reach);
                if (next.empty()) {
                    break;
                }
                ring.insert(ring.end(), next.begin() + 1, next.end());
            }
        }
        std::reverse(ring.begin(), ring.end());
        const double gap = ring.size() > 1 ? (ring.back() - ring.front()).norm() : 0.0;
        if (isClosed()) {
            ring.pop_back();
        }
        if (ring.size() < 3) {
            ++made.leftOut;
            continue;
        }
        if (gap > reach) {
            ++made.closed;
            made.longest = std::max(made.longest, gap);
        }
        made.rings.push_back(std::move(ring));
    }
    return made;
}

bool crossesItself(const OutlineRing& ring) {
    const std::size_t sides = ring.size();
    for (std::size_t i = 0; i < sides; ++i) {
        for (std::size_t j = i + 2; j < sides; ++j) {
            const bool neighbours = i == 0 && j + 1 == sides;
            if (!neighbours && sidesCross(ring[i], ring[(i + 1) % sides], ring[j], ring[(j + 1) % sides])) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace rubble
