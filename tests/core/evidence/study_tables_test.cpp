#include "core/evidence/ensembles/study_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace rubble {
namespace {

using testing::HasSubstr;

TEST(StudyTables, AMemberSaysWhatItWasGivenAndWhatCameOfIt) {
    EnsembleReport report;
    EnsembleMember& done = report.members.emplace_back();
    done.drawn = {{"friction", "0.5"}, {"restitution", "0.1"}};
    done.done = done.kept = true;
    done.figures = {12.5, 3.0, 8.25, 1000.0, 0.4, 1.5};
    done.breaches = 2;
    EnsembleMember& lost = report.members.emplace_back();
    lost.number = 1;
    lost.drawn = {{"cluster_shape", "a,b"}};
    std::ostringstream out;
    writeMembersCsv(report, out);
    EXPECT_THAT(out.str(), testing::StartsWith("member,drawn,done,footprint_m2,pile_volume_m3,run_out_m,mass_kg,mean_height_m,"
                                               "pile_height_m,health_breaches,trajectory_hash\n"));
    EXPECT_THAT(out.str(), HasSubstr("\n0,friction=0.5 restitution=0.1,kept,12.5,3,8.25,1000,0.4,1.5,2,"));
    // A member that is not done has no figures; a comma in what was drawn splits no column.
    EXPECT_THAT(out.str(), HasSubstr("\n1,\"cluster_shape=a,b\",no,,,,,,,,\n"));
}

TEST(StudyTables, TheRankingNamesTheClosestFirst) {
    CauseComparison made;
    made.hypotheses = {"scour", "crown, struck"};
    made.evidence = {"survey.tif"};
    const std::vector<Departures> departures{{{0.5, 0.6, 0.55, 0.52}}, {{0.1, 0.2, 0.15, 0.12}}};
    made.ranking = rankCauses(departures);
    std::ostringstream out;
    writeRankingCsv(made, out);
    EXPECT_THAT(out.str(), testing::StartsWith("rank,cause,members,score_p50,score_p05,score_p95,superiority,superiority_low,"
                                               "told_apart,departure_1,departure_1_deviation\n1,\"crown, struck\",4,"));
    EXPECT_THAT(out.str(), HasSubstr(",,,closest,"));
    EXPECT_THAT(out.str(), HasSubstr("\n2,scour,4,"));
    EXPECT_THAT(out.str(), HasSubstr(",not told apart,")) << "four members are never enough";
}

}  // namespace
}  // namespace rubble
