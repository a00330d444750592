#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/fe/series/mesh_series.h"

namespace rubble::io {

/// One piece of a result that several processors wrote, each in files of its own.
struct SeriesPiece {
    std::string file;  ///< named in messages
    std::shared_ptr<MeshSeries> series;
};

/// Pieces of a result as one series of meshes in pieces. A state that a piece lacks at the end is not whole yet and left out.
class StackedSeries : public MeshSeries {
public:
    /// @param pieces  at least one  Throws ParseError where pieces have other times than the first.
    explicit StackedSeries(std::vector<SeriesPiece> pieces);

    SeriesStep step(std::size_t k) override;
    SeriesFields fields(std::size_t k) const override;
    std::vector<std::pair<std::int64_t, double>> deathTimes() const override;

private:
    Mesh stacked() const;
    void gatherFindings();

    std::vector<SeriesPiece> m_pieces;
    std::vector<Mesh> m_meshes;  ///< newest of each piece
    Findings m_own;
};

}  // namespace rubble::io
