#include "core/evidence/ensembles/cause_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/analysis/accuracy/interval_fit.h"
#include "core/base/csv_text.h"
#include "core/base/error.h"
#include "core/base/unknown.h"
#include "core/evidence/ensembles/evidence_noise.h"
#include "core/evidence/photographs/match_doubts.h"

namespace rubble {

namespace {

/// Cameras drawn from the uncertainty of a match for each member.
constexpr int camerasDrawn = 8;
constexpr int longestSide = 500;  // px, of the pictures that members are compared on

/// Members that are needed before it is said that a hypothesis does not fit.
constexpr std::size_t membersToJudge = 8;
/// Chance below which the evidence lies outside of what the members of a hypothesis do.
constexpr double leastFit = 0.01;
/// Share of what speaks for a hypothesis that the telling place holds.
constexpr double tellingMost = 0.5;

/// Calls visit(cell, i, j) for each cell of either surface with the places in their lists; -1 where one holds nothing.
template <class Visit>
void forCellsOfEither(const MemberSurface& a, const MemberSurface& b, Visit visit) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.cells.size() || j < b.cells.size()) {
        const bool inA = i < a.cells.size() && (j == b.cells.size() || a.cells[i] <= b.cells[j]);
        const bool inB = j < b.cells.size() && (i == a.cells.size() || b.cells[j] <= a.cells[i]);
        visit(inA ? a.cells[i] : b.cells[j], inA ? static_cast<std::ptrdiff_t>(i) : -1, inB ? static_cast<std::ptrdiff_t>(j) : -1);
        i += inA ? 1 : 0;
        j += inB ? 1 : 0;
    }
}

Departures departuresOf(const Hypothesis& hypothesis, const CauseEvidence& evidence) {
    Departures departures(evidence.count());
    for (const EnsembleMember* member : hypothesis.ensemble->done()) {
        for (std::size_t s = 0; s < evidence.surfaces.size(); ++s) {
            departures[s].push_back(departureFrom(evidence.surfaces[s], *member->surface));
        }
        for (std::size_t p = 0; p < evidence.photographs.size(); ++p) {
            departures[evidence.surfaces.size() + p].push_back(p < member->looked.size() ? member->looked[p] : unknown);
        }
        for (std::size_t t = 0; t < evidence.times.size(); ++t) {
            departures[evidence.surfaces.size() + evidence.photographs.size() + t].push_back(
                departureFrom(evidence.times[t], member->arrivals));
        }
    }
    return departures;
}

/// How far each member, taken as evidence that was looked at as this was and with its noise, departs from the others in the mean.
FigureSpread amongMembers(const Hypothesis& hypothesis, const SurfaceEvidence& evidence) {
    const std::vector<const EnsembleMember*> members = hypothesis.ensemble->done();
    std::vector<double> among;
    for (const EnsembleMember* seen : members) {
        const SurfaceEvidence own = surveyedAs(*seen->surface, evidence, hypothesis.ensemble->surface.cell, among.size());
        std::vector<double> departures;
        for (const EnsembleMember* other : members) {
            if (other != seen) {
                departures.push_back(departureFrom(own, *other->surface));
            }
        }
        among.push_back(spreadOf(departures).mean);
    }
    return spreadOf(among);
}

/// Chance that one more member would depart from them as much as the evidence does: Student's prediction from the members.
double chanceOf(const FigureSpread& spread, double departure) {
    if (spread.count < 2) {
        return unknown;
    }
    const double count = static_cast<double>(spread.count);
    const double scale = spread.deviation * std::sqrt(1.0 + 1.0 / count);
    if (scale == 0.0) {
        return departure > spread.mean ? 0.0 : 1.0;
    }
    return studentBelow((spread.mean - departure) / scale, count - 1.0);
}

