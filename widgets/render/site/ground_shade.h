#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "core/fe/site_surface.h"

namespace rubble::render {

/// Light on the ground about a model and on the model itself: what stands in the sun throws its shadow on both, what lies close
/// above the ground darkens what is beneath it, and what lies deeper than its neighbours is darker. Reckoned from the triangles
/// that are drawn, on a raster over the ground, so that it costs little without a graphics card; free of any graphics library.
class GroundShade {
public:
    /// Cells along the longer side.
    static constexpr std::size_t cellsAlong = 512;

    /// Lays the raster around a model; nothing is in the shade until bake().
    /// @param bounds  of the model at rest, m
    void set(const Aabb& bounds, const SiteSurface& ground);
    /// The light beneath triangles, which face outwards.
    /// @param points     xyz [m]
    /// @param triangles  three points each
    void bake(const std::vector<float>& points, const std::vector<std::int32_t>& triangles);
    /// Takes all shadows away.
    void clear();

    bool empty() const { return m_columns == 0; }
    std::size_t columns() const { return m_columns; }
    std::size_t rows() const { return m_rows; }
    /// South-western corner of the raster, m.
    double left() const { return m_left; }
    double bottom() const { return m_bottom; }
    double cell() const { return m_cell; }  ///< m
    double width() const { return m_cell * static_cast<double>(m_columns); }
    double height() const { return m_cell * static_cast<double>(m_rows); }
    /// Shade of each cell, row by row from the south: 0 is in full light, 1 in none.
    const std::vector<float>& shade() const { return m_shade; }
    /// At a place, m; 0 beyond the raster.
    double shadeAt(double x, double y) const;
    /// [points of the last bake()] what the model leaves of the light on itself: 0 is in full light, 1 in none. Empty: nothing is
    /// in the shade.
    const std::vector<float>& pointShade() const { return m_pointShade; }
    /// Rises with each change of the shade.
    std::uint64_t version() const { return m_version; }

private:
    /// A point of the model over the raster, in cells.
    struct Cast {
        float u = 0.0F;  ///< where its shadow falls
        float v = 0.0F;
        float x = 0.0F;  ///< straight below
        float y = 0.0F;
        float above = 0.0F;   ///< m
        float height = 0.0F;  ///< m, on the scale of the model
    };
    Cast castOf(const float* point) const;
    float groundUnder(float x, float y) const;
    void blurred(std::vector<float>& field, std::size_t radius);
    void shadePoints();

    double m_left = 0.0;
    double m_bottom = 0.0;
    double m_cell = 1.0;
    double m_near = 1.0;  ///< m above the ground within which things darken it
    float m_cellsInMetre = 1.0F;
    float m_east = 0.0F;  ///< cells that a shadow goes east and north for each metre above the ground
    float m_north = 0.0F;
    std::size_t m_columns = 0;
    std::size_t m_rows = 0;
    std::vector<float> m_ground;  ///< m, by cell; empty: level
    float m_level = 0.0F;
    bool m_clear = true;
    std::vector<Cast> m_casts;
    std::vector<float> m_cast;
    std::vector<float> m_contact;
    std::vector<float> m_passing;  ///< of a field between its two passes
    std::vector<float> m_shade;
    std::vector<float> m_top;    ///< m, by the cell that a ray of the sun ends in: the height at which it meets the model first
    std::vector<float> m_crowd;  ///< m, mean of these about a cell
    std::vector<float> m_pointShade;
    std::uint64_t m_version = 0;
};

}  // namespace rubble::render
