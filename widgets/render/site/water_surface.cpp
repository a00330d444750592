#include "widgets/render/site/water_surface.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <array>
#include <cmath>

#include "widgets/render/site/disc.h"

namespace rubble::render {
namespace {

constexpr double opacity = 110.0;  // of 255
constexpr std::array<double, 4> rings{0.1, 0.25, 0.5, 1.0};

}  // namespace

WaterSurface::WaterSurface() : m_surface(vtkSmartPointer<vtkPolyData>::New()), m_actor(vtkSmartPointer<vtkActor>::New()) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(m_surface);
    mapper->SetColorModeToDirectScalars();
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(stepBack, stepBack);
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
    const Vec3 centre(bounds.center().x(), bounds.center().y(), *level);
    makeDisc(*m_surface, centre, reach, rings, [&colours](double ring) {
        const auto alpha = static_cast<std::uint8_t>(std::lround(opacity * (1.0 - ring)));
        return std::array{colours.water.r, colours.water.g, colours.water.b, alpha};
    });
}

}  // namespace rubble::render
