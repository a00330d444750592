#include "core/evidence/ensembles/telling_evidence.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "core/evidence/ensembles/evidence_noise.h"

namespace rubble {

namespace {

constexpr int partsAlong = 4;          // of the longer side of the site
constexpr int places = 8;              // around the debris
constexpr double placeDistance = 2.0;  // half diagonals of the debris
constexpr double eyeHeight = 1.7;      // m
constexpr double timeAccuracy = 0.5;   // s, of a time that a witness or a video gives
constexpr std::size_t columns = 256;   // of a silhouette
constexpr double halfAngle = 0.56;     // rad, that debris within one half diagonal can take from two of them, and a little

/// What happened in one member, of one cause.
struct Trial {
    std::size_t cause = 0;  ///< place among those that are to be told apart
    const MemberSurface* surface = nullptr;
    const DebrisArrivals* arrivals = nullptr;
};

/// Departures of each member from each other, as if one were the evidence.
class Apart {
public:
    /// @param departure  of one trial from another; symmetric
    template <class Departure>
    Apart(std::size_t count, Departure departure) : m_count(count), m_values(count * count, 0.0F) {
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double between = departure(i, j);
                // Where neither holds anything both look the same.
                m_values[i * count + j] = m_values[j * count + i] = static_cast<float>(std::isfinite(between) ? between : 0.0);
            }
        }
    }
    double of(std::size_t i, std::size_t j) const { return double{m_values[i * m_count + j]}; }

private:
    std::size_t m_count;
    std::vector<float> m_values;
};

Apart apartBy(const std::vector<Trial>& trials, const SurfaceEvidence& like, const Execution& execution) {
    std::size_t last = trials.size();
    SurfaceEvidence evidence;
    return {trials.size(), [&](std::size_t i, std::size_t j) {
                if (i != last) {
                    execution.check();
                    evidence = seenAs(*trials[i].surface, like);
                    last = i;
                }
                return departureFrom(evidence, *trials[j].surface);
            }};
}

/// @param place  gives when debris first reached it, s; NaN where none did
template <class Place>
Apart apartInTime(const std::vector<Trial>& trials, double accuracy, Place place) {
    std::vector<double> times;
    for (const Trial& trial : trials) {
        times.push_back(place(*trial.arrivals) - trial.arrivals->first());
    }
    return {trials.size(), [&](std::size_t i, std::size_t j) { return timesApart(times[i], times[j], accuracy); }};
}

/// The part of a surface that lies in a box.
MemberSurface within(const MemberSurface& surface, const Eigen::AlignedBox2d& part, double cell) {
    MemberSurface kept;
    for (std::size_t c = 0; c < surface.cells.size(); ++c) {
        const MapCell& at = surface.cells[c];
        if (part.contains(cell * Eigen::Vector2d(at.i + 0.5, at.j + 0.5))) {
            kept.cells.push_back(at);
            kept.heights.push_back(surface.heights[c]);
            kept.masses.push_back(surface.masses[c]);
            kept.covered.push_back(surface.covered[c]);
        }
    }
    return kept;
}

/// What debris covers of a picture, column by column, row by row.
class Silhouette {
public:
    void cover(std::size_t column, double low, double high) {
        const auto first = static_cast<int>(std::clamp(std::floor(low * rows), 0.0, rows - 1.0));
        const auto last = static_cast<int>(std::clamp(std::floor(high * rows), 0.0, rows - 1.0));
        for (int row = first; row <= last; ++row) {
            m_bits[2 * column + static_cast<std::size_t>(row / 64)] |= std::uint64_t{1} << (row % 64);
        }
    }
    /// 1 less the overlap; NaN where neither covers anything.
    double apartFrom(const Silhouette& other) const {
        int both = 0;
        int either = 0;
        for (std::size_t k = 0; k < m_bits.size(); ++k) {
            both += std::popcount(m_bits[k] & other.m_bits[k]);
            either += std::popcount(m_bits[k] | other.m_bits[k]);
        }
        return either > 0 ? 1.0 - static_cast<double>(both) / either : unknown;
    }

private:
    static constexpr double rows = 128.0;
    std::array<std::uint64_t, 2 * columns> m_bits{};
};

