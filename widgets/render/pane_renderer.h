#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <optional>

#include "widgets/render/pane_geometry.h"
#include "widgets/render/panes.h"
#include "widgets/render/site/grid_lines.h"
#include "widgets/render/site/ground.h"
#include "widgets/render/site/point_layer.h"
#include "widgets/render/site/site_layer.h"
#include "widgets/render/site/water_surface.h"

class vtkActor;
class vtkFloatArray;
class vtkLight;
class vtkPlane;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace rubble::render {

class EdgeShading;

/// One pane in VTK: a renderer with one polydata for all that moves, one for the selection, and the ground.
class PaneRenderer {
public:
    PaneRenderer();
    ~PaneRenderer();

    vtkRenderer& renderer() { return *m_renderer; }

    /// Hands the geometry's arrays to VTK (not copied: the geometry must outlive the next Render()); null shows an empty pane.
    void show(const PaneGeometry* geometry);
    /// @param waterLevel  m; unset: no water
    void setColours(const SceneColours& colours, const Aabb& bounds, const SiteSurface& ground, std::optional<double> waterLevel);
    /// What lies and stands on the ground; after setColours().
    void setSite(const std::shared_ptr<const Orthophoto>& orthophoto,
                 const std::shared_ptr<const std::vector<SiteMesh>>& surroundings, const SiteSurface& ground, const Aabb& bounds,
                 const SceneColours& colours);
    void setGround(bool visible, bool grid);
    /// As PointLayer. @param simple  fewer of them, while the picture moves
    void setPoints(const std::shared_ptr<const SitePoints>& points, bool visible, bool simple);
    void setClip(const std::optional<ClipPlane>& clip);
    /// Darkens edges and hollows after the depth of the picture.
    void setShading(bool shaded);
    /// The sun and what it leaves in the dark, or a lamp behind the viewer; null: the lamp. It must outlive the next Render().
    void setShade(const GroundShade* shade, const SceneColours& colours);
    /// Edges of the intact structure, two ends each [m]; none: nothing is drawn.
    void setOutline(const std::vector<Eigen::Vector3f>& ends);
    /// Lines over the model, two ends each [m]; none: nothing is drawn.
    void setGrid(const std::vector<Eigen::Vector3f>& ends);
    /// @param pane  place in a window of width x height device pixels
    void place(const Pane& pane, int width, int height);
    void look(const Camera& camera, const Aabb& bounds);

private:
    void makeActors();
    void setTriangles(const PaneGeometry& geometry);
    void setGrain(const std::vector<float>& grain);
    void setPointShade(const GroundShade* shade);

    vtkSmartPointer<vtkRenderer> m_renderer;
    vtkSmartPointer<vtkLight> m_lamp;
    vtkSmartPointer<vtkLight> m_sun;
    vtkSmartPointer<vtkLight> m_fill;
    vtkSmartPointer<vtkPoints> m_points;
    vtkSmartPointer<vtkFloatArray> m_coordinates;
    vtkSmartPointer<vtkUnsignedCharArray> m_rgba;
    vtkSmartPointer<vtkPolyData> m_model;
    vtkSmartPointer<vtkPolyData> m_selection;
    vtkSmartPointer<vtkActor> m_modelActor;
    vtkSmartPointer<vtkActor> m_selectionActor;
    Ground m_ground;
    SiteLayer m_site;
    PointLayer m_cloud;
    WaterSurface m_water;
    GridLines m_grid;
    GridLines m_outline;
    vtkSmartPointer<vtkPlane> m_clipPlane;
    bool m_clipped = false;
    bool m_shaded = false;
    vtkSmartPointer<vtkFloatArray> m_grain;
    bool m_grained = false;
    vtkSmartPointer<vtkFloatArray> m_pointShade;  // of each point of the model, beside the grain
    std::uint64_t m_pointShadeVersion = 0;
    const GroundShade* m_pointShadeOf = nullptr;
    vtkSmartPointer<EdgeShading> m_edges;
    const PaneGeometry* m_shown = nullptr;
    std::uint64_t m_pointsVersion = 0;
    std::uint64_t m_coloursVersion = 0;
    std::uint64_t m_trianglesVersion = 0;
    std::uint64_t m_selectionVersion = 0;
};

}  // namespace rubble::render
