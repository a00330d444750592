#include "bench/measurements.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace rubble::bench {

namespace {

using Json = nlohmann::json;

/// Three digits, more before the point: 0.0123, 4.56, 789, 12,345.
std::string figure(double value) {
    if (!std::isfinite(value)) {
        return {};
    }
    if (value == 0.0) {
        return "0";
    }
    const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", std::clamp(3 - before, 0, 5), value);
    std::string figures = text;
    if (figures.find('.') == std::string::npos) {
        for (std::ptrdiff_t at = std::ssize(figures) - 3; at > (figures.front() == '-' ? 1 : 0); at -= 3) {
            figures.insert(static_cast<std::size_t>(at), ",");
        }
    }
    return figures;
}

/// The number under a key; an empty cell for none.
std::string cell(const Json& object, const std::string& key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) {
        return {};
    }
    return figure(found->get<double>());
}

std::string fixed(const Json& object, const std::string& key, int digits, double factor = 1.0) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) {
        return {};
    }
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, found->get<double>() * factor);
    return text;
}

/// The name without what the library adds: "/process_time", "/iterations:3".
std::string plainName(const std::string& name) {
    std::string plain = name;
    for (const std::string suffix : {"/real_time", "/process_time", "/manual_time"}) {
        if (plain.ends_with(suffix)) {
            plain.resize(plain.size() - suffix.size());
        }
    }
    return plain.substr(0, plain.find("/iterations:"));
}

/// Best and worst of several runs, or one figure of one.
std::string bestAndWorst(std::vector<double> values, bool highIsBest) {
    std::sort(values.begin(), values.end());
    if (highIsBest) {
        std::reverse(values.begin(), values.end());
    }
    const std::string best = figure(values.front());
    return values.size() == 1 ? best : best + ", " + figure(values.back());
}

TableOrder benchmarks(const std::string& filter, std::vector<std::pair<std::string, std::string>> counters = {}) {
    return {{"rubble-bench --benchmark_format=json --benchmark_filter='" + filter + "'"},
            1,
            [counters = std::move(counters)](const std::vector<std::string>& outputs) {
                return benchmarkRows(outputs.at(0), counters);
            }};
}

TableOrder accuracySweep(const std::string& command) {
    return {{command}, 1, [](const std::vector<std::string>& outputs) { return accuracyRows(outputs.at(0)); }};
}

/// Runs of the sample case with so many bodies allowed; a label each.
TableOrder sampleRuns(const std::vector<std::pair<std::string, std::string>>& settings, int times) {
    TableOrder order;
    order.times = times;
    std::vector<std::string> labels;
    for (const auto& [label, words] : settings) {
        labels.push_back(label);
        order.commands.push_back("rubble-cli run resources/samples/stone-arch.rubble " + words +
                                 " --out \"$TMPDIR/arch.run.h5\" --json");
    }
    order.read = [labels](const std::vector<std::string>& outputs) { return runRows(labels, outputs); };
    return order;
}

/// A scan of the sample case's debris, held against the fragments that it was taken of. The shell tells the seconds.
TableOrder cloudDistances() {
    return {{"rubble-cli run resources/samples/stone-arch.rubble --out \"$TMPDIR/cloud.run.h5\" --json",
             "rubble-cli scan \"$TMPDIR/cloud.run.h5\" --step 0.08 --out \"$TMPDIR/scan.las\" --json",
             "bash -c 'TIMEFORMAT=%R; time rubble-cli cloud \"$TMPDIR/scan.las\" --against \"$TMPDIR/cloud.run.h5\" "
             "--normal-scale 0.5 --projection-scale 0.25 --depth 2 --json >\"$TMPDIR/distances.json\"' 2>&1; cat "
             "\"$TMPDIR/distances.json\""},
            1,
            [](const std::vector<std::string>& outputs) { return distanceRows(outputs.at(2)); }};
}

