#pragma once

#include <string>

#include "core/base/outline.h"

namespace rubble {

/// Debris that was taken away after the collapse, as by rescuers: surveys of later show the place without it.
struct Removal {
    std::string name;
    std::string time;  ///< from when on it is gone, as clockTime() gives it
    Outline area;      ///< m, local
    friend bool operator==(const Removal&, const Removal&) = default;
};

}  // namespace rubble