/// Chance that debris of one more member would reach the place as much earlier or later than theirs: Student's prediction, with the
/// accuracy as limits between which a time may lie anywhere (GUM, type B). NaN with fewer than two members that reach it.
double chanceOf(const Hypothesis& hypothesis, const TimeEvidence& evidence) {
    std::vector<double> times;
    for (const EnsembleMember* member : hypothesis.ensemble->done()) {
        times.push_back(member->arrivals.firstWithin(evidence.place, evidence.radius) - member->arrivals.first());
    }
    const FigureSpread spread = spreadOf(times);
    if (spread.count < 2) {
        return unknown;
    }
    const double count = static_cast<double>(spread.count);
    const double variance = spread.deviation * spread.deviation * (1.0 + 1.0 / count) + evidence.accuracy * evidence.accuracy / 3.0;
    const double apart = std::abs(evidence.time - spread.mean);
    if (variance == 0.0) {
        return apart > 0.0 ? 0.0 : 1.0;
    }
    return 2.0 * studentBelow(-apart / std::sqrt(variance), count - 1.0);
}

/// Height of a surface in a cell, m; 0 where it has nothing that counts.
double heightAt(const SurfaceEvidence& evidence, const MemberSurface& surface, MapCell cell) {
    const std::ptrdiff_t at = surface.find(cell);
    return evidence.holds(surface, at) ? double{surface.heights[static_cast<std::size_t>(at)]} : 0.0;
}

/// What decides a cell: whether debris lies there, or of heights whether it is higher than that of half of all members.
double decisiveHeight(std::span<const EnsembleMember* const> members, MapCell cell, const SurfaceEvidence& evidence) {
    if (evidence.kind != EvidenceKind::Heights) {
        return 0.0;
    }
    std::vector<double> heights;
    for (const EnsembleMember* member : members) {
        heights.push_back(heightAt(evidence, *member->surface, cell));
    }
    return spreadOf(std::move(heights)).middle;
}

/// Whether a surface is higher in a cell, or of no height whether it holds debris there.
bool liesAbove(const SurfaceEvidence& evidence, const MemberSurface& surface, MapCell cell, double height) {
    return height > 0.0 ? heightAt(evidence, surface, cell) > height : evidence.holds(surface, surface.find(cell));
}

/// Probability that a member is higher in a cell; half a member more that is and half a one that is not, so that none is certain.
double probabilityAbove(std::span<const EnsembleMember* const> members, MapCell cell, const SurfaceEvidence& evidence,
                        double height) {
    const auto above = std::count_if(members.begin(), members.end(), [&](const EnsembleMember* member) {
        return liesAbove(evidence, *member->surface, cell, height);
    });
    return (static_cast<double>(above) + 0.5) / (static_cast<double>(members.size()) + 1.0);
}

DebrisMap separationOf(const Hypothesis& first, const Hypothesis& second, const SurfaceEvidence& evidence) {
    const std::vector<const EnsembleMember*> ours = first.ensemble->done();
    const std::vector<const EnsembleMember*> theirs = second.ensemble->done();
    std::vector<const EnsembleMember*> all = ours;
    all.insert(all.end(), theirs.begin(), theirs.end());
    DebrisMap map;
    map.cell = first.ensemble->surface.cell;
    map.members = static_cast<std::int64_t>(all.size());
    map.hypotheses = {first.name, second.name};
    map.cells = cellsOfAny(all);
    std::vector<double>& values = map.layers[static_cast<std::size_t>(MapLayer::Separation)];
    for (const MapCell& cell : map.cells) {
        const double height = decisiveHeight(all, cell, evidence);
        const double p = probabilityAbove(ours, cell, evidence, height);
        const double q = probabilityAbove(theirs, cell, evidence, height);
        const bool seen = liesAbove(evidence, evidence.seen, cell, height);
        const double says = seen ? std::log(p / q) : std::log((1.0 - p) / (1.0 - q));
        values.push_back(evidence.counts(cell) ? says : unknown);
    }
    return map;
}

/// The cells that say most, until they hold half of all that speaks for the first hypothesis.
std::optional<TellingPlace> placeOf(const DebrisMap& map) {
    const std::vector<double>& values = map.layer(MapLayer::Separation);
    std::vector<std::size_t> order;
    double all = 0.0;
    for (std::size_t c = 0; c < values.size(); ++c) {
        if (values[c] > 0.0) {
            order.push_back(c);
            all += values[c];
        }
    }
    if (order.empty()) {
        return {};
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
    TellingPlace place;
    double sum = 0.0;
    for (const std::size_t c : order) {
        if (sum >= tellingMost * all) {
            break;
        }
        const MapCell& cell = map.cells[c];
        place.middle += values[c] * map.cell * Eigen::Vector2d(cell.i + 0.5, cell.j + 0.5);
        place.area += map.cell * map.cell;
        sum += values[c];
    }
    place.middle /= sum;
    place.share = sum / all;
    return place;
}

std::string listOf(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& each : names) {
        list += (list.empty() ? "" : ", ") + each;
    }
    return list;
}

