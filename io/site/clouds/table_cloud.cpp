#include "io/site/clouds/table_cloud.h"

#include <algorithm>
#include <array>

#include "io/base/delimited_table.h"
#include "io/base/file_words.h"
#include "io/base/files.h"
#include "io/site/clouds/scans/ptx_source.h"
#include "io/site/clouds/text_source.h"

namespace rubble::io {

namespace {

/// Lines that tell how a table is written.
constexpr std::size_t startLines = 1000;

bool isWhole(const DelimitedRow& row) {
    return row.fields.size() == 1 && wholeNumberIn(row.fields.front()).value_or(-1) >= 0;
}

bool isNumbers(const DelimitedTable& table, const DelimitedRow& row) {
    return std::all_of(row.fields.begin(), row.fields.end(), [&](const std::string& field) {
        return table.numberIn(field).has_value() || field == "nan" || field == "NaN";
    });
}

[[noreturn]] void refuseTable(const std::string& path) {
    refuseContent({"cloud.unknown", "{0} is no point cloud that can be read", {path}},
                  "Give a LAS, LAZ, E57, PLY, PCD, PTX or PTS, or a table of text with columns x, y and z.");
}

/// Throws ParseError unless the start of a file is text. @return where its first line begins, behind the mark of UTF-8
std::uint64_t requireText(const CloudFile& file) {
    std::vector<unsigned char> start(std::size_t{1} << 16);
    start.resize(file.readSome(0, start.data(), start.size()));
    const bool control =
        std::any_of(start.begin(), start.end(), [](unsigned char c) { return c < 32 && c != '\n' && c != '\r' && c != '\t'; });
    const bool lines = start.size() < std::size_t{1} << 16 || std::find(start.begin(), start.end(), '\n') != start.end();
    if (control || !lines) {
        refuseTable(file.path());
    }
    constexpr std::array<unsigned char, 3> mark{0xef, 0xbb, 0xbf};
    return std::equal(mark.begin(), mark.end(), start.begin(), start.begin() + std::min<std::ptrdiff_t>(3, std::ssize(start))) ? 3
                                                                                                                               : 0;
}

/// A PTS: how many points follow, then the points with intensity and colour.
std::unique_ptr<CloudSource> openPts(std::shared_ptr<const CloudFile> file, std::size_t columns) {
    CloudHead head;
    head.format = "PTS";
    head.coding = "text";
    TextPoints points;
    const bool bright = columns == 4 || columns >= 7;
    std::vector<std::string_view> names{"x", "y", "z"};
    if (bright) {
        names.emplace_back("intensity");
    }
    if (columns >= 6) {
        names.insert(names.end(), {"red", "green", "blue"});
    }
    for (const std::string_view name : names) {
        points.plan.add(columnRole(name), name);
    }
    points.countsBetween = true;
    points.plan.describe(head);
    return textCloud(std::move(file), 0, std::move(points), std::move(head), {});
}

ColumnPlan planAsked(const CloudRequest& request) {
    ColumnPlan plan;
    for (const std::string& name : request.columns) {
        const ColumnRole role = columnRole(name);
        if (role == ColumnRole::Unread && name != "skip") {
            throw UsageError(
                {"cloud.column_unknown", "\"{0}\" is no column of a point cloud", {name}},
                {"cloud.column_unknown.remedy",
                 "Give x, y, z and what there is of intensity, red, green, blue, class, return, returns, time; skip for others.",
                 {}});
        }
        plan.add(role, name);
    }
    if (!plan.hasPlaces()) {
        throw UsageError({"cloud.columns_without_place", "The columns do not name x, y and z", {}},
                         {"cloud.columns_without_place.remedy", "Name each column in its order, such as x,y,z,intensity.", {}});
    }
    return plan;
}

/// Whether the first line is no point by the columns that were asked for.
bool isHeading(const DelimitedTable& table, const ColumnPlan& plan) {
    const std::vector<std::string>& fields = table.rows.front().fields;
    for (std::size_t c = 0; c < std::min(plan.size(), fields.size()); ++c) {
        const bool place = plan.role(c) >= ColumnRole::X && plan.role(c) <= ColumnRole::Z;
        if (place && !fieldNumberIn(fields[c], {table.separator, table.decimalComma})) {
            return true;
        }
    }
    return false;
}

/// The fields of a heading; a unit in brackets behind a blank belongs to what stands before it.
std::vector<std::string> headingFields(const DelimitedTable& table) {
    std::vector<std::string> fields;
    for (const std::string& field : table.rows.front().fields) {
        if (table.separator == ' ' && !fields.empty() && (field.starts_with('(') || field.starts_with('['))) {
            fields.back() += ' ' + field;
        } else {
            fields.push_back(field);
        }
    }
    return fields;
}

/// Takes the unit of a coordinate. Throws ParseError where x and y have different ones.
void takeUnit(const std::string& path, const ColumnHeading& column, CloudHead& head) {
    std::optional<double>& metres = column.role == ColumnRole::Z ? head.heightMetres : head.planMetres;
    if (metres && column.metres && *metres != *column.metres) {
        refuseContent({"cloud.units_of_plan", "{0}: its headings name different units for x and y", {path}},
                      "Bring both to one unit.");
    }
    metres = column.metres ? column.metres : metres;
}

/// The units that a heading names for columns that were asked for, whatever it calls them.
void takeUnitsOfHeading(const std::string& path, const DelimitedTable& table, bool heading, const ColumnPlan& plan,
                        CloudHead& head) {
    const std::vector<std::string> fields = heading ? headingFields(table) : std::vector<std::string>();
    for (std::size_t c = 0; c < std::min(fields.size(), plan.size()); ++c) {
        ColumnHeading column = columnHeading(path, fields[c]);
        column.role = plan.role(c);
        if (column.metres && column.role >= ColumnRole::X && column.role <= ColumnRole::Z) {
            takeUnit(path, column, head);
        }
    }
}

/// The columns of a table by its heading, or the first three of one without.
ColumnPlan planFound(const std::string& path, const DelimitedTable& table, bool heading, CloudHead& head, Findings& findings) {
    ColumnPlan plan;
    const std::vector<std::string> fields = headingFields(table);
    for (std::size_t c = 0; c < fields.size(); ++c) {
        if (heading) {
            const ColumnHeading column = columnHeading(path, fields[c]);
            if (!plan.has(column.role)) {
                takeUnit(path, column, head);
            }
            plan.add(column.role, fields[c]);
        } else {
            constexpr std::array<ColumnRole, 3> places{ColumnRole::X, ColumnRole::Y, ColumnRole::Z};
            plan.add(c < places.size() ? places[c] : ColumnRole::Unread, "column " + std::to_string(c + 1));
        }
    }
    if (!plan.hasPlaces()) {
        refuseTable(path);
    }
    if (!heading) {
        addFinding(findings, path,
                   {"cloud.columns_assumed", "no heading names the columns; the first three are taken as x, y and z", {}},
                   "state the columns, such as x,y,z,intensity");
    }
    return plan;
}

/// Greatest step of any colour in the first rows, and whether there are steps between whole ones.
struct ColourSteps {
    double most = 0.0;
    bool fractions = false;
};

ColourSteps colourStepsOf(const DelimitedTable& table, const ColumnPlan& plan) {
    ColourSteps steps;
    for (const DelimitedRow& row : table.rows) {
        for (std::size_t c = 0; c < std::min(plan.size(), row.fields.size()); ++c) {
            if (plan.role(c) >= ColumnRole::Red && plan.role(c) <= ColumnRole::Blue) {
                const double step = table.numberIn(row.fields[c]).value_or(0.0);
                steps.fractions = steps.fractions || (step > 0.0 && step < 1.0);
                steps.most = std::max(steps.most, step);
            }
        }
    }
    return steps;
}

}  // namespace

std::unique_ptr<CloudSource> openTextCloud(const std::string& path, const CloudRequest& request) {
    auto file = std::make_shared<CloudFile>(path);
    if (hasEnding(path, ".dxf")) {
        refuseContent({"cloud.drawing", "{0} is a drawing, no point cloud", {path}},
                      "Add it to the evidence as measured points, or cut a section through them (rubble-cli section --points).");
    }
    const std::uint64_t start = requireText(*file);
    const DelimitedTable table = readDelimitedStart(path, startLines);
    if (table.rows.empty()) {
        refuseTable(path);
    }
    if (table.rows.size() > 1 && isWhole(table.rows[0])) {
        if (isWhole(table.rows[1])) {
            return openPtx(path);
        }
        return openPts(std::move(file), table.rows[1].fields.size());
    }
    CloudHead head;
    Findings findings;
    head.format = "table";
    head.coding = table.separator == ' ' ? "parted by blanks" : std::string("parted by \"") + table.separator + "\"";
    TextPoints points;
    bool heading = !isNumbers(table, table.rows.front());
    if (request.columns.empty()) {
        points.plan = planFound(path, table, heading, head, findings);
    } else {
        points.plan = planAsked(request);
        heading = isHeading(table, points.plan);
        takeUnitsOfHeading(path, table, heading, points.plan, head);
    }
    points.plan.describe(head);
    points.form = {table.separator, table.decimalComma};
    const ColourSteps steps = colourStepsOf(table, points.plan);
    points.colourScale = steps.fractions && steps.most <= 1.0 ? 255.0 : 1.0;
    head.fullColour = steps.most > 255.0 ? 65535.0 : 255.0;
    points.skipped = heading ? table.rows.front().line : 0;
    return textCloud(std::move(file), start, std::move(points), std::move(head), std::move(findings));
}

}  // namespace rubble::io
