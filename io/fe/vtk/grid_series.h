#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/scenario/scenario.h"
#include "io/fe/series/cell_shapes.h"
#include "io/fe/series/mesh_series.h"
#include "io/fe/straight_edges.h"
#include "io/fe/vtk/grid.h"
#include "io/fe/vtk/grid_names.h"

namespace rubble::io {

/// A series of grids as a series of meshes: cells that are no structure are left out, the active flag, numbers and parts are known
/// by the usual names, and points that never move carry the displacement if there is one.
class GridSeries : public MeshSeries {
public:
    /// Reads the first and the last state. @param path  for messages
    GridSeries(std::string path, std::unique_ptr<const GridSource> source, const ImportSettings& settings);

    SeriesStep step(std::size_t k) override;
    SeriesFields fields(std::size_t k) const override;
    std::vector<std::pair<std::int64_t, double>> deathTimes() const override;
    /// Counts that nobody says when the states are, so that they were counted.
    /// @param files  that were taken for states
    void noteMissingTimes(const std::vector<std::string>& files);
    /// Adds what was found before the grids were read.
    void note(const Findings& findings) { m_facts.findings.append(findings); }
    /// Counts times that only some of the collections of a file have, so that they are no states.
    void noteDroppedTimes(std::size_t count);
    /// Counts a last state that was left out because it is not whole.
    void noteUnfinished(const std::string& file);
    /// Counts a block of a state that is no unstructured grid.
    void noteLeftBlock(const std::string& file);
    /// Counts a file that an index names more than once for one state. @param times  how often
    void noteListedAgain(const std::string& file, std::int64_t times);
    /// Counts numbers that are missing between files that are states by their numbers.
    void noteGaps(const std::vector<std::string>& numbered);

private:
    void dropUnfinished(const GridSelection& all);
    void decideDisplacement(const Grid& first);
    Mesh meshOf(const Grid& grid, std::size_t k);
    GridNames namesOfSeries(const Grid& first, const ImportSettings& settings) const;
    bool isLink(const Grid& grid, std::size_t cell);
    void addCell(const Grid& grid, std::size_t cell, std::size_t k, Mesh& mesh);
    void skipCell(const Grid& grid, std::size_t cell);
    std::vector<std::uint32_t> pointsOf(const Grid& grid, std::size_t cell, std::size_t k) const;
    void addPieces(const Grid& grid, std::size_t cell, const std::vector<std::uint32_t>& points, Mesh& mesh);
    void addElement(const Grid& grid, std::size_t cell, ElementShape shape, const std::vector<std::uint32_t>& corners, Mesh& mesh);
    std::uint32_t partOf(std::int64_t id, ElementShape shape, Mesh& mesh) const;
    bool isGhost(double value) const;
    double flagOf(double value) const;
    void findGhosts(const Grid& grid, std::size_t k, SeriesStep& step);
    std::uint32_t componentOf(std::int64_t index, std::int64_t id, Mesh& mesh) const;

    std::string m_path;
    std::unique_ptr<const GridSource> m_source;
    GridNames m_names;
    std::vector<std::string> m_componentNames;
    bool m_moves = false;             ///< points stay, the displacement moves
    Digest m_cells;                   ///< of the newest step
    std::vector<std::size_t> m_kept;  ///< the cell of each element of the newest step
    bool m_inPieces = false;          ///< the newest mesh is
    bool m_copiesAtFirst = false;     ///< cells are marked as copies at the first state: then the mark tells no death
    std::map<std::vector<std::int64_t>, std::vector<CellPiece>> m_pieces;  ///< of bodies taken apart, by type and points
    StraightEdges m_straight;
};

}  // namespace rubble::io
