#include "io/fe/series/numbered_files.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <map>
#include <numeric>

#include "core/base/error.h"

namespace rubble::io {

namespace {

using Path = std::filesystem::path;

/// A name cut at a run of digits.
struct Numbered {
    std::string before, digits, after;
};

Numbered cutAtNumber(const std::string& name) {
    const std::string digits = "0123456789";
    const std::size_t dot = name.find_last_of('.');
    std::size_t last = dot == std::string::npos || dot == 0 ? std::string::npos : name.find_last_of(digits, dot - 1);
    if (name.find_last_not_of(digits) == dot && dot != std::string::npos && dot + 1 < name.size()) {
        last = name.size() - 1;
    } else if (last == std::string::npos || last + 1 != dot) {
        return {};
    }
    const std::size_t other = name.find_last_not_of(digits, last);
    const std::size_t first = other == std::string::npos ? 0 : other + 1;
    return {name.substr(0, first), name.substr(first, last + 1 - first), name.substr(last + 1)};
}

}  // namespace

std::vector<std::string> numberedSiblings(const std::string& path) {
    const Path file(path);
    const Numbered own = cutAtNumber(file.filename().string());
    if (own.digits.empty()) {
        return {path};
    }
    std::map<std::pair<std::uint64_t, std::size_t>, std::string> byNumber;
    const auto take = [&](const Path& candidate) {
        const Numbered cut = cutAtNumber(candidate.filename().string());
        std::uint64_t number = 0;
        const auto result = std::from_chars(cut.digits.data(), cut.digits.data() + cut.digits.size(), number);
        if (!cut.digits.empty() && result.ec == std::errc{} && cut.before == own.before && cut.after == own.after) {
            byNumber.emplace(std::pair(number, cut.digits.size()), candidate.string());
        }
    };
    for (const std::string& other : filesBeside(path)) {
        take(other);
    }
    take(file);
    std::vector<std::string> files;
    for (auto& [number, name] : byNumber) {
        files.push_back(std::move(name));
    }
    return files.empty() ? std::vector<std::string>{path} : files;
}

std::vector<NumberGap> numberGaps(const std::vector<std::string>& siblings) {
    std::vector<std::int64_t> numbers;
    for (const std::string& file : siblings) {
        const std::string digits = cutAtNumber(Path(file).filename().string()).digits;
        std::int64_t number = 0;
        if (std::from_chars(digits.data(), digits.data() + digits.size(), number).ec != std::errc{}) {
            return {};
        }
        numbers.push_back(number);
    }
    std::vector<std::int64_t> steps(numbers.size());
    std::adjacent_difference(numbers.begin(), numbers.end(), steps.begin());
    if (steps.size() < 4) {
        return {};
    }
    steps.erase(steps.begin());
    const std::int64_t step = *std::min_element(steps.begin(), steps.end());
    const auto regular = std::count(steps.begin(), steps.end(), step);
    std::vector<NumberGap> gaps;
    for (std::size_t i = 0; i < steps.size() && step > 0; ++i) {
        if (steps[i] % step != 0) {
            return {};
        }
        if (steps[i] != step) {
            gaps.push_back({siblings[i + 1], steps[i] / step - 1});
        }
    }
    return 2 * static_cast<std::size_t>(regular) > steps.size() ? gaps : std::vector<NumberGap>{};
}

void noteNumberGaps(const std::vector<std::string>& siblings, Findings& findings) {
    for (const NumberGap& gap : numberGaps(siblings)) {
        findings.add({"fe.gap", "Numbers are missing in the series; deaths are known less exactly there", {}},
                     {"fe.gap.remedy", "Copy the missing files beside the others.", {}},
                     "before " + Path(gap.before).filename().string(), gap.count);
    }
}

bool isEmptyFile(const std::string& path) {
    std::error_code error;
    return std::filesystem::file_size(path, error) == 0 && !error;
}

void requireNotEmpty(const std::string& path) {
    if (isEmptyFile(path)) {
        throw ParseError(
            {"fe.empty_state", "{0} is empty: its state is not there", {path}},
            {"fe.empty_state.remedy", "Copy it again, or take it away: the series is then read without this state.", {}});
    }
}

std::string takenForStates(const std::vector<std::string>& files) {
    constexpr std::size_t shown = 3;
    std::string names;
    for (std::size_t i = 0; i < std::min(files.size(), shown); ++i) {
        names += (i == 0 ? "" : ", ") + Path(files[i]).filename().string();
    }
    const auto count = static_cast<std::int64_t>(files.size());
    return files.size() > shown ? names + ", ... (" + englishInteger(count) + " files)" : names;
}

bool naturallyBefore(const std::string& a, const std::string& b) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (!isDigit(a[i]) || !isDigit(b[j])) {
            if (a[i] != b[j]) {
                return a[i] < b[j];
            }
            ++i;
            ++j;
            continue;
        }
        i = std::min(a.find_first_not_of('0', i), a.size());
        j = std::min(b.find_first_not_of('0', j), b.size());
        std::size_t p = i, q = j;
        for (; p < a.size() && isDigit(a[p]); ++p) {
        }
        for (; q < b.size() && isDigit(b[q]); ++q) {
        }
        if (p - i != q - j) {
            return p - i < q - j;
        }
        const int order = a.compare(i, p - i, b, j, q - j);
        if (order != 0) {
            return order < 0;
        }
        i = p;
        j = q;
    }
    return a.size() - i < b.size() - j;
}

std::string namedFile(const std::string& owner, const std::string& named) {
    std::string slashed = named;
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    const Path folder = Path(owner).parent_path();
    const Path there = folder / Path(named).lexically_normal();
    for (const Path& place : {there, folder / Path(slashed).lexically_normal(), folder / Path(slashed).filename()}) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(place, ignored)) {
            return place.string();
        }
    }
    return there.string();
}

std::vector<std::string> filesBeside(const std::string& path) {
    const Path parent = Path(path).parent_path();
    std::vector<std::string> files;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(parent.empty() ? Path(".") : parent, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored)) {
            files.push_back((parent / entry->path().filename()).string());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace rubble::io
