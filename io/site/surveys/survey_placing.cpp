#include "io/site/surveys/survey_placing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "io/base/file_words.h"

namespace rubble::io {

namespace {

/// rad: a tilt below it moves no node of a site by a millimetre.
constexpr double tiltLeast = 1e-6;

/// How heights of one level are moved in plan.
struct PlanMove {
    Eigen::Matrix2d turn;
    Eigen::Vector2d shift;

    /// @param level  m, local
    PlanMove(const Registration& registration, double level) {
        const Vec3 zero = registration(Vec3(0.0, 0.0, level));
        shift = zero.head<2>();
        turn.col(0) = (registration(Vec3(1.0, 0.0, level)) - zero).head<2>();
        turn.col(1) = (registration(Vec3(0.0, 1.0, level)) - zero).head<2>();
    }
    Eigen::Vector2d operator()(const Eigen::Vector2d& place) const { return turn * place + shift; }
    Eigen::Vector2d back(const Eigen::Vector2d& place) const { return turn.inverse() * (place - shift); }
};

struct HeightSpread {
    double mean = 0.0;
    double most = 0.0;  ///< m, farthest from the mean
};

HeightSpread spreadOf(const SurveyHeights& heights) {
    HeightSpread spread;
    double count = 0.0;
    for (const double height : heights.heights) {
        if (std::isfinite(height)) {
            spread.mean += height;
            count += 1.0;
        }
    }
    spread.mean /= std::max(1.0, count);
    for (const double height : heights.heights) {
        if (std::isfinite(height)) {
            spread.most = std::max(spread.most, std::abs(height - spread.mean));
        }
    }
    return spread;
}

/// Column and row of a place, also beyond the lattice, as its outermost cells go on.
Eigen::Vector2d pixelBeyond(const RasterLattice& lattice, const Eigen::Vector2d& place) {
    const auto [low, high] = lattice.bounds();
    const Eigen::Vector2d inside = place.cwiseMax(low).cwiseMin(high);
    const Eigen::Vector2d rim = lattice.pixelAt(inside.x(), inside.y());
    Eigen::Vector2d pixel = rim;
    for (int axis = 0; axis < 2; ++axis) {
        const double beyond = place[axis] - inside[axis];
        if (beyond != 0.0) {
            Eigen::Vector2d inner = inside;
            inner[axis] -= std::copysign(std::min(lattice.step, high[axis] - low[axis]), beyond);
            const Eigen::Vector2d change = rim - lattice.pixelAt(inner.x(), inner.y());
            pixel += change * (beyond / (inside[axis] - inner[axis]));
        }
    }
    return pixel;
}

Eigen::Vector2d pixelOf(const SurveyHeights& heights, const Eigen::Vector2d& place) {
    if (heights.lattice) {
        return pixelBeyond(*heights.lattice, place);
    }
    return {(place.x() - heights.x0) / heights.dx, (place.y() - heights.y0) / heights.dy};
}

/// The lattice that the columns and rows lie on once moved.
RasterLattice movedLattice(const SurveyHeights& heights, const PlanMove& move) {
    const auto [low, high] = heights.bounds();
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : {low, high, Eigen::Vector2d(low.x(), high.y()), Eigen::Vector2d(high.x(), low.y())}) {
        box.extend(move(corner));
    }
    RasterLattice moved;
    moved.pixel = heights.lattice ? heights.lattice->pixel : std::min(heights.dx, heights.dy);
    // Without a lattice of its own the raster is moved as a whole, which four nodes tell exactly.
    moved.step = heights.lattice ? heights.lattice->step : std::max(box.sizes().maxCoeff(), moved.pixel);
    moved.x0 = box.min().x();
    moved.y0 = box.min().y();
    moved.nx = static_cast<std::size_t>(std::ceil(box.sizes().x() / moved.step)) + 1;
    moved.ny = static_cast<std::size_t>(std::ceil(box.sizes().y() / moved.step)) + 1;
    moved.nx = std::max<std::size_t>(moved.nx, 2);
    moved.ny = std::max<std::size_t>(moved.ny, 2);
    for (std::size_t j = 0; j < moved.ny; ++j) {
        for (std::size_t i = 0; i < moved.nx; ++i) {
            const Eigen::Vector2d node(moved.x0 + static_cast<double>(i) * moved.step,
                                       moved.y0 + static_cast<double>(j) * moved.step);
            moved.pixels.push_back(pixelOf(heights, move.back(node)));
        }
    }
    return moved;
}

void liftHeights(SurveyHeights& heights, const Registration& registration) {
    for (std::size_t row = 0; row < heights.ny; ++row) {
        for (std::size_t column = 0; column < heights.nx; ++column) {
            double& height = heights.heights[row * heights.nx + column];
            if (std::isfinite(height)) {
                const Eigen::Vector2d at = heights.placeOf(static_cast<double>(column), static_cast<double>(row));
                height = registration(Vec3(at.x(), at.y(), height)).z();
            }
        }
    }
}

void placeHeights(SurveyInput& input, const Registration& registration) {
    SurveyHeights& heights = input.survey.heights;
    const HeightSpread spread = spreadOf(heights);
    const Mat3 turn = registration.rotation();
    const double tilt = turn.row(2).head<2>().norm();
    const PlanMove move(registration, spread.mean);
    const bool turned = registration.turn.norm() > 0.0;
    std::optional<RasterLattice> lattice;
    if (turned || heights.lattice) {
        lattice = movedLattice(heights, move);
    }
    if (tilt > tiltLeast) {
        liftHeights(heights, registration);
    } else {
        const double lift = registration(Vec3(registration.about.x(), registration.about.y(), spread.mean)).z() - spread.mean;
        for (double& height : heights.heights) {
            height += lift;
        }
    }
    if (lattice) {
        heights.lattice = std::move(lattice);
        heights.x0 = heights.y0 = 0.0;
        heights.dx = heights.dy = 1.0;
    } else {
        heights.x0 += registration.shift.x();
        heights.y0 += registration.shift.y();
    }
    const double besides = tilt * spread.most;
    if (besides > 0.25 * heights.spacing()) {
        addFinding(input.findings, input.path,
                   {"survey.tilted",
                    "the registration tilts the survey by {0} degrees: its highest and lowest places lie up to {1} from where they "
                    "should in plan",
                    {tilt * 180.0 / std::numbers::pi, {besides, "m"}}},
                   "register the points of the cloud before a raster is made of them");
    }
}

}  // namespace

