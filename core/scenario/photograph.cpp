#include "core/scenario/photograph.h"

#include <charconv>
#include <chrono>
#include <cmath>

namespace rubble {

bool cropped(const PhotoFacts& facts) {
    if (!facts.recorded) {
        return false;
    }
    const double here = static_cast<double>(facts.width) / facts.height;
    const double there = static_cast<double>((*facts.recorded)[0]) / (*facts.recorded)[1];
    constexpr double sameShape = 0.01;  // rounding of sizes made smaller
    return std::abs(here / there - 1.0) > sameShape;
}

std::optional<double> focalFrom(const PhotoFacts& facts) {
    // CIPA DCG-001: the equivalent keeps the diagonal of the picture, 43.27 mm on the frame.
    const double diagonal =
        cropped(facts) ? std::hypot((*facts.recorded)[0], (*facts.recorded)[1]) : std::hypot(facts.width, facts.height);
    if (!facts.focalLength35 || !(*facts.focalLength35 > 0.0) || !(diagonal > 0.0)) {
        return std::nullopt;
    }
    return *facts.focalLength35 * diagonal / std::hypot(36.0, 24.0);
}

std::string clockTime(std::string_view text) {
    constexpr std::string_view form = "dddd-dd-dd_dd:dd:dd";
    if (text.size() < form.size()) {
        return {};
    }
    std::string time(text.substr(0, form.size()));
    for (std::size_t i = 0; i < form.size(); ++i) {
        const bool digit = time[i] >= '0' && time[i] <= '9';
        const char mark = form[i] == '_' ? ' ' : form[i];
        const bool fits = mark == 'd' ? digit : time[i] == mark || (mark == '-' && time[i] == ':');
        if (!fits) {
            return {};
        }
        if (mark != 'd') {
            time[i] = mark;
        }
    }
    const auto number = [&](std::size_t from, std::size_t count) {
        int value = 0;
        std::from_chars(time.data() + from, time.data() + from + count, value);
        return value;
    };
    const std::chrono::year_month_day day{std::chrono::year(number(0, 4)), std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                          std::chrono::day(static_cast<unsigned>(number(8, 2)))};
    const bool was = day.ok() && number(0, 4) > 0 && number(11, 2) < 24 && number(14, 2) < 60 && number(17, 2) < 60;
    return was ? time : std::string();
}

std::string_view maskName(MaskClass kind) {
    switch (kind) {
        case MaskClass::Debris:
            return "debris";
        case MaskClass::Moved:
            return "moved";
        case MaskClass::Hidden:
            return "hidden";
        case MaskClass::NotDebris:
            break;
    }
    return "not_debris";
}

}  // namespace rubble
