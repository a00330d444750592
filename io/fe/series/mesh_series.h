#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/fe/mesh.h"

namespace rubble::io {

/// Where one of several pieces of a mesh ends: points and elements of it and of all before it.
struct MeshPiece {
    std::size_t nodes = 0;
    std::size_t elements = 0;
};

/// What a series says about the elements of one state, before any meaning is given to it.
struct SeriesStep {
    /// Nodes and elements in the file's own units and axes; nothing: those of the state before, in the same order.
    /// nodeIds or elementIds may be empty where the file numbers none; density and section may be empty where it has none.
    std::optional<Mesh> mesh;
    std::vector<double> flags;  ///< value of the active flag [elements]; empty: what is there is active
    /// Of a mesh that is written in pieces, one a processor or block; empty: it is one piece.
    std::vector<MeshPiece> pieces;
    /// Which elements the file marks as copies of those of another piece [elements]; empty: none. Comes with the mesh.
    std::vector<bool> ghosts;
    /// The cell of the file that each element is or is a piece of [elements]; empty: none was taken apart. Comes with the mesh.
    std::vector<std::size_t> cells;
};

/// Nodal values of one state in the file's own units and axes [nodes of that state's mesh].
struct SeriesFields {
    std::vector<Vec3> positions;   ///< absolute
    std::vector<Vec3> velocities;  ///< empty where the file has none
};

/// The name of the active flag, and what it says.
struct SeriesFlag {
    std::string name;                  ///< "STATUS"; empty: missing elements are dead
    std::optional<int> activeByName;   ///< nothing: the name does not tell
    bool alwaysZeroIsRigid = false;    ///< elements that are dead at every state are rigid bodies, which the flag cannot tell apart
    std::vector<std::string> choices;  ///< what else the user may name, for the remedy
};

/// What is known of a series before its states are read.
struct SeriesFacts {
    std::vector<double> times;  ///< s
    SeriesFlag flag;
    bool hasVelocity = false;
    bool timed = true;  ///< false: nobody says when the states are, they were counted
    Findings findings;  ///< what the series had to work around; steps add to it
};

/// A result that is a series of meshes, one a state: elements are flagged, or left out once they are dead. Implementations fill in
/// the facts when they are made, and throw ParseError or WorldError naming file and place.
class MeshSeries {
public:
    virtual ~MeshSeries() = default;

    const std::vector<double>& times() const { return m_facts.times; }
    const SeriesFlag& flag() const { return m_facts.flag; }
    bool hasVelocity() const { return m_facts.hasVelocity; }
    bool timed() const { return m_facts.timed; }
    const Findings& findings() const { return m_facts.findings; }
    /// Reads the elements of state k. Called once for every state, in order, by one thread.
    virtual SeriesStep step(std::size_t k) = 0;
    /// Reads the nodal values of state k. Called after all steps, in any order, from any thread.
    virtual SeriesFields fields(std::size_t k) const = 0;
    /// Exact death times s by element number, or empty.
    virtual std::vector<std::pair<std::int64_t, double>> deathTimes() const { return {}; }

protected:
    SeriesFacts m_facts;
};

}  // namespace rubble::io