/// Counters of a collapse, ours beside plain Bullet.
std::vector<std::pair<std::string, std::string>> engineCounters() {
    return {{"bodies", "bodies"},
            {"ms/step", "ms a step"},
            {"worst ms", "worst, ms"},
            {"in time", "in time"},
            {"real time", "real-time factor"},
            {"plain ms/step", "Bullet, ms a step"},
            {"plain over ours", "Bullet's time over ours"}};
}

/// What a run measures by itself, in some twenty minutes.
std::vector<Measurement> shortOnes() {
    return {
        {"clustering",
         "Clustering",
         "The stone arch, 49,561 fragments. The matrix is the published way to find groups; multiples are given tenfold.",
         1.0,
         false,
         {benchmarks("groups along axes|clusters|count at|slider|search",
                     {{"matrix_ms", "matrix, ms"}, {"ratio", "matrix over ours"}})}},
        {"readers",
         "Readers",
         "Milliseconds of the processor. VTK's readers have to read every state to know the deaths; ours read the flags alone.",
         1.5,
         false,
         {{{"rubble-bench --benchmark_format=json --benchmark_filter='deaths|one state'"},
           1,
           [](const std::vector<std::string>& outputs) { return benchmarkGrid(outputs.at(0), "ours", "VTK's reader"); }},
          benchmarks("20 GB", {{"index_s", "index, s"}, {"gigabytes", "GB"}, {"memory_MB", "memory, MB"}})}},
        {"clouds",
         "Point clouds",
         "LAS: 10 million points. LAZ: 110,000 points of a real terrain, format 3, with colours and times. Opening a file is not "
         "measured. Octrees are made, then opened again with a tenth of their nodes read; the memory is the program's peak. At "
         "last "
         "a scan of the stone arch's debris is held against its 49,561 fragments.",
         3.0,
         true,
         {benchmarks("cloud,", {{"points", "points"}, {"Mpoints_s", "million points a second"}, {"MB_s", "MB a second"}}),
          benchmarks("octree", {{"again_s", "opened again, s"}, {"memory_MB", "memory, MB"}}), cloudDistances()}},
        {"maps",
         "Debris maps",
         "All layers of the stone arch, by the side of a cell in mm.",
         0.3,
         false,
         {benchmarks("debris map", {{"fragments", "fragments"}, {"cells", "cells"}})}},
        {"simulation",
         "Simulation",
         "The sample case, recording included. The real-time factor is simulated time over wall time from the first to the last "
         "birth; best and worst of three runs. What came loose is moved by the engine but where `fe` stands.",
         4.0,
         false,
         {sampleRuns({{"as it opens", "--set settle_time=0"},
                      {"loose structure by `fe`", "--set settle_time=0 --set loose_structure=fe"},
                      {"2,000 bodies", "--set settle_time=0 --set bodies_max=2000"},
                      {"*Quick*: 2,000 bodies, by `fe`", "--scenario Quick --set settle_time=0"}},
                     3)}},
        {"reference",
         "The reference",
         "Every fragment its own body, the whole run with its settling; what came loose is moved by the engine.",
         6.0,
         false,
         {sampleRuns({{"reference", "--set preset=reference"}}, 1)}},
        {"bullet",
         "Beside plain Bullet",
         "The sample from its first to its last birth, nothing recorded, what came loose moved by the engine. Plain Bullet "
         "squeezes the same bodies into each other, so its time is no measure of the same work.",
         3.0,
         false,
         {benchmarks("clustered collapse", engineCounters())}},
        {"playback",
         "Playback",
         "Both views in one window of 1280 x 800, drawn by the processor under Xvfb.",
         2.0,
         false,
         {{{"xvfb-run -a playback_bench --benchmark_format=json"},
           1,
           [](const std::vector<std::string>& outputs) {
               return benchmarkRows(
                   outputs.at(0),
                   {{"frames_per_s", "frames a second"}, {"triangles", "triangles"}, {"resolution", "of the pixels"}});
           }}}},
        {"window",
         "Window",
         "Six starts with the stone arch, drawn by the processor under Xvfb; times from the start of the program.",
         1.0,
         false,
         {{{"xvfb-run -a rubble resources/samples/stone-arch.exo --measure"}, 6, startRows}}},
    };
}

