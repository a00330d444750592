#include "core/evidence/ensembles/telling_evidence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>

#include "core/base/error.h"

namespace rubble {
namespace {

/// One cell of debris for each place of a rectangle. @param height  m, at a place
MemberSurface field(std::int32_t columns, std::int32_t rows, const std::function<double(std::int32_t, std::int32_t)>& height) {
    MemberSurface surface;
    for (std::int32_t j = 0; j < rows; ++j) {
        for (std::int32_t i = 0; i < columns; ++i) {
            if (const double h = height(i, j); h > 0.0) {
                surface.cells.push_back({j, i});
                surface.heights.push_back(static_cast<float>(h));
                surface.masses.push_back(static_cast<float>(2000.0 * h));
                surface.covered.push_back(1.0F);
            }
        }
    }
    return surface;
}

using Heights = std::function<double(std::int32_t, std::int32_t, double)>;  ///< of a cell, with a number drawn for the member

Hypothesis cause(const std::string& name, unsigned seed, const Heights& heights, int members = 14) {
    EnsembleReport report;
    report.surface.cell = 1.0;
    report.complete = true;
    std::mt19937 random(seed);
    for (int m = 0; m < members; ++m) {
        const double drawn = static_cast<double>(random() % 1000) / 1000.0;
        EnsembleMember& member = report.members.emplace_back();
        member.number = m;
        member.done = true;
        member.surface = std::make_shared<const MemberSurface>(
            field(40, 20, [&](std::int32_t i, std::int32_t j) { return heights(i, j, drawn); }));
    }
    return {name, std::make_shared<const EnsembleReport>(std::move(report))};
}

bool inEnd(std::int32_t i, std::int32_t j) {
    return i >= 32 && j >= 12;
}

/// Both cover the same ground; one has a heap at its north-east end.
std::vector<Hypothesis> heapOrNot() {
    return {cause("flat", 1, [](std::int32_t, std::int32_t, double drawn) { return 1.0 + 0.3 * drawn; }),
            cause("heap", 2, [](std::int32_t i, std::int32_t j, double drawn) { return (inEnd(i, j) ? 4.0 : 1.0) + 0.3 * drawn; })};
}

TellingEvidence tell(const std::vector<Hypothesis>& hypotheses, const CauseEvidence& atHand = {}) {
    std::vector<std::size_t> causes(hypotheses.size());
    std::iota(causes.begin(), causes.end(), std::size_t{0});
    return tellingEvidence(hypotheses, atHand, causes, SiteSurface{}, Execution());
}

const FurtherEvidence& find(const TellingEvidence& telling, const std::string& id) {
    const auto found = std::find_if(telling.ranked.begin(), telling.ranked.end(),
                                    [&](const FurtherEvidence& each) { return each.words().id == id; });
    EXPECT_NE(found, telling.ranked.end()) << id;
    return *found;
}

TEST(TellingEvidence, IsThatInWhichTheCausesDiffer) {
    const TellingEvidence telling = tell(heapOrNot());
    ASSERT_GT(telling.ranked.size(), 10U);
    EXPECT_EQ(telling.atHand.trials, 0) << "nothing is at hand";
    const FurtherEvidence& outline = find(telling, "further.outline");
    EXPECT_EQ(outline.named.trials, 28);
    EXPECT_EQ(outline.named.right, 0) << "both cover the same ground";
    EXPECT_EQ(outline.named.wrong, 0);
    EXPECT_EQ(find(telling, "further.heights").named.right, 28);
    EXPECT_EQ(find(telling, "further.photograph").named.right, 28) << "the heap stands out from some place";
    // Of the parts, the one with the heap tells, and one without says nothing.
    const Eigen::Vector2d heap(36.0, 16.0);
    const Eigen::Vector2d flat(5.0, 5.0);
    for (const FurtherEvidence& each : telling.ranked) {
        if (each.part && each.kind == EvidenceKind::Heights && each.part->contains(heap)) {
            EXPECT_EQ(each.named.right, 28);
        } else if (each.part && each.part->contains(flat)) {
            EXPECT_LT(each.named.right, 14) << each.words().pattern;
        }
    }
    for (std::size_t k = 1; k < telling.ranked.size(); ++k) {
        EXPECT_GE(telling.ranked[k - 1].named.right, telling.ranked[k].named.right);
    }
}

TEST(TellingEvidence, AddsToWhatIsAtHandAndDoesNotAskForItAgain) {
    CauseEvidence atHand;
    SurfaceEvidence& outline = atHand.surfaces.emplace_back();
    outline.kind = EvidenceKind::Footprint;
    outline.seen = field(40, 20, [](std::int32_t, std::int32_t) { return 1.0; });
    const TellingEvidence telling = tell(heapOrNot(), atHand);
    EXPECT_EQ(telling.atHand.trials, 28);
    EXPECT_EQ(telling.atHand.right, 0);
    for (const FurtherEvidence& each : telling.ranked) {
        EXPECT_NE(each.kind, EvidenceKind::Footprint);
    }
    EXPECT_EQ(find(telling, "further.heights").named.right, 28);
}

TEST(TellingEvidence, ATimeTellsWhereTheRestLiesAlike) {
    const Heights same = [](std::int32_t, std::int32_t, double drawn) { return 1.0 + drawn; };
    std::vector<Hypothesis> hypotheses;
    for (const double at : {3.0, 5.0}) {
        const Hypothesis lies = cause(at < 4.0 ? "at once" : "later", 7, same);
        EnsembleReport report = *lies.ensemble;
        for (EnsembleMember& member : report.members) {
            const double by = 0.02 * static_cast<double>(member.number);
            // All begin at the west; only the east end differs. By less than half a second the south-west does too.
            member.arrivals.squares = {{0, 0, 2.0}, {0, 1, 2.1 + 0.1 * at}, {15, 36, 2.0 + at + by}};
        }
        hypotheses.push_back({lies.name, std::make_shared<const EnsembleReport>(std::move(report))});
    }
    const TellingEvidence telling = tell(hypotheses);
    const FurtherEvidence& best = telling.ranked.front();
    EXPECT_EQ(best.kind, EvidenceKind::Time);
    ASSERT_TRUE(best.part);
    EXPECT_TRUE(best.part->contains(Eigen::Vector2d(36.5, 15.5)));
    EXPECT_EQ(best.named.right, 28);
    EXPECT_EQ(best.accuracy, 0.5) << "as stated";
    EXPECT_EQ(best.words().id, "further.time");
    for (const FurtherEvidence& each : telling.ranked) {
        if (each.kind == EvidenceKind::Time && !each.part->contains(Eigen::Vector2d(36.5, 15.5))) {
            EXPECT_EQ(each.named.right, 0) << "nothing beyond the accuracy";
        }
    }
    // What is at hand counts.
    CauseEvidence atHand;
    atHand.times.push_back({"video", {36.5, 15.5}, 3.0, 3.0, 0.5});
    EXPECT_EQ(tell(hypotheses, atHand).atHand.right, 28);
}

TEST(TellingEvidence, NothingTellsCausesThatLeaveTheSame) {
    const Heights same = [](std::int32_t, std::int32_t, double drawn) { return 1.0 + drawn; };
    const TellingEvidence telling = tell({cause("a", 3, same), cause("b", 4, same)});
    for (const FurtherEvidence& each : telling.ranked) {
        EXPECT_LT(each.named.share(), 0.3) << each.words().pattern;
    }
}

TEST(TellingEvidence, ShareHasTheIntervalOfWilson) {
    BlindShare named;
    named.trials = 10;
    named.right = 10;
    EXPECT_NEAR(named.low(), 0.7225, 1e-4);
    EXPECT_DOUBLE_EQ(named.high(), 1.0);
    named.right = 5;
    EXPECT_NEAR(named.low(), 0.2366, 1e-4);
    EXPECT_NEAR(named.high(), 0.7634, 1e-4);
}

TEST(TellingEvidence, NeedsTwoCausesAndStopsWhenCancelled) {
    const std::vector<Hypothesis> hypotheses = heapOrNot();
    EXPECT_THROW(tellingEvidence(hypotheses, {}, std::vector<std::size_t>{0}, SiteSurface{}, Execution()), UsageError);
    const auto nothing = [](std::int32_t, std::int32_t, double) { return 1.0; };
    EXPECT_TRUE(tell({cause("alone", 5, nothing, 1), cause("none", 6, nothing, 0)}).ranked.empty()) << "one member in all";
    Execution cancelled;
    cancelled.cancel();
    EXPECT_THROW(tellingEvidence(hypotheses, {}, std::vector<std::size_t>{0, 1}, SiteSurface{}, cancelled), Cancelled);
}

TEST(TellingEvidence, AsksOnlyForCausesThatAreNotToldApart) {
    CauseComparison made;
    made.ranking.causes.resize(3);
    made.ranking.causes[0].hypothesis = 2;
    made.ranking.causes[1].hypothesis = 0;
    made.ranking.causes[2].hypothesis = 1;
    made.ranking.causes[2].apart = true;
    EXPECT_EQ(notToldApart(made), (std::vector<std::size_t>{2, 0}));
    made.ranking.causes[1].apart = true;
    EXPECT_EQ(notToldApart(made), (std::vector<std::size_t>{2, 0, 1})) << "all are told apart: what would confirm it";
}

}  // namespace
}  // namespace rubble
