#pragma once

#include <vtkSmartPointer.h>

#include <optional>

#include "core/base/geometry.h"
#include "widgets/render/basics/colours.h"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace rubble::render {

/// Still water: a level surface through which one sees, fading with the distance.
class WaterSurface {
public:
    WaterSurface();
    ~WaterSurface();

    void addTo(vtkRenderer& renderer);
    /// @param level  m; nothing: no water is drawn
    /// @param reach  m, from the model's centre
    void set(std::optional<double> level, const Aabb& bounds, double reach, const SceneColours& colours);
    void setVisible(bool visible);

private:
    bool m_there = false;
    vtkSmartPointer<vtkPolyData> m_surface;
    vtkSmartPointer<vtkActor> m_actor;
};

}  // namespace rubble::render
