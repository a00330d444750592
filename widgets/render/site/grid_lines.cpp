#include "widgets/render/site/grid_lines.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>

namespace rubble::render {

GridLines::GridLines() : m_lines(vtkSmartPointer<vtkPolyData>::New()), m_actor(vtkSmartPointer<vtkActor>::New()) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(m_lines);
    mapper->ScalarVisibilityOff();
    m_actor->SetMapper(mapper);
    m_actor->GetProperty()->LightingOff();
    // What lies behind a fine grid stays to be seen.
    m_actor->GetProperty()->SetOpacity(0.6);
    m_actor->PickableOff();
    m_actor->VisibilityOff();
}

GridLines::~GridLines() = default;

void GridLines::addTo(vtkRenderer& renderer) {
    renderer.AddActor(m_actor);
}

void GridLines::set(const std::vector<Eigen::Vector3f>& ends) {
    m_there = !ends.empty();
    const auto count = static_cast<vtkIdType>(ends.size());
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(count);
    if (m_there) {
        std::copy_n(ends.front().data(), 3 * ends.size(), coordinates->GetPointer(0));
    }
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    vtkNew<vtkCellArray> lines;
    lines->AllocateExact(count / 2, count);
    for (vtkIdType i = 0; i + 1 < count; i += 2) {
        const vtkIdType line[2] = {i, i + 1};
        lines->InsertNextCell(2, line);
    }
    m_lines->SetPoints(points);
    m_lines->SetLines(lines);
}

void GridLines::setColour(const Rgb& c) {
    m_actor->GetProperty()->SetColor(c.r / 255.0, c.g / 255.0, c.b / 255.0);
}

void GridLines::setVisible(bool visible) {
    m_actor->SetVisibility(visible && m_there);
}

}  // namespace rubble::render
