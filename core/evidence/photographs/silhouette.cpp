#include "core/evidence/photographs/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/evidence/maps/footprint.h"
#include "core/evidence/maps/mark_distances.h"

namespace rubble {

namespace {

/// Pixels of a silhouette with a neighbour that counts and is outside of it.
std::vector<std::uint8_t> edgeOf(const std::vector<std::uint8_t>& silhouette, const SilhouettePair& pair) {
    std::vector<std::uint8_t> edge(silhouette.size(), 0);
    const auto w = static_cast<std::ptrdiff_t>(pair.width);
    for (int y = 0; y < pair.height; ++y) {
        for (int x = 0; x < pair.width; ++x) {
            const std::ptrdiff_t i = y * w + x;
            const auto open = [&](bool inside, std::ptrdiff_t j) {
                return inside && pair.left[static_cast<std::size_t>(j)] == 0 && silhouette[static_cast<std::size_t>(j)] == 0;
            };
            const auto at = static_cast<std::size_t>(i);
            edge[at] =
                silhouette[at] != 0 && pair.left[at] == 0 &&
                (open(x > 0, i - 1) || open(x + 1 < pair.width, i + 1) || open(y > 0, i - w) || open(y + 1 < pair.height, i + w));
        }
    }
    return edge;
}

/// Mean distance of marked pixels in a map of distances; NaN without any.
double meanOver(const std::vector<std::uint8_t>& marked, const std::vector<double>& distances) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (marked[i] != 0) {
            sum += distances[i];
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// Marks the pixels whose middles lie in a polygon (even-odd), row by row.
void mark(std::vector<std::uint8_t>& pixels, const SitePicture& grid, const std::vector<Eigen::Vector2d>& corners,
          std::uint8_t as) {
    std::vector<double> crossings;
    for (int y = 0; y < grid.height; ++y) {
        const double level = (y + 0.5) / grid.scale;
        crossings.clear();
        addCrossings(corners, level, crossings);
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
            const double from = std::ceil(crossings[k] * grid.scale - 0.5);
            const double to = std::ceil(crossings[k + 1] * grid.scale - 0.5);
            const int first = static_cast<int>(std::clamp(from, 0.0, static_cast<double>(grid.width)));
            const int end = static_cast<int>(std::clamp(to, 0.0, static_cast<double>(grid.width)));
            for (int x = first; x < end; ++x) {
                pixels[grid.index(x, y)] = as;
            }
        }
    }
}

}  // namespace

SilhouetteScore scoreOf(const SilhouettePair& pair) {
    SilhouetteScore score;
    std::int64_t either = 0;
    for (std::size_t i = 0; i < pair.simulated.size(); ++i) {
        if (pair.left[i] == 0) {
            score.simulated += pair.simulated[i];
            score.observed += pair.observed[i];
            score.both += pair.simulated[i] & pair.observed[i];
            either += pair.simulated[i] | pair.observed[i];
        }
    }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    score.iou = either > 0 ? static_cast<double>(score.both) / static_cast<double>(either) : none;
    const std::vector<std::uint8_t> simulated = edgeOf(pair.simulated, pair);
    const std::vector<std::uint8_t> observed = edgeOf(pair.observed, pair);
    const auto any = [](const std::vector<std::uint8_t>& edge) {
        return std::find(edge.begin(), edge.end(), std::uint8_t{1}) != edge.end();
    };
    score.edgeDistance = none;
    if (any(simulated) && any(observed)) {
        score.edgeDistance = 0.5 * (meanOver(simulated, distancesTo(observed, pair.width, pair.height)) +
                                    meanOver(observed, distancesTo(simulated, pair.width, pair.height)));
    }
    return score;
}

SilhouettePair observedOn(const SitePicture& grid, const std::vector<PhotoMask>& masks) {
    const std::size_t pixels = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    SilhouettePair pair{grid.width, grid.height, {}, std::vector<std::uint8_t>(pixels, 0), std::vector<std::uint8_t>(pixels, 0)};
    for (const PhotoMask& mask : masks) {
        if (mask.kind == MaskClass::Debris) {
            mark(pair.observed, grid, mask.corners, 1);
        } else if (mask.kind != MaskClass::NotDebris) {
            mark(pair.left, grid, mask.corners, 1);
        }
    }
    for (const PhotoMask& mask : masks) {
        if (mask.kind == MaskClass::NotDebris) {
            mark(pair.observed, grid, mask.corners, 0);
        }
    }
    return pair;
}

std::vector<std::uint8_t> debrisIn(const SitePicture& picture, bool withFallen) {
    std::vector<std::uint8_t> debris(picture.things.size());
    std::transform(picture.things.begin(), picture.things.end(), debris.begin(), [&](SiteThing thing) {
        return static_cast<std::uint8_t>(thing == SiteThing::Debris || (withFallen && thing == SiteThing::FallenStructure));
    });
    return debris;
}

std::vector<std::vector<Eigen::Vector2d>> outlinesOf(const SitePicture& grid, const std::vector<std::uint8_t>& silhouette) {
    std::vector<MapCell> cells;
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            if (silhouette[grid.index(x, y)] != 0) {
                cells.push_back({y, x});
            }
        }
    }
    std::vector<std::vector<Eigen::Vector2d>> rings;
    const auto add = [&](const FootprintRing& ring) {
        std::vector<Eigen::Vector2d>& corners = rings.emplace_back();
        for (const MapCell& corner : ring) {
            corners.emplace_back(corner.i / grid.scale, corner.j / grid.scale);
        }
    };
    for (const FootprintPolygon& polygon : footprintOf(cells)) {
        add(polygon.outer);
        std::for_each(polygon.holes.begin(), polygon.holes.end(), add);
    }
    return rings;
}

}  // namespace rubble
