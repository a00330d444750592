#include "core/evidence/maps/piece_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/base/error.h"
#include "core/base/unknown.h"
#include "core/engine/world/worker_pool.h"
#include "core/evidence/maps/tile_cover.h"

namespace rubble {

namespace {

using Vec2 = Eigen::Vector2d;

/// Cells are numbered within this, either way.
constexpr double cellsEitherWay = 1e9;
/// Cells within the bounds of all outlines together, at most: what a map may take in time.
constexpr double workMax = 4e8;
/// Cells that a map may hold: what it may take in memory (80 bytes each).
constexpr double heldMax = 2e7;
/// Share of a cell that an outline has to reach into: less is rounding on the edge between two cells.
constexpr double reachedShare = 1e-9;

[[noreturn]] void refuseCells(double cell) {
    throw UsageError({"map.too_many_cells",
                      "A map with cells of {0} would take too many of them: the debris is too large or too far away for it.",
                      {Argument(cell, "m")}},
                     {"map.too_many_cells.remedy", "Choose larger cells, or look for bodies that left the site.", {}});
}

void checkPieces(std::span<const MapPiece> pieces, double cell) {
    if (!(cell > 0.0) || !std::isfinite(cell)) {
        throw UsageError({"map.cell_size", "A map cannot have cells of {0}.", {Argument(cell, "m")}},
                         {"map.cell_size.remedy", "Give a size above zero, 0.25 m or 1 m for example.", {}});
    }
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const MapPiece& piece = pieces[p];
        const bool sound = piece.centre.allFinite() && piece.box.centre.allFinite() && piece.box.halfExtents.allFinite() &&
                           (piece.box.halfExtents.array() >= 0.0).all() && piece.box.orientation.coeffs().allFinite() &&
                           std::isfinite(piece.mass) && piece.mass >= 0.0 && std::isfinite(piece.volume) && piece.volume >= 0.0;
        if (!sound) {
            throw UsageError(
                {"map.not_a_number",
                 "The place, size or mass of piece {0} of the debris is not a number, or negative: it cannot be mapped.",
                 {p}},
                {"map.not_a_number.remedy", "Look at the health of the run; a higher step rate may keep it sound.", {}});
        }
    }
}

/// A tile of cells, by its number along y and x.
struct Tile {
    std::int32_t j = 0;
    std::int32_t i = 0;
    friend auto operator<=>(const Tile&, const Tile&) = default;
};

/// That a piece may reach into a tile.
struct Entry {
    Tile tile;
    std::uint32_t component = 0;
    std::uint32_t piece = 0;
    friend auto operator<=>(const Entry&, const Entry&) = default;
};

std::int32_t cellAt(double place, double cell) {
    return static_cast<std::int32_t>(std::floor(place / cell));
}

std::int32_t tileOf(std::int32_t cell) {
    return cell >= 0 ? cell / tileCells : -((-cell + tileCells - 1) / tileCells);
}

/// Which pieces each tile has to look at, by tile, component and piece.
std::vector<Entry> entriesOf(std::span<const MapPiece> pieces, const std::vector<SmallPolygon>& outlines, double cell) {
    std::vector<Entry> entries;
    entries.reserve(2 * pieces.size());
    double work = 0.0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const SmallPolygon& outline = outlines[p];
        Vec2 low = pieces[p].centre.head<2>();
        Vec2 high = low;
        if (outline.size > 0) {
            low = high = outline.corners[0];
        }
        for (std::size_t k = 1; k < outline.size; ++k) {
            low = low.cwiseMin(outline.corners[k]);
            high = high.cwiseMax(outline.corners[k]);
        }
        if (std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) > cellsEitherWay * cell) {
            refuseCells(cell);
        }
        const MapCell first{cellAt(low.y(), cell), cellAt(low.x(), cell)};
        const MapCell last{cellAt(high.y(), cell), cellAt(high.x(), cell)};
        work += (1.0 + last.i - first.i) * (1.0 + last.j - first.j);
        if (work > workMax) {
            refuseCells(cell);
        }
        for (std::int32_t j = tileOf(first.j); j <= tileOf(last.j); ++j) {
            for (std::int32_t i = tileOf(first.i); i <= tileOf(last.i); ++i) {
                entries.push_back({{j, i}, pieces[p].component, static_cast<std::uint32_t>(p)});
            }
        }
    }
    std::sort(entries.begin(), entries.end());
    std::size_t tiles = 0;
    for (std::size_t e = 0; e < entries.size(); ++e) {
        tiles += e == 0 || entries[e].tile != entries[e - 1].tile;
    }
    if (std::min(work, static_cast<double>(tiles) * tileCells * tileCells) > heldMax) {
        refuseCells(cell);
    }
    return entries;
}

/// What a tile of cells holds.
class TileSums {
public:
    TileSums(std::span<const MapPiece> pieces, const std::vector<SmallPolygon>& outlines, double cell)
        : m_pieces(pieces), m_outlines(outlines), m_cell(cell) {}

