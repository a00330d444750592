#include "widgets/render/site/point_layer.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace rubble::render {

namespace {

/// px: neighbours on a surface that is seen whole close up.
constexpr float pointSize = 2.0F;

vtkSmartPointer<vtkActor> actorOf(const SitePoints::Patch& patch) {
    const auto count = static_cast<vtkIdType>(patch.rgb.size() / 3);
    // VTK only reads these arrays; its interface has no const.
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(3);
    places->SetArray(const_cast<float*>(patch.places.data()), 3 * count, 1);
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    colours->SetArray(const_cast<std::uint8_t*>(patch.rgb.data()), 3 * count, 1);
    vtkNew<vtkPoints> points;
    points->SetData(places);
    vtkNew<vtkCellArray> cells;
    std::vector<vtkIdType> ids(static_cast<std::size_t>(count));
    std::iota(ids.begin(), ids.end(), vtkIdType{0});
    cells->InsertNextCell(count, ids.data());
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(cells);
    data->GetPointData()->SetScalars(colours);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetColorModeToDirectScalars();
    vtkSmartPointer<vtkActor> actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetPointSize(pointSize);
    actor->PickableOff();
    return actor;
}

}  // namespace

PointLayer::PointLayer() = default;
PointLayer::~PointLayer() = default;

void PointLayer::set(const std::shared_ptr<const SitePoints>& points) {
    if (points == m_points) {
        return;
    }
    std::vector<Shown> before = std::exchange(m_shown, {});
    m_points = points;
    for (std::size_t i = 0; points != nullptr && i < points->patches.size(); ++i) {
        const auto& patch = points->patches[i];
        const auto kept = std::find_if(before.begin(), before.end(), [&](const Shown& shown) { return shown.patch == patch; });
        if (kept != before.end()) {
            m_shown.push_back(std::move(*kept));
            before.erase(kept);
        } else {
            m_shown.push_back({patch, actorOf(*patch)});
            if (m_clip != nullptr) {
                m_shown.back().actor->GetMapper()->AddClippingPlane(m_clip);
            }
            m_renderer->AddActor(m_shown.back().actor);
        }
    }
    for (const Shown& gone : before) {
        gone.actor->ReleaseGraphicsResources(m_renderer->GetVTKWindow());
        m_renderer->RemoveActor(gone.actor);
    }
}

void PointLayer::setClip(vtkPlane* plane) {
    m_clip = plane;
    for (const Shown& shown : m_shown) {
        shown.actor->GetMapper()->RemoveAllClippingPlanes();
        if (plane != nullptr) {
            shown.actor->GetMapper()->AddClippingPlane(plane);
        }
    }
}

void PointLayer::show(bool visible, std::uint64_t most) {
    std::uint64_t drawn = 0;
    for (const Shown& shown : m_shown) {
        shown.actor->SetVisibility(visible && drawn < most);
        drawn += shown.patch->rgb.size() / 3;
    }
}

}  // namespace rubble::render
