#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// Points that a block holds at most, so that a cloud of any size takes the same memory.
inline constexpr std::size_t cloudBlockPoints = 16'384;

/// What becomes of a point.
enum class PointFate : std::uint8_t {
    Taken,
    Invalid,    ///< marked by the scanner as no place, or as a direction alone
    Withheld,   ///< marked as withdrawn by who made the file
    Noise,      ///< of class 7 or 18
    NoReturn,   ///< at 0, 0, 0 of its scan, where scanners write what gave no echo
    NotFinite,  ///< a coordinate is no finite number
};
inline constexpr std::size_t pointFateCount = 6;

/// What a cloud may have beside places.
struct CloudColumns {
    bool intensity = false;
    bool colour = false;
    bool classes = false;
    bool returns = false;
    bool times = false;
    bool scans = false;  ///< each point is of a scan
};

/// Points one after another, column by column. A column that the cloud does not have is empty.
struct CloudBlock {
    std::vector<Vec3> places;  ///< in units of the file; scale and offset applied, scans brought to their poses
    std::vector<float> intensity;
    std::vector<std::array<std::uint16_t, 3>> colours;  ///< red, green, blue in steps of the file
    std::vector<std::uint16_t> classes;
    std::vector<std::uint8_t> returns;    ///< number of the echo, from 1
    std::vector<std::uint8_t> returnsOf;  ///< how many its pulse gave
    std::vector<double> times;            ///< s, by the clock of the file
    std::vector<std::uint16_t> scans;     ///< index of the scan
    std::vector<PointFate> fates;         ///< as the file marks them; empty: all are taken

    std::size_t size() const { return places.size(); }
    /// Gives every column that the cloud has this many entries.
    void resize(std::size_t count, const CloudColumns& columns);
    void clear();
    /// Keeps the points that are taken, in order, and drops the marks.
    void keepTaken();
    /// Adds point i of another block with the same columns, without its mark.
    void add(const CloudBlock& other, std::size_t i);
};

/// Classes of LAS for what neither is ground nor debris: vegetation, wires and what carries them.
inline bool isPlantOrWire(std::uint16_t kind) {
    return (kind >= 3 && kind <= 5) || kind == 13 || kind == 14 || kind == 16;
}

}  // namespace rubble::io
