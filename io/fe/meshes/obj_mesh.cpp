#include "io/fe/meshes/obj_mesh.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "io/base/file_words.h"
#include "io/fe/meshes/mesh_lines.h"
#include "io/fe/vtk/stored_numbers.h"

namespace rubble::io {

namespace {

/// Words that begin free-form curves and surfaces.
constexpr std::array<std::string_view, 3> curvedShapes{"curv", "curv2", "surf"};

/// Reads one file.
class ObjReading {
public:
    ObjReading(const std::string& path, const Execution& execution)
        : m_path(path), m_execution(execution), m_lines(path), m_gathering(m_path) {}

    RawMesh read() {
        std::string_view line;
        while (m_lines.next(line)) {
            if (m_lines.number() % 4096 == 0) {
                m_execution.check();
            }
            const std::string_view word = takeWord(line);
            if (word == "v") {
                readPoint(line);
            } else if (word == "f" || word == "fo") {
                readFace(line);
            } else if (word == "l" || word == "p") {
                m_gathering.leaveOut(1);
            } else if (std::find(curvedShapes.begin(), curvedShapes.end(), word) != curvedShapes.end()) {
                m_gathering.leaveOutCurved();
            }
        }
        return std::move(m_gathering).finish(m_execution);
    }

private:
    void readPoint(std::string_view line) {
        Vec3 point;
        for (double& coordinate : point) {
            const std::string_view text = takeWord(line);
            coordinate = m_lines.numberIn(text);
            m_gathering.noteStep(stepOfText(text, coordinate));
        }
        m_gathering.addPoint(point, m_lines.number());
    }

    void readFace(std::string_view line) {
        m_corners.clear();
        for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
            // Of "point/texture/normal" the first counts; the others may be missing, and their strokes stay.
            const std::string_view text = word.substr(0, word.find('/'));
            std::int64_t corner = 0;
            const auto end = std::from_chars(text.data(), text.data() + text.size(), corner);
            if (end.ec != std::errc{} || end.ptr != text.data() + text.size()) {
                refuseContent({"surroundings.no_corner",
                               "{0}, line {1}: \"{2}\" names no corner of a face",
                               {m_path, static_cast<std::int64_t>(m_lines.number()), word.substr(0, 60)}},
                              "Export the mesh anew, or put the line right.");
            }
            // Counted from 1, or back from the newest.
            m_corners.push_back(corner < 0 ? static_cast<std::int64_t>(m_gathering.points()) + corner : corner - 1);
        }
        m_gathering.addFace(m_corners, m_lines.number());
    }

    const std::string& m_path;
    const Execution& m_execution;
    MeshLines m_lines;
    MeshGathering m_gathering;
    std::vector<std::int64_t> m_corners;
};

}  // namespace

RawMesh readObjMesh(const std::string& path, const Execution& execution) {
    return ObjReading(path, execution).read();
}

}  // namespace rubble::io
