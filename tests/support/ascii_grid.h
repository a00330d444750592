#pragma once

#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>

namespace rubble::io {

/// An ESRI ASCII grid, m. By itself it has 40 x 40 cells of a metre around 0, 0.
struct AsciiGrid {
    std::size_t columns = 40;
    std::size_t rows = 40;
    double west = -20.0;
    double south = -20.0;
    double cell = 1.0;

    /// Writes what the file says of the middle of each cell. Returns the path.
    std::string writeText(const std::string& path, const std::function<std::string(double, double)>& text) const {
        std::ofstream out(path);
        out << std::setprecision(15) << "ncols " << columns << "\nnrows " << rows << "\nxllcorner " << west << "\nyllcorner "
            << south << "\ncellsize " << cell << "\nNODATA_value -9999\n";
        for (std::size_t r = 0; r < rows; ++r) {
            for (std::size_t c = 0; c < columns; ++c) {
                const double x = west + cell * (static_cast<double>(c) + 0.5);
                const double y = south + cell * (static_cast<double>(rows - r) - 0.5);
                out << text(x, y) << (c + 1 < columns ? " " : "\n");
            }
        }
        return path;
    }
    /// Writes the height of the middle of each cell, m; none where it is not a number. Returns the path.
    std::string write(const std::string& path, const std::function<double(double, double)>& height) const {
        return writeText(path, [&](double x, double y) { return textOf(height(x, y)); });
    }
    /// A level of that height, m. Returns the path.
    std::string writeLevel(const std::string& path, double height) const {
        return write(path, [height](double, double) { return height; });
    }
    /// All digits of a height; what stands for none where it is not a number.
    static std::string textOf(double height) {
        if (std::isnan(height)) {
            return "-9999";
        }
        std::ostringstream text;
        text << std::setprecision(17) << height;
        return text.str();
    }
};

}  // namespace rubble::io
