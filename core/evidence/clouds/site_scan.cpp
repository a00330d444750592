#include "core/evidence/clouds/site_scan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/sequence.h"
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

/// A ray with what it was sent for.
struct SentRay {
    Vec3 from = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();
    std::uint16_t scanner = 0;
};

/// Of a normal distribution with a deviation of 1 (Box & Muller 1958).
double normalNumber(Sequence& numbers) {
    const double u = 1.0 - numbers.between(0.0, 1.0);
    return std::sqrt(-2.0 * std::log(u)) * std::cos(numbers.between(0.0, 2.0 * std::numbers::pi));
}

/// Sends rays block by block; what each block met is put together in order.
/// @param seedFor  (block) gives the seed of a block; @param ray  (k, numbers) the ray with number k
template <class Seed, class Ray>
void send(const SurfaceTree& site, std::size_t rays, double range, double noise, SiteScan& scan, const Execution& execution,
          const Seed& seedFor, const Ray& ray) {
    struct Block {
        std::vector<Vec3> places;
        std::vector<std::uint32_t> triangles;
        std::vector<std::uint16_t> scanners;
    };
    const std::size_t blocksAtOnce = 256;
    WorkerPool pool(execution.threads());
    const std::size_t blocks = (rays + raysAtOnce - 1) / raysAtOnce;
    for (std::size_t begin = 0; begin < blocks; begin += blocksAtOnce) {
        std::vector<Block> made(std::min(blocksAtOnce, blocks - begin));
        pool.loop(made.size(), 1, [&](std::size_t from, std::size_t to) {
            for (std::size_t b = from; b < to && !execution.cancelled(); ++b) {
                Sequence numbers(seedFor(begin + b));
                const std::size_t first = (begin + b) * raysAtOnce;
                for (std::size_t k = first; k < std::min(first + raysAtOnce, rays); ++k) {
                    const SentRay sent = ray(k, numbers);
                    const double error = noise > 0.0 ? noise * normalNumber(numbers) : 0.0;
                    const std::optional<RayHit> hit = site.firstHit(sent.from, sent.direction, range);
                    if (hit) {
                        made[b].places.push_back(sent.from + (hit->range + error) * sent.direction);
                        made[b].triangles.push_back(hit->triangle);
                        made[b].scanners.push_back(sent.scanner);
                    }
                }
            }
        });
        for (const Block& block : made) {
            scan.places.insert(scan.places.end(), block.places.begin(), block.places.end());
            scan.triangles.insert(scan.triangles.end(), block.triangles.begin(), block.triangles.end());
            scan.scanners.insert(scan.scanners.end(), block.scanners.begin(), block.scanners.end());
        }
        execution.report({"scan.rays", "Sending rays", {}}, static_cast<double>(begin) / static_cast<double>(blocks));
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
        send(
            site, static_cast<std::size_t>(each), settings.range, settings.noise, scan, execution,
            [&](std::uint64_t block) { return seedOf(settings.seed, s, block); },
            [&](std::size_t /*k*/, Sequence& numbers) {
                return SentRay{settings.scanners[s], numbers.direction(), static_cast<std::uint16_t>(s)};
            });
        scan.rays.push_back(static_cast<std::uint64_t>(each));
        scan.echoes.push_back(scan.places.size() - before);
    }
    execution.check();
    return scan;
}

SiteScan seenAlike(const SurfaceTree& site, std::span<const Vec3> points, const PointSights& sights, double spread,
                   const Execution& execution) {
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
    const auto rayTo = [&](std::size_t k, Sequence& numbers) {
        const Vec3& point = points[k];
        SentRay ray;
        Vec3 axis = -Vec3::UnitZ();
        if (!sights.scanners.empty()) {
            const std::size_t which = k < sights.which.size() ? sights.which[k] : nearest(point);
            ray.scanner = static_cast<std::uint16_t>(std::min(which, sights.scanners.size() - 1));
            ray.from = sights.scanners[ray.scanner];
            axis = (point - ray.from).normalized();
        }
        const Vec3 one = axis.unitOrthogonal();
        const double angle = numbers.between(0.0, 2.0 * std::numbers::pi);
        const double off = spread * std::sqrt(numbers.between(0.0, 1.0));
        const Vec3 through = point + off * (std::cos(angle) * one + std::sin(angle) * axis.cross(one));
        if (sights.scanners.empty()) {
            ray.from = {through.x(), through.y(), std::max(top, through.z())};
            ray.direction = axis;
        } else {
            ray.direction = (through - ray.from).normalized();
        }
        return ray;
    };
    SiteScan scan;
    reserveLarge(scan.places, points.size());
    reserveLarge(scan.triangles, points.size());
    reserveLarge(scan.scanners, points.size());
    constexpr double everywhere = 1e9;  // m
    const auto seedFor = [](std::uint64_t block) { return seedOf(0, 0, block); };
    send(site, points.size(), everywhere, 0.0, scan, execution, seedFor, rayTo);
    execution.check();
    return scan;
}

}  // namespace rubble
