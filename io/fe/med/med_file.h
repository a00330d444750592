#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace rubble::io {

/// All cells of one type of a MED mesh, as the file has them.
struct MedCells {
    int type = 0;                        ///< MED's number of the geometry: 308 for HEXA8; its last two digits count the nodes
    std::size_t count = 0;               ///< cells
    std::vector<std::int64_t> nodes;     ///< 1-based [count x nodes of the type]; empty for types without fixed nodes
    std::vector<std::int64_t> numbers;   ///< user's; empty: not numbered
    std::vector<std::int64_t> families;  ///< empty: all in family 0
};

/// A mesh at its first computation step.
struct MedMesh {
    std::string name;
    int axes = 3;  ///< coordinates of a node
    std::vector<Vec3> nodes;
    std::vector<std::int64_t> nodeNumbers;  ///< empty: not numbered
    std::vector<MedCells> cells;
    std::map<std::int64_t, std::vector<std::string>> groups;  ///< by family
    int steps = 1;                                            ///< computation steps of the mesh itself
};

/// One computation step of a field.
struct MedStep {
    std::int64_t number = -1, iteration = -1;
    double time = 0.0;  ///< s
};

struct MedField {
    std::string name;  ///< "RESU____DEPL"
    std::string mesh;
    std::vector<std::string> components;
    std::vector<MedStep> steps;
};

/// What values of a field stand at.
enum class MedPlace { Nodes, Cells, CellNodes };

/// Values of a field at one step on nodes, or on cells of one type.
struct MedValues {
    int type = 0;                        ///< of the cells; 0: nodes
    std::size_t count = 0;               ///< entities that have values
    std::vector<std::int64_t> entities;  ///< 1-based; empty: all, in their order
    std::size_t points = 1;              ///< values an entity has of each component
    std::vector<double> values;          ///< [count x points x components]; empty where only the entities were asked for
};

/// A MED file (Salome, code_aster), open for reading through libmed. Members may be called from any thread and throw ParseError
/// naming the file.
class MedFile {
public:
    /// Opens the file, after a look at all of it in a child process. Throws WorldError, ParseError.
    explicit MedFile(const std::string& path);
    ~MedFile();
    MedFile(const MedFile&) = delete;
    MedFile& operator=(const MedFile&) = delete;

    const std::string& path() const { return m_path; }
    std::vector<std::string> meshNames() const;
    MedMesh mesh(const std::string& name) const;
    std::vector<MedField> fields() const;
    /// Empty where the field has nothing at this place and step. @param numbers  false: only which entities have values
    std::vector<MedValues> values(const MedField& field, const MedStep& step, MedPlace place, bool numbers) const;

private:
    void open();
    void close();
    void lookAtAll() const;
    std::size_t bounded(std::int64_t count, std::size_t each, const std::string& what) const;
    void readNodes(const MedStep& step, MedMesh& mesh) const;
    void readCells(const std::string& mesh, const MedStep& step, int type, std::vector<MedCells>& cells) const;
    void readFamilies(MedMesh& mesh) const;
    MedValues readValues(const MedField& field, const MedStep& step, MedPlace place, int type, int profile, bool numbers) const;

    std::string m_path;
    std::uint64_t m_bytes = 0;
    std::int64_t m_file = -1;          ///< of libmed
    mutable std::vector<int> m_types;  ///< of cells in the meshes read so far, under the lock of the library
};

}  // namespace rubble::io