Message verdictOf(const CauseComparison& made) {
    const RankedCause& best = made.ranking.causes.front();
    const std::string& name = made.hypotheses[best.hypothesis];
    if (made.ranking.causes.size() < 2) {
        return {"causes.alone", "There is only \"{0}\": nothing to tell it from.", {name}};
    }
    if (made.unexplained) {
        if (made.ranking.decided()) {
            return {"causes.closest_only",
                    "\"{0}\" is closer to the evidence than the others, but the evidence lies outside of what its members do: "
                    "perhaps none of the hypotheses is the cause.",
                    {name}};
        }
        return {"causes.not_told_none",
                "This evidence cannot tell \"{0}\" from \"{1}\", and it lies outside of what the members of \"{0}\" do: perhaps "
                "none of the hypotheses is the cause.",
                {name, listOf(made.alike)}};
    }
    const RankedCause& next = made.ranking.causes[1];
    const bool times =
        std::all_of(made.kinds.begin(), made.kinds.end(), [](EvidenceKind kind) { return kind == EvidenceKind::Time; });
    if (made.ranking.decided() && times) {
        return {
            "causes.told_time",
            "Of these hypotheses \"{0}\" explains the times best: one of its members is closer than one of \"{1}\" in {2} % of the "
            "pairs, at least {3} % with 95 % confidence. A cause that is not among them may give the same times.",
            {name, made.hypotheses[next.hypothesis], 100.0 * next.bestOver.share, 100.0 * next.bestOver.low}};
    }
    const bool outlines =
        std::none_of(made.kinds.begin(), made.kinds.end(), [](EvidenceKind kind) { return kind == EvidenceKind::Heights; });
    if (made.ranking.decided() && outlines) {
        return {"causes.told_outline",
                "Of these hypotheses \"{0}\" explains the outline best: one of its members is closer than one of \"{1}\" in {2} % "
                "of the pairs, at least {3} % with 95 % confidence. A cause that is not among them may leave the same outline.",
                {name, made.hypotheses[next.hypothesis], 100.0 * next.bestOver.share, 100.0 * next.bestOver.low}};
    }
    if (made.ranking.decided()) {
        return {"causes.told",
                "\"{0}\" explains the evidence best: one of its members is closer than one of \"{1}\" in {2} % of the pairs, at "
                "least {3} % with 95 % confidence.",
                {name, made.hypotheses[next.hypothesis], 100.0 * next.bestOver.share, 100.0 * next.bestOver.low}};
    }
    return {"causes.not_told",
            "This evidence cannot tell \"{0}\" from \"{1}\": \"{0}\" is closest, but not surely.",
            {name, listOf(made.alike)}};
}

/// Members that are enough for whatever is told of causes: to name one, in a blind test too, and to say that none fits.
std::size_t membersEnough(std::size_t hypotheses) {
    return std::max(membersToJudge, hypotheses > 1 ? membersToTell(hypotheses, 1) : 0);
}

/// What the program says against resting a conclusion on a photograph counts here too.
/// @param leftOut  members that are held against the others
void findTooFew(Findings& findings, std::span<const Hypothesis> hypotheses, std::size_t leftOut) {
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const Hypothesis& hypothesis : hypotheses) {
        least = std::min(least, hypothesis.ensemble->done().size());
    }
    const std::size_t needed = membersToTell(hypotheses.size(), leftOut);
    if (hypotheses.size() > 1 && least < needed) {
        findings.add(
            {"causes.too_few_to_tell",
             "With {0} members of a cause none of {1} causes can be named, however clear the evidence is",
             {least, hypotheses.size()}},
            {"causes.too_few_to_tell.remedy", "Simulate at least {0} members of each cause.", {membersEnough(hypotheses.size())}});
    }
}

