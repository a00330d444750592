#include "core/validation/release.h"

#include <algorithm>
#include <numeric>

#include "core/base/sequence.h"

namespace rubble {

namespace {

void note(ReleaseCount& kind, std::size_t body, double measure) {
    if (kind.count++ == 0 || measure > kind.measure) {
        kind.worst = body;
        kind.measure = measure;
    }
}

double deepestCorner(const LooseBody& body, const SiteSurface& surface) {
    double deepest = -std::numeric_limits<double>::infinity();
    for (const Vec3& corner : cornersOf(body)) {
        deepest = std::max(deepest, surface.depth(corner));
    }
    return deepest;
}

}  // namespace

ReleaseCheck checkRelease(const std::vector<LooseBody>& bodies, const SiteSurface& surface) {
    ReleaseCheck check;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec3& place = bodies[i].pose.position;
        if (surface.terrain && surface.terrain->source(place.x(), place.y()) != TerrainGrid::Source::Raster) {
            note(check.outside, i, 0.0);
        } else if (surface.depth(place) > 0.0) {
            note(check.below, i, surface.depth(place));
        } else if (const double depth = deepestCorner(bodies[i], surface); depth > 0.0) {
            note(check.touching, i, depth);
        }
    }
    return check;
}

ReleaseCount crowded(const std::vector<LooseBody>& bodies, std::int64_t limit) {
    std::vector<Aabb> boxes(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (const Vec3& corner : cornersOf(bodies[i])) {
            boxes[i].extend(corner);
        }
    }
    std::vector<std::size_t> order(bodies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return boxes[a].min().x() < boxes[b].min().x(); });
    ReleaseCount found;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Aabb& box = boxes[order[i]];
        std::int64_t others = 0;
        for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].min().x() < box.max().x() && others <= limit; ++j) {
            others += bodies[order[i]].time == bodies[order[j]].time && box.intersection(boxes[order[j]]).volume() > 0.0;
        }
        if (others > limit) {
            note(found, order[i], static_cast<double>(others));
        }
    }
    return found;
}

ReleaseCount liftOut(std::vector<LooseBody>& bodies, const SiteSurface& surface) {
    ReleaseCount lifted;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (const double depth = deepestCorner(bodies[i], surface); depth > 0.0) {
            bodies[i].pose.position.z() += depth;
            note(lifted, i, depth);
        }
    }
    return lifted;
}

void turnAtRandom(std::vector<LooseBody>& bodies, std::int64_t seed, std::int64_t repeat) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Hasher hasher;
        const Digest digest = hasher.value(seed).value(repeat).value(static_cast<std::uint64_t>(i)).finish();
        std::uint64_t stream = 0;
        for (std::size_t b = 0; b < sizeof stream; ++b) {
            stream = (stream << 8) | digest.bytes[b];
        }
        bodies[i].pose.orientation = Sequence(stream).turn();
    }
}

}  // namespace rubble
