#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/frame/command.h"

namespace rubble::cli {

/// The words after a command, checked against its row of the table.
class Arguments {
public:
    /// Throws UsageError for an unknown option, a missing or surplus value, a repeated single option, and a missing or surplus
    /// operand. Nothing is missing once --help is among the words.
    Arguments(const Command& command, std::span<const std::string> words);

    const Command& command() const { return *m_command; }
    const std::string& operand() const { return operand(0); }
    /// Of a command that takes several.
    const std::string& operand(std::size_t i) const {
        static const std::string none;
        return i < m_operands.size() ? m_operands[i] : none;
    }
    bool has(std::string_view option) const { return m_values.contains(option); }
    /// Value of an option that was given at most once.
    std::optional<std::string> value(std::string_view option) const;
    /// Values of a repeated option in the order given.
    std::vector<std::string> values(std::string_view option) const;
    bool json() const { return has("--json"); }

private:
    const Option& findOption(std::string_view name) const;
    void takeOperand(const std::string& word);
    /// Takes the option at words[i]; returns the index of the last word it used.
    std::size_t takeOption(std::span<const std::string> words, std::size_t i);

    const Command* m_command;
    std::vector<std::string> m_operands;
    std::map<std::string, std::vector<std::string>, std::less<>> m_values;
};

/// Splits "KEY=VALUE". Throws UsageError naming the option if there is no "=" or nothing before it.
std::pair<std::string, std::string> splitAssignment(std::string_view option, const std::string& text);

}  // namespace rubble::cli