void findDoubtful(Findings& findings, const PhotoEvidence& photo) {
    for (const MatchDoubt& doubt : matchDoubts(photo.photograph, photo.match)) {
        findings.add(doubt.what,
                     {"causes.doubtful_photograph.remedy",
                      "Place its camera by pairs of points until the match is good, or compare without it.",
                      {}},
                     photo.name);
    }
}

void judge(CauseComparison& made, std::span<const Hypothesis> hypotheses, const CauseEvidence& evidence) {
    const RankedCause& best = made.ranking.causes.front();
    made.fit = unknown;
    for (std::size_t s = 0; s < evidence.surfaces.size(); ++s) {
        const FigureSpread among = amongMembers(hypotheses[best.hypothesis], evidence.surfaces[s]);
        made.fit = std::fmin(made.fit, chanceOf(among, best.departures[s].mean));
    }
    for (const TimeEvidence& time : evidence.times) {
        made.fit = std::fmin(made.fit, chanceOf(hypotheses[best.hypothesis], time));
    }
    // With more pieces the worst of them is worse by chance.
    const auto pieces = static_cast<double>(evidence.surfaces.size() + evidence.times.size());
    made.fit = std::isnan(made.fit) ? unknown : std::min(1.0, made.fit * pieces);
    made.unexplained = made.fit < leastFit && best.score.count >= membersToJudge;
    if (made.unexplained) {
        made.findings.add({"causes.no_fit",
                           "The evidence lies farther from the members of the closest hypothesis than these lie from each other: "
                           "perhaps none of the hypotheses is the cause.",
                           {}},
                          {"causes.no_fit.remedy",
                           "Vary more of what is not known, look for other causes, and check the place of the evidence.",
                           {}},
                          '"' + made.hypotheses[best.hypothesis] + '"');
    }
    // Photographs are not judged by.
    if (pieces > 0.0 && best.score.count < membersToJudge) {
        made.findings.add(
            {"causes.few_members",
             "With {0} members it cannot be told whether the evidence lies outside of what a cause does",
             {static_cast<std::int64_t>(best.score.count)}},
            {"causes.few_members.remedy", "Simulate at least {0} members of each cause.", {membersEnough(hypotheses.size())}},
            '"' + made.hypotheses[best.hypothesis] + '"');
    }
    findTooFew(made.findings, hypotheses, 0);
    for (const SurfaceEvidence& surface : evidence.surfaces) {
        findApart(made.findings, surface, hypotheses);
    }
    for (const PhotoEvidence& photo : evidence.photographs) {
        findDoubtful(made.findings, photo);
    }
    for (std::size_t k = 1; k < made.ranking.causes.size(); ++k) {
        if (!made.ranking.causes[k].apart) {
            made.alike.push_back(made.hypotheses[made.ranking.causes[k].hypothesis]);
        }
    }
    if (made.ranking.causes.size() > 1) {
        const std::vector<Superiority>& by = made.ranking.causes[1].bestOverEvidence;
        made.telling = static_cast<std::size_t>(
            std::max_element(by.begin(), by.end(), [](const Superiority& a, const Superiority& b) { return a.share < b.share; }) -
            by.begin());
        if (!evidence.surfaces.empty()) {
            const SurfaceEvidence& surface = evidence.surfaces[made.telling < evidence.surfaces.size() ? made.telling : 0];
            made.separation = separationOf(hypotheses[best.hypothesis], hypotheses[made.ranking.causes[1].hypothesis], surface);
            made.place = placeOf(*made.separation);
        }
    }
}

}  // namespace

void checkAlike(std::span<const Hypothesis> hypotheses) {
    for (const Hypothesis& hypothesis : hypotheses) {
        const EnsembleReport& first = *hypotheses.front().ensemble;
        if (!(hypothesis.ensemble->surface == first.surface) || hypothesis.ensemble->instant != first.instant) {
            throw UsageError(
                {"causes.cells",
                 "The ensembles of \"{0}\" and \"{1}\" are not mapped alike.",
                 {hypotheses.front().name, hypothesis.name}},
                {"causes.cells.remedy", "Make both with the same cells, instant and counting of fallen structure.", {}});
        }
    }
}

std::string_view evidenceKindName(EvidenceKind kind) {
    static constexpr std::array<std::string_view, 4> names{"footprint", "heights", "photograph", "time"};
    return names[static_cast<std::size_t>(kind)];
}

