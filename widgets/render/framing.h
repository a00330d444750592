#pragma once

#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "widgets/render/basics/camera.h"

namespace rubble::render {

/// What pictures seen from one direction have to hold: some points about everything that they show, few however large the model.
class Framing {
public:
    explicit Framing(Preset look) : m_look(look) {}

    /// What one picture shows.
    /// @param points   corners of everything, m
    /// @param centres  of its elements and fragments, m: the few that lie far out beyond all others need not be in the picture
    /// @param always   m, is in it in any case
    /// @param largest  m, across the largest element
    void add(std::span<const Vec3> points, std::span<const Vec3> centres, const Aabb& always, double largest);
    /// What lies around is seen as well, in plan. @param factor  1: nothing
    void widen(double factor);

    bool empty() const { return m_points.empty(); }
    std::span<const Vec3> points() const { return m_points; }
    /// Shows all of it, with a small margin.
    Camera camera(double aspect) const { return fitCamera(m_points, aspect, m_look); }
    /// Width over height of the picture that it fills both ways, 0.5 to 8.
    double aspect() const;

private:
    Preset m_look;
    std::vector<Vec3> m_points;
};

}  // namespace rubble::render
