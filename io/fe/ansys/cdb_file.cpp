#include "io/fe/ansys/cdb_file.h"

#include <algorithm>
#include <limits>
#include <span>
#include <unordered_map>

#include "core/base/error.h"
#include "io/fe/ansys/ansys_elements.h"
#include "io/fe/series/byte_window.h"

namespace rubble::io {

namespace {

constexpr std::size_t headerFields = 11;  // of an element, before its nodes

/// A Fortran format of integers and then reals: "(3i9,6e21.13e3)".
struct BlockFormat {
    std::size_t integers = 0, integerWidth = 0, realWidth = 0;
};

BlockFormat formatOf(const std::string& text) {
    BlockFormat format;
    std::size_t number = 0, repeat = 1;
    char kind = 0;
    for (const char c : upperCase(text)) {
        if (c >= '0' && c <= '9') {
            number = std::min<std::size_t>(10 * number + static_cast<std::size_t>(c - '0'), 1000);
            continue;
        }
        if (kind == 'I' && format.integerWidth == 0) {
            format.integers = repeat;
            format.integerWidth = number;
        } else if (kind == 'E' && format.realWidth == 0) {
            format.realWidth = number;
        }
        if (c == 'I' || c == 'E') {
            repeat = number;
            kind = kind == 'E' && c == 'E' ? 'X' : c;
        } else {
            kind = c == '.' ? 'X' : 0;
        }
        number = 0;
    }
    return format;
}

/// "time=39.97" or "time 9.95" in a comment.
std::optional<double> timeIn(const std::string& comment) {
    const std::string text = upperCase(comment);
    const std::size_t word = text.find("TIME");
    if (word == std::string::npos) {
        return std::nullopt;
    }
    const std::size_t first = text.find_first_not_of(" =:", word + 4);
    double time = 0.0;
    const bool right = first != std::string::npos && first > word + 4 &&
                       toReal(column(text, first, text.find_first_of(" ,;", first) - first), time);
    return right ? std::optional(time) : std::nullopt;
}

class CdbReader {
public:
    explicit CdbReader(const std::string& path) : m_path(path), m_window(path) { m_model.mesh.offsets.push_back(0); }

    CdbModel read() {
        std::string line;
        while (m_window.line(line)) {
            const std::string key = upperCase(line.substr(0, 8));
            if (key.starts_with("NBLOCK,")) {
                readNodes(fieldsOf(line));
            } else if (key.starts_with("EBLOCK,")) {
                readElements(fieldsOf(line));
            } else if (key.starts_with("ETBLOCK,")) {
                readTypes();
            } else if (key.starts_with("ET,")) {
                readType(fieldsOf(line));
            } else if (key.starts_with("MP,") || key.starts_with("MPDATA,")) {
                readDensity(fieldsOf(line));
            } else if (key.starts_with("TIME,")) {
                double time = 0.0;
                if (toReal(fieldsOf(line)[1], time)) {
                    m_model.time = time;
                }
            } else if ((key.starts_with("/COM") || key.starts_with("!")) && !m_model.time) {
                m_model.time = timeIn(line);
            }
        }
        finish();
        return std::move(m_model);
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw ParseError(
            {"cdb.broken", "{0}: before byte {1}: {2}", {m_path, static_cast<std::int64_t>(m_window.place()), what}},
            {"cdb.broken.remedy", "The file is damaged: copy it again, or let CDWRITE write it again (blocked format).", {}});
    }

    BlockFormat readFormat() {
        std::string line;
        if (!m_window.line(line)) {
            fail("a block has no format");
        }
        const BlockFormat format = formatOf(line);
        if (format.integers < 1 || format.integers > 100 || format.integerWidth < 1 || format.integerWidth > 40 ||
            format.realWidth > 60) {
            fail("the format \"" + line.substr(0, 40) + "\" is not known");
        }
        return format;
    }

    void readNodes(const std::vector<std::string>&) {
        const BlockFormat format = readFormat();
        if (format.realWidth == 0) {
            fail("the nodes' format has no reals");
        }
        std::string line;
        while (m_window.line(line)) {
            std::int64_t number = 0;
            if (upperCase(line).starts_with("N,") || column(line, 0, format.integerWidth) == "-1") {
                return;
            }
            if (!toInteger(column(line, 0, format.integerWidth), number)) {
                fail("a node should stand, but there is \"" + line.substr(0, 40) + "\"");
            }
            Vec3 place = Vec3::Zero();
            for (std::size_t axis = 0; axis < 3; ++axis) {
                // Zeros at the end of a line may be left out.
                const std::string text =
                    column(line, format.integers * format.integerWidth + axis * format.realWidth, format.realWidth);
                if (!text.empty() && !toReal(text, place[static_cast<Eigen::Index>(axis)])) {
                    fail("node " + std::to_string(number) + " has the coordinate \"" + text + "\"");
                }
            }
            m_model.mesh.nodeIds.push_back(number);
            m_model.mesh.nodes.push_back(place);
        }
        fail("the nodes have no end");
    }

