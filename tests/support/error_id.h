#pragma once

#include <string>

#include "core/base/error.h"

namespace rubble {

/// Id of the error that work is refused with; empty: it is done.
template <class Work>
std::string idOfError(Work work) {
    try {
        work();
    } catch (const Error& error) {
        return error.message().id;
    }
    return {};
}

}  // namespace rubble