/// How debris is seen from a place: angles to the side, and tangents of the elevation.
class Look {
public:
    Look(const Eigen::Vector2d& from, const Eigen::Vector2d& middle, const SiteSurface& ground, double cell)
        : m_from(from),
          m_towards(std::atan2(middle.y() - from.y(), middle.x() - from.x())),
          m_eye(ground.height(from.x(), from.y()) + eyeHeight),
          m_ground(ground),
          m_cell(cell) {}

    /// The picture is as high as what is seen of all surfaces.
    void hold(const MemberSurface& surface) {
        visit(surface, [&](double, double, double low, double high) {
            m_low = std::min(m_low, low);
            m_high = std::max(m_high, high);
        });
    }
    Silhouette of(const MemberSurface& surface) const {
        Silhouette shape;
        const double height = std::max(m_high - m_low, 1e-6);
        const auto column = [](double angle) {
            return std::clamp((0.5 + 0.5 * angle / halfAngle) * static_cast<double>(columns), 0.0,
                              static_cast<double>(columns) - 1.0);
        };
        visit(surface, [&](double left, double right, double low, double high) {
            const auto last = static_cast<std::size_t>(column(right));
            for (auto k = static_cast<std::size_t>(column(left)); k <= last; ++k) {
                shape.cover(k, (low - m_low) / height, (high - m_low) / height);
            }
        });
        return shape;
    }

private:
    template <class Visit>
    void visit(const MemberSurface& surface, Visit seen) const {
        for (std::size_t c = 0; c < surface.cells.size(); ++c) {
            const Eigen::Vector2d at = m_cell * Eigen::Vector2d(surface.cells[c].i + 0.5, surface.cells[c].j + 0.5);
            const Eigen::Vector2d way = at - m_from;
            const double distance = std::max(way.norm(), m_cell);
            const double angle = std::remainder(std::atan2(way.y(), way.x()) - m_towards, 2.0 * std::numbers::pi);
            const double half = 0.5 * m_cell / distance;
            const double low = m_ground.height(at.x(), at.y()) - m_eye;
            seen(angle - half, angle + half, low / distance, (low + double{surface.heights[c]}) / distance);
        }
    }

    Eigen::Vector2d m_from;
    double m_towards;
    double m_eye;
    const SiteSurface& m_ground;
    double m_cell;
    double m_low = std::numeric_limits<double>::infinity();
    double m_high = -m_low;
};

Apart apartFrom(const std::vector<Trial>& trials, Look look, const Execution& execution) {
    for (const Trial& trial : trials) {
        look.hold(*trial.surface);
    }
    std::vector<Silhouette> shapes;
    for (const Trial& trial : trials) {
        execution.check();
        shapes.push_back(look.of(*trial.surface));
    }
    return {trials.size(), [&](std::size_t i, std::size_t j) { return shapes[i].apartFrom(shapes[j]); }};
}

BlindShare namedBy(const std::vector<Trial>& trials, std::size_t causes, std::span<const Apart* const> pieces) {
    BlindShare named;
    for (std::size_t t = 0; t < trials.size(); ++t) {
        std::vector<Departures> departures(causes, Departures(pieces.size()));
        for (std::size_t m = 0; m < trials.size(); ++m) {
            for (std::size_t e = 0; e < pieces.size(); ++e) {
                departures[trials[m].cause][e].push_back(m == t ? unknown : pieces[e]->of(t, m));
            }
        }
        const CauseRanking ranking = rankCauses(departures);
        const bool right = ranking.causes.front().hypothesis == trials[t].cause;
        named.right += ranking.decided() && right ? 1 : 0;
        named.wrong += ranking.decided() && !right ? 1 : 0;
        ++named.trials;
    }
    return named;
}

