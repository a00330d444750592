#include "core/analysis/accuracy/run_time_left.h"

#include <gtest/gtest.h>

#include <vector>

namespace rubble {
namespace {

/// How far a run had got: wall time [s], time of the collapse [s], bodies born until then.
struct Recorded {
    double wall;
    double time;
    int bodies;
};

/// The sample case of the stone arch, 4,087 bodies, on two cores; its debris comes to rest while it is simulated.
const std::vector<Recorded> stoneArch{
    {0.00, 0.07998, 0},  {0.54, 3, 586},       {1.04, 4.04, 1217},   {1.55, 4.76, 1791},   {2.10, 5.48, 2085},  {2.61, 5.88, 2771},
    {3.15, 6.28, 3198},  {3.69, 6.64, 3500},   {4.23, 7.04, 3695},   {4.74, 7.4, 3858},    {5.26, 7.76, 3988},  {5.85, 8.2, 4084},
    {6.40, 8.6, 4084},   {6.95, 9, 4084},      {7.50, 9.48, 4084},   {8.05, 10.13, 4087},  {8.57, 10.83, 4087}, {9.12, 11.73, 4087},
    {9.66, 12.73, 4087}, {10.19, 13.93, 4087}, {10.70, 15.73, 4087}, {11.23, 18.58, 4087}, {11.39, 19.63, 4087}};
constexpr double stoneArchEnd = 19.68;  // s

/// The arch over a river, 4,531 bodies: most are born within one second, and the water keeps them moving.
const std::vector<Recorded> riverArch{
    {0.00, 0.05001, 0},   {0.58, 2.275, 1837},  {1.17, 2.575, 3022},  {1.72, 2.75, 3897},   {2.28, 2.925, 4232},
    {2.82, 3.125, 4241},  {3.36, 3.35, 4247},   {3.87, 3.55, 4295},   {4.37, 3.75, 4312},   {4.93, 3.975, 4343},
    {5.47, 4.2, 4361},    {6.00, 4.425, 4375},  {6.53, 4.65, 4380},   {7.05, 4.875, 4380},  {7.58, 5.1, 4381},
    {8.08, 5.3, 4475},    {8.61, 5.5, 4477},    {9.17, 5.675, 4531},  {9.70, 5.924, 4531},  {10.25, 6.204, 4531},
    {10.76, 6.484, 4531}, {11.27, 6.796, 4531}, {11.78, 7.045, 4531}, {12.30, 7.326, 4531}, {12.85, 7.606, 4531},
    {13.39, 7.918, 4531}, {13.98, 8.291, 4531}, {14.49, 8.634, 4531}, {15.03, 9.008, 4531}, {15.60, 9.444, 4531},
    {16.11, 9.88, 4531},  {16.63, 10.32, 4531}, {17.20, 10.75, 4531}, {17.76, 11.19, 4531}, {18.26, 11.56, 4531},
    {18.81, 11.97, 4531}, {19.33, 12.31, 4531}, {19.91, 12.68, 4531}, {20.43, 12.96, 4531}, {21.00, 13.28, 4531},
    {21.53, 13.65, 4531}, {22.11, 14.09, 4531}, {22.64, 14.46, 4531}, {23.15, 14.83, 4531}, {23.69, 15.27, 4531},
    {23.97, 15.52, 4531}};
constexpr double riverArchEnd = 15.6;  // s

RunTimeLeft::Course courseOf(const std::vector<Recorded>& rows, double end) {
    RunTimeLeft::Course course;
    course.first = rows.front().time;
    course.end = end;
    int born = 0;
    for (const Recorded& row : rows) {
        course.births.insert(course.births.end(), static_cast<std::size_t>(row.bodies - born), row.time);
        born = row.bodies;
    }
    return course;
}

/// Says the time left at each row, and holds it against what was left in truth.
void replay(const std::vector<Recorded>& rows, double end) {
    RunTimeLeft left(courseOf(rows, end));
    double before = std::numeric_limits<double>::infinity();
    std::size_t said = 0;
    for (const Recorded& row : rows) {
        left.reached(row.time, row.wall);
        if (!left.left()) {
            EXPECT_LT(row.wall, 2.0) << "something is said within two seconds";
            continue;
        }
        ++said;
        EXPECT_LE(*left.left(), before) << "it never grows, at " << row.wall << " s";
        before = *left.left();
        const double truth = rows.back().wall - row.wall;
        // By the fraction of the time of the collapse it was 10 times too much where most bodies were still to be born.
        if (row.wall > 1.5 && truth > 0.1 * rows.back().wall) {
            EXPECT_GT(before, truth / 2.5) << "at " << row.wall << " s";
            EXPECT_LT(before, truth * 2.5) << "at " << row.wall << " s";
        }
    }
    EXPECT_GT(said, rows.size() / 2);
    EXPECT_LT(before, 0.1 * rows.back().wall) << "at the end nothing is left";
}

TEST(RunTimeLeft, OfARecordedCollapseThatComesToRest) {
    replay(stoneArch, stoneArchEnd);
}

TEST(RunTimeLeft, OfARecordedCollapseThatKeepsMoving) {
    replay(riverArch, riverArchEnd);
}

TEST(RunTimeLeft, CountsTheBirthsToCome) {
    // Ten bodies now, a thousand after half of the time: by the clock of the collapse nearly half would be done.
    RunTimeLeft::Course course;
    course.first = 0.0;
    course.end = 4.0;
    course.births.assign(10, 0.0);
    course.births.insert(course.births.end(), 1000, 2.0);
    RunTimeLeft left(course);
    left.reached(0.9, 1.0);
    EXPECT_FALSE(left.left()) << "too little of the work is done";
    left.reached(1.9, 2.1);
    ASSERT_TRUE(left.left());
    EXPECT_GT(*left.left(), 20.0 * 2.1) << "the births to come cost far more than what was";
}

TEST(RunTimeLeft, SaysNothingBeforeItKnowsAnything) {
    RunTimeLeft none;
    none.reached(1.0, 10.0);
    EXPECT_FALSE(none.left());
}

}  // namespace
}  // namespace rubble