/// @param chart  beside the page
std::string accuracyWords(const std::string& chart) {
    return "2 s after the FE end in cells of 2 m. The floor is what the reference repeats itself to when births shift by 1e-6 m; "
           "repeats of a setting stand in brackets. [Chart](" +
           chart + ") of the mass map over milliseconds a step.";
}

/// What is measured when it is asked for by name.
std::vector<Measurement> longOnes() {
    return {
        {"styles",
         "Styles",
         "Figures and page of the stone arch, 49,561 fragments, in both styles by turns: each figure drawn, the views of the page "
         "at rest and played for 6 s from the third on, in Chromium of 1280 x 800 that draws in software.",
         3.0,
         true,
         {{{"rubble-cli run resources/samples/stone-arch.rubble --out \"$TMPDIR/arch.run.h5\" --json",
            "xvfb-run -a style_bench resources/samples/stone-arch.exo \"$TMPDIR/arch.run.h5\" --benchmark_format=json"},
           1,
           [](const std::vector<std::string>& outputs) {
               return benchmarkRows(outputs.at(1), {{"presentation_ms", "presentation, ms"},
                                                    {"analysis_ms", "analysis, ms"},
                                                    {"presentation_fps", "presentation, frames a second"},
                                                    {"analysis_fps", "analysis, frames a second"},
                                                    {"ratio", "presentation over analysis"},
                                                    {"page_MB", "page, MB"},
                                                    {"start_s", "start, s"}});
           }}}},
        {"scale",
         "Scale",
         "The stone arch with every brick split in 1, 3 and 10: 60,660, 181,980 and 606,600 elements. Memory is the most that the "
         "process had in the stage, MiB. Runs are as by default: loose structure that the engine moves "
         "(`loose_structure=at_once`).",
         18.0,
         true,
         {{{"rubble-bench scale \"$TMPDIR/scale\""},
           1,
           [](const std::vector<std::string>& outputs) { return scaleRows(outputs.at(0)); }}}},
        {"accuracy-stone-arch",
         "Accuracy against time, stone arch",
         accuracyWords("accuracy-stone-arch.svg"),
         30.0,
         true,
         {accuracySweep(
             "rubble-cli accuracy resources/samples/stone-arch.rubble --repeats 2 --setting-repeats 1 --set settle_time=2 "
             "--multiples auto,1.5,2,3 --vary birth_window=0,0.1 --json")}},
        {"accuracy-rc-arch",
         "Accuracy against time, concrete arch",
         accuracyWords("accuracy-rc-arch.svg"),
         15.0,
         true,
         {accuracySweep(
             "rubble-cli accuracy resources/samples/rc-arch.exo --repeats 3 --setting-repeats 1 --set settle_time=2 --multiples "
             "auto,1,1.5,2,3 --vary birth_window=0,0.1 --json")}},
        {"reference-bullet",
         "The reference beside plain Bullet",
         "Every fragment its own body, no pieces, to 2 s after the FE end; what came loose is moved by the FE result "
         "(`loose_structure=fe`).",
         12.0,
         true,
         {benchmarks("reference without pieces", {{"ms/step", "ms a step"},
                                                  {"run s", "whole run, s"},
                                                  {"plain run s", "Bullet, s"},
                                                  {"plain run over ours", "Bullet's time over ours"},
                                                  {"ours mean height m", "mean height, m"},
                                                  {"plain mean height m", "Bullet's, m"},
                                                  {"ours overlap deepest m", "deepest overlap, m"},
                                                  {"plain overlap deepest m", "Bullet's, m"},
                                                  {"ours beyond 5 %", "boxes beyond 5 %"},
                                                  {"plain beyond 5 %", "Bullet's"}})}},
    };
}

}  // namespace

const std::vector<Measurement>& measurements() {
    static const std::vector<Measurement> all = [] {
        std::vector<Measurement> both = shortOnes();
        for (Measurement& measurement : longOnes()) {
            both.push_back(std::move(measurement));
        }
        return both;
    }();
    return all;
}

