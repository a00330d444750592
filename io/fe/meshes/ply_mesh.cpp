#include "io/fe/meshes/ply_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "io/base/file_words.h"
#include "io/fe/meshes/ply_header.h"

namespace rubble::io {

namespace {

/// The numbers behind the head, one after the other, whether text or bytes.
class PlyNumbers {
public:
    PlyNumbers(const std::string& path, MeshLines& lines, const PlyHeader& header)
        : m_path(path), m_lines(lines), m_header(header) {}

    double real(NumberType type) {
        if (!m_header.text) {
            return realsIn(bytes(type.bytes), type, m_header.bigEndian).front();
        }
        m_word = nextWord();
        return m_lines.numberIn(m_word);
    }
    std::int64_t integer(NumberType type) {
        if (!m_header.text) {
            return integersIn(bytes(type.bytes), type, m_header.bigEndian).front();
        }
        const double value = real(type);
        return std::abs(value) < 9e15 ? static_cast<std::int64_t>(value) : std::int64_t{-1};
    }
    /// How finely the number last read is told from its neighbours, 0: finely enough.
    double stepOf(NumberType type, double value) const {
        const bool single = type.kind == NumberType::Kind::Real && type.bytes == sizeof(float);
        return m_header.text ? stepOfText(m_word, value) : single ? stepOfFloat(value) : 0.0;
    }
    /// Of the number last read; 0: there are no lines.
    std::uint64_t line() const { return m_header.text ? m_lines.number() : 0; }
    /// Throws ParseError if a length cannot be that of what is left of the file.
    std::size_t lengthOfList(const PlyProperty& property) {
        const std::int64_t length = integer(property.length);
        const std::uint64_t least = m_header.text ? 1 : property.type.bytes;
        constexpr std::int64_t small = 64;  // found short soon enough
        if (length < 0 || (length > small && static_cast<std::uint64_t>(length) > left() / least + 1)) {
            failCut();
        }
        return static_cast<std::size_t>(length);
    }
    std::uint64_t left() {
        const std::streamoff at = m_lines.file().tellg();
        std::error_code ignored;
        const std::uintmax_t size = std::filesystem::file_size(m_path, ignored);
        return at < 0 || static_cast<std::uintmax_t>(at) > size ? m_rest.size()
                                                                : size - static_cast<std::uintmax_t>(at) + m_rest.size();
    }
    [[noreturn]] void failCut() const {
        refuseContent({"surroundings.cut", "{0} promises more numbers than it holds", {m_path}},
                      "The file may be cut short: copy it again from where it came.");
    }

private:
    std::string_view nextWord() {
        for (;;) {
            const std::string_view word = takeWord(m_rest);
            if (!word.empty()) {
                return word;
            }
            if (!m_lines.next(m_rest)) {
                failCut();
            }
        }
    }
    std::string_view bytes(std::size_t count) {
        if (m_lines.file().rdbuf()->sgetn(m_raw.data(), static_cast<std::streamsize>(count)) !=
            static_cast<std::streamsize>(count)) {
            failCut();
        }
        return {m_raw.data(), count};
    }

    const std::string& m_path;
    MeshLines& m_lines;
    const PlyHeader& m_header;
    std::string_view m_rest;
    std::string_view m_word;
    std::array<char, sizeof(double)> m_raw{};
};

/// Reads one file.
class PlyReading {
public:
    PlyReading(const std::string& path, const Execution& execution)
        : m_path(path),
          m_execution(execution),
          m_lines(path),
          m_header(readPlyHeader(m_lines, path)),
          m_numbers(m_path, m_lines, m_header),
          m_gathering(m_path) {}

    RawMesh read() {
        for (const PlyElement& element : m_header.elements) {
            if (element.count > 0 && (element.properties.empty() || element.count > m_numbers.left())) {
                m_numbers.failCut();
            }
            for (std::uint64_t k = 0; k < element.count; ++k) {
                if (k % 4096 == 0) {
                    m_execution.check();
                }
                element.name == "vertex" ? readPoint(element) : readOther(element);
            }
        }
        return std::move(m_gathering).finish(m_execution);
    }

private:
    void readPoint(const PlyElement& element) {
        Vec3 point = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
        for (const PlyProperty& property : element.properties) {
            const std::size_t axis = std::string_view("xyz").find(property.name);
            if (property.list) {
                passOver(property);
            } else if (property.name.size() == 1 && axis < 3) {
                const double value = m_numbers.real(property.type);
                point[static_cast<Eigen::Index>(axis)] = value;
                m_gathering.noteStep(m_numbers.stepOf(property.type, value));
            } else {
                m_numbers.real(property.type);
            }
        }
        m_gathering.addPoint(point, m_numbers.line());
    }

    void passOver(const PlyProperty& property) {
        for (std::size_t left = m_numbers.lengthOfList(property); left > 0; --left) {
            m_numbers.real(property.type);
        }
    }

    void readOther(const PlyElement& element) {
        const bool strips = element.name == "tristrips";
        for (const PlyProperty& property : element.properties) {
            const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
            if (property.list && corners && (strips || element.name == "face")) {
                readCorners(property, strips);
            } else if (property.list) {
                passOver(property);
            } else {
                m_numbers.real(property.type);
            }
        }
    }

    void readCorners(const PlyProperty& property, bool strips) {
        const std::size_t count = m_numbers.lengthOfList(property);
        m_corners.clear();
        for (std::size_t k = 0; k < count; ++k) {
            const std::int64_t corner = m_numbers.integer(property.type);
            if (strips) {
                addToStrip(corner);
            } else {
                m_corners.push_back(corner);
            }
        }
        if (!strips) {
            m_gathering.addFace(m_corners, m_numbers.line());
        }
    }

    /// Every corner makes a triangle with the two before it, turned the other way each time; one below zero begins anew.
    void addToStrip(std::int64_t corner) {
        if (corner < 0) {
            m_corners.clear();
            return;
        }
        m_corners.push_back(corner);
        if (const std::size_t n = m_corners.size(); n >= 3) {
            const bool turned = n % 2 == 0;
            const std::array<std::int64_t, 3> triangle{m_corners[n - (turned ? 2 : 3)], m_corners[n - (turned ? 3 : 2)], corner};
            m_gathering.addFace(triangle, m_numbers.line());
        }
    }

    const std::string& m_path;
    const Execution& m_execution;
    MeshLines m_lines;
    PlyHeader m_header;
    PlyNumbers m_numbers;
    MeshGathering m_gathering;
    std::vector<std::int64_t> m_corners;
};

}  // namespace

RawMesh readPlyMesh(const std::string& path, const Execution& execution) {
    return PlyReading(path, execution).read();
}

}  // namespace rubble::io
