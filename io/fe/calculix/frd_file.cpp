#include "io/fe/calculix/frd_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/base/error.h"
#include "io/fe/straight_edges.h"

namespace rubble::io {

namespace {

/// Element types of the format: nodes written, and the shape where it makes fragments.
struct FrdType {
    std::size_t nodes;
    std::optional<ElementShape> shape;
};

std::optional<FrdType> typeOf(std::int64_t type) {
    using enum ElementShape;
    constexpr std::array<std::pair<std::size_t, ElementShape>, 12> types{{{8, Hexahedron},
                                                                          {6, Wedge},
                                                                          {4, Tetrahedron},
                                                                          {20, Hexahedron},
                                                                          {15, Wedge},
                                                                          {10, Tetrahedron},
                                                                          {3, Triangle},
                                                                          {6, Triangle},
                                                                          {4, Quadrilateral},
                                                                          {8, Quadrilateral},
                                                                          {2, Beam},
                                                                          {3, Beam}}};
    if (type < 1 || type > static_cast<std::int64_t>(types.size())) {
        return std::nullopt;
    }
    const auto& [nodes, shape] = types[static_cast<std::size_t>(type - 1)];
    return FrdType{nodes, shape};
}

template <class T>
T valueAt(const std::string& bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

// What the blocks of a step are where they are no states of a course of time; null: they are. The number is that of the kind of
// analysis: 0 static, 1 in time, 2 frequencies, 3 other, 4 buckling.
const char* shapesOf(const std::string& head, bool ofMode) {
    const std::string kind = column(head, 57, 1);
    if (kind == "2" || ofMode || column(head, 63, 5) == "MODAL") {
        return "a frequency analysis";
    }
    return kind == "4" ? "a buckling analysis" : nullptr;
}

std::size_t realBytes(int format) {
    return format == 3 ? 8 : 4;
}

double realAt(const std::string& bytes, std::size_t at, int format) {
    return format == 3 ? valueAt<double>(bytes, at) : static_cast<double>(valueAt<float>(bytes, at));
}

constexpr std::string_view digits = "0123456789", signs = "+-", blanks = " \t";
constexpr std::size_t valueWidth = 12;
constexpr std::size_t valuesInLine = 6;
constexpr std::size_t shortExponent = 3;  // digits of an exponent without its letter

std::size_t behind(std::string_view text, std::size_t from, std::string_view characters, std::size_t most = std::string::npos) {
    const std::size_t end = std::min(text.find_first_not_of(characters, from), text.size());
    return std::min(end, most > text.size() - from ? text.size() : from + most);
}

// Where the number that begins a text ends. Digits before a point that follow an exponent begin the next number, with one digit.
std::size_t endOfReal(std::string_view text) {
    std::size_t end = behind(text, 0, signs, 1);
    if (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) {
        return std::min(text.find_first_of(" \t+-", end), text.size());
    }
    end = behind(text, behind(text, behind(text, end, digits), ".", 1), digits);
    const std::size_t letter = behind(text, end, "EeDd", 1), exponent = behind(text, letter, signs, 1);
    std::size_t last = behind(text, exponent, digits);
    if (last < text.size() && text[last] == '.' && last > exponent) {
        --last;
    }
    const bool isExponent = letter > end ? last > exponent : exponent > letter && last - exponent == shortExponent;
    return isExponent ? last : end;
}

// The reals of a line from a place on: in columns of twelve where the line is as long as they are together. Writers of exponents
// with three digits fill the columns or run over them, so their numbers part by sign and exponent alone.
bool realsOf(const std::string& line, std::size_t from, std::size_t inLine, Vec3& value) {
    std::string_view text(line);
    text = text.substr(std::min(from, text.size()));
    text = text.substr(0, text.find_last_not_of(blanks) + 1);
    const bool columns = text.size() == inLine * valueWidth;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t first = columns ? axis * valueWidth : std::min(text.find_first_not_of(blanks), text.size());
        const std::size_t width = columns ? valueWidth : endOfReal(text.substr(first));
        if (!toReal(column(std::string(text), first, width), value[static_cast<Eigen::Index>(axis)])) {
            return false;
        }
        if (!columns) {
            text = text.substr(first + width);
        }
    }
    return true;
}

}  // namespace

FrdFile::FrdFile(const std::string& path) : m_path(path), m_window(path) {
    std::string line;
    while (m_window.line(line)) {
        if (line.starts_with("    2C")) {
            readNodes(line);
        } else if (line.starts_with("    3C")) {
            readElements(line);
        } else if (line.starts_with("    1PMODE")) {
            m_ofMode = true;
        } else if (line.starts_with("  100C") && (m_window.place() >= m_window.size() || !readResult(line))) {
            m_findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                           {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, path);
            break;
        } else if (line.starts_with(" 9999")) {
            break;
        }
    }
    finish();
}

void FrdFile::fail(const std::string& what) const {
    throw ParseError({"frd.broken", "{0}: before byte {1} {2}", {m_path, static_cast<std::int64_t>(m_window.place()), what}},
                     {"frd.broken.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
}

// The format stands at the end of a block's first line.
int FrdFile::formatOf(const std::string& head) const {
    std::int64_t format = 1;
    const std::string last = column(head, head.size() < 5 ? 0 : head.find_last_of(' '), 16);
    if (!toInteger(last, format) || format < 0 || format > 3) {
        fail("the format of a block should be 0 to 3, but is \"" + last + "\"");
    }
    return static_cast<int>(format);
}

std::size_t FrdFile::countOf(const std::string& head, std::size_t bytesEach) const {
    std::int64_t count = 0;
    if (!toInteger(column(head, 24, 12), count) || count < 0) {
        fail("a block should say how many entries it has, but says \"" + column(head, 24, 12) + "\"");
    }
    if (static_cast<std::uint64_t>(count) > (m_window.size() - std::min(m_window.place(), m_window.size())) / bytesEach) {
        fail("a block says that it has " + std::to_string(count) + " entries, more than the file can hold");
    }
    return static_cast<std::size_t>(count);
}

void FrdFile::readNodes(const std::string& head) {
    const int format = formatOf(head);
    const std::size_t each = format < 2 ? 3 + (format == 0 ? 5 : 10) + 3 : 4 + 3 * realBytes(format);
    const std::size_t count = countOf(head, each);
    m_mesh.nodeIds.clear();
    m_mesh.nodes.clear();
    std::string text;
    for (std::size_t n = 0; n < count; ++n) {
        Vec3 place = Vec3::Zero();
        std::int64_t number = 0;
        if (format >= 2) {
            if (!m_window.bytes(each, text)) {
                fail("the nodes end after " + std::to_string(n) + " of " + std::to_string(count));
            }
            number = valueAt<std::int32_t>(text, 0);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                place[static_cast<Eigen::Index>(axis)] = realAt(text, 4 + axis * realBytes(format), format);
            }
        } else {
            const std::size_t width = format == 0 ? 5 : 10;
            if (!m_window.line(text) || !text.starts_with(" -1") || !toInteger(column(text, 3, width), number) ||
                !realsOf(text, 3 + width, 3, place)) {
                fail("a node should stand, but there is \"" + text.substr(0, 40) + "\"");
            }
        }
        m_mesh.nodeIds.push_back(number);
        m_mesh.nodes.push_back(place);
    }
}

void FrdFile::readElements(const std::string& head) {
    const int format = formatOf(head);
    const std::size_t count = countOf(head, format < 2 ? 20 : 16);
    m_elements.clear();
    if (format < 2) {
        readTextElements(count, format, m_elements);
    } else {
        readBinaryElements(count, m_elements);
    }
}

void FrdFile::readTextElements(std::size_t count, int format, std::vector<Element>& elements) {
    const std::size_t width = format == 0 ? 5 : 10;
    std::string text;
    const auto bad = [&] { fail("an element should stand, but there is \"" + text.substr(0, 40) + "\""); };
    for (std::size_t e = 0; e < count; ++e) {
        Element element{};
        if (!m_window.line(text) || !text.starts_with(" -1") || !toInteger(column(text, 3, width), element.number) ||
            !toInteger(column(text, 3 + width, 5), element.type)) {
            bad();
        }
        toInteger(column(text, 13 + width, 5), element.material);
        const auto type = typeOf(element.type);
        const std::size_t nodes = type ? type->nodes : 0;
        while (element.nodes.size() < nodes) {
            if (!m_window.line(text) || !text.starts_with(" -2")) {
                bad();
            }
            std::int64_t node = 0;
            const std::size_t before = element.nodes.size();
            for (std::size_t at = 3; element.nodes.size() < nodes && toInteger(column(text, at, width), node); at += width) {
                element.nodes.push_back(node);
            }
            if (element.nodes.size() == before) {
                bad();
            }
        }
        if (!type) {
            fail("there is an element of the type " + std::to_string(element.type) + ", which the format does not have");
        }
        elements.push_back(std::move(element));
    }
}

void FrdFile::readBinaryElements(std::size_t count, std::vector<Element>& elements) {
    std::string text;
    for (std::size_t e = 0; e < count; ++e) {
        if (!m_window.bytes(16, text)) {
            fail("the elements end after " + std::to_string(e) + " of " + std::to_string(count));
        }
        Element element{valueAt<std::int32_t>(text, 0), valueAt<std::int32_t>(text, 4), valueAt<std::int32_t>(text, 12), {}};
        const auto type = typeOf(element.type);
        if (!type) {
            fail("there is an element of the type " + std::to_string(element.type) + ", which the format does not have");
        }
        if (!m_window.bytes(4 * type->nodes, text)) {
            fail("the elements end after " + std::to_string(e) + " of " + std::to_string(count));
        }
        for (std::size_t n = 0; n < type->nodes; ++n) {
            element.nodes.push_back(valueAt<std::int32_t>(text, 4 * n));
        }
        elements.push_back(std::move(element));
    }
}

// @return false if the file ends inside the block
bool FrdFile::readResult(const std::string& head) {
    FrdState state;
    state.format = formatOf(head);
    const char* const shapes = shapesOf(head, std::exchange(m_ofMode, false));
    if (!toReal(column(head, 12, 12), state.time)) {
        fail("a block of results should have a time, but has \"" + column(head, 12, 12) + "\"");
    }
    toInteger(column(head, 58, 5), state.step);
    std::string line;
    if (!m_window.line(line) || !line.starts_with(" -4")) {
        return false;
    }
    const std::string name = column(line, 5, 8);
    std::int64_t listed = 0;
    toInteger(column(line, 13, 5), listed);
    if (listed < 1 || listed > 1000) {
        fail("a block of results has " + std::to_string(listed) + " components");
    }
    state.components = 0;
    for (std::int64_t c = 0; c < listed; ++c) {
        std::int64_t derived = 0;
        if (!m_window.line(line) || !line.starts_with(" -5")) {
            return false;
        }
        toInteger(column(line, 33, 5), derived);
        state.components += derived == 0 ? 1 : 0;
    }
    state.offset = m_window.place();
    const std::size_t each = state.format < 2 ? 8 : 4 + state.components * realBytes(state.format);
    std::int64_t nodes = 0;
    if (!toInteger(column(head, 24, 12), nodes) || nodes < 0) {
        fail("a block of results should say how many nodes it has");
    }
    state.nodes = static_cast<std::size_t>(nodes);
    if (state.nodes > (m_window.size() - m_window.place()) / each || !skipBlock(state)) {
        return false;
    }
    if (name == "DISP" && shapes) {
        m_shapes = shapes;
        ++m_shapeCount;
    } else if (name == "DISP" && state.components >= 3) {
        // A step that ends where the next begins writes its time twice: the newer counts.
        while (!m_states.empty() && m_states.back().time == state.time) {
            m_states.pop_back();
        }
        m_states.push_back(state);
    }
    return true;
}

bool FrdFile::skipBlock(const FrdState& state) {
    if (state.format >= 2) {
        m_window.skip(state.nodes * (4 + state.components * realBytes(state.format)));
        return m_window.place() <= m_window.size();
    }
    for (std::string line; m_window.line(line);) {
        if (line.starts_with(" -3")) {
            return true;
        }
        if (m_window.place() >= m_window.size()) {
            return false;
        }
        if (!line.starts_with(" -1") && !line.starts_with(" -2")) {
            fail("a block of results goes on with \"" + line.substr(0, 40) + "\"");
        }
    }
    return false;
}

// A step of frequencies may stand before one in time, which is made of its shapes.
void FrdFile::noteShapes() {
    if (m_shapeCount > 0 && m_states.empty()) {
        throw ParseError(
            {"frd.analysis", "{0} is {1} of CalculiX, whose shapes are no states of a course of time", {m_path, m_shapes}},
            {"rst.analysis.remedy", "Give the results of the collapse: a static or a transient analysis.", {}});
    }
    if (m_shapeCount > 0) {
        m_findings.add(
            {"frd.shapes", "Shapes of frequencies or of buckling are no states of a course of time: they were left out", {}},
            {"frd.shapes.remedy", "Nothing to do: the states of the other steps were read.", {}}, m_path, m_shapeCount);
    }
}

void FrdFile::finish() {
    noteShapes();
    if (m_elements.empty()) {
        throw ParseError({"fe.no_elements", "{0} has no solids, shells or beams", {m_path}},
                         {"fe.no_elements.remedy", "Give an analysis whose structure is made of such elements.", {}});
    }
    m_mesh.offsets.push_back(0);
    std::unordered_map<std::int64_t, std::uint32_t> places;
    for (std::size_t n = 0; n < m_mesh.nodeIds.size(); ++n) {
        places.emplace(m_mesh.nodeIds[n], static_cast<std::uint32_t>(n));
    }
    StraightEdges straight;
    for (const Element& element : m_elements) {
        const ElementShape shape = *typeOf(element.type)->shape;
        for (std::size_t c = 0; c < static_cast<std::size_t>(cornerCount(shape)); ++c) {
            const auto found = places.find(element.nodes[c]);
            if (found == places.end()) {
                throw ParseError(
                    {"frd.bad_node",
                     "{0}: element {1} uses the node {2}, which is not there",
                     {m_path, element.number, element.nodes[c]}},
                    {"frd.broken.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
            }
            m_mesh.corners.push_back(found->second);
        }
        straight.add(shape, EdgeOrder::SidesBeforeTop, placesOfNodes(element.nodes, places, m_mesh.nodes),
                     "element " + englishInteger(element.number));
        addElement(element);
    }
    straight.note(m_findings);
    m_elements = {};
}

void FrdFile::addElement(const Element& element) {
    std::uint32_t part = 0;
    while (part < m_mesh.parts.size() && m_mesh.parts[part].fileId != element.material) {
        ++part;
    }
    if (part == m_mesh.parts.size()) {
        m_mesh.parts.push_back({"material " + std::to_string(element.material), element.material});
    }
    m_mesh.part.push_back(part);
    m_mesh.elementIds.push_back(element.number);
    m_mesh.shapes.push_back(*typeOf(element.type)->shape);
    m_mesh.offsets.push_back(static_cast<std::uint32_t>(m_mesh.corners.size()));
}

FrdValues FrdFile::read(const FrdState& state) const {
    const std::scoped_lock lock(m_mutex);
    FrdValues result;
    std::string text;
    m_window.seek(state.offset);
    const std::size_t each = 4 + state.components * realBytes(state.format);
    const std::size_t width = state.format == 0 ? 5 : 10;
    while (result.nodes.size() < state.nodes) {
        Vec3 value = Vec3::Zero();
        std::int64_t number = 0;
        bool right = true;
        if (state.format >= 2) {
            right = m_window.bytes(each, text);
            number = right ? valueAt<std::int32_t>(text, 0) : 0;
            for (std::size_t axis = 0; right && axis < 3; ++axis) {
                value[static_cast<Eigen::Index>(axis)] = realAt(text, 4 + axis * realBytes(state.format), state.format);
            }
        } else {
            right = m_window.line(text);
            if (right && text.starts_with(" -2")) {
                continue;
            }
            right = right && text.starts_with(" -1") && toInteger(column(text, 3, width), number) &&
                    realsOf(text, 3 + width, std::min(state.components, valuesInLine), value);
        }
        if (!right) {
            fail("the displacements of " + std::to_string(state.nodes) + " nodes end after " + std::to_string(result.nodes.size()));
        }
        result.nodes.push_back(number);
        result.values.push_back(value);
    }
    return result;
}

}  // namespace rubble::io