    void readElements(const std::vector<std::string>& head) {
        if (head.size() < 3 || upperCase(head[2]) != "SOLID") {
            fail("elements are not written in the solid format (EBLOCK,19,SOLID)");
        }
        const BlockFormat format = readFormat();
        std::string line;
        while (m_window.line(line)) {
            std::vector<std::int64_t> values = integersOf(line, format);
            if (values.size() == 1 && values[0] == -1) {
                return;
            }
            if (values.size() < headerFields || values[8] < 0 || values[8] > 100) {
                fail("an element should stand, but there is \"" + line.substr(0, 60) + "\"");
            }
            const std::size_t nodes = static_cast<std::size_t>(values[8]);
            while (values.size() < headerFields + nodes) {
                const std::vector<std::int64_t> more = m_window.line(line) ? integersOf(line, format) : std::vector<std::int64_t>();
                if (more.empty()) {
                    fail("element " + std::to_string(values[10]) + " does not have its " + std::to_string(nodes) + " nodes");
                }
                values.insert(values.end(), more.begin(), more.end());
            }
            values.resize(headerFields + nodes);
            m_elements.push_back(std::move(values));
        }
        fail("the elements have no end");
    }

    std::vector<std::int64_t> integersOf(const std::string& line, const BlockFormat& format) const {
        std::vector<std::int64_t> values;
        std::int64_t value = 0;
        for (std::size_t i = 0; i < format.integers; ++i) {
            const std::string text = column(line, i * format.integerWidth, format.integerWidth);
            if (text.empty()) {
                break;
            }
            if (!toInteger(text, value)) {
                fail("an integer should stand, but there is \"" + text.substr(0, 20) + "\"");
            }
            values.push_back(value);
        }
        return values;
    }

    // What is written since 2023 instead of ET: a line for each type, with its number, its routine and its options.
    void readTypes() {
        const BlockFormat format = readFormat();
        std::string line;
        while (m_window.line(line)) {
            const std::string number = column(line, 0, format.integerWidth);
            if (number == "-1") {
                return;
            }
            setType(number, column(line, format.integerWidth, format.integerWidth));
        }
        fail("the types of elements have no end");
    }

    void readType(const std::vector<std::string>& fields) {
        if (fields.size() >= 3) {
            setType(fields[1], fields[2]);
        }
    }

    // The routine stands alone or behind the name of the family: SOLID185.
    void setType(const std::string& type, const std::string& element) {
        std::int64_t number = 0, routine = 0;
        const std::size_t digits = element.find_first_of("0123456789");
        if (toInteger(type, number) && digits != std::string::npos && toInteger(element.substr(digits), routine)) {
            m_types[number] = routine;
        }
    }

    // MP,DENS,mat,value; MPDATA,[revision,1,]DENS,mat,location,value.
    void readDensity(const std::vector<std::string>& fields) {
        for (std::size_t i = 1; i + 2 < fields.size(); ++i) {
            std::int64_t material = 0;
            double density = 0.0;
            const bool data = upperCase(fields[0]) == "MPDATA";
            const std::size_t value = i + (data ? 3 : 2);
            if (upperCase(fields[i]) == "DENS" && value < fields.size() && toInteger(fields[i + 1], material) &&
                toReal(fields[value], density)) {
                m_densities[material] = density;
            }
        }
    }

    void finish() {
        std::unordered_map<std::int64_t, std::uint32_t> places;
        for (std::size_t n = 0; n < m_model.mesh.nodeIds.size(); ++n) {
            places.emplace(m_model.mesh.nodeIds[n], static_cast<std::uint32_t>(n));
        }
        for (const std::vector<std::int64_t>& values : m_elements) {
            const auto type = m_types.find(values[1]);
            const auto shape = type == m_types.end() ? std::nullopt : shapeOfAnsys(type->second, values.size() - headerFields);
            if (shape) {
                addElement(values, *shape, places);
                continue;
            }
            if (type == m_types.end()) {
                m_model.findings.add({"cdb.no_type", "Elements whose type the file does not say were left out", {}},
                                     {"cdb.no_type.remedy", "Let CDWRITE write the whole database (CDWRITE,DB).", {}},
                                     "element " + englishInteger(values[10]) + " of type " + std::to_string(values[1]));
                continue;
            }
            m_model.findings.add(
                {"fe.skipped", "Elements of a type that makes no fragment were left out", {}},
                {"fe.skipped.remedy", "Nothing to do if they are masses, springs, contacts or rigid surfaces.", {}},
                "element " + englishInteger(values[10]) + " of type " + std::to_string(type->second));
        }
        if (m_model.mesh.elementCount() == 0 && m_model.findings.count("cdb.no_type") > 0) {
            throw ParseError({"cdb.no_types", "{0} does not say of which types its {1} elements are", {m_path, m_elements.size()}},
                             {"cdb.no_type.remedy", "Let CDWRITE write the whole database (CDWRITE,DB).", {}});
        }
    }

