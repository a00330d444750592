#include "core/evidence/photographs/photo_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/base/error.h"
#include "core/engine/world/worker_pool.h"
#include "core/evidence/photographs/confidence.h"
#include "core/evidence/photographs/refusal.h"

namespace rubble {

namespace {

/// Normal numbers by Box and Muller: the library's own distribution is not the same everywhere.
class NormalNumbers {
public:
    explicit NormalNumbers(std::uint64_t seed) : m_engine(seed) {}
    double next() {
        const double u = (static_cast<double>(m_engine() >> 11) + 0.5) * 0x1p-53;
        const double v = static_cast<double>(m_engine() >> 11) * 0x1p-53;
        return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * v);
    }

private:
    std::mt19937_64 m_engine;
};

/// What one camera makes of it.
struct Draw {
    double iou = 0.0;
    double edge = 0.0;      // px of the photograph
    double distance = 0.0;  // m
    double edgeMetres = 0.0;
};

/// Mean depth of the debris that is seen and counts, m.
double depthOf(const SitePicture& picture, const SilhouettePair& pair) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < pair.simulated.size(); ++i) {
        if (pair.simulated[i] != 0 && pair.left[i] == 0) {
            sum += picture.depths[i];
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

class Comparing {
public:
    Comparing(const SiteShape& site, const Photograph& photograph, const ComparisonSettings& settings)
        : m_site(site), m_photograph(photograph), m_settings(settings) {}

    Draw with(const CameraModel& camera, PhotoComparison* tell = nullptr) const {
        const PhotoFacts& facts = m_photograph.facts;
        const SitePicture picture = pictureOf(m_site, camera, facts.width, facts.height, m_settings.longestSide);
        SilhouettePair pair = observedOn(picture, m_photograph.masks);
        pair.simulated = debrisIn(picture, m_settings.withFallen);
        const SilhouetteScore score = scoreOf(pair);
        Draw draw{score.iou, score.edgeDistance / picture.scale, depthOf(picture, pair), 0.0};
        draw.edgeMetres = draw.edge * draw.distance / camera.focal;
        if (tell != nullptr) {
            tell->score = score;
            tell->scale = picture.scale;
            tell->distance = draw.distance;
            tell->pixelMetres = draw.distance / camera.focal;
            tell->outlines = outlinesOf(picture, pair.simulated);
        }
        return draw;
    }

private:
    const SiteShape& m_site;
    const Photograph& m_photograph;
    const ComparisonSettings& m_settings;
};

SpreadNumber spreadOf(double best, const std::vector<Draw>& draws, double Draw::* of) {
    SpreadNumber number{best, best, 0.0};
    double sum = 0.0;
    double squares = 0.0;
    double count = 0.0;
    for (const Draw& draw : draws) {
        if (std::isfinite(draw.*of)) {
            sum += draw.*of;
            count += 1.0;
        }
    }
    if (count < 2.0) {
        return number;
    }
    number.mean = sum / count;
    for (const Draw& draw : draws) {
        if (std::isfinite(draw.*of)) {
            squares += (draw.*of - number.mean) * (draw.*of - number.mean);
        }
    }
    number.spread = std::sqrt(squares / (count - 1.0));
    return number;
}

void checkDrawn(const Photograph& photograph) {
    const bool drawn = std::any_of(photograph.masks.begin(), photograph.masks.end(),
                                   [](const PhotoMask& mask) { return mask.kind == MaskClass::Debris; });
    if (!drawn) {
        refuse({"photo.no_outline", "No outline of the debris is drawn on the photograph.", {}},
               "Draw around the debris that the photograph shows.");
    }
}

}  // namespace

std::vector<CameraModel> drawnCameras(const CameraMatch& match, int count, std::uint64_t seed) {
    // Numbers of different units are brought to one scale before the root is taken.
    const Eigen::VectorXd deviation = match.covariance.diagonal().cwiseSqrt().cwiseMax(std::numeric_limits<double>::min());
    const Eigen::MatrixXd correlation =
        deviation.cwiseInverse().asDiagonal() * match.covariance * deviation.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(correlation);
    const Eigen::MatrixXd root =
        deviation.asDiagonal() * axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
    NormalNumbers normal(seed);
    std::vector<CameraModel> cameras;
    for (int k = 0; k < count; ++k) {
        Eigen::VectorXd z(match.covariance.rows());
        for (double& number : z) {
            number = normal.next();
        }
        double chi = 0.0;
        for (int d = 0; d < match.freedom; ++d) {
            const double number = normal.next();
            chi += number * number;
        }
        const Eigen::VectorXd off = root * z * (match.freedom > 0 ? std::sqrt(match.freedom / chi) : 1.0);
        CameraStep step = CameraStep::Zero();
        for (std::size_t i = 0; i < match.found.size(); ++i) {
            step[match.found[i]] = off[static_cast<Eigen::Index>(i)];
        }
        cameras.push_back(stepped(match.camera, step));
        cameras.back().focal = std::max(cameras.back().focal, 0.1 * match.camera.focal);
    }
    return cameras;
}

PhotoComparison compareWithPhoto(const SiteShape& site, const Photograph& photograph, const CameraMatch& match,
                                 const ComparisonSettings& settings, const Execution& execution) {
    checkDrawn(photograph);
    const Comparing comparing(site, photograph, settings);
    PhotoComparison made;
    made.time = site.time;
    made.withFallen = settings.withFallen;
    const Draw best = comparing.with(match.camera, &made);
    if (made.score.simulated == 0 && made.score.observed == 0) {
        refuse({"photo.nothing_counts", "Neither drawn nor simulated debris lies in what counts of this photograph.", {}},
               "Draw less of it as hidden or moved, or check the outline.");
    }
    const std::vector<CameraModel> cameras = drawnCameras(match, settings.cameras, settings.seed);
    std::vector<Draw> draws(cameras.size());
    WorkerPool pool(execution.threads());
    pool.loop(cameras.size(), 1, [&](std::size_t k, std::size_t) {
        if (!execution.cancelled()) {
            draws[k] = comparing.with(cameras[k]);
        }
    });
    execution.check();
    made.cameras = static_cast<int>(cameras.size());
    made.iou = spreadOf(best.iou, draws, &Draw::iou);
    made.edgePixels = spreadOf(best.edge, draws, &Draw::edge);
    made.edgeMetres = spreadOf(best.edgeMetres, draws, &Draw::edgeMetres);
    const auto [iou, iouSpread] = roundedToSpread(made.iou.best, made.iou.spread);
    if (std::isfinite(made.edgeMetres.best)) {
        const auto [edge, edgeSpread] = roundedToSpread(made.edgeMetres.best, made.edgeMetres.spread);
        made.words = {"photo.agreement",
                      "The silhouettes overlap by {0} ± {1}; their edges are {2} ± {3} apart in the mean, {4} from the camera.",
                      {{iou}, {iouSpread}, {edge, "m"}, {edgeSpread, "m"}, {made.distance, "m"}}};
    } else {
        made.words = {
            "photo.no_edges", "The silhouettes overlap by {0} ± {1}; there are no two edges to compare.", {{iou}, {iouSpread}}};
    }
    return made;
}

PhotoComparison compareRunWithPhoto(const MappedRun& run, const Photograph& photograph, const CameraMatch& match,
                                    const ComparisonSettings& settings, const Execution& execution) {
    checkDrawn(photograph);
    const SiteShape site = siteOfRun(run, photograph.time, settings.liveThreshold, match.camera.place, execution);
    PhotoComparison made = compareWithPhoto(site, photograph, match, settings, execution);
    if (photograph.time && photograph.timeUncertainty > 0.0) {
        const MapSpan span = mapSpan(run);
        std::array<double, 2> range{made.iou.best, made.iou.best};
        for (const double sign : {-1.0, 1.0}) {
            const double when = std::clamp(*photograph.time + sign * photograph.timeUncertainty, span.first, span.last);
            const SiteShape then = siteOfRun(run, when, settings.liveThreshold, match.camera.place, execution);
            const double iou = Comparing(then, photograph, settings).with(match.camera).iou;
            range = {std::fmin(range[0], iou), std::fmax(range[1], iou)};
        }
        made.iouOverTime = range;
    }
    return made;
}

}  // namespace rubble
