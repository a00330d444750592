#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/fe/mesh.h"
#include "io/fe/vtk/hdf5_table.h"

namespace rubble::io {

/// One state that an MPCO file holds.
struct MpcoState {
    std::size_t stage = 0;     ///< the model that stood then
    std::int64_t step = 0;     ///< of the analysis; rises for ever
    double time = 0.0;         ///< s; may be set back
    std::string displacement;  ///< its table
    std::string velocity;      ///< its table; empty: not recorded
};

/// Elements of one class as they stand in a model.
struct MpcoTable {
    std::string name;           ///< "56-Brick[400:0]"
    std::int64_t geometry = 0;  ///< attribute GEOMETRY; 0: not said
    std::size_t width = 1;      ///< numbers in a row: the element's, then those of its nodes
    std::vector<std::int64_t> rows;
};

/// The model of one stage: what the domain held from then on.
struct MpcoModel {
    std::vector<std::int64_t> nodeIds;
    std::vector<Vec3> nodes;  ///< where the file has fewer than three coordinates, the others are zero
    std::vector<MpcoTable> tables;
    std::unordered_map<std::int64_t, double> section;  ///< area of beams, thickness of layered shells, by element
};

/// A file of the recorder mpco of OpenSees, open for reading. Its layout: SRC/recorder/MPCORecorder.cpp of OpenSees. A stage begins
/// whenever the domain changes, so elements that are removed are missing in the next one. Members may be called from any thread.
class MpcoFile {
public:
    /// @param displacement  the nodal result that moves the nodes; "none": the stages are the states
    /// Throws WorldError, ParseError.
    MpcoFile(const std::string& path, const std::string& displacement);

    const std::string& path() const { return m_table.path(); }
    std::size_t stageCount() const { return m_stages.size(); }
    /// In the order of the analysis.
    const std::vector<MpcoState>& states() const { return m_states; }
    /// True if a state at the end was not whole and is not among the states.
    bool unfinished() const { return m_unfinished; }
    /// True if the model has fewer than three coordinates.
    bool plane() const { return m_plane; }
    /// Nodal results that could stand for the displacement.
    std::vector<std::string> nodalResults() const;

    MpcoModel model(std::size_t stage) const;
    /// Numbers of the nodes that the rows of a stage's results belong to.
    std::vector<std::int64_t> rowNodes(std::size_t stage) const;
    std::vector<Vec3> displacements(std::size_t state) const { return vectors(m_states[state].displacement); }
    std::vector<Vec3> velocities(std::size_t state) const { return vectors(m_states[state].velocity); }

private:
    void addStates(std::size_t stage);
    bool isWhole(const std::string& table, std::uint64_t rows) const;
    std::vector<Vec3> vectors(const std::string& table) const;
    void readSections(const std::string& stage, MpcoModel& model) const;

    Hdf5Table m_table;
    std::string m_displacement;
    std::vector<std::string> m_stages;  ///< groups, by their numbers
    std::vector<MpcoState> m_states;
    bool m_unfinished = false, m_plane = false;
};

}  // namespace rubble::io
