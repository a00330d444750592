#include "io/fe/meshes/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>

#include "io/base/file_words.h"

namespace rubble::io {

namespace {

[[noreturn]] void refuseLine(const std::string& path, const MeshLines& lines, std::string_view line) {
    refuseContent({"surroundings.ply_head",
                   "{0}, line {1}: \"{2}\" is no line of the head of a PLY",
                   {path, static_cast<std::int64_t>(lines.number()), line.substr(0, 60)}},
                  "Export the mesh anew.");
}

std::optional<NumberType> typeNamed(std::string_view name) {
    using Kind = NumberType::Kind;
    struct Row {
        std::array<std::string_view, 2> names;
        NumberType type;
    };
    static constexpr std::array<Row, 8> rows{{{{"char", "int8"}, {Kind::Signed, 1}},
                                              {{"uchar", "uint8"}, {Kind::Unsigned, 1}},
                                              {{"short", "int16"}, {Kind::Signed, 2}},
                                              {{"ushort", "uint16"}, {Kind::Unsigned, 2}},
                                              {{"int", "int32"}, {Kind::Signed, 4}},
                                              {{"uint", "uint32"}, {Kind::Unsigned, 4}},
                                              {{"float", "float32"}, {Kind::Real, 4}},
                                              {{"double", "float64"}, {Kind::Real, 8}}}};
    for (const Row& row : rows) {
        if (std::find(row.names.begin(), row.names.end(), name) != row.names.end()) {
            return row.type;
        }
    }
    return std::nullopt;
}

/// "float x" or "list uchar int vertex_indices"
std::optional<PlyProperty> propertyIn(std::string_view line) {
    PlyProperty property;
    std::string_view word = takeWord(line);
    if (word == "list") {
        const auto length = typeNamed(takeWord(line));
        if (!length || length->kind == NumberType::Kind::Real) {
            return std::nullopt;
        }
        property.list = true;
        property.length = *length;
        word = takeWord(line);
    }
    const auto type = typeNamed(word);
    property.name = takeWord(line);
    if (!type || property.name.empty()) {
        return std::nullopt;
    }
    property.type = *type;
    return property;
}

}  // namespace

PlyHeader readPlyHeader(MeshLines& lines, const std::string& path) {
    constexpr std::uint64_t linesMax = 10'000;
    PlyHeader header;
    std::string_view line;
    bool format = false;
    if (!lines.next(line) || takeWord(line) != "ply") {
        refuseContent({"surroundings.no_ply", "{0} does not begin as a PLY does", {path}}, "Export the mesh anew, as PLY.");
    }
    while (lines.number() < linesMax && lines.next(line)) {
        const std::string_view whole = line;
        const std::string_view word = takeWord(line);
        if (word == "format") {
            const std::string_view kind = takeWord(line);
            header.text = kind == "ascii";
            header.bigEndian = kind == "binary_big_endian";
            format = header.text || header.bigEndian || kind == "binary_little_endian";
            if (!format) {
                refuseLine(path, lines, whole);
            }
        } else if (word == "element") {
            PlyElement element;
            element.name = takeWord(line);
            std::int64_t count = 0;
            if (!takeInteger(line, count) || count < 0) {
                refuseLine(path, lines, whole);
            }
            element.count = static_cast<std::uint64_t>(count);
            header.elements.push_back(std::move(element));
        } else if (word == "property") {
            const auto property = propertyIn(line);
            if (!property || header.elements.empty()) {
                refuseLine(path, lines, whole);
            }
            header.elements.back().properties.push_back(*property);
        } else if (word == "end_header" && format) {
            return header;
        } else if (word == "comment") {
            header.comments.emplace_back(line);
        } else if (word != "obj_info" && !word.empty()) {
            refuseLine(path, lines, whole);
        }
    }
    refuseContent({"surroundings.ply_head_cut", "{0}: the head of the PLY does not end, or names no format", {path}},
                  "The file may be cut short: copy it again from where it came.");
}

bool isPlyOfPoints(const std::string& path) {
    try {
        MeshLines lines(path);
        const PlyHeader header = readPlyHeader(lines, path);
        bool points = false;
        bool faces = false;
        for (const PlyElement& element : header.elements) {
            points = points || (element.name == "vertex" && element.count > 0);
            faces = faces || ((element.name == "face" || element.name == "tristrips") && element.count > 0);
        }
        return points && !faces;
    } catch (const Error&) {
        return false;  // what is said of it as a mesh says more
    }
}

}  // namespace rubble::io
