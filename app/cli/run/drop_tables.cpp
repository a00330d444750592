#include "app/cli/run/drop_tables.h"

#include <array>

#include "core/evidence/ensembles/ensemble.h"
#include "core/validation/drop_figures.h"

namespace rubble::cli {

namespace {

constexpr std::array allEndings{Ending::AtRest, Ending::Moving, Ending::Left, Ending::Lost, Ending::Refused};

/// Of all bodies that came to rest or still move; what left the terrain or was lost has no end.
FigureSpread figureSpread(const std::vector<DropRepeat>& repeats, const DropFigure& figure, const Vec3& zero) {
    std::vector<double> values;
    for (const DropRepeat& repeat : repeats) {
        for (const DropOutcome& body : repeat.result.bodies) {
            if (hasEnd(body)) {
                values.push_back(figure.of(body, zero));
            }
        }
    }
    return rubble::spreadOf(std::move(values));
}

void addPose(std::vector<Cell>& row, const Pose& pose, const Vec3& zero) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        row.push_back(numberCell(pose.position[axis] + zero[axis]));
    }
    const Quat& q = pose.orientation;
    for (const double part : {q.w(), q.x(), q.y(), q.z()}) {
        row.push_back(numberCell(part));
    }
}

}  // namespace

TextTable dropTable(const std::vector<DropRepeat>& repeats, const Vec3& zero) {
    std::vector<TextTable::Column> columns{{"id", "id"}, {"repeat", "repeat"}, {"ending", "ending"}};
    for (const char* key : {"from_x_m",  "from_y_m",  "from_z_m", "from_qw", "from_qx",  "from_qy",       "from_qz",
                            "end_x_m",   "end_y_m",   "end_z_m",  "end_qw",  "end_qx",   "end_qy",        "end_qz",
                            "run_out_m", "lateral_m", "fall_m",   "path_m",  "contacts", "top_speed_m_s", "moving_s"}) {
        columns.push_back({key, key});
    }
    TextTable table(std::move(columns));
    for (std::size_t r = 0; r < repeats.size(); ++r) {
        for (std::size_t i = 0; i < repeats[r].bodies.size(); ++i) {
            const LooseBody& body = repeats[r].bodies[i];
            const DropOutcome& outcome = repeats[r].result.bodies[i];
            std::vector<Cell> row{textCell(body.id), integerCell(static_cast<std::int64_t>(r)),
                                  textCell(std::string(endingName(outcome.ending)))};
            addPose(row, body.pose, zero);
            addPose(row, placed(body, outcome, outcome.trace.latest), zero);
            for (const DropFigure& figure : dropFigures().first(dropFiguresOfWay)) {
                row.push_back(numberCell(figure.of(outcome, zero)));
            }
            table.add(std::move(row));
        }
    }
    return table;
}

TextTable pathTable(const std::vector<DropRepeat>& repeats, const Vec3& zero) {
    std::vector<TextTable::Column> columns;
    for (const char* key : {"id", "repeat", "t_s", "x_m", "y_m", "z_m", "qw", "qx", "qy", "qz", "speed_m_s"}) {
        columns.push_back({key, key});
    }
    TextTable table(std::move(columns));
    for (std::size_t r = 0; r < repeats.size(); ++r) {
        for (std::size_t i = 0; i < repeats[r].bodies.size(); ++i) {
            const LooseBody& body = repeats[r].bodies[i];
            const DropOutcome& outcome = repeats[r].result.bodies[i];
            for (const TracePoint& point : outcome.trace.points) {
                std::vector<Cell> row{textCell(body.id), integerCell(static_cast<std::int64_t>(r)), numberCell(point.time)};
                addPose(row, placed(body, outcome, point.pose), zero);
                row.push_back(numberCell(point.speed));
                table.add(std::move(row));
            }
        }
    }
    return table;
}

std::string stepsText(const SimulationResult& simulation) {
    return englishNumber(simulation.stepRate) + " steps a second: " + englishText(simulation.stepRateReason);
}

TextTable dropSummary(const std::vector<DropRepeat>& repeats, const Vec3& zero) {
    TextTable table({{"figure", "figure"},
                     {"bodies", "bodies"},
                     {"mean", "mean"},
                     {"deviation", "deviation"},
                     {"5 %", "low"},
                     {"median", "median"},
                     {"95 %", "high"}});
    for (const DropFigure& figure : dropFigures()) {
        const FigureSpread spread = figureSpread(repeats, figure, zero);
        table.add({textCell(figure.title), integerCell(static_cast<std::int64_t>(spread.count)), numberCell(spread.mean),
                   numberCell(spread.deviation), numberCell(spread.low), numberCell(spread.middle), numberCell(spread.high)});
    }
    return table;
}

Json dropJson(const std::vector<DropRepeat>& repeats, const Vec3& zero) {
    Json object;
    object["bodies"] = repeats.empty() ? std::size_t{0} : repeats.front().bodies.size();
    object["repeats"] = repeats.size();
    Json ends;
    for (const Ending ending : allEndings) {
        std::int64_t count = 0;
        for (const DropRepeat& repeat : repeats) {
            count += repeat.result.count(ending);
        }
        ends[endingName(ending)] = count;
    }
    object["endings"] = std::move(ends);
    Json all;
    for (const DropFigure& figure : dropFigures()) {
        const FigureSpread spread = figureSpread(repeats, figure, zero);
        all[figure.key] = Json{{"mean", spread.mean},
                               {"deviation", spread.deviation},
                               {"low", spread.low},
                               {"median", spread.middle},
                               {"high", spread.high}};
    }
    object["figures"] = std::move(all);
    return object;
}

}  // namespace rubble::cli