Eigen::AlignedBox2d boxOf(const std::vector<Trial>& trials, double cell) {
    Eigen::AlignedBox2d box;
    for (const Trial& trial : trials) {
        for (const MapCell& at : trial.surface->cells) {
            box.extend(cell * Eigen::Vector2d(at.i, at.j));
            box.extend(cell * Eigen::Vector2d(at.i + 1.0, at.j + 1.0));
        }
    }
    return box;
}

/// Squares that cover a box, on whole cells.
std::vector<Eigen::AlignedBox2d> partsOf(const Eigen::AlignedBox2d& box, double cell) {
    const double side = cell * std::ceil(box.sizes().maxCoeff() / partsAlong / cell);
    std::vector<Eigen::AlignedBox2d> parts;
    for (double y = box.min().y(); y < box.max().y(); y += side) {
        for (double x = box.min().x(); x < box.max().x(); x += side) {
            parts.emplace_back(Eigen::Vector2d(x, y), Eigen::Vector2d(x + side, y + side));
        }
    }
    return parts;
}

/// Ends of the interval after Wilson. @param sign  -1 the lower, 1 the upper
double wilson(std::int64_t hits, std::int64_t trials, double sign) {
    if (trials == 0) {
        return sign < 0.0 ? 0.0 : 1.0;
    }
    constexpr double z = 1.959964;
    const auto n = static_cast<double>(trials);
    const double share = static_cast<double>(hits) / n;
    const double root = std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
    return std::clamp((share + z * z / (2.0 * n) + sign * z * root) / (1.0 + z * z / n), 0.0, 1.0);
}

bool whollySeen(const CauseEvidence& evidence, EvidenceKind kind) {
    return std::any_of(evidence.surfaces.begin(), evidence.surfaces.end(),
                       [&](const SurfaceEvidence& each) { return each.kind == kind && each.everywhere && each.leftOut.empty(); });
}

}  // namespace

double BlindShare::low() const {
    return wilson(right, trials, -1.0);
}

double BlindShare::high() const {
    return wilson(right, trials, 1.0);
}

Message FurtherEvidence::words() const {
    const bool heights = kind == EvidenceKind::Heights;
    if (from) {
        return {"further.photograph",
                "photograph of the debris at rest from x = {0}, y = {1}, towards its middle",
                {{std::round(from->x()), "m"}, {std::round(from->y()), "m"}}};
    }
    if (kind == EvidenceKind::Time && part) {
        return {"further.time",
                "time at which debris first lay in the part x = {0} to {1}, y = {2} to {3} m, within {4}",
                {part->min().x(), part->max().x(), part->min().y(), part->max().y(), {accuracy, "s"}}};
    }
    if (!part) {
        return heights ? Message{"further.heights", "heights of all debris", {}}
                       : Message{"further.outline", "outline of all debris", {}};
    }
    const std::vector<Argument> where{part->min().x(), part->max().x(), part->min().y(), part->max().y()};
    return heights ? Message{"further.heights_part", "heights of the part x = {0} to {1}, y = {2} to {3} m", where}
                   : Message{"further.outline_part", "outline of the part x = {0} to {1}, y = {2} to {3} m", where};
}

std::vector<std::size_t> notToldApart(const CauseComparison& made) {
    std::vector<std::size_t> causes;
    const bool all = made.ranking.decided();
    for (std::size_t k = 0; k < made.ranking.causes.size(); ++k) {
        if (k == 0 || all || !made.ranking.causes[k].apart) {
            causes.push_back(made.ranking.causes[k].hypothesis);
        }
    }
    return causes;
}

