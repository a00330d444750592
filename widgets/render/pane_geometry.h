#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "widgets/render/basics/camera.h"
#include "widgets/render/basics/colours.h"
#include "widgets/render/basics/scene_data.h"
#include "widgets/render/scene.h"
#include "widgets/render/shapes/debris_geometry.h"
#include "widgets/render/shapes/island_motion.h"
#include "widgets/render/shapes/node_motion.h"
#include "widgets/render/shapes/structure_faces.h"
#include "widgets/render/shown_counts.h"

namespace rubble::render {

/// What the scene knows about all data, for colours.
struct ColourScale {
    SceneColours colours;
    double firstBirth = 0.0;         ///< s
    double lastBirth = 0.0;          ///< s
    double speedTop = 1.0;           ///< m/s
    std::vector<double> errorSteps;  ///< m, ascending
    Style style = Style::Analysis;
    std::map<std::string, Rgb> componentColours;  ///< that the user chose, by component
};

/// The triangles of one pane at one instant, free of any graphics library: points, colours, triangles and who owns them.
/// Positions change every frame, triangles only at events (births, deaths), so each has its own version.
class PaneGeometry {
public:
    static constexpr std::uint32_t none = 0xffffffffu;

    /// @param states  where the states come from while the picture is simplified, shared with other panes; null: of its own
    PaneGeometry(PaneContent content, const SceneData& data, bool allFaces, std::shared_ptr<StateReadAhead> states = nullptr);

    /// Moves to a time on the file's clock, s. Throws what reading a state or a frame throws; the picture before then stays.
    void update(double time, ColourBy colourBy, const ColourScale& scale, const std::vector<ElementIndex>& selection);

    /// Leaves elements and their fragments out; what they covered is drawn instead.
    /// @param hidden  [elements], 1 for those, or empty: none
    void setHidden(std::vector<std::uint8_t> hidden);
    /// Draws no more than a screen can follow while it moves: vertices of the structure that share a cell are one, and so are those
    /// of clusters, the small ones of which become boxes. Cells are so large that about `simplifiedFaces` faces are left of each;
    /// what has no more stays as it is. The structure moves between the nearest FE states at hand (NodeMotion). Picking and places
    /// of elements need full detail; counts do not.
    void setSimplified(bool simplified);
    static constexpr std::size_t simplifiedFaces = 30000;
    /// Leaves out fragments that do not meet a filter; speeds are those of the time shown.
    void setFilter(const FragmentFilter& filter);
    /// A plane that opens the model needs the faces inside it too. What draws the triangles cuts them.
    void setClip(const std::optional<ClipPlane>& clip);

    const PaneStatus& status() const { return m_status; }
    const std::vector<float>& points() const { return m_points; }           ///< xyz
    const std::vector<std::uint8_t>& colours() const { return m_colours; }  ///< rgba by point
    /// Place at rest [m] and roughness of the material, four by point, in the presentation style; else empty. Changes with the
    /// colours.
    const std::vector<float>& grain() const { return m_grain; }
    const std::vector<std::int32_t>& triangles() const { return m_triangles; }  ///< three points each
    const std::vector<std::int32_t>& lines() const { return m_lines; }          ///< two points each (beams)
    const std::vector<std::int32_t>& selected() const { return m_selected; }    ///< triangles of the selection, three points each
    std::uint64_t pointsVersion() const { return m_pointsVersion; }
    std::uint64_t coloursVersion() const { return m_coloursVersion; }
    std::uint64_t trianglesVersion() const { return m_trianglesVersion; }
    std::uint64_t selectionVersion() const { return m_selectionVersion; }

    /// The nearest element or fragment that a ray meets from outside.
    std::optional<Pick> cast(const Ray& ray) const;
    /// The elements shown, active or as fragments, whose centre passes a test, ascending.
    std::vector<ElementIndex> elementsWhere(const std::function<bool(const Vec3&)>& inside) const;

private:
    struct Owner {
        ElementIndex element{};
        std::uint32_t fragment = none;
    };
    struct StructurePoint {
        std::uint32_t node = 0;
        std::uint32_t look = 0;
        bool carried = false;    ///< its island of live structure is carried by a body
        std::int32_t next = -1;  ///< another point of the node, in addStructure()
    };

    void makeFaces(bool carried);
    double shownTime(double time);
    void followTrajectory();
    void bindBodies();
    void bindIslands();
    /// Edges of the cells in which vertices are joined, m; 0: none are.
    struct Cells {
        double structure = 0.0;
        double debris = 0.0;

