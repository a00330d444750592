#include "io/fe/exodus/exodus_files.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <optional>

#include "io/fe/series/numbered_files.h"

namespace rubble::io {

namespace {

namespace fs = std::filesystem;

constexpr int mostProcessors = 1'000'000;

std::optional<int> wholeNumber(const std::string& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    return digits && error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

// "out.e.4.2": processor 2 of 4.
void cutProcessors(ExodusName& name) {
    const std::size_t last = name.base.rfind('.');
    const std::size_t before = last == std::string::npos || last == 0 ? std::string::npos : name.base.rfind('.', last - 1);
    if (before == std::string::npos || before == 0) {
        return;
    }
    const auto processors = wholeNumber(name.base.substr(before + 1, last - before - 1));
    const auto processor = wholeNumber(name.base.substr(last + 1));
    if (processors && processor && *processors > 1 && *processors <= mostProcessors && *processor < *processors) {
        name.processors = *processors;
        name.processor = *processor;
        name.base.resize(before);
    }
}

// "out.e-s0003" is number 3 behind "out.e".
void cutNumber(ExodusName& name) {
    const std::size_t mark = name.base.rfind("-s");
    const auto number = mark == std::string::npos || mark == 0 ? std::nullopt : wholeNumber(name.base.substr(mark + 2));
    if (number && *number > 1) {
        name.number = *number;
        name.base.resize(mark);
    }
}

}  // namespace

ExodusName exodusName(const std::string& path) {
    ExodusName name;
    name.base = fs::path(path).filename().string();
    cutProcessors(name);
    cutNumber(name);
    return name;
}

std::vector<std::string> exodusSequence(const std::string& path) {
    const ExodusName own = exodusName(path);
    std::map<int, std::string> byNumber;
    for (const std::string& other : filesBeside(path)) {
        const ExodusName name = exodusName(other);
        if (name.base == own.base && name.processors == own.processors && name.processor == own.processor) {
            byNumber.emplace(name.number, other);
        }
    }
    std::vector<std::string> files;
    for (auto& [number, name] : byNumber) {
        files.push_back(std::move(name));
    }
    const bool known = std::find(files.begin(), files.end(), path) != files.end();
    return known ? files : std::vector<std::string>{path};
}

std::vector<std::vector<std::string>> exodusPieces(const std::string& path) {
    const ExodusName own = exodusName(path);
    std::vector<std::map<int, std::string>> byNumber(static_cast<std::size_t>(own.processors));
    for (const std::string& other : byNumber.empty() ? std::vector<std::string>{} : filesBeside(path)) {
        const ExodusName name = exodusName(other);
        if (name.base == own.base && name.processors == own.processors) {
            byNumber[static_cast<std::size_t>(name.processor)].emplace(name.number, other);
        }
    }
    std::vector<std::vector<std::string>> pieces;
    for (auto& sequence : byNumber) {
        std::vector<std::string>& files = pieces.emplace_back();
        for (auto& [number, name] : sequence) {
            files.push_back(std::move(name));
        }
    }
    return pieces;
}

std::string exodusPieceName(const std::string& path, int processor) {
    const ExodusName own = exodusName(path);
    const std::string name = fs::path(path).filename().string();
    const std::size_t width = name.size() - name.rfind('.') - 1;
    std::string digits = std::to_string(processor);
    digits.insert(0, width - std::min(width, digits.size()), '0');
    return own.base +
           name.substr(name.size() - width - std::to_string(own.processors).size() - 2, std::to_string(own.processors).size() + 2) +
           digits;
}

}  // namespace rubble::io
