#include "core/evidence/maps/piece_raster.h"
#include <gtest/gtest.h>

#include "core/base/unknown.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "core/base/error.h"
#include "core/evidence/maps/tile_cover.h"
#include "tests/core/analysis/debris_scene.h"
#include "tests/core/analysis/random_numbers.h"
#include "tests/scenes/level_site.h"

namespace rubble {
namespace {

using namespace analysis_scene;

std::vector<MapPiece> piecesOf(const Debris& debris) {
    std::vector<MapPiece> pieces;
    for (const DebrisFragment& lies : debris.fragments) {
        MapPiece piece;
        piece.box = lies.box;
        piece.centre = lies.centre;
        piece.mass = lies.mass;
        piece.volume = lies.volume;
        piece.component = static_cast<std::uint32_t>(pieces.size() % 3);
        piece.arrival = 1.0 + 0.01 * static_cast<double>(pieces.size());
        piece.impactEnergy = 100.0 * lies.mass;
        pieces.push_back(piece);
    }
    return pieces;
}

double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) {
        total += value;
    }
    return total;
}

PieceRaster raster(const std::vector<MapPiece>& pieces, double cell, const SiteSurface& ground = levelSite) {
    return rasterOf(pieces, cell, ground, Execution());
}

TEST(TileCover, AreaOfAnOutlineInEachCellIsThatOfTheCutPolygon) {
    RandomNumbers random(7);
    TileCover cover;
    for (int trial = 0; trial < 300; ++trial) {
        // Some lie across the edges of the tile, some outside it.
        OrientedBox box{Vec3(random.between(-3, 19), random.between(-3, 19), 0.0),
                        Quat(random.normal(), random.normal(), random.normal(), random.normal()).normalized(),
                        Vec3(random.between(0.05, 3), random.between(0.05, 3), random.between(0.05, 3))};
        if (trial % 5 == 0) {
            // Along the cells, so that edges fall on edges.
            box = {box.centre.array().round(), Quat::Identity(), Vec3(0.5, 1.0, 2.0)};
        }
        const SmallPolygon outline = outlineOf(box);
        cover.take(outline);
        double all = 0.0;
        for (int j = 0; j < tileCells; ++j) {
            for (int i = 0; i < tileCells; ++i) {
                const double expected = clipped(clipped(outline, 0, i, i + 1), 1, j, j + 1).area();
                const bool inside = !cover.empty() && i >= cover.firstColumn() && i <= cover.lastColumn() &&
                                    j >= cover.firstRow() && j <= cover.lastRow();
                // Areas of order one, summed over a few edges in double precision.
                EXPECT_NEAR(inside ? cover.area(i, j) : 0.0, expected, 1e-13) << trial << ": " << i << ", " << j;
                all += inside ? cover.area(i, j) : 0.0;
            }
        }
        EXPECT_NEAR(all, clipped(clipped(outline, 0, 0, tileCells), 1, 0, tileCells).area(), 1e-12);
    }
}

// The maps of the measures go another way: they cut polygons cell by cell and ask each box at each point.
TEST(PieceRaster, AgreesWithTheMapsOfTheMeasures) {
    const Debris debris = randomField(3, 1500, 30.0);
    const std::vector<MapPiece> pieces = piecesOf(debris);
    for (const double cell : {0.25, 1.0, 7.3}) {
        const PieceRaster map = raster(pieces, cell);
        const CellMap mass = massMap(debris, cell);
        const CellMap heights = heightMap(debris, cell, levelSite);
        ASSERT_EQ(map.cells, mass.cells) << cell;
        for (std::size_t c = 0; c < map.cells.size(); ++c) {
            ASSERT_NEAR(map.mass[c], mass.values[c], 1e-9 * (1.0 + mass.values[c])) << cell;
            ASSERT_NEAR(map.height[c], heights.values[c], 1e-9) << cell;
        }
    }
}

