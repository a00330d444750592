#pragma once

#include <vtkSmartPointer.h>

#include "core/base/geometry.h"
#include "core/fe/site_surface.h"
#include "widgets/render/basics/colours.h"
#include "widgets/render/site/shade_texture.h"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace rubble::render {

/// What surrounds the model in a pane: a plane or a terrain that fades into the horizon, with a quiet grid of round spacing, and
/// the sky above.
class Ground {
public:
    Ground();
    ~Ground();

    void addTo(vtkRenderer& renderer);
    /// @param bounds  of the model, m
    /// @param ground  level, or a terrain: a surface shaded by its slope
    void set(const Aabb& bounds, const SiteSurface& ground, const SceneColours& colours);
    void setVisible(bool visible, bool grid);
    /// The light on the ground about the model; null or empty: full light everywhere. It must outlive the next picture.
    void setShade(const GroundShade* shade, const SceneColours& colours);
    /// The grid recedes behind a picture of the ground, which has marks of its own.
    void setGridOpacity(double opacity);
    /// How far the ground reaches from the model's centre, m.
    double reach() const { return m_reach; }
    /// Distance of grid lines, m.
    static double spacing(const Aabb& bounds);

private:
    void makeSky(const Vec3& centre, const SceneColours& colours);
    void makePlane(const Vec3& centre, const SceneColours& colours);
    void makeRelief(const TerrainGrid& terrain, const Aabb& bounds, const SceneColours& colours);
    void makeGrid(const SiteSurface& ground, const Vec3& centre, double size, double step, const SceneColours& colours);

    double m_reach = 0.0;
    ShadeTexture m_shade{ShadeTexture::Kind::Light};
    bool m_shadeLaid = false;  ///< the plane has places in it
    vtkSmartPointer<vtkPolyData> m_sky;
    vtkSmartPointer<vtkPolyData> m_plane;
    vtkSmartPointer<vtkPolyData> m_grid;
    vtkSmartPointer<vtkActor> m_skyActor;
    vtkSmartPointer<vtkActor> m_planeActor;
    vtkSmartPointer<vtkActor> m_gridActor;
};

}  // namespace rubble::render
