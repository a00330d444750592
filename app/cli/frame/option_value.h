#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/cli/frame/arguments.h"
#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/scenario/cloud_request.h"

namespace rubble::cli {

/// An option was given a value that it does not know. @param offered  what it does know
UsageError wrongValue(std::string_view option, const std::string& value, std::string_view offered);

/// Splits "a,b,c"; an empty part stays empty.
std::vector<std::string> splitAtCommas(std::string_view text);

/// Reads a number that is the whole text, without blanks and with a point as decimal sign; false if it is none.
template <class Number>
bool parseNumber(std::string_view text, Number& number) {
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
    return end.ec == std::errc{} && end.ptr == text.data() + text.size();
}

/// The most pieces of work at a time, and threads, that an option may ask for.
constexpr int jobsMax = 1024;

/// A whole number within a range; what otherwise holds if the option was not given.
int parseCount(const Arguments& arguments, std::string_view option, int low, int high, int otherwise);

/// Numbers above zero, separated by commas; empty if the option was not given.
std::vector<double> parsePositives(const Arguments& arguments, std::string_view option, std::string_view offered);

/// Metres, above zero unless zero is allowed; what otherwise holds if the option was not given.
double parseLength(const Arguments& arguments, std::string_view option, double otherwise, bool zeroToo = false);

/// Three finite numbers at commas, m; unset if the option was not given.
std::optional<Vec3> parsePlace(const Arguments& arguments, std::string_view option);

/// Classes of points at commas, 0 to 255; unset if the option was not given.
std::optional<std::vector<std::uint16_t>> parseClasses(const Arguments& arguments, std::string_view option);

/// Takes how a cloud is read, as far as it was given, in place of what was stated before.
void takeCloudRequest(const Arguments& arguments, CloudRequest& read, std::string_view columns = "--columns",
                      std::string_view system = "--crs");

/// Whether an option was given as on or as off; what otherwise holds if it was not given.
bool parseOnOff(const Arguments& arguments, std::string_view option, bool otherwise);

}  // namespace rubble::cli
