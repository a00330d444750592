#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "core/base/error.h"

namespace rubble {

/// Throws UsageError. @param what  its id with ".remedy" behind it is that of the remedy
[[noreturn]] inline void refuse(Message what, std::string_view remedy) {
    std::string id = what.id + ".remedy";
    throw UsageError(std::move(what), {std::move(id), std::string(remedy), {}});
}

}  // namespace rubble
