#pragma once

#include <vtkSmartPointer.h>

#include <vector>

#include "core/base/geometry.h"
#include "widgets/render/basics/colours.h"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace rubble::render {

/// Straight lines over a model, in one colour.
class GridLines {
public:
    GridLines();
    ~GridLines();

    void addTo(vtkRenderer& renderer);
    /// @param ends  two for each line [m]; none: nothing is drawn
    void set(const std::vector<Eigen::Vector3f>& ends);
    void setColour(const Rgb& colour);
    void setVisible(bool visible);

private:
    bool m_there = false;
    vtkSmartPointer<vtkPolyData> m_lines;
    vtkSmartPointer<vtkActor> m_actor;
};

}  // namespace rubble::render
