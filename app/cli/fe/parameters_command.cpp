#include <cmath>

#include "app/cli/frame/arguments.h"
#include "app/cli/frame/commands.h"
#include "app/cli/frame/json_output.h"
#include "app/cli/frame/output_file.h"
#include "app/cli/frame/text_output.h"
#include "core/base/message.h"
#include "core/scenario/parameters.h"

namespace rubble::cli {

namespace {

std::string_view kindName(ParameterKind kind) {
    switch (kind) {
        case ParameterKind::Switch:
            return "switch";
        case ParameterKind::Integer:
            return "integer";
        case ParameterKind::Number:
            return "number";
        case ParameterKind::Choice:
            return "choice";
        case ParameterKind::Text:
            return "text";
    }
    return "";
}

std::string defaultText(const Parameter& row) {
    // A keyed row has no subject yet; any will do, since an unnamed one has the default.
    const std::string text = valueText(row.get(Scenario{}, row.keyed() ? "*" : ""));
    return text.empty() ? "\"\"" : text;
}

std::string rangeText(const Parameter& row) {
    if (row.kind == ParameterKind::Choice) {
        std::string text;
        for (const std::string_view choice : row.choices) {
            text += (text.empty() ? "" : " | ") + std::string(choice);
        }
        return text;
    }
    if (row.kind == ParameterKind::Switch) {
        return "true | false";
    }
    const bool low = std::isfinite(row.low);
    const bool high = std::isfinite(row.high);
    if (low && high) {
        return exactNumber(row.low) + " .. " + exactNumber(row.high);
    }
    return low ? ">= " + exactNumber(row.low) : high ? "<= " + exactNumber(row.high) : "";
}

TextTable parameterTextTable() {
    TextTable table({{"parameter", "key"},
                     {"unit", "unit"},
                     {"default", "default"},
                     {"range", "range"},
                     {"stage", "stage"},
                     {"what it does", "help"}});
    for (const Parameter& row : parameterTable()) {
        table.add({textCell(std::string(row.key)), textCell(std::string(row.unit)), textCell(defaultText(row)),
                   textCell(rangeText(row) + (row.automatic ? " | auto" : "")), textCell(std::string(stageName(row.stage))),
                   textCell(std::string(row.help))});
    }
    return table;
}

Json parametersJson() {
    Json object;
    object["parameters"] = Json::array();
    for (const Parameter& row : parameterTable()) {
        Json entry;
        entry["key"] = row.key;
        entry["kind"] = kindName(row.kind);
        entry["unit"] = row.unit;
        entry["default"] = defaultText(row);
        entry["automatic"] = row.automatic;
        entry["low"] = row.low;
        entry["high"] = row.high;
        entry["choices"] = row.choices;
        entry["stage"] = stageName(row.stage);
        entry["label"] = row.label;
        entry["help"] = row.help;
        object["parameters"].push_back(std::move(entry));
    }
    object["presets"] = Json::array();
    for (const std::string_view name : presetNames()) {
        object["presets"].push_back(name);
    }
    return object;
}

/// Entries one under another: the help texts are too long for a table on a terminal.
void printParameters(std::ostream& out) {
    std::string_view stage;
    for (const Parameter& row : parameterTable()) {
        if (stageName(row.stage) != stage) {
            stage = stageName(row.stage);
            printHeading(out, "Stage: " + std::string(stage));
        }
        out << "  " << row.key << " = " << defaultText(row);
        if (!row.unit.empty()) {
            out << " [" << row.unit << ']';
        }
        const std::string range = rangeText(row);
        if (!range.empty() || row.automatic) {
            out << "   (" << range << (row.automatic ? (range.empty() ? "auto" : " | auto") : "") << ')';
        }
        out << "\n      " << row.help << '\n';
    }
    out << "\nPresets (--set preset=NAME):";
    for (const std::string_view name : presetNames()) {
        out << ' ' << name;
    }
    out << '\n';
}

ExitCode parameters(const Arguments& arguments, Session& session) {
    checkCsvPath(arguments, {});
    writeCsv(arguments, parameterTextTable());
    if (arguments.json()) {
        printJson(session, parametersJson());
    } else {
        printParameters(session.out());
    }
    return ExitCode::Ok;
}

}  // namespace

Command parametersCommand() {
    return {"parameters",
            "",
            "every parameter that --set takes, with its range and default",
            "Lists the parameter table: key, default, unit, range, the stage that reads it, and what it does.",
            {csvOption("write the table of parameters")},
            parameters};
}

}  // namespace rubble::cli
