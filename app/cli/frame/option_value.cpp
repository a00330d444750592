#include "app/cli/frame/option_value.h"

#include <cmath>

#include "core/scenario/site.h"

namespace rubble::cli {

UsageError wrongValue(std::string_view option, const std::string& value, std::string_view offered) {
    return UsageError({"cli.option_value", "{0} {1}: this value is not known.", {option, value}},
                      {"cli.option_value.remedy", "Give {0}.", {offered}});
}

std::vector<std::string> splitAtCommas(std::string_view text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ',') {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

int parseCount(const Arguments& arguments, std::string_view option, int low, int high, int otherwise) {
    const auto text = arguments.value(option);
    int number = otherwise;
    if (text && (!parseNumber(*text, number) || number < low || number > high)) {
        throw wrongValue(option, *text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return number;
}

std::vector<double> parsePositives(const Arguments& arguments, std::string_view option, std::string_view offered) {
    std::vector<double> numbers;
    if (const auto text = arguments.value(option)) {
        for (const std::string& part : splitAtCommas(*text)) {
            double number = 0.0;
            if (!parseNumber(part, number) || !std::isfinite(number) || number <= 0.0) {
                throw wrongValue(option, part, offered);
            }
            numbers.push_back(number);
        }
    }
    return numbers;
}

double parseLength(const Arguments& arguments, std::string_view option, double otherwise, bool zeroToo) {
    const auto text = arguments.value(option);
    double metres = otherwise;
    if (text && (!parseNumber(*text, metres) || !std::isfinite(metres) || metres < 0.0 || (metres == 0.0 && !zeroToo))) {
        throw wrongValue(option, *text, zeroToo ? "metres, not below zero" : "metres, above zero");
    }
    return metres;
}

std::optional<Vec3> parsePlace(const Arguments& arguments, std::string_view option) {
    const auto text = arguments.value(option);
    if (!text) {
        return std::nullopt;
    }
    const std::vector<std::string> parts = splitAtCommas(*text);
    Vec3 place = Vec3::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double& metres = place[static_cast<Eigen::Index>(axis)];
        if (parts.size() != 3 || !parseNumber(parts[axis], metres) || !std::isfinite(metres)) {
            throw wrongValue(option, *text, "easting, northing and height in metres, as 451000,5311000,0");
        }
    }
    return place;
}

std::optional<std::vector<std::uint16_t>> parseClasses(const Arguments& arguments, std::string_view option) {
    const auto text = arguments.value(option);
    if (!text) {
        return std::nullopt;
    }
    std::vector<std::uint16_t> classes;
    for (const std::string& part : splitAtCommas(*text)) {
        std::uint16_t kind = 0;
        if (!parseNumber(part, kind) || kind > groundClassMost) {
            throw wrongValue(option, *text, "classes from 0 to 255 at commas, such as 2,9");
        }
        classes.push_back(kind);
    }
    return classes;
}

bool parseOnOff(const Arguments& arguments, std::string_view option, bool otherwise) {
    const auto text = arguments.value(option);
    if (text && *text != "on" && *text != "off") {
        throw wrongValue(option, *text, "on or off");
    }
    return text ? *text == "on" : otherwise;
}

void takeCloudRequest(const Arguments& arguments, CloudRequest& read, std::string_view columns, std::string_view system) {
    if (const auto list = arguments.value(columns)) {
        read.columns = list->empty() ? std::vector<std::string>() : splitAtCommas(*list);
    }
    read.crs = arguments.value(system).value_or(read.crs);
}

}  // namespace rubble::cli
