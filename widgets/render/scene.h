#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "widgets/render/basics/colours.h"
#include "widgets/render/basics/scene_data.h"
#include "widgets/render/basics/view.h"
#include "widgets/render/panes.h"

class vtkRenderWindow;

namespace rubble::render {

/// An island of loose structure at the FE state that a pane shows.
struct ShownIsland {
    std::uint32_t island = 0;    ///< index in LooseStructure
    std::size_t elements = 0;    ///< of it at that state
    std::uint32_t category = 0;  ///< of the scene's colours (colour_choice::category())
};

/// What a pane showed when it was last updated: for captions, legends and the status line.
struct PaneStatus {
    double time = 0.0;          ///< s, of what is shown (a growing run may not have reached the view's time)
    std::uint32_t state = 0;    ///< last FE state at or before it, 0-based
    std::uint32_t states = 0;   ///< of the FE result
    bool interpolated = false;  ///< between two FE states (FE pane) or two frames (fragments pane)
    bool afterFeEnd = false;    ///< the structure is held at the last FE state
    bool waitsForRun = false;   ///< the run has not got to the view's time; the last computed instant is shown
    bool looseBodies = false;   ///< of a table of bodies: there is no FE result
    bool simulated = false;     ///< bodies come from a trajectory; else fragments stand at their birth place
    FrameKind kind = FrameKind::Fe;
    std::size_t elements = 0;                  ///< of the model
    std::size_t active = 0;                    ///< shown as active structure
    std::size_t released = 0;                  ///< shown as islands of live structure that bodies carry
    std::size_t fragments = 0;                 ///< shown as born
    std::vector<std::size_t> bornByComponent;  ///< fragments shown as born, of each component
    std::size_t clusters = 0;                  ///< with at least one fragment born
    std::vector<std::size_t> errors;           ///< fragments shown as born, by the steps of the error; empty: not coloured by it
    std::size_t errorsUnknown = 0;             ///< of them, those that the reference does not have at this time
    bool islandsKnown = false;                 ///< the scene has its loose structure
    std::vector<ShownIsland> islands;          ///< the largest first; empty: not coloured by island, or none
    std::size_t faces = 0;                     ///< drawn
    double simplifiedTo = 0.0;                 ///< m: shapes are drawn to within this; 0: as they are
    double resolution = 1.0;                   ///< share of the pixels in each direction; below 1 while simplified only
    std::size_t statesApart = 1;  ///< FE states from one to the next between which nodes move; more while simplified only
    std::size_t hidden = 0;       ///< elements left out of the picture; the counts above hold them all the same
    std::size_t ahead = 0;        ///< fragments shown as born of elements that the FE result still has: births joined in windows
    std::optional<std::size_t> meeting = {};  ///< fragments shown as born that meet the filter of the view; unset: it has none
};

/// What lies under a pixel.
struct Pick {
    PaneContent pane = PaneContent::Fe;
    ElementIndex element{};
    std::optional<FragmentId> fragment;  ///< set when the element is shown as a fragment
    Vec3 position = Vec3::Zero();        ///< m, where the ray meets it
    Vec3 corner = Vec3::Zero();          ///< m, the nearest node of it there, as drawn
};

/// Views of a collapse as renderers in one VTK window that the caller owns: a vtkGenericOpenGLRenderWindow inside a widget, or
/// an off-screen window. One polydata per view; only faces that can be seen are made. To be used from one thread.
class Scene {
public:
    Scene();
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// Puts the renderers into a window (not owned; detach before it dies).
    void attach(vtkRenderWindow& window);
    /// Takes them out and frees their GL resources. The window's GL context must be current.
    void detach();

    void setData(const SceneData& data);
    const SceneData& data() const;
    /// The run of another scenario of the same FE result, for the pane that shows one; without FE result: none.
    void setOther(const SceneData& data, const std::string& scenario);
    /// What a pane of this content shows.
    const SceneData& dataOf(PaneContent content) const;
    /// Name of the other scenario.
    const std::string& otherScenario() const;
    void setColours(const SceneColours& colours);

    /// Draw every face, hidden ones too (what leaving them out brings is measured with this). Default off.
    void setAllFaces(bool all);

    /// Draw large models with less detail, for as long as they move, and their structure between the FE states at hand rather than
    /// wait for those next to the time. Counts, picking and what elementsWhere() finds stay the same, and PaneStatus (simplifiedTo,
    /// statesApart, resolution) tells of it. Default off: figures and movies never ask for it.
    /// @param resolution  share of the pixels in each direction with which whoever draws is going to; pixels of update() and of
    /// what is asked here stay those of the whole window
    void setSimplified(bool simplified, double resolution = 1.0);
    /// As of the last update().
    double resolution() const;

    /// Brings all panes to a view: positions, colours, cameras, layout. Draws nothing; call the window's Render() after.
    /// @param width, height  of the window, device pixels
    /// Throws what reading a state or a frame throws (WorldError, ParseError); the picture before then stays.
    void update(const View& view, int width, int height);
    /// As of the last update().
    const PaneStatus& status(PaneContent content) const;
    /// The element or fragment under a pixel (y downwards) as of the last update(); nothing where there is only ground or sky.
    /// A simplified picture is brought to full detail first, and stays so until the next update().
    std::optional<Pick> pick(int x, int y) const;
    /// The elements shown in a pane, active or as fragments, whose centres lie in a rectangle of pixels, seen or covered,
    /// ascending.
    std::vector<ElementIndex> elementsIn(const Pane& pane, int left, int top, int right, int bottom) const;
    /// The elements shown in a pane, active or as fragments, whose centres [m] pass a test, ascending; as of the last update(), a
    /// simplified picture at full detail.
    std::vector<ElementIndex> elementsWhere(PaneContent content, const std::function<bool(const Vec3&)>& inside) const;
    /// Corners of what is drawn of the model in a pane, m, as of the last update(), a simplified picture at full detail.
    std::vector<Vec3> shownPoints(PaneContent content) const;
    /// Of each rectangle of pixels (left, top, right, bottom), whether a face of the model may lie in it.
    std::vector<bool> covered(const Pane& pane, std::span<const std::array<double, 4>> rectangles) const;
    /// The point of the ground under a pixel, as of the last update().
    std::optional<Vec3> groundAt(int x, int y) const;

    /// Box of the model at rest, down to the ground; empty without data.
    Aabb bounds() const;
    /// Speed at the upper end of the speed colours, m/s: a fall from the model's full height, rounded up.
    double speedTop() const;
    /// First and last birth time, s; both 0 without fragments.
    std::pair<double, double> birthSpan() const;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Box of a model at rest, down to the ground; empty without data.
Aabb boundsOf(const SceneData& data);

/// A sensible view of data that was just opened: both cameras fitted, time at the first state.
/// @param layout  of the panes; nothing: by the model's proportions
View defaultView(const SceneData& data, int width, int height, std::optional<Layout> layout = {});

}  // namespace rubble::render
