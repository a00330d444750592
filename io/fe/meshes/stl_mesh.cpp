#include "io/fe/meshes/stl_mesh.h"

#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "io/base/file_words.h"
#include "io/fe/meshes/mesh_lines.h"
#include "io/fe/vtk/stored_numbers.h"

namespace rubble::io {

namespace {

constexpr std::size_t headBytes = 84;
constexpr std::size_t facetBytes = 50;

std::uint32_t littleEndian(const char* bytes) {
    std::uint32_t number = 0;
    for (std::size_t i = 4; i-- > 0;) {
        number = (number << 8) | static_cast<std::uint8_t>(bytes[i]);
    }
    return number;
}

/// Facets that a binary file promises; nothing: its length fits no number of facets, so it is text.
std::optional<std::uint64_t> facetsOf(const std::string& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    std::array<char, headBytes> head{};
    if (error || !file.read(head.data(), headBytes)) {
        return std::nullopt;
    }
    const std::uint64_t facets = littleEndian(head.data() + 80);
    const bool isText = std::string_view(head.data(), 5) == "solid";
    if (size == headBytes + facetBytes * facets) {
        return facets;
    }
    if (!isText) {
        refuseContent({"surroundings.stl_cut",
                       "{0} promises {1} triangles, but its length is that of {2}",
                       {path, static_cast<std::int64_t>(facets), static_cast<std::int64_t>((size - headBytes) / facetBytes)}},
                      "Copy it again from where it came.");
    }
    return std::nullopt;
}

void addTriangle(MeshGathering& gathering) {
    const auto last = static_cast<std::int64_t>(gathering.points());
    const std::array<std::int64_t, 3> corners{last - 3, last - 2, last - 1};
    gathering.addFace(corners);
}

void readBinary(const std::string& path, std::uint64_t facets, MeshGathering& gathering, const Execution& execution) {
    std::ifstream file(path, std::ios::binary);
    file.seekg(headBytes);
    std::array<char, facetBytes> facet{};
    for (std::uint64_t i = 0; i < facets && file.read(facet.data(), facetBytes); ++i) {
        if (i % 4096 == 0) {
            execution.check();
        }
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Vec3 point;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto stored = std::bit_cast<float>(littleEndian(facet.data() + 12 * (corner + 1) + 4 * axis));
                point[static_cast<Eigen::Index>(axis)] = static_cast<double>(stored);
                gathering.noteStep(stepOfFloat(static_cast<double>(stored)));
            }
            gathering.addPoint(point);
        }
        addTriangle(gathering);
    }
}

void readText(const std::string& path, MeshGathering& gathering, const Execution& execution) {
    MeshLines lines(path);
    std::string_view line;
    std::size_t corners = 0;
    while (lines.next(line)) {
        if (lines.number() % 4096 == 0) {
            execution.check();
        }
        if (takeWord(line) != "vertex") {
            continue;
        }
        Vec3 point;
        for (double& coordinate : point) {
            const std::string_view text = takeWord(line);
            coordinate = lines.numberIn(text);
            gathering.noteStep(stepOfText(text, coordinate));
        }
        gathering.addPoint(point, lines.number());
        if (++corners % 3 == 0) {
            addTriangle(gathering);
        }
    }
}

}  // namespace

RawMesh readStlMesh(const std::string& path, const Execution& execution) {
    MeshGathering gathering(path);
    if (const auto facets = facetsOf(path)) {
        readBinary(path, *facets, gathering, execution);
    } else {
        readText(path, gathering, execution);
    }
    RawMesh mesh = std::move(gathering).finish(execution);
    addFinding(mesh.findings, path, {"surroundings.stl_unit", "an STL states no unit; its numbers are taken as metres", {}},
               "scale the mesh to metres before it is written if they are not");
    return mesh;
}

}  // namespace rubble::io
