#include "tests/io/fe/d3plot/d3plot_builder.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <fstream>

namespace rubble::io {

namespace {

template <class Value>
void append(std::string& out, Value value, bool bigEndian) {
    auto bytes = std::bit_cast<std::array<char, sizeof(Value)>>(value);
    if (bigEndian != (std::endian::native == std::endian::big)) {
        std::reverse(bytes.begin(), bytes.end());
    }
    out.append(bytes.data(), bytes.size());
}

constexpr double endMark = -999999.0;
constexpr std::array<std::int64_t, 10> particleFlags{10, 1, 1, 6, 1, 1, 1, 1, 6, 0};
constexpr std::int64_t particleWords = 1 + 1 + 1 + 6 + 1 + 1 + 1 + 1 + 6;
constexpr std::int64_t particleDensityPlace = 10;

}  // namespace

void D3plotBuilder::integer(std::string& out, std::int64_t value) const {
    if (format.bytes == 4) {
        append(out, static_cast<std::int32_t>(value), format.bigEndian);
    } else {
        append(out, value, format.bigEndian);
    }
}

void D3plotBuilder::real(std::string& out, double value) const {
    if (format.bytes == 4) {
        append(out, static_cast<float>(value), format.bigEndian);
    } else {
        append(out, value, format.bigEndian);
    }
}

void D3plotBuilder::text(std::string& out, const std::string& value, std::size_t bytes) const {
    std::string padded = value;
    padded.resize(bytes, ' ');
    out += padded;
}

bool D3plotBuilder::dead(std::int64_t entry, std::size_t k) const {
    const auto found = deaths.find(entry);
    return found != deaths.end() && k >= found->second;
}

std::vector<Vec3> D3plotBuilder::nodes() const {
    constexpr int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    std::vector<Vec3> list;
    for (std::int64_t c = 0; c < cubes; ++c) {
        for (const auto& at : corner) {
            list.emplace_back(2.0 * static_cast<double>(c) + at[0], at[1], at[2]);
        }
    }
    return list;
}

void D3plotBuilder::appendControl(std::string& out) const {
    text(out, title, 10 * static_cast<std::size_t>(format.bytes));
    std::map<std::size_t, std::int64_t> word{
        {11, 1},           {15, dimension},   {16, 8 * cubes},  {17, 6},         {18, 6 + 7 * parts},
        {19, temperature}, {20, coordinates}, {21, velocities}, {22, 0},         {23, cubes},
        {24, 1},           {27, 7},           {28, beams},      {29, 1},         {30, 6},
        {31, shells},      {32, 2},           {33, 2 * 7 + 4},  {37, particles}, {38, particles > 0},
        {40, thickShells}, {41, 1},           {42, 2 * 7},      {43, 1000},      {44, 1000},
        {45, 999},         {46, 1000},        {51, parts},      {57, extraWords}};
    word[36] = deletionOption == 2 ? -10002 : deletionOption == 1 ? -2 : 2;
    word[39] = numbers ? 16 + 8 * cubes + cubes + beams + shells + thickShells + 3 * parts : 0;
    for (const auto& [place, value] : words) {
        word[place] = value;
    }
    for (std::size_t w = 10; w < 64 + static_cast<std::size_t>(extraWords); ++w) {
        if (w == 14) {
            real(out, 971.0);
        } else {
            integer(out, word.contains(w) ? word[w] : 0);
        }
    }
}

void D3plotBuilder::appendNumbers(std::string& out) const {
    for (const std::int64_t word :
         {std::int64_t{-1}, std::int64_t{0}, std::int64_t{0}, std::int64_t{0}, std::int64_t{0}, 8 * cubes, cubes, beams, shells,
          thickShells, std::int64_t{0}, std::int64_t{0}, std::int64_t{0}, std::int64_t{0}, std::int64_t{0}, parts}) {
        integer(out, word);
    }
    const auto numbered = [&](std::int64_t count, std::int64_t from) {
        for (std::int64_t i = 0; i < count; ++i) {
            integer(out, from + i);
        }
    };
    numbered(8 * cubes, 1001);
    numbered(cubes, 101);
    numbered(beams, 301);
    numbered(shells, 401);
    numbered(thickShells, 201);
    for (std::int64_t p = 1; p <= parts; ++p) {
        integer(out, 10 * p);
    }
    numbered(2 * parts, 0);
}

void D3plotBuilder::appendGeometry(std::string& out) const {
    if (dimension == 5) {
        integer(out, rigidShells);
        integer(out, parts);
        for (std::int64_t p = 1; p <= parts; ++p) {
            integer(out, p == 5 ? 20 : 24);
        }
    }
    for (const std::int64_t flag : particleFlags) {
        if (particles > 0) {
            integer(out, flag);
        }
    }
    for (const Vec3& node : nodes()) {
        for (const double x : node) {
            real(out, x);
        }
    }
    const auto row = [&](std::int64_t cube, std::initializer_list<int> corners, std::int64_t part) {
        for (const int corner : corners) {
            integer(out, 8 * cube + corner + 1);
        }
        integer(out, part);
    };
    for (std::int64_t c = 0; c < cubes; ++c) {
        row(c, {0, 1, 2, 3, 4, 5, 6, 7}, 1);
    }
    for (std::int64_t c = 0; c < thickShells; ++c) {
        row(c, {0, 1, 2, 3, 4, 5, 6, 7}, 2);
    }
    for (std::int64_t c = 0; c < beams; ++c) {
        row(c, {0, 1, 3, 0, 0}, 3);
    }
    for (std::int64_t c = 0; c < shells; ++c) {
        row(c, {0, 1, 2, 3}, c < shells - rigidShells ? 4 : 5);
    }
    if (numbers) {
        appendNumbers(out);
    }
    for (std::int64_t p = 0; p < particles; ++p) {
        integer(out, 8 * p + 1);
        integer(out, 6);
    }
}

void D3plotBuilder::appendTitles(std::string& out) const {
    integer(out, 90000);
    text(out, title, 72);
    integer(out, 90001);
    integer(out, parts);
    for (std::int64_t p = 1; p <= parts; ++p) {
        integer(out, p);
        text(out, "part number " + std::to_string(p), 72);
    }
    real(out, endMark);
}

std::string D3plotBuilder::state(std::size_t k) const {
    std::string out;
    real(out, times[k]);
    const std::array<double, 6> massOf{static_cast<double>(cubes) * density,
                                       static_cast<double>(thickShells) * density,
                                       1.0,
                                       static_cast<double>(shells - rigidShells) * density * thickness,
                                       1.0,
                                       static_cast<double>(particles) * density * particleVolume};
    for (int i = 0; i < 6 + 5 * parts; ++i) {
        real(out, 0.0);
    }
    for (const double mass : massOf) {
        real(out, mass);
    }
    for (int i = 0; i < parts; ++i) {
        real(out, 0.0);
    }
    for (const Vec3& node : nodes()) {
        if (coordinates > 0) {
            real(out, times[k] + (coordinates == 1 ? node.x() : 0.0));
            real(out, coordinates == 1 ? node.y() : 0.0);
            real(out, coordinates == 1 ? node.z() : 0.0);
        }
    }
    const std::array<std::int64_t, 4> heat{0, 1, 4, 6};
    for (std::int64_t i = 0; i < (heat[static_cast<std::size_t>(temperature % 10)] + temperature / 10) * 8 * cubes; ++i) {
        real(out, 300.0);
    }
    for (std::int64_t i = 0; velocities && i < 8 * cubes; ++i) {
        real(out, 1.0);
        real(out, 2.0);
        real(out, 3.0);
    }
    // Stresses are zero at the first state and of the dead.
    const auto stress = [&](std::int64_t entry) { return k > 0 && !dead(entry, k) ? 5.0 : 0.0; };
    const auto values = [&](std::int64_t entry, int count) {
        for (int i = 0; i < count; ++i) {
            real(out, stress(entry));
        }
    };
    const std::int64_t shellsFrom = cubes + thickShells;
    for (std::int64_t e = 0; e < cubes; ++e) {
        values(e, 7);
    }
    for (std::int64_t e = 0; e < thickShells; ++e) {
        values(cubes + e, 14);
    }
    for (std::int64_t e = 0; e < beams; ++e) {
        values(shellsFrom + shells + e, 6);
    }
    for (std::int64_t e = 0; e < shells - rigidShells; ++e) {
        values(shellsFrom + e, 14);
        for (const double value : {thickness, 0.0, 0.0, 0.0}) {
            real(out, value);
        }
    }
    for (std::int64_t n = 0; deletionOption == 1 && n < 8 * cubes; ++n) {
        real(out, dead(n / 8, k) ? 0.0 : 1.0);
    }
    for (std::int64_t entry = 0; deletionOption == 2 && entry < shellsFrom + shells + beams; ++entry) {
        real(out, dead(entry, k) ? 0.0 : 3.0);
    }
    for (std::int64_t p = 0; p < particles; ++p) {
        const auto death = particleDeaths.find(p);
        for (std::int64_t i = 0; i < particleWords; ++i) {
            const bool gone = death != particleDeaths.end() && k >= death->second;
            real(out, i == 0 ? (gone ? 0.0 : 6.0) : i == particleDensityPlace ? density : 1.0);
        }
    }
    return out;
}

std::size_t D3plotBuilder::stateWords() const {
    return state(0).size() / static_cast<std::size_t>(format.bytes);
}

std::vector<std::string> D3plotBuilder::files() const {
    std::vector<std::string> list(1);
    appendControl(list.front());
    appendGeometry(list.front());
    const auto width = static_cast<std::size_t>(format.bytes);
    // What does not fit into a file goes on in the next one.
    const auto spill = [&] {
        while (fileWords > 0 && list.back().size() > fileWords * width) {
            std::string rest = list.back().substr(fileWords * width);
            list.back().resize(fileWords * width);
            list.push_back(std::move(rest));
        }
    };
    const auto close = [&] {
        real(list.back(), endMark);
        if (fileWords > 0) {
            return;
        }
        list.back().resize((list.back().size() + 512 * width - 1) / (512 * width) * 512 * width, '\0');
    };
    spill();
    std::size_t inFile = 0;
    if (statesInRoot == 0) {
        real(list.back(), endMark);
        if (titles) {
            appendTitles(list.back());
        }
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        const std::size_t most = list.size() == 1 && fileWords == 0 ? statesInRoot : statesPerFile;
        if (inFile >= most || (k == 0 && statesInRoot == 0)) {
            if (k > 0) {
                close();
            }
            list.emplace_back();
            inFile = 0;
        }
        list.back() += state(k);
        ++inFile;
        spill();
    }
    close();
    return list;
}

void D3plotBuilder::write(const std::string& path) const {
    const std::vector<std::string> list = files();
    for (std::size_t i = 0; i < list.size(); ++i) {
        char number[16] = "";
        if (i > 0) {
            std::snprintf(number, sizeof number, "%02d", static_cast<int>(i));
        }
        std::ofstream(path + number, std::ios::binary | std::ios::trunc)
            .write(list[i].data(), static_cast<std::streamsize>(list[i].size()));
    }
}

}  // namespace rubble::io
