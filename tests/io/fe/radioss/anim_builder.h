#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rubble::io {

/// Writes small animation files for tests: a row of unit bricks in mm, two shells, two trusses with a link of a rigid body, and
/// particles. Masses are in t: bricks of 2.4e-9, shells 8 thick of 1.8e-9, trusses of 7.85e-9 and 200 mm2.
struct AnimBuilder {
    std::size_t bricks = 3;
    std::size_t particles = 0;
    bool masses = true, numbers = true, deletion = true, densities = true, velocities = true;
    std::int32_t magic = 0x542C;
    std::map<std::size_t, double> brickDeaths;  ///< by time
    std::map<std::size_t, double> shellDeaths;
    std::vector<std::size_t> rigid;  ///< bricks
    std::size_t firstBrick = 0;      ///< added to the numbers of bricks

    /// The bytes of the state at a time.
    std::string file(double time) const;
    /// Writes RUNA001, RUNA002, ... into a folder, one for each time.
    void write(const std::string& folder, const std::vector<double>& times) const;
};

void putFile(const std::string& path, const std::string& bytes);
void putPacked(const std::string& path, const std::string& bytes);

}  // namespace rubble::io