TimeEvidence timeEvidence(double seconds, const Eigen::Vector2d& place, double radius, double accuracy) {
    std::string name = "time=" + exactNumber(seconds);
    for (const double number : {place.x(), place.y(), radius, accuracy}) {
        name += ',' + exactNumber(number);
    }
    return {std::move(name), place, radius, seconds, accuracy};
}

std::string CauseEvidence::name(std::size_t evidence) const {
    if (evidence < surfaces.size()) {
        return surfaces[evidence].name;
    }
    evidence -= surfaces.size();
    return evidence < photographs.size() ? photographs[evidence].name : times[evidence - photographs.size()].name;
}

EvidenceKind CauseEvidence::kind(std::size_t evidence) const {
    if (evidence < surfaces.size()) {
        return surfaces[evidence].kind;
    }
    return evidence < surfaces.size() + photographs.size() ? EvidenceKind::Photograph : EvidenceKind::Time;
}

bool SurfaceEvidence::counts(const MapCell& cell) const {
    return !std::binary_search(leftOut.begin(), leftOut.end(), cell) &&
           (everywhere || std::binary_search(looked.begin(), looked.end(), cell));
}

bool SurfaceEvidence::holds(const MemberSurface& surface, std::ptrdiff_t at) const {
    if (kind == EvidenceKind::Footprint) {
        return surface.covers(at, reached);
    }
    return at >= 0 && double{surface.heights[static_cast<std::size_t>(at)]} >= least;
}

SurfaceEvidence seenAs(const MemberSurface& surface, const SurfaceEvidence& like) {
    SurfaceEvidence evidence = like;
    evidence.seen = surface;
    return evidence;
}

double departureFrom(const SurfaceEvidence& evidence, const MemberSurface& surface) {
    const bool footprint = evidence.kind == EvidenceKind::Footprint;
    double apart = 0.0;
    double all = 0.0;
    forCellsOfEither(evidence.seen, surface, [&](const MapCell& cell, std::ptrdiff_t i, std::ptrdiff_t j) {
        const bool seen = evidence.holds(evidence.seen, i);
        const bool lies = evidence.holds(surface, j);
        if (!(seen || lies) || !evidence.counts(cell)) {
            return;
        }
        if (footprint) {
            apart += seen && lies ? 0.0 : 1.0;
            all += 1.0;
            return;
        }
        const double a = seen ? double{evidence.seen.heights[static_cast<std::size_t>(i)]} : 0.0;
        const double b = lies ? double{surface.heights[static_cast<std::size_t>(j)]} : 0.0;
        apart += std::abs(a - b);
        all += a + b;
    });
    return all > 0.0 ? apart / all : unknown;
}

double departureFrom(const TimeEvidence& evidence, const DebrisArrivals& arrivals) {
    const double first = arrivals.first();
    return std::isfinite(first)
               ? timesApart(evidence.time, arrivals.firstWithin(evidence.place, evidence.radius) - first, evidence.accuracy)
               : unknown;
}

double timesApart(double a, double b, double accuracy) {
    if (!std::isfinite(a) || !std::isfinite(b)) {
        return std::isfinite(a) == std::isfinite(b) ? 0.0 : 1.0;
    }
    constexpr double half = 1.0;  // s, at which a departure is one half
    const double beyond = std::max(0.0, std::abs(a - b) - accuracy);
    return beyond / (beyond + half);
}

double departureFrom(const PhotoEvidence& evidence, const MemberSite& site, const SurfaceSettings& settings,
                     const Execution& execution) {
    if (evidence.photograph.time && *evidence.photograph.time < site.debris->time) {
        return unknown;
    }
    const SiteShape shape = siteAtRest(*site.fe, site.scenario->fragments, *site.fragments, *site.debris, *site.islands,
                                       *site.ground, settings.liveThreshold, evidence.match.camera.place, execution);
    ComparisonSettings comparison;
    comparison.longestSide = longestSide;
    comparison.cameras = camerasDrawn;
    comparison.withFallen = settings.withFallen;
    comparison.liveThreshold = settings.liveThreshold;
    return 1.0 - compareWithPhoto(shape, evidence.photograph, evidence.match, comparison, execution).iou.mean;
}

