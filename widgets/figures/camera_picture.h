#pragma once

#include <QImage>
#include <QSize>

#include "core/evidence/photographs/camera_model.h"
#include "widgets/figures/figure_file.h"

namespace rubble::figures {

/// The camera of a view that looks from the place and in the direction of a matched one. A view has no distortion and its principal
/// point in the middle, so that lines may lie elsewhere than on the photograph.
/// @param distance  m, to the point that the view turns about
render::Camera viewCamera(const CameraModel& camera, int height, double distance);

/// Draws the fragments as a matched camera sees them, principal point and distortion included: a wider view without distortion is
/// drawn and every pixel of the photograph looks into it. Opens its GL window once and keeps it.
class CameraStudio {
public:
    /// Throws as Studio.
    explicit CameraStudio(const render::SceneData& data) : m_studio(data) {}

    /// The picture in the frame of the photograph, no larger than it.
    /// @param like         time, colours and theme
    /// @param photograph   px
    /// @param longestSide  px, of the picture
    /// @param distance     m, from the camera to what it looks at
    QImage picture(const render::View& like, const CameraModel& camera, QSize photograph, int longestSide, double distance);

private:
    Studio m_studio;
};

}  // namespace rubble::figures
