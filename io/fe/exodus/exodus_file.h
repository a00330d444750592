#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "io/fe/exodus/exodus_chunks.h"

namespace rubble::io {

/// One element block as the file has it. Its elements follow those of the blocks before it.
struct ExodusBlock {
    std::int64_t id = 0;
    std::string name;      ///< empty where the file gives none
    std::string topology;  ///< "HEX8"
    std::int64_t elements = 0;
    std::int64_t nodesPerElement = 0;
    std::vector<std::string> attributes;  ///< names, empty strings where the file gives none
    std::int64_t first = 0;               ///< position of its first element in the file
};

enum class ExodusEntity { Node, Element };

/// An Exodus II file open for reading. Every member may be called from any thread; calls into the library are serialised.
/// All indices are 0-based. Reads throw ParseError naming the file and what was being read.
class ExodusFile {
public:
    /// Checks the layout (see checkExodusLayout) and opens. Throws WorldError, ParseError.
    explicit ExodusFile(const std::string& path);
    ~ExodusFile();
    ExodusFile(const ExodusFile&) = delete;
    ExodusFile& operator=(const ExodusFile&) = delete;

    const std::string& path() const { return m_path; }
    int dimensions() const { return m_dimensions; }
    std::size_t nodeCount() const { return m_nodes; }
    std::size_t elementCount() const { return m_elements; }
    /// Times of the states that count, s, as in the file: without those that are not whole, written twice or abandoned by a
    /// restart.
    const std::vector<double>& times() const { return m_times; }
    const Findings& findings() const { return m_findings; }  ///< states that were left out
    /// Processors that the result was written by, each in a file of its own; 1 where it is whole.
    std::int64_t processors() const { return m_processors; }
    /// Elements in the files of all processors.
    std::int64_t elementsOfAll() const { return m_elementsOfAll; }
    const std::vector<ExodusBlock>& blocks() const { return m_blocks; }
    const std::vector<std::string>& variables(ExodusEntity entity) const {
        return entity == ExodusEntity::Node ? m_nodeVariables : m_elementVariables;
    }
    /// Which blocks make one part: equal values do (exodusPartVariable) [blocks]; empty where every block is a part.
    const std::vector<std::int64_t>& partsOfBlocks() const { return m_partsOfBlocks; }
    /// Whether a block has values of an element variable.
    bool has(std::size_t block, int variable) const;

    /// Coordinates along one axis [nodes].
    std::vector<double> coordinates(int axis) const;
    /// User's numbers [nodes or elements].
    std::vector<std::int64_t> numbers(ExodusEntity entity) const;
    /// Node numbers of a block's elements, 1-based as in the file and not yet checked [elements x nodesPerElement].
    std::vector<std::int64_t> connectivity(std::size_t block) const;
    std::vector<double> attribute(std::size_t block, std::size_t index) const;
    /// Values of a nodal variable at a state [nodes].
    void readNodal(std::size_t state, int variable, std::span<double> values) const;
    /// Values of an element variable on one block at a state [elements of the block].
    void readElement(std::size_t state, int variable, std::size_t block, std::span<double> values) const;

private:
    void readHeader();
    void readBlocks();
    void readVariables();
    void readTimes();
    void readParts();
    void readDecomposition();
    /// Throws ParseError for a library status that is an error. @param what  "the coordinates"
    void require(int status, const std::string& what) const;

    std::string m_path;
    int m_id = -1;
    int m_dimensions = 0;
    std::size_t m_nodes = 0;
    std::size_t m_elements = 0;
    std::size_t m_unfinished = 0;  ///< states at the end that are not whole
    std::vector<double> m_times;
    std::vector<std::size_t> m_written;  ///< place in the file of each state
    Findings m_findings;
    std::int64_t m_processors = 1, m_elementsOfAll = 0;
    std::vector<ExodusBlock> m_blocks;
    std::vector<std::string> m_nodeVariables;
    std::vector<std::string> m_elementVariables;
    std::vector<std::int64_t> m_partsOfBlocks;
    std::vector<int> m_truthTable;  ///< [blocks x element variables]
    std::optional<ExodusChunks> m_chunks;
};

}  // namespace rubble::io