Table benchmarkRows(const std::string& json, const std::vector<std::pair<std::string, std::string>>& counters) {
    Table table;
    table.head = {"", "wall", "of the processors"};
    for (const auto& [key, head] : counters) {
        table.head.push_back(head);
    }
    const Json output = Json::parse(json);
    for (const Json& made : output.at("benchmarks")) {
        const std::string unit = " " + made.at("time_unit").get<std::string>();
        const std::string label = made.value("label", std::string());
        std::vector<std::string> row{label.empty() ? plainName(made.at("name").get<std::string>()) : label,
                                     cell(made, "real_time") + unit, cell(made, "cpu_time") + unit};
        for (const auto& [key, head] : counters) {
            row.push_back(cell(made, key));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table benchmarkGrid(const std::string& json, const std::string& ours, const std::string& other) {
    const Json output = Json::parse(json);
    std::vector<std::string> rows, columns;
    std::map<std::pair<std::string, std::string>, double> times;
    const auto note = [](std::vector<std::string>& names, const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            names.push_back(name);
        }
    };
    for (const Json& made : output.at("benchmarks")) {
        const std::string name = plainName(made.at("name").get<std::string>());
        const std::size_t colon = name.find(": ");
        if (colon == std::string::npos || made.at("time_unit") != "ms") {
            throw std::runtime_error("\"" + name + "\" is no benchmark of a row and a column in ms");
        }
        note(rows, name.substr(0, colon));
        note(columns, name.substr(colon + 2));
        times[{name.substr(0, colon), name.substr(colon + 2)}] = made.at("cpu_time").get<double>();
    }
    const auto timeOf = [&](const std::string& row, const std::string& column) {
        const auto found = times.find({row, column});
        return found == times.end() ? std::nan("") : found->second;
    };
    Table table{{""}, {}};
    table.head.insert(table.head.end(), columns.begin(), columns.end());
    table.head.push_back(other + " over " + ours);
    for (const std::string& row : rows) {
        std::vector<std::string>& cells = table.rows.emplace_back(1, row);
        for (const std::string& column : columns) {
            cells.push_back(figure(timeOf(row, column)));
        }
        cells.push_back(figure(timeOf(row, other) / timeOf(row, ours)));
    }
    return table;
}

Table accuracyRows(const std::string& json) {
    const Json report = Json::parse(json);
    Table table;
    table.head = {"setting",       "bodies",         "mass-map difference",      "core IoU", "footprint IoU",          "run-out, m",
                  "height RMS, m", "mean height, m", "within 0.1 / 0.2 / 0.3 m", "wall, s",  "ms a step: mean, worst", "live FPS"};
    const Json details = report.value("details", Json::array());
    for (const Json& point : report.at("points")) {
        std::string map = fixed(point, "mass_map_difference", 3), core = fixed(point, "core_iou", 3);
        for (const Json& detail : details) {
            if (detail.value("setting", std::string()) != point.at("setting").get<std::string>()) {
                continue;
            }
            for (const Json& repeat : detail.value("repeats", Json::array())) {
                map += " (" + fixed(repeat, "mass_map_difference", 3) + ")";
                core += " (" + fixed(repeat, "core_iou", 3) + ")";
            }
        }
        const std::string worst = cell(point, "ms_per_step_worst");
        table.rows.push_back(
            {point.at("setting").get<std::string>(), cell(point, "bodies"), map, core, fixed(point, "footprint_iou", 3),
             fixed(point, "runout95_error_m", 2), fixed(point, "height_rms_m", 2), fixed(point, "mean_height_error_m", 2),
             fixed(point, "accuracy_0_1m", 2, 100.0) + " / " + fixed(point, "accuracy_0_2m", 2, 100.0) + " / " +
                 fixed(point, "accuracy_0_3m", 2, 100.0) + " %",
             cell(point, "wall_s"), worst.empty() ? worst : cell(point, "ms_per_step_mean") + ", " + worst, cell(point, "fps")});
    }
    return table;
}

Table runRows(const std::vector<std::string>& labels, const std::vector<std::string>& outputs) {
    Table table;
    table.head = {"",           "bodies",           "real-time factor", "ms a step, mean",
                  "95 % below", "steps in time, %", "simulation, s",    "trajectory"};
    const std::size_t times = outputs.size() / labels.size();
    for (std::size_t i = 0; i < labels.size(); ++i) {
        std::vector<double> factors, means, highs, shares, walls;
        Json last;
        for (std::size_t k = 0; k < times; ++k) {
            last = Json::parse(outputs.at(i * times + k));
            factors.push_back(last.at("real_time_factor").get<double>());
            means.push_back(last.at("ms_per_step").at("mean").get<double>());
            highs.push_back(last.at("ms_per_step").at("p95").get<double>());
            shares.push_back(100.0 * last.at("share_of_steps_in_time").get<double>());
            walls.push_back(last.at("wall_s").at("simulation").get<double>());
        }
        table.rows.push_back({labels[i], cell(last, "bodies_peak"), bestAndWorst(factors, true), bestAndWorst(means, false),
                              bestAndWorst(highs, false), bestAndWorst(shares, true), bestAndWorst(walls, false),
                              "`" + last.at("trajectory_hash").get<std::string>().substr(0, 8) + "`"});
    }
    return table;
}

Table startRows(const std::vector<std::string>& outputs) {
    const std::vector<std::pair<std::string, nlohmann::json::json_pointer>> quantities{
        {"first window, s", Json::json_pointer("/first_window_s")},
        {"first picture of the file, s", Json::json_pointer("/first_picture_s")},
        {"fragments and clusters ready behind it, s", Json::json_pointer("/prepared_s")},
        {"scrub to a state in the cache, median, ms", Json::json_pointer("/scrub_again/median_ms")},
        {"scrub to another state, 95 % below, ms", Json::json_pointer("/scrub_first_visit/p95_ms")},
        {"memory at most, MiB", Json::json_pointer("/memory_peak_mib")}};
    std::vector<Json> starts;
    for (const std::string& output : outputs) {
        starts.push_back(Json::parse(output));
    }
    Table table{{"", "best", "median", "worst"}, {}};
    for (const auto& [label, place] : quantities) {
        std::vector<double> values;
        for (const Json& start : starts) {
            values.push_back(start.at(place).get<double>());
        }
        std::sort(values.begin(), values.end());
        const std::size_t half = values.size() / 2;
        const double median = values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
        table.rows.push_back({label, figure(values.front()), figure(median), figure(values.back())});
    }
    return table;
}

Table distanceRows(const std::string& output) {
    const std::size_t line = output.find('\n');
    if (line == std::string::npos) {
        throw std::runtime_error("neither seconds nor distances were printed");
    }
    const double seconds = std::stod(output.substr(0, line));
    const Json compared = Json::parse(output.substr(line));
    const double points = compared.at("first").at("points_near").get<double>();
    return {{"points", "s", "s for 10 million", "core points", "measured"},
            {{figure(points), figure(seconds), figure(1e7 * seconds / points), cell(compared.at("cores"), "points"),
              cell(compared.at("states"), "measured")}}};
}

Table scaleRows(const std::string& output) {
    constexpr std::size_t width = 30;  // of the first column, see bench/scale.cpp
    Table table;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        const bool isHead = line.starts_with("stage ");
        if (!isHead && table.head.empty()) {
            continue;
        }
        std::string label = line.substr(0, width);
        label.erase(label.find_last_not_of(' ') + 1);
        std::vector<std::string> row{label};
        std::istringstream rest(line.substr(std::min(width, line.size())));
        if (isHead) {
            table.head = {label, "1x, s", "3x, s", "10x, s", "10x to 1x", "1x, MiB", "3x, MiB", "10x, MiB"};
            continue;
        }
        for (std::string word; rest >> word;) {
            row.push_back(word);
        }
        table.rows.push_back(std::move(row));
    }
    if (table.rows.empty()) {
        throw std::runtime_error("no table of sizes was printed");
    }
    return table;
}

}  // namespace rubble::bench
