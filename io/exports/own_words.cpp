#include "io/exports/own_words.h"

#include <array>
#include <set>
#include <sstream>
#include <utility>

#include "core/base/error.h"
#include "io/base/files.h"

namespace rubble::io {

namespace {

constexpr std::array<std::pair<std::string_view, std::string OwnWords::*>, 5> parts{{{"custody", &OwnWords::custody},
                                                                                     {"alternatives", &OwnWords::alternatives},
                                                                                     {"change", &OwnWords::change},
                                                                                     {"summary", &OwnWords::summary},
                                                                                     {"qualification", &OwnWords::qualification}}};

std::string trimmedEnds(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

[[noreturn]] void refuse(const std::string& path, std::size_t line, const std::string& found) {
    throw ParseError({"report.words", "{0}, line {1}: {2} is no part of what a report lets its author say", {path, line, found}},
                     {"report.words.remedy",
                      "Begin each part once, with text below: # custody, # alternatives, # change, # summary, # qualification.",
                      {}});
}

}  // namespace

OwnWords readOwnWords(const std::string& path) {
    const std::optional<std::string> content = contentOf(path);
    if (!content) {
        failToRead(path);
    }
    OwnWords words;
    std::string OwnWords::* part = nullptr;
    std::set<std::string> seen;
    std::istringstream lines(*content);
    std::size_t number = 0;
    std::size_t began = 0;
    const auto checkPart = [&] {
        if (part != nullptr && trimmedEnds(words.*part).empty()) {
            refuse(path, began, "a heading without text");
        }
    };
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (number == 1 && line.starts_with("\xEF\xBB\xBF")) {
            line.erase(0, 3);
        }
        if (line.starts_with("# ")) {
            checkPart();
            const std::string name = trimmedEnds(line.substr(2));
            part = nullptr;
            for (const auto& [known, member] : parts) {
                part = name == known ? member : part;
            }
            if (part == nullptr || !seen.insert(name).second) {
                refuse(path, number, "\"# " + name + "\"" + (part == nullptr ? "" : ", which is there already,"));
            }
            began = number;
        } else if (part != nullptr) {
            (words.*part) += line + '\n';
        } else if (!trimmedEnds(line).empty()) {
            refuse(path, number, "text before the first heading");
        }
    }
    checkPart();
    for (const auto& [known, member] : parts) {
        words.*member = trimmedEnds(words.*member);
    }
    return words;
}

}  // namespace rubble::io
