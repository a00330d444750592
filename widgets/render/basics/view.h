#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "widgets/render/basics/colours.h"
#include "widgets/render/basics/fragment_filter.h"

namespace rubble::render {

/// What a pane shows: the conventional FE result; the fragments with the active structure; the same with the outline of the intact
/// structure over it; the same seen from above; the fragments of another scenario.
enum class PaneContent : std::uint8_t { Fe, Fragments, Overlay, Plan, Other };
inline constexpr std::size_t paneContents = 5;
/// Another scenario is always seen as the fragments are.
inline constexpr std::size_t paneCameras = 4;
enum class Layout : std::uint8_t { Beside, Stacked, FeOnly, FragmentsOnly, OverlayOnly, Four, Scenarios };
/// Island: structure that is loose, by the island that it belongs to; the others say it of fragments.
enum class ColourBy : std::uint8_t { Highlight, Component, BirthTime, Speed, Cluster, Error, Island };
enum class Theme : std::uint8_t { Light, Dark, Print };
/// Scale of colours of birth time and speed; all of them rise in lightness.
enum class ColourMap : std::uint8_t { Standard, Viridis, Cividis, Grey };
/// How surfaces look: plain greys with fragments picked out, or every element in the look of its material, dead or alive.
enum class Style : std::uint8_t { Analysis, Presentation };

/// What the colour of a point of a cloud says: what the file has (colour, else intensity, else height), its height, its class, or
/// how far the simulated site lies from it.
enum class PointColour : std::uint8_t { Own, Height, Class, Distance };

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

/// A plane that opens the model: what lies on the side to which the normal points is not drawn.
struct ClipPlane {
    Vec3 point = Vec3::Zero();    ///< m
    Vec3 normal = Vec3::UnitX();  ///< unit length

    friend bool operator==(const ClipPlane&, const ClipPlane&) = default;
};

/// A length drawn into the view, with its label in m.
struct Measurement {
    Vec3 from = Vec3::Zero();  ///< m
    Vec3 to = Vec3::Zero();    ///< m
    bool height = false;       ///< the vertical part of it

    /// m
    double length() const { return height ? std::abs(to.z() - from.z()) : (to - from).norm(); }
    friend bool operator==(const Measurement&, const Measurement&) = default;
};

/// Everything that decides a picture apart from the data: a value that window, command line and movie share.
struct View {
    Layout layout = Layout::Beside;
    std::array<Camera, paneCameras> cameras;  ///< by content of the pane
    bool camerasLinked = true;                ///< all panes but the plan use cameras[0]
    double time = 0.0;                        ///< s, on the file's clock
    double timeOrigin = 0.0;                  ///< s, on the file's clock: captions count from here
    ColourBy colourBy = ColourBy::Highlight;
    ColourMap colourMap = ColourMap::Standard;
    Style style = Style::Analysis;
    Theme theme = Theme::Light;
    bool ground = true;
    bool groundGrid = true;
    bool shading = false;  ///< edges and hollows darker, after the depth of the picture
    bool shadows = true;   ///< the sun's shadow on the ground, which is darker beneath what lies on it
    std::string cloud;     ///< id of the input whose points are drawn; empty: none
    PointColour pointColour = PointColour::Own;
    bool axes = true;
    bool captions = true;
    bool legends = true;
    bool scaleBar = true;
    std::optional<std::array<double, 3>> basicGrid;           ///< m, l w h of boxes drawn over the fragments; unset: none
    std::vector<double> errorSteps{0.1, 0.2, 0.3, 1.0, 3.0};  ///< m, ascending: where the colours of an error change
    std::vector<ElementIndex> selection;                      ///< drawn in the accent colour in all panes, active or fragment
    std::vector<std::string> hiddenComponents;                ///< by name; not drawn, active or fragment
    std::vector<ElementIndex> hidden;                         ///< not drawn, active or fragment
    FragmentFilter filter;                                    ///< fragments that do not meet it are not drawn
    std::map<std::string, Rgb> componentColours;              ///< that take the place of the component's own
    std::optional<ClipPlane> clip;
    std::vector<Measurement> measurements;
    std::vector<Vec3> path;  ///< m, way of a fragment, drawn as a line where fragments are

    friend bool operator==(const View&, const View&) = default;
};

/// Where the camera of a pane stands in View::cameras.
std::size_t cameraIndex(const View& view, PaneContent content);
/// The camera that a pane of this view uses.
const Camera& cameraOf(const View& view, PaneContent content);
Camera& cameraOf(View& view, PaneContent content);

}  // namespace rubble::render
