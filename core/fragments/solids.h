#pragma once

#include <span>

#include "core/base/geometry.h"
#include "core/fe/mesh.h"
#include "core/fragments/consistent_mass.h"

namespace rubble {

/// A solid on the move: its shape (Hexahedron, Wedge, Pyramid or Tetrahedron) and its own corners, one column each.
struct MovingSolid {
    ElementShape shape = ElementShape::Hexahedron;
    Corners positions = Corners::Zero();   ///< m; columns from cornerCount(shape) on are unused
    Corners velocities = Corners::Zero();  ///< m/s
};

/// The solid of an element: solids as they are; shells extruded by their thickness, half to either side, along the normal of the
/// mean plane; beams to a prism of square section. The corners on either side move with the turning normal, so that a rigidly
/// turning shell is a rigidly turning solid; a beam's spin about its own axis is not in the velocities of its two nodes and is
/// taken as zero.
/// @param positions   m, one column a corner of the element
/// @param velocities  m/s, likewise
/// @param section     thickness m (shells) or area m2 (beams); unused for solids
MovingSolid solidOf(ElementShape element, const Corners& positions, const Corners& velocities, double section);

/// The rotation nearest to a matrix (polar decomposition); always a proper rotation, for singular and reflecting matrices too.
Mat3 nearestRotation(const Mat3& matrix);

/// Axes of an element's box: a frame along the edge directions of its reference shape, turned by the rotation of its deformation
/// since (polar decomposition). Of the frames that the edges offer it is the one whose box around the reference shape is smallest;
/// a reference shape without volume leaves the choice to the present one.
/// @param reference, present  positions as asHexahedron() gives them, m
Mat3 boxAxes(const Corners& reference, const Corners& present);

/// The tight box with these axes around the first `count` corners.
OrientedBox boxAround(const Corners& corners, int count, const Mat3& axes);

/// Numbers the corners of a mirrored solid the right way round.
void unmirror(ElementShape shape, Corners& corners);

/// A solid that an engine and a picture can use, with the box around it.
struct SoundSolid {
    ElementShape shape = ElementShape::Hexahedron;
    Corners corners = Corners::Zero();
    OrientedBox box;
    bool thickened = false;  ///< it was thinner than the minimum
    bool boxed = false;      ///< its own shape could not be kept: the solid is the box
};

/// Least half extent of a solid whose longest is known: ratio of it, at least `least` (m).
double minimumHalfExtent(const Vec3& halfExtents, double ratio, double least);

/// Makes a solid sound: nothing thinner than the minimum, no fold, no inside out. Thin solids are stretched along the axes of their
/// box; folded and collapsed ones become their box, along the principal axes where they hold next to no volume.
/// @param state, volume  from consistentMass()
/// @param axes           boxAxes()
SoundSolid soundSolid(const MovingSolid& solid, SolidState state, double volume, const Mat3& axes, double ratio, double least);

}  // namespace rubble