        bool join() const { return structure > 0.0 || debris > 0.0; }
    };
    Cells cellsWanted() const;
    void makeCoarse();
    bool settleDetail();
    bool settleFilter();
    bool meets(std::size_t fragment) const { return m_meets.empty() || m_meets[fragment] != 0; }
    const DebrisGeometry& drawnDebris() const { return m_cells.debris > 0.0 ? *m_coarse : *m_debris; }
    void findVisible(std::size_t slot);
    void joinNodes();
    bool born(std::size_t fragment) const { return m_slots->born(fragment, m_debrisSlot); }
    /// Out of an island and not yet born: it shows as what it was.
    bool leavesIsland(std::size_t fragment) const {
        return !m_wasAfloat.empty() && m_wasAfloat[at(m_data.fragments->list[fragment].element)] != 0 &&
               m_slots->drawn(fragment, m_debrisSlot) && !born(fragment);
    }
    bool afloat(std::uint32_t node) const { return m_islands.of(node) != IslandMotion::none; }
    Eigen::Vector3f placeOf(std::uint32_t node) const { return afloat(node) ? m_islands.place(node) : m_motion[node]; }
    void rebuildTriangles();
    void addStructure();
    void addDebris();
    void place(double time);
    void colour(ColourBy colourBy, const ColourScale& scale);
    void takeErrors();
    void countErrors(const ColourScale& scale);
    Rgb errorColour(FragmentId fragment, const ColourScale& scale) const;
    Rgb debrisColour(FragmentId fragment, std::size_t group, const std::vector<float>& speeds, ColourBy colourBy,
                     const ColourScale& scale) const;
    bool settleLooks(const ColourScale& scale, ColourBy colourBy);
    bool settleIslands(double time, ColourBy colourBy, const ColourScale& scale);
    std::uint32_t lookOf(ElementIndex element) const;
    void takeGrain();
    std::optional<Vec3> centreOf(ElementIndex element) const;
    bool hidden(ElementIndex element) const { return !m_hidden.empty() && m_hidden[at(element)] != 0; }
    bool cutAway(const Vec3& point) const { return m_clip && (point - m_clip->point).dot(m_clip->normal) > 0.0; }
    void select(const std::vector<ElementIndex>& selection);
    /// Fragments shown as born of elements that the FE result still has.
    std::size_t countAhead();
    void countShown(double time);
    std::uint32_t componentOf(ElementIndex element) const;

    PaneContent m_content;
    SceneData m_data;
    bool m_allFaces;
    std::vector<std::uint8_t> m_hidden;  ///< by element, or empty
    std::optional<ClipPlane> m_clip;
    FragmentFilter m_filter;
    bool m_filterSettled = true;          ///< m_meets is of m_filter, but for speeds
    std::vector<std::uint8_t> m_meets;    ///< by fragment, or empty: all do
    std::vector<std::uint32_t> m_lookOf;  ///< by component: which of the looks its active structure has
    std::vector<Rgb> m_looks;
    std::vector<Rgb> m_customColours;            ///< by component
    std::vector<std::uint8_t> m_hasCustom;       ///< by component
    std::vector<std::uint32_t> m_islandColours;  ///< by island; empty: not coloured by it
    std::vector<std::uint32_t> m_islandOf;       ///< by element, inNoIsland of what is not loose; empty: not coloured by island
    std::size_t m_islandCategories = 0;          ///< colours that they share
    std::size_t m_islandState = 0;               ///< FE state that it is of
    std::uint32_t m_firstIslandLook = 0;
    Style m_style = Style::Analysis;
    bool m_carried = false;  ///< bodies carry fragments from their hand-over
    NodeMotion m_motion;
    ShowTimes m_showTimes;
    std::unique_ptr<StructureFaces> m_structure;
    std::unique_ptr<DebrisGeometry> m_debris;
    bool m_simplify = false;
    std::optional<Cells> m_cellsWanted;        ///< made when first needed
    Cells m_cells;                             ///< of what is drawn
    std::unique_ptr<DebrisGeometry> m_coarse;  ///< drawn in place of m_debris while its vertices are joined; kept from then on
    std::unique_ptr<ElementCounts> m_elementCounts;
    std::unique_ptr<FragmentSlots> m_slots;
    IslandMotion m_islands;
    std::vector<std::uint8_t> m_wasAfloat;  ///< by element, or empty: it was part of an island while it was active
    TrajectoryFrame m_frame;
    std::size_t m_boundBodies = 0;

    std::uint64_t m_structureSlot = ~std::uint64_t{0};
    std::uint64_t m_debrisSlot = ~std::uint64_t{0};
    std::pair<std::uint64_t, std::uint32_t> m_aheadOf{~std::uint64_t{0}, 0};  // slot and state that are counted below
    std::size_t m_ahead = 0;                                                  // fragments
    std::size_t m_groupsShown = 0;
    std::size_t m_debrisPoints = 0;
    std::vector<std::uint32_t> m_visible;  ///< faces of the structure in m_structureSlot
    std::vector<std::uint32_t> m_joined;   ///< by node: the one that is drawn in its place; `none` of those that are not drawn
    std::vector<std::int32_t> m_pointOf;   ///< by node: its latest point, -1 outside addStructure()
    std::uint64_t m_islandsDrawn = 0;      ///< version of m_islands that the triangles are of
    std::vector<std::uint32_t> m_groupOfPoint;
    std::vector<StructurePoint> m_structurePoints;
    std::vector<Owner> m_owners;  ///< by triangle
    double m_placedTime = 0.0;
    bool m_placed = false;
    ColourBy m_colourBy = ColourBy::Highlight;
    SceneColours m_colouredWith;
    std::vector<double> m_colouredSteps;
    std::vector<double> m_errors;  ///< m, by fragment; empty: not known
    std::vector<Carrier> m_referenceCarriers;
    bool m_coloured = false;
    std::vector<ElementIndex> m_selection;

    PaneStatus m_status;
    std::vector<float> m_points;
    std::vector<std::uint8_t> m_colours;
    std::vector<float> m_grain;
    std::vector<std::int32_t> m_triangles;
    std::vector<std::int32_t> m_lines;
    std::vector<std::int32_t> m_selected;
    std::uint64_t m_pointsVersion = 0;
    std::uint64_t m_coloursVersion = 0;
    std::uint64_t m_trianglesVersion = 0;
    std::uint64_t m_selectionVersion = 0;
};

}  // namespace rubble::render