void addPlacedFinding(Findings& findings, const std::string& path, const Registration& registration) {
    const Vec3 moved = registration.shift;
    const double degrees = registration.turn.norm() * 180.0 / std::numbers::pi;
    const bool fitted = registration.fitted > 0;
    const Argument left(fitted ? registration.fitLeft : registration.pairsLeft, "m");
    if (!fitted && registration.pairs == 0) {
        const std::vector<Argument> move{{moved.norm(), "m"}, degrees, {registration.error.value_or(0.0), "m"}};
        addFinding(
            findings, path,
            registration.error
                ? Message{"survey.placed_stated",
                          "the registration of the case moves it by {0} and turns it by {1} degrees, and does not say by what "
                          "it was found; a place is known to {2}",
                          move}
                : Message{"survey.placed_stated",
                          "the registration of the case moves it by {0} and turns it by {1} degrees, and says neither by what "
                          "it was found nor how well a place is known",
                          move},
            "register it by pairs or by a fit, so that what is left of it is known");
    } else if (registration.error) {
        addFinding(
            findings, path,
            {"survey.placed",
             "the registration of the case moves it by {0} and turns it by {1} degrees; {2} are left, and a place is known to {3}",
             {{moved.norm(), "m"}, degrees, left, {*registration.error, "m"}}},
            "none is needed");
    } else {
        addFinding(
            findings, path,
            {"survey.placed_unknown",
             "the registration of the case moves it by {0} and turns it by {1} degrees; {2} are left, and how well a place is "
             "known is not known",
             {{moved.norm(), "m"}, degrees, left}},
            "give more pairs, or state the error of the registration");
    }
}

void placeSurvey(SurveyInput& input, const Registration& registration) {
    Survey& survey = input.survey;
    if (survey.isFootprint) {
        const PlanMove move(registration, registration.about.z());
        for (OutlinePolygon& polygon : survey.footprint.polygons) {
            for (OutlineRing& ring : polygon) {
                std::transform(ring.begin(), ring.end(), ring.begin(), move);
            }
        }
    } else if (survey.heights.aboveGround) {
        throw UsageError({"survey.placed_map", "{0} holds heights above the ground, which no registration moves", {input.path}},
                         {"survey.placed_map.remedy", "Take the registration of this survey out of the case.", {}});
    } else {
        placeHeights(input, registration);
    }
    addPlacedFinding(input.findings, input.path, registration);
}

}  // namespace rubble::io
