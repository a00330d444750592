#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rubble::io {

/// A GLB file taken apart, and what of it breaks the rules of glTF 2.0 (Khronos, sections 3 to 5), as a validator would tell.
struct CheckedGlb {
    nlohmann::json asset;
    std::string binary;
    std::vector<std::string> broken;  ///< empty for a sound file

    /// Numbers of an accessor of floats, row by row.
    std::vector<float> floats(std::size_t accessor) const;
    std::vector<std::uint32_t> indices(std::size_t accessor) const;
};

CheckedGlb checkGlb(const std::string& bytes);

}  // namespace rubble::io
