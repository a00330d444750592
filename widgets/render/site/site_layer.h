#pragma once

#include <vtkSmartPointer.h>

#include <memory>
#include <vector>

#include "core/base/geometry.h"
#include "core/fe/orthophoto.h"
#include "core/fe/site_mesh.h"
#include "core/fe/site_surface.h"
#include "widgets/render/basics/colours.h"
#include "widgets/render/site/shade_texture.h"

class vtkActor;
class vtkPolyData;
class vtkRenderer;
class vtkTexture;

namespace rubble::render {

/// What lies and stands on the ground around the structure: an orthophoto draped over it, and meshes of the surroundings.
class SiteLayer {
public:
    SiteLayer();
    ~SiteLayer();

    void addTo(vtkRenderer& renderer);
    /// @param bounds  of the model, m
    /// @param reach   how far the ground is drawn from its centre, m
    void set(const std::shared_ptr<const Orthophoto>& orthophoto, const std::shared_ptr<const std::vector<SiteMesh>>& surroundings,
             const SiteSurface& ground, const Aabb& bounds, double reach, const SceneColours& colours);
    void setVisible(bool visible);
    /// Shadows over the orthophoto; null or empty: none. It must outlive the next picture.
    void setShade(const GroundShade* shade, const SceneColours& colours);

private:
    void drape(const Orthophoto& picture, const SiteSurface& ground, const Aabb& bounds, double reach, double brightest);
    void build(const std::vector<SiteMesh>& surroundings);

    std::shared_ptr<const Orthophoto> m_orthophoto;
    std::shared_ptr<const std::vector<SiteMesh>> m_surroundings;
    SiteSurface m_ground;
    double m_reach = 0.0;
    double m_brightest = 1.0;
    bool m_visible = false;
    bool m_shaded = false;
    bool m_shadeLaid = false;
    ShadeTexture m_shade{ShadeTexture::Kind::Veil};
    vtkSmartPointer<vtkPolyData> m_veil;
    vtkSmartPointer<vtkActor> m_veilActor;
    vtkSmartPointer<vtkPolyData> m_drape;
    vtkSmartPointer<vtkTexture> m_texture;
    vtkSmartPointer<vtkPolyData> m_meshes;
    vtkSmartPointer<vtkActor> m_drapeActor;
    vtkSmartPointer<vtkActor> m_meshActor;
};

}  // namespace rubble::render