    void addElement(const std::vector<std::int64_t>& values, ElementShape shape,
                    const std::unordered_map<std::int64_t, std::uint32_t>& places) {
        Mesh& mesh = m_model.mesh;
        for (std::size_t c = 0; c < static_cast<std::size_t>(cornerCount(shape)); ++c) {
            const auto found = headerFields + c < values.size() ? places.find(values[headerFields + c]) : places.end();
            if (found == places.end()) {
                fail("element " + std::to_string(values[10]) + " uses a node that is not there");
            }
            mesh.corners.push_back(found->second);
        }
        if (shape != ElementShape::Beam) {
            m_model.straight.add(shape, EdgeOrder::TopBeforeSides,
                                 placesOfNodes(std::span(values).subspan(headerFields), places, mesh.nodes),
                                 "element " + englishInteger(values[10]));
        }
        std::uint32_t part = 0;
        while (part < mesh.parts.size() && mesh.parts[part].fileId != values[0]) {
            ++part;
        }
        if (part == mesh.parts.size()) {
            mesh.parts.push_back({"material " + std::to_string(values[0]), values[0]});
        }
        const auto density = m_densities.find(values[0]);
        mesh.part.push_back(part);
        mesh.elementIds.push_back(values[10]);
        mesh.shapes.push_back(shape);
        mesh.offsets.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        mesh.density.push_back(density == m_densities.end() ? std::numeric_limits<double>::quiet_NaN() : density->second);
        m_model.flags.push_back(static_cast<double>(values[5]));
    }

    const std::string& m_path;
    ByteWindow m_window;
    CdbModel m_model;
    std::vector<std::vector<std::int64_t>> m_elements;  // fields as written, nodes behind them
    std::map<std::int64_t, std::int64_t> m_types;
    std::map<std::int64_t, double> m_densities;
};

}  // namespace

CdbModel readCdb(const std::string& path) {
    return CdbReader(path).read();
}

// Blank lines and other commands may stand before the blocks.
bool beginsAsCdb(const std::string& head) {
    const std::string text = upperCase(head);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    const std::string commands = first == std::string::npos ? "" : '\n' + text.substr(first);
    const auto has = [&commands](std::string_view command) { return commands.find(command) != std::string::npos; };
    const bool known = commands.starts_with("\n/COM") || commands.starts_with("\n/PREP7") || commands.starts_with("\n!") ||
                       commands.starts_with("\n/NOPR");
    return has("\nNBLOCK,") || has("\nETBLOCK,") || (known && (has("NBLOCK,") || has("\n/PREP7")));
}

std::vector<KillEvent> readKills(const std::string& path, std::vector<double>& times, Findings& findings) {
    ByteWindow window(path);
    std::vector<KillEvent> events, pending;
    double time = 0.0;
    bool solves = false;
    const auto flush = [&] {
        for (KillEvent& event : pending) {
            event.time = time;
            events.push_back(event);
        }
        pending.clear();
        if (times.empty() || time > times.back()) {
            times.push_back(time);
        }
    };
    for (std::string line; window.line(line);) {
        const std::vector<std::string> fields = fieldsOf(line);
        const std::string key = upperCase(fields[0]);
        const std::optional<double> comment = key.starts_with("!") || key.starts_with("/COM") ? timeIn(line) : std::nullopt;
        double value = 0.0;
        if (key == "SOLVE") {
            solves = true;
            flush();
        } else if (comment || (key == "TIME" && fields.size() > 1 && toReal(fields[1], value))) {
            if (!solves && !pending.empty()) {
                flush();
            }
            time = comment.value_or(value);
        } else if ((key == "EKILL" || key == "EALIVE") && fields.size() > 1) {
            KillEvent event{0, time, key == "EALIVE"};
            if (toInteger(fields[1], event.element)) {
                pending.push_back(event);
            } else {
                findings.add({"cdb.kill_name", "Kills that do not name an element by number were passed over", {}},
                             {"cdb.kill_name.remedy", "Put a list of deaths (element,time) beside the file.", {}},
                             line.substr(0, 60));
            }
        }
    }
    if (!pending.empty()) {
        flush();
    }
    return events;
}

}  // namespace rubble::io
