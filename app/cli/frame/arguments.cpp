#include "app/cli/frame/arguments.h"

#include <algorithm>

#include "core/base/error.h"

namespace rubble::cli {

namespace {

Message seeHelp(const Command& command) {
    return {"cli.see_help", "See rubble-cli {0} --help.", {command.name}};
}

/// "CASE...": one or more.
bool takesMany(const Command& command) {
    return command.operand.ends_with("...");
}

std::size_t operandCount(const Command& command) {
    const auto blanks = std::count(command.operand.begin(), command.operand.end(), ' ');
    return command.operand.empty() ? 0 : static_cast<std::size_t>(blanks) + 1;
}

/// Those in brackets may be missing.
std::size_t operandsNeeded(const Command& command) {
    const auto optional = std::count(command.operand.begin(), command.operand.end(), '[');
    return operandCount(command) - static_cast<std::size_t>(optional);
}

}  // namespace

Arguments::Arguments(const Command& command, std::span<const std::string> words) : m_command(&command) {
    bool optionsEnded = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!optionsEnded && words[i] == "--") {
            optionsEnded = true;
        } else if (!optionsEnded && words[i].size() > 1 && words[i].front() == '-') {
            i = takeOption(words, i);
        } else {
            takeOperand(words[i]);
        }
    }
    // Help, and lists of what a command knows, need no file.
    if (m_operands.size() < operandsNeeded(command) && !has("--help") && !has("--list")) {
        throw UsageError({"cli.operand_missing", "rubble-cli {0} needs a file: {1}.", {command.name, command.operand}},
                         seeHelp(command));
    }
}

std::optional<std::string> Arguments::value(std::string_view option) const {
    const auto found = m_values.find(option);
    return found == m_values.end() ? std::nullopt : std::optional(found->second.front());
}

std::vector<std::string> Arguments::values(std::string_view option) const {
    const auto found = m_values.find(option);
    return found == m_values.end() ? std::vector<std::string>{} : found->second;
}

const Option& Arguments::findOption(std::string_view name) const {
    for (const Option& option : m_command->options) {
        if (option.name == name) {
            return option;
        }
    }
    throw UsageError({"cli.unknown_option", "rubble-cli {0} has no option {1}.", {m_command->name, name}}, seeHelp(*m_command));
}

void Arguments::takeOperand(const std::string& word) {
    if (m_operands.size() >= operandCount(*m_command) && !takesMany(*m_command)) {
        throw UsageError({"cli.operand_surplus", "rubble-cli {0} cannot use \"{1}\" here.", {m_command->name, word}},
                         seeHelp(*m_command));
    }
    if (word.empty()) {
        throw UsageError({"cli.operand_empty", "The name of the file is empty.", {}}, seeHelp(*m_command));
    }
    m_operands.push_back(word);
}

std::size_t Arguments::takeOption(std::span<const std::string> words, std::size_t i) {
    const std::string_view word = words[i];
    const std::size_t equals = word.find('=');
    const Option& option = findOption(word.substr(0, equals));
    std::string value;
    if (option.value.empty()) {
        if (equals != std::string_view::npos) {
            throw UsageError({"cli.value_surplus", "The option {0} takes no value.", {option.name}}, seeHelp(*m_command));
        }
    } else if (equals != std::string_view::npos) {
        value = word.substr(equals + 1);
    } else if (i + 1 < words.size()) {
        value = words[++i];
    } else {
        throw UsageError({"cli.value_missing", "The option {0} needs a value: {1}.", {option.name, option.value}},
                         seeHelp(*m_command));
    }
    auto& values = m_values[std::string(option.name)];
    if (!values.empty() && !option.repeated && !option.value.empty()) {
        throw UsageError({"cli.option_twice", "The option {0} was given twice.", {option.name}}, seeHelp(*m_command));
    }
    values.push_back(std::move(value));
    return i;
}

std::pair<std::string, std::string> splitAssignment(std::string_view option, const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw UsageError({"cli.assignment", "{0} {1}: there is no \"=\" with a name before it.", {option, text}},
                         {"cli.assignment.remedy", "Write {0} NAME=VALUE.", {option}});
    }
    return {text.substr(0, equals), text.substr(equals + 1)};
}

}  // namespace rubble::cli
