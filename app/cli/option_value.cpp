#include "app/cli/option_value.h"

namespace rubble::cli {

UsageError wrongValue(std::string_view option, const std::string& value, std::string_view offered) {
    return UsageError({"cli.option_value", "{0} {1}: this value is not known.", {option, value}},
                      {"cli.option_value.remedy", "Give {0}.", {offered}});
}

}  // namespace rubble::cli