TEST(PieceRaster, SaysHowMuchOfACellIsCovered) {
    // Two blocks of 1.5 by 1 m, one above the other, over the first of two cells and half of the second.
    std::vector<MapPiece> pieces;
    for (const double z : {0.5, 1.5}) {
        const DebrisFragment block = boxAt(Vec3(0.75, 0.5, z), 1000.0, Vec3(0.75, 0.5, 0.5));
        pieces.push_back({block.box, block.centre, block.mass, block.volume});
    }
    const PieceRaster map = raster(pieces, 1.0);
    ASSERT_EQ(map.cells.size(), 2u);
    EXPECT_EQ(map.covered, (std::vector<double>{1.0, 0.5}));
    // Of a field as much as its outlines hold, to the points that are looked at.
    const std::vector<MapPiece> field = piecesOf(randomField(3, 40, 30.0));
    const double fine = 0.05;
    const double exact = fine * fine * sum(raster(field, fine).covered);
    EXPECT_NEAR(sum(raster(field, 0.5).covered) * 0.25, exact, 0.02 * exact);
}

TEST(PieceRaster, SumsAreThoseOfThePieces) {
    const std::vector<MapPiece> pieces = piecesOf(randomField(5, 3000, 40.0));
    double mass = 0.0;
    double volume = 0.0;
    double energy = 0.0;
    for (const MapPiece& piece : pieces) {
        mass += piece.mass;
        volume += piece.volume;
        energy += piece.impactEnergy;
    }
    for (const double cell : {0.1, 0.25, 2.0, 50.0}) {
        const PieceRaster map = raster(pieces, cell);
        // Rounding of 3,000 pieces in 200,000 cells.
        EXPECT_NEAR(sum(map.mass), mass, 1e-12 * mass) << cell;
        EXPECT_NEAR(sum(map.volume), volume, 1e-12 * volume) << cell;
        EXPECT_NEAR(sum(map.impactEnergy), energy, 1e-12 * energy) << cell;
    }
}

TEST(PieceRaster, CountsRanksAndDatesWhatReachesIntoACell) {
    const Debris debris = randomField(9, 120, 6.0);
    const std::vector<MapPiece> pieces = piecesOf(debris);
    std::map<MapCell, std::vector<std::size_t>> reaching;
    std::map<MapCell, std::array<double, 3>> ofComponent;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const CellMap one = massMap(debrisFrom({debris.fragments[p]}), 0.5);
        for (std::size_t c = 0; c < one.size(); ++c) {
            reaching[one.cells[c]].push_back(p);
            ofComponent[one.cells[c]][p % 3] += one.values[c];
        }
    }
    const PieceRaster map = raster(pieces, 0.5);
    ASSERT_EQ(map.cells.size(), reaching.size());
    for (std::size_t c = 0; c < map.cells.size(); ++c) {
        const std::vector<std::size_t>& here = reaching.at(map.cells[c]);
        double largest = 0.0;
        for (const std::size_t p : here) {
            largest = std::max(largest, pieces[p].volume);
        }
        EXPECT_EQ(map.pieces[c], static_cast<double>(here.size()));
        EXPECT_EQ(map.largest[c], largest);
        EXPECT_EQ(map.arrival[c], pieces[here.front()].arrival);
        const auto& masses = ofComponent.at(map.cells[c]);
        EXPECT_NEAR(masses[map.component[c]], *std::max_element(masses.begin(), masses.end()), 1e-9);
    }
}

TEST(PieceRaster, DoesNotDependOnThreads) {
    const std::vector<MapPiece> pieces = piecesOf(randomField(13, 2000, 25.0));
    const PieceRaster one = rasterOf(pieces, 0.25, levelSite, Execution().withThreads(1));
    const PieceRaster four = rasterOf(pieces, 0.25, levelSite, Execution().withThreads(4));
    EXPECT_EQ(one.cells, four.cells);
    EXPECT_EQ(one.height, four.height);
    EXPECT_EQ(one.volume, four.volume);
    EXPECT_EQ(one.mass, four.mass);
    EXPECT_EQ(one.component, four.component);
    EXPECT_EQ(one.arrival, four.arrival);
    EXPECT_EQ(one.impactEnergy, four.impactEnergy);
}

