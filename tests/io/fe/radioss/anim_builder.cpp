#include "tests/io/fe/radioss/anim_builder.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <fstream>

namespace rubble::io {

namespace {

/// Big-endian values one after the other.
class Bytes {
public:
    void integer(std::int64_t value) { word(static_cast<std::uint32_t>(static_cast<std::int32_t>(value))); }
    void real(double value) { word(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
    void byte(int value) { m_bytes += static_cast<char>(value); }
    void text(std::string value, std::size_t length) {
        value.resize(length, '\0');
        m_bytes += value;
    }
    const std::string& get() const { return m_bytes; }

private:
    void word(std::uint32_t value) {
        for (const int shift : {24, 16, 8, 0}) {
            m_bytes += static_cast<char>(value >> shift & 0xff);
        }
    }

    std::string m_bytes;
};

constexpr std::size_t nameBytes = 81, partBytes = 50;

}  // namespace

std::string AnimBuilder::file(double time) const {
    Bytes out;
    const auto integers = [&](std::initializer_list<std::size_t> values) {
        for (const std::size_t value : values) {
            out.integer(static_cast<std::int64_t>(value));
        }
    };
    const auto died = [&](const std::map<std::size_t, double>& deaths, std::size_t e) {
        return deaths.contains(e) && time >= deaths.at(e);
    };
    const std::size_t nodes = 8 * bricks, shells = 2, beams = 3;
    out.integer(magic);
    out.real(time);
    for (const char* name : {"Time=", "ModAnim", "Radioss Run="}) {
        out.text(name, nameBytes);
    }
    integers({masses, numbers, 1, 1, 1, 0, 0, particles > 0, 0, 0});
    integers({nodes, shells, 1, 0, deletion ? 1u : 0u, velocities ? 1u : 0u, 0, 0});
    constexpr int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (std::size_t b = 0; b < bricks; ++b) {
        for (const auto& at : corner) {
            out.real(2.0 * static_cast<double>(b) + at[0] + time);
            out.real(at[1]);
            out.real(at[2]);
        }
    }
    integers({0, 1, 2, 3, 8, 9, 10, 10});
    for (std::size_t e = 0; e < shells; ++e) {
        out.byte(died(shellDeaths, e) ? 0 : 1);
    }
    integers({2});
    out.text("       3:SKIN", partBytes);
    for (std::size_t i = 0; i < 3 * nodes; ++i) {
        out.text("", 2);
    }
    if (deletion) {
        out.text("TIME DELETION ELEMENT", nameBytes);
        for (std::size_t e = 0; e < shells; ++e) {
            out.real(0.0);
        }
    }
    if (velocities) {
        out.text("Velocity", nameBytes);
        for (std::size_t n = 0; n < nodes; ++n) {
            out.real(1.0);
            out.real(2.0);
            out.real(3.0);
        }
    }
    if (masses) {
        out.real(1.8e-9 * 8.0);
        out.real(1.8e-9 * 8.0 * 0.5);
        for (std::size_t n = 0; n < nodes; ++n) {
            out.real(1.0);
        }
    }
    if (numbers) {
        for (std::size_t n = 0; n < nodes; ++n) {
            out.integer(static_cast<std::int64_t>(n + 1));
        }
        integers({31, 32});
    }
    integers({0, 1, 1});
    // Bricks: the last one is a part of its own.
    integers({bricks, 2, (deletion ? 1u : 0u) + (densities ? 1u : 0u), 0});
    for (std::size_t n = 0; n < nodes; ++n) {
        out.integer(static_cast<std::int64_t>(n));
    }
    for (std::size_t b = 0; b < bricks; ++b) {
        const bool stands = std::find(rigid.begin(), rigid.end(), b) != rigid.end();
        out.byte(stands ? 255 : died(brickDeaths, b) ? 0 : 1);
    }
    integers({bricks - 1, bricks});
    out.text("       1:COLUMN", partBytes);
    out.text("       2:BLOCK", partBytes);
    if (deletion) {
        out.text("TIME DELETION ELEMENT", nameBytes);
    }
    if (densities) {
        out.text("Density", nameBytes);
    }
    for (std::size_t b = 0; deletion && b < bricks; ++b) {
        out.real(died(brickDeaths, b) ? brickDeaths.at(b) : 0.0);
    }
    for (std::size_t b = 0; densities && b < bricks; ++b) {
        out.real(died(brickDeaths, b) ? 0.0 : 2.4e-9);
    }
    for (std::size_t b = 0; masses && b < bricks; ++b) {
        out.real(2.4e-9);
    }
    for (std::size_t b = 0; numbers && b < bricks; ++b) {
        out.integer(static_cast<std::int64_t>(firstBrick + 11 + b));
    }
    integers({0, 0, 1, 1, 1, 1});
    // Trusses and one link; the link's part has the number of a part of bricks.
    integers({beams, 2, 0, 0, 0});
    integers({0, 1, 0, 4, 0, 8});
    for (std::size_t e = 0; e < beams; ++e) {
        out.byte(1);
    }
    integers({2, 3});
    out.text("       4:TIE", partBytes);
    out.text("       1: block", partBytes);
    for (const double mass : {7.85e-9 * 200.0, 7.85e-9 * 200.0, 0.0}) {
        if (masses) {
            out.real(mass);
        }
    }
    if (numbers) {
        integers({41, 42, 0});
    }
    integers({0, 0, 1, 1, 1, 1});
    // Hierarchy: one subset with members, materials and properties.
    integers({1});
    out.text("ALL", partBytes);
    integers({0, 0, 1, 1, 2, 1, 2, 0});
    integers({1, 1});
    out.text("Dummy Material", partBytes);
    integers({0});
    out.text("Dummy Property", partBytes);
    integers({0});
    if (particles > 0) {
        integers({particles, 1, 1, 0});
        for (std::size_t p = 0; p < particles; ++p) {
            out.integer(static_cast<std::int64_t>(8 * p));
        }
        for (std::size_t p = 0; p < particles; ++p) {
            out.byte(p == 0 && time > 0.0 ? 0 : 1);
        }
        integers({particles});
        out.text("       6:SAND", partBytes);
        out.text("Density", nameBytes);
        for (std::size_t p = 0; p < particles; ++p) {
            out.real(1.6e-9);
        }
        for (std::size_t p = 0; masses && p < particles; ++p) {
            out.real(0.2e-9);
        }
        for (std::size_t p = 0; numbers && p < particles; ++p) {
            out.integer(static_cast<std::int64_t>(61 + p));
        }
        integers({0, 1, 1});
    }
    return out.get();
}

void AnimBuilder::write(const std::string& folder, const std::vector<double>& times) const {
    for (std::size_t k = 0; k < times.size(); ++k) {
        char name[16];
        std::snprintf(name, sizeof name, "/RUNA%03d", static_cast<int>(k + 1));
        putFile(folder + name, file(times[k]));
    }
}

void putFile(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void putPacked(const std::string& path, const std::string& bytes) {
    const gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(file);
}

}  // namespace rubble::io
