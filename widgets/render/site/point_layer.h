#pragma once

#include <vtkSmartPointer.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "widgets/render/basics/site_points.h"

class vtkActor;
class vtkPlane;
class vtkRenderer;

namespace rubble::render {

/// The points of a cloud in one pane, each patch an actor of its own, so that those that stay are not sent to the GPU again.
class PointLayer {
public:
    PointLayer();
    ~PointLayer();

    void addTo(vtkRenderer& renderer) { m_renderer = &renderer; }
    /// Points that are null are none. What they hold is not copied; they are kept as long as they are shown.
    void set(const std::shared_ptr<const SitePoints>& points);
    /// @param most  points that are drawn, by the patch: the coarse ones come first
    void show(bool visible, std::uint64_t most);
    /// Points on the other side of a plane than its normal shows to are not drawn; null: all are. It is kept.
    void setClip(vtkPlane* plane);

private:
    struct Shown {
        std::shared_ptr<const SitePoints::Patch> patch;
        vtkSmartPointer<vtkActor> actor;
    };
    vtkRenderer* m_renderer = nullptr;
    vtkPlane* m_clip = nullptr;
    std::shared_ptr<const SitePoints> m_points;
    std::vector<Shown> m_shown;
};

}  // namespace rubble::render
