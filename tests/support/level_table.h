#pragma once

#include <fstream>
#include <string>

namespace rubble {

/// Writes points every 0.4 m on a level square of 40 m about the origin, as a table. @return  its path
inline std::string layLevelTable(const std::string& path, double height) {
    std::ofstream out(path);
    out << "x,y,z\n";
    for (int k = 0; k < 10'000; ++k) {
        out << 0.4 * (k % 100) - 20.0 << ',' << 0.4 * (k / 100) - 20.0 << ',' << height << '\n';
    }
    return path;
}

}  // namespace rubble
