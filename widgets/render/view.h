#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"

namespace rubble::render {

/// What a pane shows: the conventional FE result, or the fragments with the active structure.
enum class PaneContent : std::uint8_t { Fe, Fragments };
enum class Layout : std::uint8_t { Beside, Stacked, FeOnly, FragmentsOnly };
enum class ColourBy : std::uint8_t { Highlight, Component, BirthTime, Speed, Cluster, Error };
enum class Theme : std::uint8_t { Light, Dark, Print };

/// Camera in the case's local frame.
struct Camera {
    Vec3 position = Vec3(0, -100, 30);
    Vec3 focalPoint = Vec3::Zero();
    Vec3 up = Vec3::UnitZ();
    double viewAngle = 30.0;  ///< degrees, vertical
    bool parallel = false;
    double parallelScale = 1.0;  ///< m, half the height of the view

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Everything that decides a picture apart from the data: a value that window, command line and movie share.
struct View {
    Layout layout = Layout::Beside;
    std::array<Camera, 2> cameras;  ///< of the FE pane and the fragments pane
    bool camerasLinked = true;      ///< both panes use cameras[0]
    double time = 0.0;              ///< s, on the file's clock
    double timeOrigin = 0.0;        ///< s, on the file's clock: captions count from here
    ColourBy colourBy = ColourBy::Highlight;
    Theme theme = Theme::Light;
    bool ground = true;
    bool captions = true;
    bool legends = true;
    bool scaleBar = true;
    std::optional<std::array<double, 3>> basicGrid;           ///< m, l w h of boxes drawn over the fragments; unset: none
    std::vector<double> errorSteps{0.1, 0.2, 0.3, 1.0, 3.0};  ///< m, ascending: where the colours of an error change
    std::vector<ElementIndex> selection;                      ///< drawn in the accent colour in both panes, active or fragment

    friend bool operator==(const View&, const View&) = default;
};

/// The camera that a pane of this view uses.
const Camera& cameraOf(const View& view, PaneContent content);
Camera& cameraOf(View& view, PaneContent content);

}  // namespace rubble::render
