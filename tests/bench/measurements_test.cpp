#include "bench/measurements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <regex>
#include <set>
#include <stdexcept>

namespace rubble::bench {

TEST(Measurements, HaveNamesOfTheirOwnAndFitIntoTwentyMinutes) {
    std::set<std::string> names, titles;
    double minutes = 0.0;
    for (const Measurement& measurement : measurements()) {
        EXPECT_TRUE(std::regex_match(measurement.name, std::regex("[a-z-]+"))) << measurement.name;
        EXPECT_TRUE(names.insert(measurement.name).second) << measurement.name;
        EXPECT_TRUE(titles.insert(measurement.title).second) << measurement.title;
        EXPECT_FALSE(measurement.tables.empty()) << measurement.name;
        minutes += measurement.onlyByName ? 0.0 : measurement.minutes;
    }
    EXPECT_LE(minutes, 20.0);
}

TEST(Measurements, BenchmarksAreRows) {
    const std::string json = R"({"benchmarks": [
        {"name": "map/250/process_time/real_time", "time_unit": "ms", "real_time": 56.04, "cpu_time": 112.4, "cells": 59880},
        {"name": "other/iterations:3/manual_time", "label": "with a label", "time_unit": "s", "real_time": 0.0123, "cpu_time": 1585}]})";
    const Table table = benchmarkRows(json, {{"cells", "cells"}});
    EXPECT_EQ(table.head, (std::vector<std::string>{"", "wall", "of the processors", "cells"}));
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"map/250", "56.0 ms", "112 ms", "59,880"}));
    EXPECT_EQ(table.rows[1], (std::vector<std::string>{"with a label", "0.0123 s", "1,585 s", ""}));
}

TEST(Measurements, StylesAreReadFromWhatTheirBenchmarkPrints) {
    const auto styles = std::find_if(measurements().begin(), measurements().end(),
                                     [](const Measurement& measurement) { return measurement.name == "styles"; });
    ASSERT_NE(styles, measurements().end());
    const Table table = styles->tables.at(0).read({R"({"of": "the run"})", R"({"benchmarks": [
        {"name": "page played/iterations:1/real_time", "time_unit": "ms", "real_time": 9000, "cpu_time": 20,
         "presentation_fps": 29.5, "analysis_fps": 31.0, "ratio": 0.952, "page_MB": 21.0, "start_s": 2.7}]})"});
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0].front(), "page played");
    EXPECT_EQ((std::vector<std::string>(table.rows[0].end() - 5, table.rows[0].end())),
              (std::vector<std::string>{"29.5", "31.0", "0.952", "21.0", "2.70"}));
}

TEST(Measurements, ReadersStandBesideEachOther) {
    const std::string json = R"({"benchmarks": [
        {"name": "VTU: ours", "time_unit": "ms", "cpu_time": 10},
        {"name": "VTU, one state: ours", "time_unit": "ms", "cpu_time": 0.5},
        {"name": "VTU: VTK", "time_unit": "ms", "cpu_time": 25}]})";
    const Table table = benchmarkGrid(json, "ours", "VTK");
    EXPECT_EQ(table.head, (std::vector<std::string>{"", "ours", "VTK", "VTK over ours"}));
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"VTU", "10.0", "25.0", "2.50"}));
    EXPECT_EQ(table.rows[1], (std::vector<std::string>{"VTU, one state", "0.500", "", ""}));
    EXPECT_THROW(benchmarkGrid(R"({"benchmarks": [{"name": "no column", "time_unit": "ms", "cpu_time": 1}]})", "ours", "VTK"),
                 std::runtime_error);
}

TEST(Measurements, RunsShowBestAndWorst) {
    const auto run = [](double factor, double mean) {
        return R"({"bodies_peak": 4085, "real_time_factor": )" + std::to_string(factor) + R"(, "ms_per_step": {"mean": )" +
               std::to_string(mean) +
               R"(, "p95": 20}, "share_of_steps_in_time": 0.75, "wall_s": {"simulation": 4}, "trajectory_hash": "0123456789abcdef"})";
    };
    const Table table = runRows({"a", "b"}, {run(2.0, 9.0), run(3.0, 8.0), run(1.0, 7.0), run(1.0, 7.0)});
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"a", "4,085", "3.00, 2.00", "8.00, 9.00", "20.0, 20.0", "75.0, 75.0",
                                                       "4.00, 4.00", "`01234567`"}));
}

TEST(Measurements, AccuracyLeavesOutWhatWasNotMeasured) {
    const std::string json = R"({"points": [
        {"setting": "floor", "bodies": 9643, "mass_map_difference": 0.0718, "core_iou": 0.9476, "footprint_iou": 0.885,
         "runout95_error_m": -0.0096, "height_rms_m": 0.659, "mean_height_error_m": -0.062, "accuracy_0_1m": 0.0123,
         "accuracy_0_2m": 0.0354, "accuracy_0_3m": 0.0704, "wall_s": null, "ms_per_step_mean": null, "ms_per_step_worst": null,
         "fps": null}],
        "details": [{"setting": "floor", "repeats": [{"mass_map_difference": 0.08, "core_iou": 0.9}]}]})";
    const Table table = accuracyRows(json);
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"floor", "9,643", "0.072 (0.080)", "0.948 (0.900)", "0.885", "-0.01", "0.66",
                                                       "-0.06", "1.23 / 3.54 / 7.04 %", "", "", ""}));
}

TEST(Measurements, StartsHaveBestMedianAndWorst) {
    const auto start = [](const std::string& seconds) {
        return R"({"first_window_s": )" + seconds +
               R"(, "first_picture_s": 1, "prepared_s": 2, "scrub_again": {"median_ms": 3}, "scrub_first_visit": {"p95_ms": 4},
                  "memory_peak_mib": 500})";
    };
    const Table table = startRows({start("0.7"), start("0.5"), start("0.6"), start("0.9")});
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"first window, s", "0.500", "0.650", "0.900"}));
}

TEST(Measurements, DistancesStandBehindTheirSeconds) {
    const std::string compared = R"({"first": {"points_near": 4000000}, "cores": {"points": 1234}, "states": {"measured": 1000}})";
    const Table table = distanceRows("6.000\n" + compared);
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"4,000,000", "6.00", "15.0", "1,234", "1,000"}));
    EXPECT_THROW(distanceRows(compared), std::exception);
}

TEST(Measurements, TheTableOfSizesIsReadAsItIsPrinted) {
    char head[128], row[128];
    const char* format = "%-30s %9s %9s %9s %7s %9s %9s %9s\n";
    std::snprintf(head, sizeof head, format, "stage", "1x s", "3x s", "10x s", "10x/1x", "1x MiB", "3x MiB", "10x MiB");
    std::snprintf(row, sizeof row, format, "reading all states", "1.290", "4.410", "14.100", "10.9", "254", "311", "434");
    const Table table = scaleRows(std::string("Stone arch\n 1x: elements\n") + head + row);
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0],
              (std::vector<std::string>{"reading all states", "1.290", "4.410", "14.100", "10.9", "254", "311", "434"}));
    EXPECT_THROW(scaleRows("nothing"), std::runtime_error);
}

}  // namespace rubble::bench