TEST(PieceRaster, HeightCountsFromTheTerrain) {
    SiteSurface slope;
    slope.terrain = std::make_shared<TerrainGrid>(0.0, 0.0, 4.0, 2, 2, std::vector<double>{0.0, 4.0, 0.0, 4.0});  // z = x
    const Debris debris = debrisFrom({boxAt(Vec3(0.5, 0.5, 1.5), 1.0), boxAt(Vec3(2.5, 0.5, -5.0), 1.0)});
    const PieceRaster map = raster(piecesOf(debris), 1.0, slope);
    ASSERT_EQ(map.cells.size(), 2u);
    EXPECT_DOUBLE_EQ(map.height[0], 1.5) << "the mean of 2 - x over the cell from 0 to 1";
    EXPECT_EQ(map.height[1], 0.0) << "what sank still has its cell";
}

TEST(PieceRaster, APieceWithoutOutlineGoesToTheCellOfItsCentre) {
    const Debris debris =
        debrisFrom({boxAt(Vec3(2.5, 0.5, 1.0), 7.0, Vec3(0.0, 0.0, 1.0)), boxAt(Vec3(-17.5, 0.5, 1.0), 5.0, Vec3::Zero())});
    const PieceRaster map = raster(piecesOf(debris), 1.0);
    ASSERT_EQ(map.cells, (std::vector<MapCell>{{0, -18}, {0, 2}}));
    EXPECT_EQ(map.mass, (std::vector<double>{5.0, 7.0}));
}

TEST(PieceRaster, WhatFlewFarCostsATile) {
    const Debris debris =
        debrisFrom({boxAt(Vec3(1e8 + 0.5, -1e8 + 0.5, 0.0), 3.0, Vec3::Constant(0.25)), boxAt(Vec3(0.5, 0.5, 0.0), 1.0)});
    EXPECT_EQ(raster(piecesOf(debris), 1.0).cells.size(), 2u);
    EXPECT_TRUE(raster({}, 1.0).cells.empty());
}

TEST(PieceRaster, UnknownArrivalsAndEnergiesStayUnknown) {
    std::vector<MapPiece> pieces = piecesOf(debrisFrom({boxAt(Vec3(0.5, 0.5, 0.5), 1.0), boxAt(Vec3(0.5, 0.5, 1.5), 1.0)}));
    pieces[0].arrival = pieces[0].impactEnergy = unknown;
    EXPECT_EQ(raster(pieces, 1.0).arrival[0], pieces[1].arrival);
    pieces[1].arrival = pieces[1].impactEnergy = unknown;
    EXPECT_TRUE(std::isnan(raster(pieces, 1.0).arrival[0]));
    EXPECT_EQ(raster(pieces, 1.0).impactEnergy[0], 0.0);
}

TEST(PieceRaster, RefusesWhatIsNoNumberAndWhatIsTooLarge) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const Vec3& place : {Vec3(unknown, 0, 0), Vec3(0, 0, unknown), Vec3(0, infinite, 0), Vec3(1e300, 0, 0), Vec3(0, 4e9, 0)}) {
        EXPECT_THROW(raster(piecesOf(debrisFrom({boxAt(place, 1.0)})), 1.0), UsageError) << place.transpose();
    }
    for (const double bad : {unknown, infinite, -1.0}) {
        EXPECT_THROW(raster(piecesOf(debrisFrom({boxAt(Vec3::Zero(), bad)})), 1.0), UsageError) << bad;
        EXPECT_THROW(raster(piecesOf(debrisFrom({boxAt(Vec3::Zero(), 1.0, Vec3(bad, 1.0, 1.0))})), 1.0), UsageError) << bad;
        EXPECT_THROW(raster(piecesOf(debrisFrom({boxAt(Vec3::Zero(), 1.0)})), bad), UsageError) << bad;
    }
    EXPECT_THROW(raster(piecesOf(debrisFrom({boxAt(Vec3::Zero(), 1.0, Vec3(1e6, 1e6, 1.0))})), 1.0), UsageError);
    EXPECT_THROW(raster(piecesOf(debrisFrom({boxAt(Vec3::Zero(), 1.0)})), 1e-9), UsageError);
    EXPECT_THROW(raster({}, 0.0), UsageError);
}

TEST(PieceRaster, StopsWhenCancelled) {
    const Execution execution;
    execution.cancel();
    EXPECT_THROW(rasterOf(piecesOf(randomField(1, 10, 5.0)), 1.0, levelSite, execution), Cancelled);
}

}  // namespace
}  // namespace rubble
