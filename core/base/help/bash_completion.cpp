#include "core/base/help/bash_completion.h"

namespace rubble {

namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : " ") + word;
    }
    return "'" + text + "'";
}

// bash takes "=" as a word of its own: --set key=value arrives as four words.
constexpr const char* head = R"(() {
    local current=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD-1]} key= words=
    COMPREPLY=()
    if [[ $current == = ]]; then
        key=$option current= option=${COMP_WORDS[COMP_CWORD-2]}
    elif [[ $option == = ]]; then
        key=${COMP_WORDS[COMP_CWORD-2]} option=${COMP_WORDS[COMP_CWORD-3]}
    fi
    if [[ $key == --* ]]; then
        option=$key key=
    fi
)";

constexpr const char* tail = R"(    COMPREPLY=($(compgen -W "$words" -- "$current"))
    if [[ ${#COMPREPLY[@]} -gt 0 && ${COMPREPLY[0]} == *[=\[] ]]; then
        compopt -o nospace 2>/dev/null
    fi
}
)";

void addOption(std::string& text, const std::string& command, const CompletedOption& option) {
    text += "        '" + command + " " + option.name + "')\n";
    if (!option.afterKey.empty()) {
        text += "            case $key in\n                '') words=" + joined(option.values) + " ;;\n";
        for (const auto& [key, values] : option.afterKey) {
            text += "                " + key + ") words=" + joined(values) + " ;;\n";
        }
        text += "            esac ;;\n";
    } else {
        text += "            [[ $key ]] || words=" + joined(option.values) + " ;;\n";
    }
}

}  // namespace

std::string bashCompletion(const std::string& program, const std::vector<CompletedCommand>& commands,
                           const std::vector<std::string>& options) {
    std::string function = "_" + program;
    for (char& c : function) {
        if (c == '-') {
            c = '_';
        }
    }
    std::string text = "# bash completion for " + program + "\n" + function + head;
    const bool named = !commands.empty() && !commands.front().name.empty();
    std::vector<std::string> first = options;
    if (named) {
        for (const CompletedCommand& command : commands) {
            first.push_back(command.name);
        }
        text += "    local command=${COMP_WORDS[1]}\n    if [[ $COMP_CWORD -eq 1 ]]; then\n        command=\n    fi\n";
    } else {
        text += "    local command=\n";
    }
    text += "    case \"$command $option\" in\n";
    for (const CompletedCommand& command : commands) {
        for (const CompletedOption& option : command.options) {
            if (option.takesValue) {
                addOption(text, command.name, option);
            }
        }
    }
    text += "        *)\n            case \"$command\" in\n";
    for (const CompletedCommand& command : commands) {
        std::vector<std::string> names = named ? std::vector<std::string>() : options;
        for (const CompletedOption& option : command.options) {
            names.push_back(option.name);
        }
        text += "                '" + command.name + "') [[ $current == -* ]] && words=" + joined(names) +
                " || words=" + joined(command.operands) + " ;;\n";
    }
    if (named) {
        text += "                '') words=" + joined(first) + " ;;\n";
    }
    return text + "            esac ;;\n    esac\n" + tail + "complete -o bashdefault -o default -F " + function + " " + program +
           "\n";
}

}  // namespace rubble
