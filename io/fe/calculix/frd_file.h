#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"
#include "io/fe/series/byte_window.h"

namespace rubble::io {

/// Where the displacements of one state stand in the file.
struct FrdState {
    double time = 0.0;
    std::int64_t step = 1;
    std::uint64_t offset = 0;
    std::size_t nodes = 0;
    std::size_t components = 3;  ///< written for each node
    int format = 1;              ///< 0 short, 1 long, 2 binary of 4 bytes, 3 of 8
};

/// Displacements of those nodes that a state has.
struct FrdValues {
    std::vector<std::int64_t> nodes;
    std::vector<Vec3> values;
};

/// A result file of CalculiX: mesh and index of its displacement blocks. Layout after the manual of CalculiX GraphiX, "Result file
/// format".
class FrdFile {
public:
    /// Reads mesh and index. Throws WorldError, ParseError with line offset; a file that ends inside a block ends before it.
    explicit FrdFile(const std::string& path);

    const std::vector<FrdState>& states() const { return m_states; }
    /// Elements with their materials as parts, in the file's units.
    const Mesh& mesh() const { return m_mesh; }
    const Findings& findings() const { return m_findings; }
    /// Thread-safe.
    FrdValues read(const FrdState& state) const;

private:
    struct Element {
        std::int64_t number, type, material;
        std::vector<std::int64_t> nodes;
    };

    void readNodes(const std::string& head);
    void readElements(const std::string& head);
    void readTextElements(std::size_t count, int format, std::vector<Element>& elements);
    void readBinaryElements(std::size_t count, std::vector<Element>& elements);
    bool readResult(const std::string& head);
    bool skipBlock(const FrdState& state);
    void noteShapes();
    void finish();
    void addElement(const Element& element);
    std::size_t countOf(const std::string& head, std::size_t bytesEach) const;
    int formatOf(const std::string& head) const;
    [[noreturn]] void fail(const std::string& what) const;

    std::string m_path;
    mutable std::mutex m_mutex;
    mutable ByteWindow m_window;
    Mesh m_mesh;
    std::vector<Element> m_elements;
    std::vector<FrdState> m_states;
    bool m_ofMode = false;           // the next block of results is that of a mode
    const char* m_shapes = nullptr;  // what they are of
    std::int64_t m_shapeCount = 0;
    Findings m_findings;
};

}  // namespace rubble::io
