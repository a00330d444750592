#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/fe/height_grid.h"
#include "core/fe/orthophoto.h"
#include "core/fe/raster_lattice.h"
#include "io/site/raster_file.h"
#include "io/site/site_place.h"

namespace rubble::io {

/// A raster seen from the local frame, whatever its system and however it is turned.
class RasterSampling {
public:
    /// @param crs  of the case; empty: the world's coordinates are those of the file. All must outlive this object.
    RasterSampling(const RasterFile& file, const std::string& crs, const SitePlace& place);

    /// Box around the raster, m local.
    std::pair<Eigen::Vector2d, Eigen::Vector2d> bounds() const;
    /// Shorter side of a pixel at a place, m. Throws UsageError where the raster has no place there.
    double pixelSize(const Eigen::Vector2d& local) const;
    /// Where a window of the local frame lies among the pixels. @param cell  m, of a pixel as it is used
    RasterLattice lattice(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double cell) const;
    /// The pixels around the places of a lattice, one more to each side; empty if there are none.
    /// @param factor  pixels of the file that are put together
    RasterWindow windowAround(const std::vector<Eigen::Vector2d>& pixels, std::size_t factor) const;
    /// Makes a lattice count among the pixels of a window that were read.
    static void countWithin(const RasterWindow& window, RasterLattice& lattice);
    /// Takes values of a window before anything is made of them.
    using Look = std::function<void(const RasterWindow&, std::vector<double>&)>;
    /// Heights at the nodes of a grid by bilinear interpolation; not a number beyond the pixels, and where one that counts has
    /// none.
    std::vector<double> heights(const HeightGrid& nodes, std::size_t factor, const Look& look, const Execution& execution) const;
    /// m, local, of the middles of pixels of a window; not a number where one has no place.
    std::vector<Eigen::Vector2d> placesOf(const RasterWindow& window, const std::vector<std::size_t>& which) const;
    /// Colours at the middles of the pixels of a picture, whose place and size are given.
    void colour(Orthophoto& picture, std::size_t factor, const Execution& execution, Findings& findings) const;

private:
    struct Nodes;
    std::vector<Eigen::Vector2d> pixelsOf(std::vector<Eigen::Vector2d> local) const;
    /// Fractional pixels of a lattice of places, interpolated between every sixteenth row and column.
    std::vector<Eigen::Vector2d> pixelsOf(const Nodes& nodes, const Execution& execution) const;

    const RasterFile& m_file;
    const std::string& m_crs;
    const SitePlace& m_place;
};

}  // namespace rubble::io