    void begin(Tile tile) {
        m_sums = {};
        m_ofComponent = {};
        m_surface.clear();
        m_origin = {tile.j * tileCells, tile.i * tileCells};
        m_corner = Vec2(m_origin.i * m_cell, m_origin.j * m_cell);
    }
    void add(std::uint32_t number);
    /// All pieces of a component have been added.
    void closeComponent(std::uint32_t component);
    /// Puts the cells of one row at the end of a raster.
    void giveRow(int row, const SiteSurface& ground, PieceRaster& raster) const;

private:
    struct Sum {
        double volume = 0.0;
        double mass = 0.0;
        double pieces = 0.0;
        double largest = 0.0;
        double arrival = unknown;
        double energy = 0.0;
        double mostOfOne = -1.0;  ///< kg, of the component that has most so far
        std::uint32_t component = 0;
    };
    template <class T>
    using Grid = std::array<std::array<T, tileCells>, tileCells>;

    void addShare(int column, int row, const MapPiece& piece, double share);
    double heightOf(int column, int row, const SiteSurface& ground) const;
    double coverOf(int column, int row) const;

    std::span<const MapPiece> m_pieces;
    const std::vector<SmallPolygon>& m_outlines;
    double m_cell;
    MapCell m_origin;
    Vec2 m_corner = Vec2::Zero();
    Grid<Sum> m_sums{};
    Grid<double> m_ofComponent{};  ///< kg, of the component at hand
    TileSurface m_surface;
    TileCover m_cover;
};

void TileSums::add(std::uint32_t number) {
    const MapPiece& piece = m_pieces[number];
    const SmallPolygon& outline = m_outlines[number];
    const double area = outline.area() / (m_cell * m_cell);
    if (!(area > 0.0)) {
        const int column = cellAt(piece.centre.x(), m_cell) - m_origin.i;
        const int row = cellAt(piece.centre.y(), m_cell) - m_origin.j;
        if (std::min(column, row) >= 0 && std::max(column, row) < tileCells) {
            addShare(column, row, piece, 1.0);
        }
        return;
    }
    SmallPolygon inTile = outline;
    for (std::size_t k = 0; k < inTile.size; ++k) {
        inTile.corners[k] = (inTile.corners[k] - m_corner) / m_cell;
    }
    m_cover.take(inTile);
    const double least = reachedShare * std::min(area, 1.0);
    for (int row = m_cover.firstRow(); !m_cover.empty() && row <= m_cover.lastRow(); ++row) {
        for (int column = m_cover.firstColumn(); column <= m_cover.lastColumn(); ++column) {
            const double part = m_cover.area(column, row);
            if (part > least) {
                addShare(column, row, piece, part / area);
            }
        }
    }
    m_surface.raise(piece.box, inTile, m_corner, m_cell);
}

void TileSums::addShare(int column, int row, const MapPiece& piece, double share) {
    Sum& sum = m_sums[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    sum.volume += share * piece.volume;
    sum.mass += share * piece.mass;
    sum.pieces += 1.0;
    sum.largest = std::max(sum.largest, piece.volume);
    sum.arrival = std::fmin(sum.arrival, piece.arrival);
    sum.energy += std::isfinite(piece.impactEnergy) ? share * piece.impactEnergy : 0.0;
    m_ofComponent[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] += share * piece.mass;
}

void TileSums::closeComponent(std::uint32_t component) {
    for (std::size_t j = 0; j < tileCells; ++j) {
        for (std::size_t i = 0; i < tileCells; ++i) {
            Sum& sum = m_sums[j][i];
            if (sum.pieces > 0.0 && m_ofComponent[j][i] > sum.mostOfOne) {
                sum.mostOfOne = m_ofComponent[j][i];
                sum.component = component;
            }
            m_ofComponent[j][i] = 0.0;
        }
    }
}

double TileSums::heightOf(int column, int row, const SiteSurface& ground) const {
    double sum = 0.0;
    for (int b = 0; b < heightPoints; ++b) {
        for (int a = 0; a < heightPoints; ++a) {
            const double top = m_surface.at(column * heightPoints + a, row * heightPoints + b);
            if (std::isinf(top)) {
                continue;
            }
            const double x = (m_origin.i + column + (a + 0.5) / heightPoints) * m_cell;
            const double y = (m_origin.j + row + (b + 0.5) / heightPoints) * m_cell;
            sum += std::max(0.0, top - ground.height(x, y));
        }
    }
    return sum / (heightPoints * heightPoints);
}

double TileSums::coverOf(int column, int row) const {
    int covered = 0;
    for (int b = 0; b < heightPoints; ++b) {
        for (int a = 0; a < heightPoints; ++a) {
            covered += std::isinf(m_surface.at(column * heightPoints + a, row * heightPoints + b)) ? 0 : 1;
        }
    }
    return static_cast<double>(covered) / (heightPoints * heightPoints);
}

void TileSums::giveRow(int row, const SiteSurface& ground, PieceRaster& raster) const {
    for (int column = 0; column < tileCells; ++column) {
        const Sum& sum = m_sums[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
        if (!(sum.pieces > 0.0)) {
            continue;
        }
        raster.cells.push_back({m_origin.j + row, m_origin.i + column});
        raster.height.push_back(heightOf(column, row, ground));
        raster.covered.push_back(coverOf(column, row));
        raster.volume.push_back(sum.volume);
        raster.mass.push_back(sum.mass);
        raster.pieces.push_back(sum.pieces);
        raster.largest.push_back(sum.largest);
        raster.component.push_back(sum.component);
        raster.arrival.push_back(sum.arrival);
        raster.impactEnergy.push_back(sum.energy);
    }
}

/// A tile's cells row by row, and where in its raster each row begins.
struct TileRows {
    Tile tile;
    std::size_t firstEntry = 0;
    std::size_t lastEntry = 0;
    PieceRaster raster;
    std::array<std::size_t, tileCells + 1> rowStart{};
};

template <class T>
void appendPart(std::vector<T>& to, const std::vector<T>& from, std::size_t first, std::size_t last) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first), from.begin() + static_cast<std::ptrdiff_t>(last));
}

