#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/results_page.h"

namespace rubble::bench {

/// A table of a measurement: commands, how often each is run, and what becomes of what they print.
struct TableOrder {
    /// For a shell at the root of the source tree that finds the programs of the build; $TMPDIR is a folder for what they keep.
    std::vector<std::string> commands;
    int times = 1;
    /// Makes the table of the standard outputs, those of one command after those of the other. Throws nlohmann::json::exception or
    /// std::exception if they are not what the commands print.
    std::function<Table(const std::vector<std::string>& outputs)> read;
};

/// A row of the list of what is measured.
struct Measurement {
    std::string name;  ///< for --only
    std::string title;
    std::string about;
    double minutes = 0.0;     ///< about, on two quiet cores
    bool onlyByName = false;  ///< too long to be measured without being asked for
    std::vector<TableOrder> tables;
};

/// Everything that the page holds, in its order.
const std::vector<Measurement>& measurements();

/// Benchmarks as rows: name, wall time and time of the processor in the unit of the benchmark, and these counters, as key and head
/// of the column. A counter that a benchmark does not have leaves its cell empty.
Table benchmarkRows(const std::string& json, const std::vector<std::pair<std::string, std::string>>& counters = {});

/// Benchmarks that are named "ROW: COLUMN" as a table of processor times, ms, with how often `other` takes as long as `ours`.
Table benchmarkGrid(const std::string& json, const std::string& ours, const std::string& other);

/// The points of `rubble-cli accuracy --json` as rows, the floor after the reference.
Table accuracyRows(const std::string& json);

/// Runs of `rubble-cli run --json` as rows, as many outputs a row as `labels` fit into them; best and worst where they differ.
Table runRows(const std::vector<std::string>& labels, const std::vector<std::string>& outputs);

/// Starts of `rubble --measure`: best, median and worst.
Table startRows(const std::vector<std::string>& outputs);

/// Distances of `rubble-cli cloud --against RUN --json`, behind a line with the seconds that they took.
/// Throws std::runtime_error if there is no such line.
Table distanceRows(const std::string& output);

/// The table that `rubble-bench scale` prints.
Table scaleRows(const std::string& output);

}  // namespace rubble::bench
