#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "io/fe/d3plot/d3plot_family.h"

namespace rubble::io {

/// Writes small d3plot families for tests: a row of unit cubes along x, eight nodes each, and elements of the other kinds at its
/// nodes. Every state moves all nodes by its time along x.
struct D3plotBuilder {
    WordFormat format{4, false};
    std::string title = "a row of cubes";
    std::int64_t dimension = 4;  ///< word NDIM
    std::int64_t cubes = 2;
    std::int64_t thickShells = 0;  ///< the same nodes as the first cubes
    std::int64_t beams = 0;        ///< along the first edge of the first cubes
    std::int64_t shells = 0;       ///< on the lower face of the first cubes
    std::int64_t rigidShells = 0;  ///< the last of the shells, in the rigid part; needs dimension 5
    std::int64_t particles = 0;    ///< at the first node of the first cubes
    std::int64_t deletionOption = 2;
    std::int64_t coordinates = 1;  ///< word IU
    std::int64_t temperature = 0;  ///< word IT
    bool velocities = true;
    std::int64_t extraWords = 0;  ///< of the header
    bool numbers = true;
    bool titles = true;
    std::size_t statesInRoot = 0;
    std::size_t statesPerFile = 2;
    std::size_t fileWords = 0;  ///< files are full at this length and go on in the next; 0: never
    std::vector<double> times{0.0, 1.0, 2.0};
    std::map<std::int64_t, std::size_t> deaths;  ///< entry of the table (solids, thick shells, shells, beams) by first dead state
    std::map<std::int64_t, std::size_t> particleDeaths;
    std::map<std::size_t, std::int64_t> words;  ///< words of the control block that are something else

    /// Parts: 1 cubes, 2 thick shells, 3 beams, 4 shells, 5 rigid shells, 6 particles. User's numbers are ten times as large.
    static constexpr std::int64_t parts = 6;
    static constexpr double density = 2.5, thickness = 0.25, particleVolume = 0.125;

    std::vector<Vec3> nodes() const;
    /// The words of every file, the root first.
    std::vector<std::string> files() const;
    /// Writes them as `path`, `path`01, ...
    void write(const std::string& path) const;
    /// Words of one state.
    std::size_t stateWords() const;

private:
    void appendControl(std::string& out) const;
    void appendGeometry(std::string& out) const;
    void appendNumbers(std::string& out) const;
    void appendTitles(std::string& out) const;
    std::string state(std::size_t k) const;
    void integer(std::string& out, std::int64_t value) const;
    void real(std::string& out, double value) const;
    void text(std::string& out, const std::string& value, std::size_t bytes) const;
    bool dead(std::int64_t entry, std::size_t k) const;
};

}  // namespace rubble::io
