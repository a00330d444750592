#include "app/cli/option_value.h"

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

}  // namespace rubble::cli
