#include "widgets/render/water_surface.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>
#include <numbers>

namespace rubble::render {
namespace {

constexpr int sectors = 64;
constexpr double opacity = 110.0;  // of 255
constexpr std::array<double, 4> rings{0.1, 0.25, 0.5, 1.0};

}  // namespace

WaterSurface::WaterSurface() : m_surface(vtkSmartPointer<vtkPolyData>::New()), m_actor(vtkSmartPointer<vtkActor>::New()) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(m_surface);
    mapper->SetColorModeToDirectScalars();
    m_actor->SetMapper(mapper);
    m_actor->GetProperty()->LightingOff();
    m_actor->PickableOff();
    m_actor->ForceTranslucentOn();
    m_actor->VisibilityOff();
}

WaterSurface::~WaterSurface() = default;

void WaterSurface::addTo(vtkRenderer& renderer) {
    renderer.AddActor(m_actor);
}

void WaterSurface::setVisible(bool visible) {
    m_actor->SetVisibility(visible && m_there);
}

void WaterSurface::set(std::optional<double> level, const Aabb& bounds, double reach, const SceneColours& colours) {
    m_there = level.has_value();
    if (!m_there) {
        m_actor->VisibilityOff();
        return;
    }
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> rgba;
    rgba->SetNumberOfComponents(4);
    const auto add = [&](double x, double y, double share) {
        points->InsertNextPoint(x, y, *level);
        const auto alpha = static_cast<unsigned char>(std::lround(opacity * share));
        const std::array<unsigned char, 4> colour{colours.water.r, colours.water.g, colours.water.b, alpha};
        rgba->InsertNextTypedTuple(colour.data());
    };
    add(bounds.center().x(), bounds.center().y(), 1.0);
    for (const double ring : rings) {
        for (int s = 0; s < sectors; ++s) {
            const double angle = 2.0 * std::numbers::pi * s / sectors;
            add(bounds.center().x() + ring * reach * std::cos(angle), bounds.center().y() + ring * reach * std::sin(angle),
                1.0 - ring);
        }
    }
    for (int s = 0; s < sectors; ++s) {
        const vtkIdType next = (s + 1) % sectors;
        const std::array<vtkIdType, 3> first{0, 1 + s, 1 + next};
        cells->InsertNextCell(3, first.data());
        for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
            const vtkIdType inner = 1 + static_cast<vtkIdType>(r) * sectors;
            const vtkIdType outer = inner + sectors;
            const std::array<vtkIdType, 4> quad{inner + s, outer + s, outer + next, inner + next};
            cells->InsertNextCell(4, quad.data());
        }
    }
    m_surface->SetPoints(points);
    m_surface->SetPolys(cells);
    m_surface->GetPointData()->SetScalars(rgba);
    m_surface->Modified();
}

}  // namespace rubble::render
