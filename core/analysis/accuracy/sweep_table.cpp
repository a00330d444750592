#include "core/analysis/accuracy/sweep_table.h"

#include <algorithm>

#include "core/base/csv_text.h"
#include "core/base/unknown.h"

namespace rubble {

namespace {

SweepRow rowOf(const AccuracyPoint& point) {
    return {point.setting, point.multiple, point.grid, point.fragments, point.bodies, &point.difference, point.cost};
}

template <Measure measure>
double measured(const SweepRow& row) {
    return row.difference->of(measure);
}

}  // namespace

std::vector<SweepRow> sweepRows(const AccuracyReport& report) {
    std::vector<SweepRow> rows;
    if (report.reference.done) {
        rows.push_back(rowOf(report.reference));
    }
    if (report.floor && !report.floor->repeats.empty()) {
        SweepRow floor;
        floor.multiple.fill(unknown);
        floor.grid.fill(unknown);
        floor.setting = std::string(floorSetting);
        floor.fragments = report.reference.fragments;
        floor.bodies = report.reference.bodies;
        floor.difference = &report.floor->largest;
        rows.push_back(std::move(floor));
    }
    for (const AccuracyPoint& point : report.points) {
        if (point.done) {
            rows.push_back(rowOf(point));
        }
    }
    return rows;
}

const std::vector<SweepColumn>& sweepColumns() {
    static const std::vector<SweepColumn> columns{
        {"multiple_x", [](const SweepRow& r) { return r.multiple[0]; }},
        {"multiple_y", [](const SweepRow& r) { return r.multiple[1]; }},
        {"multiple_z", [](const SweepRow& r) { return r.multiple[2]; }},
        {"grid_l_m", [](const SweepRow& r) { return r.grid[0]; }},
        {"grid_w_m", [](const SweepRow& r) { return r.grid[1]; }},
        {"grid_h_m", [](const SweepRow& r) { return r.grid[2]; }},
        {"fragments", [](const SweepRow& r) { return static_cast<double>(r.fragments); }, true},
        {"bodies", [](const SweepRow& r) { return static_cast<double>(r.bodies); }, true},
        {"accuracy_0_1m", [](const SweepRow& r) { return publishedRate(*r.difference, 0); }},
        {"accuracy_0_2m", [](const SweepRow& r) { return publishedRate(*r.difference, 1); }},
        {"accuracy_0_3m", [](const SweepRow& r) { return publishedRate(*r.difference, 2); }},
        {"mass_map_difference", measured<Measure::MassMap>},
        {"core_iou", measured<Measure::CoreIou>},
        {"footprint_iou", measured<Measure::FootprintIou>},
        {"runout95_error_m", measured<Measure::RunOut>},
        {"height_rms_m", measured<Measure::HeightRms>},
        {"mean_height_error_m", measured<Measure::MeanHeight>},
        {"centroid_shift_m", measured<Measure::CentroidShift>},
        {"wall_s", [](const SweepRow& r) { return r.cost.wallSeconds; }},
        {"ms_per_step_mean", [](const SweepRow& r) { return r.cost.stepMeanMs; }},
        {"ms_per_step_worst", [](const SweepRow& r) { return r.cost.stepWorstMs; }},
        {"fps", [](const SweepRow& r) { return r.cost.fps; }},
    };
    return columns;
}

void writeSweepCsv(const AccuracyReport& report, std::ostream& out) {
    out << "setting";
    for (const SweepColumn& column : sweepColumns()) {
        out << ',' << column.key;
    }
    out << '\n';
    for (const SweepRow& row : sweepRows(report)) {
        out << csvField(row.setting);
        for (const SweepColumn& column : sweepColumns()) {
            const double value = column.value(row);
            out << ',' << (column.whole ? std::to_string(static_cast<std::int64_t>(value)) : exactNumber(value));
        }
        out << '\n';
    }
}

double publishedRate(const DebrisDifference& difference, std::size_t number) {
    const auto found = std::find(difference.tolerances.begin(), difference.tolerances.end(), publishedTolerances[number]);
    const auto index = static_cast<std::size_t>(found - difference.tolerances.begin());
    return index < difference.accuracy.size() ? difference.accuracy[index] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace rubble
