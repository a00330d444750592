#include "io/fe/marc/marc_file.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "io/fe/marc/marc_mesh.h"

namespace rubble::io {

namespace {

constexpr std::size_t fieldWidth = 13;
constexpr std::size_t fieldsOfLine = 6;

bool isStress(std::int64_t code) {
    return (code >= 11 && code <= 17) || (code >= 311 && code <= 317);
}

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

std::size_t linesOf(std::size_t fields) {
    return (fields + fieldsOfLine - 1) / fieldsOfLine;
}

}  // namespace

bool MarcFields::field(std::string& text) {
    while (m_at >= m_line.size() || m_line.find_first_not_of(' ', m_at) == std::string::npos) {
        if (!m_window.line(m_line) || m_line.starts_with("=")) {
            m_line.clear();
            return false;
        }
        m_at = 0;
    }
    text = column(m_line, m_at, fieldWidth);
    m_at += fieldWidth;
    return true;
}

bool MarcFields::integer(std::int64_t& value) {
    std::string text;
    return field(text) && toInteger(text, value);
}

bool MarcFields::real(double& value) {
    std::string text;
    return field(text) && toReal(text, value);
}

MarcFile::MarcFile(const std::string& path) : m_path(path), m_window(path) {
    std::string line;
    std::uint64_t begin = m_window.place();
    while (m_window.line(line)) {
        if (line.starts_with("=beg=")) {
            readBlock(line, begin, nullptr);
        } else if (line.starts_with("****")) {
            if (!wholeIncrement()) {
                m_findings.add({"fe.unfinished", "The last state is not whole and was left out", {}},
                               {"fe.unfinished.remedy", "Open the result again once the analysis has gone on.", {}}, path);
                break;
            }
        } else if (line.starts_with("++++")) {
            break;
        }
        begin = m_window.place();
    }
    if (m_model.nodes == 0) {
        fail("there is no mesh");
    }
}

void MarcFile::fail(const std::string& what) const {
    throw ParseError({"marc.broken", "{0}: before byte {1}: {2}", {m_path, static_cast<std::int64_t>(m_window.place()), what}},
                     {"marc.broken.remedy", "The file is damaged: copy it again or let the analysis write it again.", {}});
}

std::size_t MarcFile::count(std::uint64_t value, const char* what) const {
    if (value > m_window.size() / fieldWidth) {
        fail(std::string("the number of ") + what + " is " + std::to_string(value) + ", more than the file can hold");
    }
    return static_cast<std::size_t>(value);
}

// What the file ends in is still being written.
bool MarcFile::wholeIncrement() {
    try {
        return readIncrement();
    } catch (const ParseError&) {
        if (m_increments.empty() || m_window.place() < m_window.size()) {
            throw;
        }
        return false;
    }
}

// @return false if the file ends inside it
bool MarcFile::readIncrement() {
    MarcIncrement increment;
    std::string line;
    std::uint64_t begin = m_window.place();
    while (m_window.line(line)) {
        if (line.starts_with("----")) {
            increment.nodes = m_model.nodes;
            // A restart writes its increment again: the newer counts.
            while (!m_increments.empty() && increment.time == m_increments.back().time) {
                if (!increment.mesh) {
                    increment.mesh = m_increments.back().mesh;
                }
                m_increments.pop_back();
            }
            if (m_increments.empty()) {
                increment.mesh = increment.mesh.value_or(m_model.offset);
            }
            m_increments.push_back(std::move(increment));
            return true;
        }
        if (line.starts_with("=beg=")) {
            readBlock(line, begin, &increment);
        }
        begin = m_window.place();
    }
    return false;
}

void MarcFile::readBlock(const std::string& head, std::uint64_t begin, MarcIncrement* increment) {
    std::int64_t code = 0;
    toInteger(column(head, 5, 5), code);
    if (code == 50200) {
        readVerification();
        m_model.offset = begin;
        if (increment) {
            increment->mesh = begin;
        }
    } else if (code / 100 == 506) {
        readCodes();
    } else if (code == 51801 && increment) {
        readTimes(*increment);
    } else if (code / 100 == 523 && increment) {
        readStress(*increment);
        return;
    } else if (code / 100 == 524 && increment && readNodal(*increment)) {
        return;
    }
    skipToEnd();
}

void MarcFile::skipToEnd() {
    const std::uint64_t before = m_window.place();
    for (std::string line; m_window.line(line);) {
        if (line.starts_with("=end=")) {
            return;
        }
        if (line.starts_with("=beg=") || line.starts_with("****") || line.starts_with("----")) {
            m_window.seek(before);
            fail("a block has no end");
        }
    }
}

void MarcFile::readVerification() {
    MarcFields fields(m_window);
    std::array<std::int64_t, 14> values{};
    for (std::int64_t& value : values) {
        if (!fields.integer(value) || value < -1'000'000'000) {
            fail("the verification data is not whole");
        }
    }
    const auto at = [&](std::size_t i) { return static_cast<std::uint64_t>(std::max<std::int64_t>(values[i], 0)); };
    m_model = {};
    m_model.values = count(at(0), "element post codes");
    m_model.nodes = count(at(1), "nodes");
    m_model.elements = count(at(2), "elements");
    m_model.points = count(std::max<std::uint64_t>(at(4), 1), "integration points");
    if (values[8] != 3) {
        throw ParseError({"marc.flat", "{0} has {1} coordinates a node instead of three", {m_path, values[8]}},
                         {"marc.flat.remedy", "Give a three-dimensional analysis.", {}});
    }
}

// A code and its label on each line.
void MarcFile::readCodes() {
    std::string line;
    std::int64_t code = 0;
    for (std::size_t i = 0; i < m_model.values; ++i) {
        const std::uint64_t before = m_window.place();
        if (!m_window.line(line) || line.starts_with("=") || !toInteger(column(line, 0, fieldWidth), code)) {
            m_window.seek(before);
            return;
        }
        m_model.codes.push_back(code);
    }
}

void MarcFile::readTimes(MarcIncrement& increment) {
    MarcFields fields(m_window);
    std::int64_t number = 0;
    if (!fields.integer(number)) {
        fail("an increment does not say its time");
    }
    fields.newLine();
    if (!fields.real(increment.time)) {
        fail("an increment does not say its time");
    }
}

// Values point by point: each on lines of its own, each element on lines of its own, or all in a row. The number of lines tells
// which.
void MarcFile::readStress(MarcIncrement& increment) {
    const std::uint64_t begin = m_window.place();
    std::size_t lines = 0;
    std::string line;
    while (m_window.line(line) && !line.starts_with("=")) {
        ++lines;
    }
    const std::uint64_t end = m_window.place();
    std::vector<std::size_t> stresses;
    for (std::size_t i = 0; i < m_model.codes.size(); ++i) {
        if (isStress(m_model.codes[i])) {
            stresses.push_back(i);
        }
    }
    const std::size_t perElement = m_model.points * m_model.values;
    if (stresses.empty() || m_model.elements == 0 || perElement > m_window.size() / m_model.elements) {
        return;
    }
    const bool byPoint = lines == m_model.elements * m_model.points * linesOf(m_model.values);
    const bool byElement = lines == m_model.elements * linesOf(perElement);
    if (!byPoint && !byElement && lines != linesOf(m_model.elements * perElement)) {
        m_findings.add({"marc.stress", "Element values do not have the length that their counts give and were passed over", {}},
                       {"marc.stress.remedy", "Nothing to do if the dead are left out of the mesh.", {}}, m_path);
        return;
    }
    m_window.seek(begin);
    MarcFields fields(m_window);
    increment.stressed.assign(m_model.elements, false);
    for (std::size_t e = 0; e < m_model.elements; ++e) {
        for (std::size_t p = 0; p < m_model.points; ++p) {
            for (std::size_t i = 0; i < m_model.values; ++i) {
                double value = 0.0;
                if (!fields.real(value)) {
                    fail("element values end before element " + std::to_string(e + 1));
                }
                const bool stress = std::find(stresses.begin(), stresses.end(), i) != stresses.end();
                increment.stressed[e] = increment.stressed[e] || (stress && value != 0.0);
            }
            if (byPoint) {
                fields.newLine();
            }
        }
        if (byElement) {
            fields.newLine();
        }
    }
    m_window.seek(end);
}

// @return true if the end of the block has been read
bool MarcFile::readNodal(MarcIncrement& increment) {
    MarcFields fields(m_window);
    std::int64_t vectors = 0;
    if (!fields.integer(vectors) || vectors < 0 || vectors > 1000) {
        fail("nodal results do not say how many vectors there are");
    }
    std::string name;
    for (std::int64_t v = 0; v < vectors; ++v) {
        MarcFields numbers(m_window);
        std::array<std::int64_t, 12> about{};
        if (!m_window.line(name) || name.starts_with("=")) {
            return true;
        }
        for (std::int64_t& value : about) {
            if (!numbers.integer(value)) {
                fail("the nodal vector \"" + column(name, 0, 48) + "\" is not described");
            }
        }
        const std::size_t components = count(static_cast<std::uint64_t>(std::max<std::int64_t>(about[3], 0)), "components");
        const MarcVector vector{m_window.place(), components};
        const std::string key = lowerCase(column(name, 0, 48));
        if (about[6] == -1 && components == 3 && key == "displacement") {
            increment.displacement = vector;
        } else if (about[6] == -1 && components == 3 && key == "velocity") {
            increment.velocity = vector;
        } else if (about[6] != -1) {
            return false;  // a list of nodes of its own: nobody knows how long
        }
        std::string line;
        for (std::size_t i = 0; i < linesOf(count(m_model.nodes * components, "nodal values")); ++i) {
            const std::uint64_t before = m_window.place();
            if (!m_window.line(line) || line.starts_with("=")) {
                m_window.seek(before);
                fail("the nodal vector \"" + column(name, 0, 48) + "\" ends after " + std::to_string(i) + " lines");
            }
        }
    }
    return false;
}

Mesh MarcFile::readMesh(std::uint64_t offset, Findings& findings) const {
    const std::scoped_lock lock(m_mutex);
    m_window.seek(offset);
    return readMarcMesh(m_window, findings);
}

std::vector<Vec3> MarcFile::readVectors(const MarcVector& vector, std::size_t nodes) const {
    const std::scoped_lock lock(m_mutex);
    m_window.seek(vector.offset);
    MarcFields fields(m_window);
    std::vector<Vec3> values;
    for (std::size_t n = 0; n < nodes; ++n) {
        Vec3 value;
        if (!fields.real(value.x()) || !fields.real(value.y()) || !fields.real(value.z())) {
            fail("nodal values end after " + std::to_string(n) + " of " + std::to_string(nodes) + " nodes");
        }
        values.push_back(value);
    }
    return values;
}

}  // namespace rubble::io