void appendRow(PieceRaster& raster, const TileRows& tile, std::size_t row) {
    const std::size_t first = tile.rowStart[row];
    const std::size_t last = tile.rowStart[row + 1];
    appendPart(raster.cells, tile.raster.cells, first, last);
    appendPart(raster.height, tile.raster.height, first, last);
    appendPart(raster.covered, tile.raster.covered, first, last);
    appendPart(raster.volume, tile.raster.volume, first, last);
    appendPart(raster.mass, tile.raster.mass, first, last);
    appendPart(raster.pieces, tile.raster.pieces, first, last);
    appendPart(raster.largest, tile.raster.largest, first, last);
    appendPart(raster.component, tile.raster.component, first, last);
    appendPart(raster.arrival, tile.raster.arrival, first, last);
    appendPart(raster.impactEnergy, tile.raster.impactEnergy, first, last);
}

/// The rows of all tiles, from the south-west on.
PieceRaster joined(const std::vector<TileRows>& tiles) {
    PieceRaster raster;
    for (std::size_t first = 0; first < tiles.size();) {
        std::size_t last = first;
        while (last < tiles.size() && tiles[last].tile.j == tiles[first].tile.j) {
            ++last;
        }
        for (std::size_t row = 0; row < tileCells; ++row) {
            for (std::size_t t = first; t < last; ++t) {
                appendRow(raster, tiles[t], row);
            }
        }
        first = last;
    }
    return raster;
}

std::vector<TileRows> tilesOf(const std::vector<Entry>& entries) {
    std::vector<TileRows> tiles;
    for (std::size_t e = 0; e < entries.size(); ++e) {
        if (e == 0 || entries[e].tile != entries[e - 1].tile) {
            tiles.push_back({entries[e].tile, e, e, {}, {}});
        }
        tiles.back().lastEntry = e + 1;
    }
    return tiles;
}

void fillTile(TileRows& tile, const std::vector<Entry>& entries, TileSums& sums, const SiteSurface& ground) {
    sums.begin(tile.tile);
    for (std::size_t e = tile.firstEntry; e < tile.lastEntry; ++e) {
        sums.add(entries[e].piece);
        if (e + 1 == tile.lastEntry || entries[e + 1].component != entries[e].component) {
            sums.closeComponent(entries[e].component);
        }
    }
    for (std::size_t row = 0; row < tileCells; ++row) {
        sums.giveRow(static_cast<int>(row), ground, tile.raster);
        tile.rowStart[row + 1] = tile.raster.cells.size();
    }
}

}  // namespace

PieceRaster rasterOf(std::span<const MapPiece> pieces, double cell, const SiteSurface& ground, const Execution& execution) {
    checkPieces(pieces, cell);
    execution.check();
    WorkerPool pool(execution.threads());
    std::vector<SmallPolygon> outlines(pieces.size());
    pool.loop(pieces.size(), 1024, [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            outlines[p] = outlineOf(pieces[p].box);
            if (!(outlines[p].area() > 0.0)) {
                outlines[p].size = 0;
            }
        }
    });
    const std::vector<Entry> entries = entriesOf(pieces, outlines, cell);
    std::vector<TileRows> tiles = tilesOf(entries);
    execution.check();
    pool.loop(tiles.size(), 1, [&](std::size_t first, std::size_t last) {
        TileSums sums(pieces, outlines, cell);
        for (std::size_t t = first; t < last; ++t) {
            fillTile(tiles[t], entries, sums, ground);
        }
    });
    execution.check();
    return joined(tiles);
}

}  // namespace rubble
