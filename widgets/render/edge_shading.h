#pragma once

#include <vtkEDLShading.h>

namespace rubble::render {

/// Shading of what lies behind an edge on the screen. It fades beyond the model: ground that is seen at a flat angle falls away
/// from pixel to pixel as edges do, and would grow black towards the horizon.
class EdgeShading : public vtkEDLShading {
public:
    using Superclass = vtkEDLShading;
    static EdgeShading* New();

    /// Distances along the view at which shading begins to fade and is gone, m.
    void setFading(double from, double to);
    void Render(const vtkRenderState* state) override;

private:
    double m_from = 0.0;
    double m_to = 1.0;
};

}  // namespace rubble::render
