#include "core/evidence/clouds/site_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/sequence.h"
#include "core/base/unknown.h"
#include "core/engine/world/worker_pool.h"

namespace rubble {

namespace {

/// Rays that share a sequence of random numbers. A different number gives another scan for the same seed.
constexpr std::size_t raysAtOnce = 4096;

/// The seed of a sequence that shares no part with those of other blocks, scanners and scans.
std::uint64_t seedOf(std::uint64_t scan, std::uint64_t scanner, std::uint64_t block) {
    std::uint64_t mixed = 0;
    for (const std::uint64_t part : {scan, scanner, block}) {
        mixed = (mixed ^ part) * 0xff51afd7ed558ccdu;
        mixed = (mixed ^ (mixed >> 33)) * 0xc4ceb9fe1a85ec53u;
        mixed ^= mixed >> 29;
    }
    return mixed;
}

/// Of a normal distribution with a deviation of 1 (Box & Muller 1958).
double normalNumber(Sequence& numbers) {
    const double u = 1.0 - numbers.between(0.0, 1.0);
    return std::sqrt(-2.0 * std::log(u)) * std::cos(numbers.between(0.0, 2.0 * std::numbers::pi));
}

void reportRays(const Execution& execution, std::size_t sent, std::size_t all) {
    execution.report({"scan.rays", "Sending rays", {}}, static_cast<double>(sent) / static_cast<double>(all));
}

/// Sends the rays of a scanner block by block; what each block met is put together in order.
void send(const SurfaceTree& site, const ScanSettings& settings, std::size_t scanner, std::size_t rays, SiteScan& scan,
          const Execution& execution) {
    struct Block {
        std::vector<Vec3> places;
        std::vector<std::uint32_t> triangles;
    };
    const std::size_t blocksAtOnce = 256;
    WorkerPool pool(execution.threads());
    const Vec3& from = settings.scanners[scanner];
    const std::size_t blocks = (rays + raysAtOnce - 1) / raysAtOnce;
    for (std::size_t begin = 0; begin < blocks; begin += blocksAtOnce) {
        std::vector<Block> made(std::min(blocksAtOnce, blocks - begin));
        pool.loop(made.size(), 1, [&](std::size_t low, std::size_t high) {
            for (std::size_t b = low; b < high && !execution.cancelled(); ++b) {
                Sequence numbers(seedOf(settings.seed, scanner, begin + b));
                const std::size_t first = (begin + b) * raysAtOnce;
                for (std::size_t k = first; k < std::min(first + raysAtOnce, rays); ++k) {
                    const Vec3 direction = numbers.direction();
                    const double error = settings.noise > 0.0 ? settings.noise * normalNumber(numbers) : 0.0;
                    if (const std::optional<RayHit> hit = site.firstHit(from, direction, settings.range)) {
                        made[b].places.push_back(from + (hit->range + error) * direction);
                        made[b].triangles.push_back(hit->triangle);
                    }
                }
            }
        });
        for (const Block& block : made) {
            scan.places.insert(scan.places.end(), block.places.begin(), block.places.end());
            scan.triangles.insert(scan.triangles.end(), block.triangles.begin(), block.triangles.end());
        }
        scan.scanners.resize(scan.places.size(), static_cast<std::uint16_t>(scanner));
        reportRays(execution, begin, blocks);
        if (scan.places.size() > scanPointsMost) {
            throw UsageError({"scan.points", "The scan has more than {0} points", {scanPointsMost}},
                             {"scan.points.remedy", "Give a greater step, a shorter range or fewer scanners.", {}});
        }
    }
}

void checkScan(const ScanSettings& settings) {
    const auto size = [](double value) { return std::isfinite(value) && value > 0.0; };
    const bool places =
        std::all_of(settings.scanners.begin(), settings.scanners.end(), [](const Vec3& at) { return at.allFinite(); });
    if (settings.scanners.empty() || !places || settings.scanners.size() > std::numeric_limits<std::uint16_t>::max()) {
        throw UsageError({"scan.scanners", "A scan takes 1 to {0} scanners at places that are numbers", {65535}},
                         {"scan.scanners.remedy", "Give places with easting, northing and height.", {}});
    }
    if (!size(settings.step) || !size(settings.range) || !(settings.noise >= 0.0) || !std::isfinite(settings.noise)) {
        throw UsageError({"scan.settings", "Step and range of a scan must be above zero, its noise not below", {}},
                         {"scan.settings.remedy", "Correct them.", {}});
    }
}

}  // namespace

SiteScan scanSite(const SurfaceTree& site, const ScanSettings& settings, const Execution& execution) {
    checkScan(settings);
    const double each = std::ceil(4.0 * std::numbers::pi / (settings.step * settings.step));
    if (each * static_cast<double>(settings.scanners.size()) > scanRaysMost) {
        throw UsageError({"scan.too_many_rays",
                          "The scan would take {0} rays; at most {1} are sent",
                          {each * static_cast<double>(settings.scanners.size()), scanRaysMost}},
                         {"scan.too_many_rays.remedy", "Give a greater step, or fewer scanners.", {}});
    }
    SiteScan scan;
    for (std::size_t s = 0; s < settings.scanners.size(); ++s) {
        const std::size_t before = scan.places.size();
        send(site, settings, s, static_cast<std::size_t>(each), scan, execution);
        scan.rays.push_back(static_cast<std::uint64_t>(each));
        scan.echoes.push_back(scan.places.size() - before);
    }
    execution.check();
    return scan;
}

MetAlike seenAlike(const SurfaceTree& site, std::span<const Vec3> points, const PointSights& sights, const Execution& execution) {
    const auto nearest = [&](const Vec3& point) {
        std::size_t best = 0;
        for (std::size_t s = 1; s < sights.scanners.size(); ++s) {
            if ((sights.scanners[s] - point).squaredNorm() < (sights.scanners[best] - point).squaredNorm()) {
                best = s;
            }
        }
        return best;
    };
    const double top = site.box().isEmpty() ? 0.0 : site.box().max().z() + 1.0;
    const auto meet = [&](std::size_t k, MetAlike& met) {
        const Vec3& point = points[k];
        Vec3 from(point.x(), point.y(), std::max(top, point.z()));
        Vec3 direction = -Vec3::UnitZ();
        if (!sights.scanners.empty()) {
            const std::size_t which = k < sights.which.size() ? sights.which[k] : nearest(point);
            from = sights.scanners[std::min(which, sights.scanners.size() - 1)];
            direction = (point - from).normalized();
        }
        constexpr double everywhere = 1e9;  // m
        if (const std::optional<RayHit> hit = site.firstHit(from, direction, everywhere)) {
            met.places[k] = from + hit->range * direction;
            met.triangles[k] = hit->triangle;
        }
    };
    MetAlike met;
    reserveLarge(met.places, points.size());
    reserveLarge(met.triangles, points.size());
    met.places.resize(points.size(), Vec3::Constant(unknown));
    met.triangles.resize(points.size(), noTriangle);
    WorkerPool pool(execution.threads());
    constexpr std::size_t atOnce = 256 * raysAtOnce;
    for (std::size_t begin = 0; begin < points.size(); begin += atOnce) {
        reportRays(execution, begin, points.size());
        pool.loop(std::min(atOnce, points.size() - begin), raysAtOnce, [&](std::size_t from, std::size_t to) {
            for (std::size_t k = begin + from; k < begin + to && !execution.cancelled(); ++k) {
                meet(k, met);
            }
        });
    }
    execution.check();
    return met;
}

}  // namespace rubble