TellingEvidence tellingEvidence(std::span<const Hypothesis> hypotheses, const CauseEvidence& atHand,
                                std::span<const std::size_t> causes, const SiteSurface& ground, const Execution& execution) {
    if (causes.size() < 2) {
        throw UsageError({"further.alone", "There are no two causes that further evidence could tell apart.", {}},
                         {"further.alone.remedy", "Give several cases or FE results, or a case with several scenarios.", {}});
    }
    const Message stage{"further.looking", "Trying which evidence would tell", {}};
    checkAlike(hypotheses);
    const double cell = hypotheses[causes.front()].ensemble->surface.cell;
    TellingEvidence telling;
    telling.causes.assign(causes.begin(), causes.end());
    std::vector<Trial> trials;
    for (std::size_t k = 0; k < causes.size(); ++k) {
        for (const EnsembleMember* member : hypotheses[causes[k]].ensemble->done()) {
            trials.push_back({k, member->surface.get(), &member->arrivals});
        }
    }
    if (trials.size() < 2) {
        return telling;  // nothing is left to compare one with
    }
    std::vector<Apart> known;
    Findings told;  // where the causes are compared
    for (const SurfaceEvidence& surface : withDetection(atHand, hypotheses, told).surfaces) {
        known.push_back(apartBy(trials, surface, execution));
    }
    for (const TimeEvidence& time : atHand.times) {
        known.push_back(apartInTime(trials, time.accuracy,
                                    [&](const DebrisArrivals& arrivals) { return arrivals.firstWithin(time.place, time.radius); }));
    }
    std::vector<const Apart*> pieces;
    for (const Apart& each : known) {
        pieces.push_back(&each);
    }
    if (!pieces.empty()) {
        telling.atHand = namedBy(trials, causes.size(), pieces);
    }
    const Eigen::AlignedBox2d box = boxOf(trials, cell);
    if (box.isEmpty()) {
        return telling;
    }
    const auto take = [&](FurtherEvidence evidence, const Apart& apart) {
        pieces.push_back(&apart);
        evidence.named = namedBy(trials, causes.size(), pieces);
        pieces.pop_back();
        telling.ranked.push_back(std::move(evidence));
    };
    constexpr std::array<EvidenceKind, 2> kinds{EvidenceKind::Footprint, EvidenceKind::Heights};
    for (const EvidenceKind kind : kinds) {
        if (!whollySeen(atHand, kind)) {
            SurfaceEvidence all;
            all.kind = kind;
            take({kind, {}, {}, 0.0, {}}, apartBy(trials, all, execution));
        }
    }
    for (int k = 0; k < places; ++k) {
        execution.report(stage, 0.2 + 0.3 * k / places);
        const double angle = 2.0 * std::numbers::pi * k / places;
        const Eigen::Vector2d from =
            box.center() + 0.5 * placeDistance * box.diagonal().norm() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        take({EvidenceKind::Photograph, {}, from, 0.0, {}}, apartFrom(trials, Look(from, box.center(), ground, cell), execution));
    }
    const std::vector<Eigen::AlignedBox2d> parts = partsOf(box, cell);
    for (std::size_t p = 0; p < parts.size(); ++p) {
        execution.report(stage, 0.5 + 0.5 * static_cast<double>(p) / static_cast<double>(parts.size()));
        std::vector<MemberSurface> cut;
        std::vector<Trial> inPart = trials;
        for (const Trial& trial : trials) {
            cut.push_back(within(*trial.surface, parts[p], cell));
        }
        for (std::size_t t = 0; t < trials.size(); ++t) {
            inPart[t].surface = &cut[t];
        }
        if (std::all_of(cut.begin(), cut.end(), [](const MemberSurface& each) { return each.cells.empty(); })) {
            continue;
        }
        for (const EvidenceKind kind : kinds) {
            if (!whollySeen(atHand, kind)) {
                SurfaceEvidence all;
                all.kind = kind;
                take({kind, parts[p], {}, 0.0, {}}, apartBy(inPart, all, execution));
            }
        }
        take({EvidenceKind::Time, parts[p], {}, timeAccuracy, {}},
             apartInTime(trials, timeAccuracy, [&](const DebrisArrivals& arrivals) { return arrivals.firstIn(parts[p]); }));
    }
    std::stable_sort(telling.ranked.begin(), telling.ranked.end(), [](const FurtherEvidence& a, const FurtherEvidence& b) {
        return a.named.right != b.named.right ? a.named.right > b.named.right : a.named.wrong < b.named.wrong;
    });
    return telling;
}

}  // namespace rubble
