#include "core/base/nearest_names.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/base/message.h"

namespace rubble {

namespace {

// Longer names are compared by their beginning: the table grows with the product of the lengths.
constexpr std::size_t comparedLength = 200;

std::string lowerCase(std::string_view text) {
    std::string result(text.substr(0, comparedLength));
    for (char& c : result) {
        if (c >= 'A' && c <= 'Z') {
            c = static_cast<char>(c - 'A' + 'a');
        }
    }
    return result;
}

std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

}  // namespace

std::vector<std::string> nearestNames(std::string_view wanted, std::span<const std::string> names, std::size_t count) {
    const std::string key = lowerCase(wanted);
    std::vector<std::tuple<std::size_t, bool, std::size_t>> order;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string name = lowerCase(names[i]);
        const bool apart = key.empty() || name.find(key) == std::string::npos;
        order.emplace_back(editDistance(key, name), apart, i);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::string> result;
    for (std::size_t i = 0; i < std::min(count, order.size()); ++i) {
        result.push_back(names[std::get<2>(order[i])]);
    }
    return result;
}

std::string quotedList(std::span<const std::string> names, std::size_t count) {
    if (names.empty()) {
        return "none";
    }
    std::string result;
    for (std::size_t i = 0; i < std::min(count, names.size()); ++i) {
        result += (i ? ", \"" : "\"") + names[i] + "\"";
    }
    if (names.size() > count) {
        result += ", and " + englishInteger(static_cast<std::int64_t>(names.size() - count)) + " more";
    }
    return result;
}

}  // namespace rubble
