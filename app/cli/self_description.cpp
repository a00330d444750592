#include "app/cli/self_description.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "app/cli/exports/export_request.h"
#include "app/cli/frame/commands.h"
#include "core/base/help/bash_completion.h"
#include "core/base/help/man_page.h"
#include "core/scenario/parameters.h"

namespace rubble::cli {

namespace {

constexpr std::string_view program = "rubble-cli";

/// "on|off" as its parts; names of things to fill in (FE|CASE) have none.
std::vector<std::string> alternatives(std::string_view value) {
    const bool literal = std::all_of(value.begin(), value.end(), [](unsigned char c) { return std::isupper(c) == 0; });
    std::vector<std::string> parts;
    while (literal && value.find('|') != std::string_view::npos) {
        parts.emplace_back(value.substr(0, value.find('|')));
        value.remove_prefix(value.find('|') + 1);
        if (value.find('|') == std::string_view::npos) {
            parts.emplace_back(value);
        }
    }
    return parts;
}

void completeParameters(CompletedOption& option) {
    for (const Parameter& row : parameterTable()) {
        const std::string key(row.key.substr(0, row.key.find('*')));
        const std::string word = row.keyed() ? key : key + '=';
        if (std::find(option.values.begin(), option.values.end(), word) == option.values.end()) {
            option.values.push_back(word);
        }
        std::vector<std::string> values(row.choices.begin(), row.choices.end());
        if (row.kind == ParameterKind::Switch) {
            values = {"true", "false"};
        }
        if (row.automatic) {
            values.emplace_back("auto");
        }
        if (!row.keyed()) {
            option.afterKey[key] = values;
        }
    }
    option.values.emplace_back("preset=");
    option.afterKey["preset"] = {presetNames().begin(), presetNames().end()};
}

CompletedOption completed(const Option& option) {
    CompletedOption row{std::string(option.name), !option.value.empty(), alternatives(option.value), {}};
    if (option.value == "KEY=VALUE") {
        completeParameters(row);
    } else if (option.value == "KIND=PATH") {
        for (const ExportKind& kind : exportKinds()) {
            row.values.push_back(std::string(kind.name) + '=');
        }
    }
    return row;
}

}  // namespace

std::string usageOf(const Command& command) {
    return std::string(program) + ' ' + std::string(command.name) + (command.operand.empty() ? "" : " ") +
           std::string(command.operand);
}

std::string manPageText() {
    ManPage page(program, "where the deactivated elements of a collapse go");
    page.section("SYNOPSIS");
    for (const Command& command : commandTable()) {
        page.paragraph(usageOf(command) + " [options]");
    }
    page.section("DESCRIPTION")
        .paragraph(
            "Reads a finished finite-element result of a collapse, turns every element that was deactivated into a rigid fragment, "
            "simulates where the fragments go and writes tables, maps, figures and run files. Every number comes from the "
            "functions "
            "that rubble(1) uses.")
        .paragraph(
            "FE is a finite-element result, CASE a case (*.rubble), RUN a recorded run (*.run.h5). A file is recognised by its "
            "content.")
        .section("COMMANDS");
    for (const Command& command : commandTable()) {
        page.subsection(usageOf(command)).paragraph(std::string(command.summary) + '.').paragraph(command.details);
        for (const Option& option : command.options) {
            page.item(std::string(option.name) + (option.value.empty() ? "" : " ") + std::string(option.value),
                      std::string(option.help) + (option.repeated ? " (may be repeated)" : ""));
        }
    }
    page.section("EXIT STATUS")
        .item("0", "done")
        .item("1", "failed: a file cannot be read or written, or its content is not what it should be")
        .item("2", "wrong usage")
        .item("3", "cancelled; what was simulated so far is kept");
    page.section("SEE ALSO").paragraph("rubble(1)");
    return page.text();
}

std::string completionText() {
    std::vector<CompletedCommand> commands;
    for (const Command& command : commandTable()) {
        CompletedCommand row{std::string(command.name), {}, alternatives(command.operand)};
        std::transform(command.options.begin(), command.options.end(), std::back_inserter(row.options), completed);
        commands.push_back(std::move(row));
    }
    return bashCompletion(std::string(program), commands, {"--help", "--version", "--man-page", "--completion"});
}

}  // namespace rubble::cli
