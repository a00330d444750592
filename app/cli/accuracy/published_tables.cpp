#include "app/cli/accuracy/published_tables.h"

#include <algorithm>

#include "app/cli/frame/measure_output.h"
#include "core/analysis/accuracy/published_results.h"
#include "core/analysis/accuracy/sweep_table.h"

namespace rubble::cli {

namespace {

/// One case of either table.
struct CaseRow {
    std::string name;
    std::int64_t elements = 0;
    std::int64_t fragments = 0;
    double fpsWithout = 0.0;
    std::int64_t clusters = 0;
    double fpsWith = 0.0;
    std::array<double, 3> rates{};
};

std::vector<CaseRow> casesOf(const AccuracyReport& report) {
    std::vector<CaseRow> rows;
    for (const AccuracyPoint& point : report.points) {
        if (!point.done) {
            continue;
        }
        CaseRow row{point.setting, report.elements, point.fragments, report.reference.cost.fps, point.bodies, point.cost.fps, {}};
        for (std::size_t k = 0; k < row.rates.size(); ++k) {
            row.rates[k] = publishedRate(point.difference, k);
        }
        rows.push_back(std::move(row));
    }
    for (const PublishedCase& printed : publishedCases) {
        rows.push_back({std::string(printed.name), printed.elements, printed.fragments, printed.fpsWithout, printed.clusters,
                        printed.fpsWith, printed.accuracyRates});
    }
    return rows;
}

}  // namespace

TextTable publishedFpsTable(const AccuracyReport& report) {
    TextTable table({{"case", ""}, {"elements", ""}, {"fragments", ""}, {"FPS without", ""}, {"clusters", ""}, {"FPS with", ""}});
    for (const CaseRow& row : casesOf(report)) {
        table.add({textCell(row.name), integerCell(row.elements), integerCell(row.fragments), numberCell(row.fpsWithout),
                   integerCell(row.clusters), numberCell(row.fpsWith)});
    }
    return table;
}

Json publishedFpsJson(const AccuracyReport& report) {
    Json list = Json::array();
    for (const CaseRow& row : casesOf(report)) {
        list.push_back({{"case", row.name},
                        {"elements", row.elements},
                        {"fragments", row.fragments},
                        {"fps_without", row.fpsWithout},
                        {"clusters", row.clusters},
                        {"fps_with", row.fpsWith}});
    }
    return list;
}

TextTable publishedAccuracyTable(const AccuracyReport& report) {
    TextTable table({{"case", ""}, {"within 0.3 m", ""}, {"within 0.2 m", ""}, {"within 0.1 m", ""}});
    const auto add = [&table](const std::string& name, const std::array<double, 3>& rates) {
        std::vector<Cell> cells{textCell(name)};
        for (std::size_t k = rates.size(); k-- > 0;) {
            cells.push_back({percentOrDash(rates[k]), "", true});
        }
        table.add(std::move(cells));
    };
    if (report.floor) {
        add("floor: the reference repeated", {publishedRate(report.floor->largest, 0), publishedRate(report.floor->largest, 1),
                                              publishedRate(report.floor->largest, 2)});
    }
    for (const CaseRow& row : casesOf(report)) {
        add(row.name, row.rates);
    }
    return table;
}

Json publishedAccuracyJson(const AccuracyReport& report) {
    Json list = Json::array();
    for (const CaseRow& row : casesOf(report)) {
        list.push_back({{"case", row.name},
                        {"accuracy_0_3m", row.rates[2]},
                        {"accuracy_0_2m", row.rates[1]},
                        {"accuracy_0_1m", row.rates[0]}});
    }
    return list;
}

}  // namespace rubble::cli