std::vector<double> lookedAt(const CauseEvidence& evidence, const MemberSite& site, const SurfaceSettings& settings,
                             const Execution& execution) {
    std::vector<double> departures;
    for (const PhotoEvidence& photo : evidence.photographs) {
        departures.push_back(departureFrom(photo, site, settings, execution));
    }
    return departures;
}

CauseComparison compareCauses(std::span<const Hypothesis> hypotheses, const CauseEvidence& given) {
    if (given.count() == 0) {
        throw UsageError(
            {"causes.no_evidence", "There is no evidence to hold the hypotheses against.", {}},
            {"causes.no_evidence.remedy", "Give a footprint, a height model, a time, or photographs with an outline.", {}});
    }
    checkAlike(hypotheses);
    CauseComparison made;
    const CauseEvidence evidence = withDetection(given, hypotheses, made.findings);
    for (const Hypothesis& hypothesis : hypotheses) {
        made.hypotheses.push_back(hypothesis.name);
        made.departures.push_back(departuresOf(hypothesis, evidence));
    }
    for (std::size_t e = 0; e < evidence.count(); ++e) {
        made.evidence.push_back(evidence.name(e));
        made.kinds.push_back(evidence.kind(e));
    }
    made.ranking = rankCauses(made.departures);
    judge(made, hypotheses, evidence);
    made.verdict = verdictOf(made);
    return made;
}

std::int64_t BlindTest::trials() const {
    return std::accumulate(undecided.begin(), undecided.end(), right() + wrong());
}

std::int64_t BlindTest::right() const {
    std::int64_t count = 0;
    for (std::size_t h = 0; h < named.size(); ++h) {
        count += named[h][h];
    }
    return count;
}

std::int64_t BlindTest::wrong() const {
    std::int64_t count = -right();
    for (const std::vector<std::int64_t>& row : named) {
        count = std::accumulate(row.begin(), row.end(), count);
    }
    return count;
}

BlindTest blindTest(std::span<const Hypothesis> hypotheses, EvidenceKind kind, const Execution& execution) {
    checkAlike(hypotheses);
    const std::size_t count = hypotheses.size();
    BlindTest test;
    test.kind = kind;
    test.named.assign(count, std::vector<std::int64_t>(count, 0));
    test.undecided.assign(count, 0);
    test.closest.assign(count, 0);
    SurfaceEvidence everywhere;
    everywhere.kind = kind;
    std::vector<FigureSpread> among;
    for (const Hypothesis& hypothesis : hypotheses) {
        execution.check();
        among.push_back(amongMembers(hypothesis, everywhere));
    }
    const bool judged = count > 1 && std::all_of(among.begin(), among.end(),
                                                 [](const FigureSpread& spread) { return spread.count >= membersToJudge; });
    test.noticed.assign(judged ? count : 0, 0);
    findTooFew(test.findings, hypotheses, 1);
    for (std::size_t truth = 0; truth < count; ++truth) {
        for (const EnsembleMember* seen : hypotheses[truth].ensemble->done()) {
            execution.check();
            const SurfaceEvidence evidence = seenAs(*seen->surface, everywhere);
            std::vector<Departures> departures;
            for (const Hypothesis& hypothesis : hypotheses) {
                Departures& own = departures.emplace_back(1);
                for (const EnsembleMember* member : hypothesis.ensemble->done()) {
                    own[0].push_back(member == seen ? unknown : departureFrom(evidence, *member->surface));
                }
            }
            const CauseRanking ranking = rankCauses(departures);
            const std::size_t best = ranking.causes.front().hypothesis;
            test.closest[truth] += best == truth ? 1 : 0;
            (ranking.decided() ? test.named[truth][best] : test.undecided[truth]) += 1;
            if (judged) {
                departures.erase(departures.begin() + static_cast<std::ptrdiff_t>(truth));
                const RankedCause closest = rankCauses(departures).causes.front();
                const FigureSpread& own = among[closest.hypothesis + (closest.hypothesis >= truth ? 1 : 0)];
                test.noticed[truth] += chanceOf(own, closest.departures.front().mean) < leastFit ? 1 : 0;
            }
        }
    }
    return test;
}

}  // namespace rubble
