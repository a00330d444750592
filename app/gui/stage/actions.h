#pragma once

#include <QAction>
#include <QStringList>
#include <QStringView>
#include <optional>
#include <span>
#include <vector>

#include "widgets/basics/icons.h"

namespace rubble {

/// What can be done from a menu, in the order of the menus.
enum class ActionId {
    // Case
    NewCase,
    Open,
    Sample,
    Refresh,
    KeepCopies,
    DuplicateScenario,
    CompareScenarios,
    Terrain,
    NoTerrain,
    Orthophoto,
    Surroundings,
    NoSurroundings,
    Site,
    Save,
    SaveAs,
    SaveRun,
    SealCase,
    OpenSealed,
    Close,
    Quit,
    // Edit
    Undo,
    Redo,
    PresetDefault,
    PresetPaper,
    Preferences,
    // View
    Stacked,
    Beside,
    Overlay,
    Four,
    FeOnly,
    FragmentsOnly,
    OtherScenario,
    Clip,
    MeasureDistance,
    MeasureHeight,
    ClearMeasurements,
    Components,
    Inspector,
    DebrisMap,
    History,
    HistoryCurves,
    ResetLayout,
    // Camera
    Link,
    Fit,
    LookSide,
    LookFront,
    LookBack,
    LookLeft,
    LookRight,
    LookTop,
    LookBottom,
    LookCorner,
    Parallel,
    ZoomIn,
    ZoomOut,
    TurnLeft,
    TurnRight,
    TurnUp,
    TurnDown,
    CameraKey,
    RemoveCameraKey,
    AlongCameraKeys,
    // Look
    Presentation,
    Shading,
    Shadows,
    CloudPoints,
    GroundGrid,
    Axes,
    MapStandard,
    MapViridis,
    MapCividis,
    MapGrey,
    ThemeSystem,
    ThemeLight,
    ThemeDark,
    // Select
    SelectBy,
    FragmentTable,
    SelectCluster,
    SelectComponent,
    SelectNone,
    Hide,
    Isolate,
    ShowAll,
    GoToBirth,
    // Simulation
    Simulate,
    Live,
    Cancel,
    Play,
    Back,
    Forward,
    BackTen,
    ForwardTen,
    First,
    Last,
    PlayBackwards,
    Loop,
    LoopFrom,
    LoopTo,
    Bookmark,
    PreviousBookmark,
    NextBookmark,
    Snap,
    TimeFromZero,
    KeptRuns,
    // Evidence
    AddPhotographs,
    AddPoint,
    PhotoAlone,
    PhotoSwipe,
    PhotoBlend,
    PhotoBlink,
    PhotoOutline,
    PhotoBeside,
    ComparePhoto,
    LookThrough,
    AddSurvey,
    CompareSurvey,
    MeasureCloud,
    CompareClouds,
    ScanRun,
    ShowEnsemble,
    SimulateEnsemble,
    ShowCauses,
    CompareCauses,
    // Export
    ExportFigure,
    ExportMovie,
    WriteReport,
    ExportMap,
    SharePage,
    ExportFragments,
    ExportSelection,
    ExportSeries,
    ExportVtkhdf,
    ExportGltf,
    ExportView,
    ImportView,
    // Help
    Tour,
    Manual,
    ManualSearch,
    Validation,
    About
};

/// Of the actions of a choice one is checked.
enum class ActionChoice { None, Layout, ColourMap, Theme };

/// The groups of buttons in the tool bar, from the left.
enum class ToolSection { Case, Layout, View, Run };

/// A button in the tool bar.
struct ToolPlace {
    ToolSection section;
    int place;              ///< from the left, within the section
    bool iconOnly = false;  ///< else only its text is shown
};

/// Where an action stands, and with which others.
struct ActionPlace {
    bool line = false;  ///< there is one above it in the menu
    ActionChoice choice = ActionChoice::None;
    std::optional<ToolPlace> tool = {};  ///< unset: it is not in the tool bar
};

/// One row of the table of actions: feeds menus, tool bar, keys and manual.
struct ActionRow {
    ActionId id;
    const char* name;  ///< in settings, for `--action`, and of its QAction
    const char* menu;  ///< "Case", "Edit", "View", "Camera", "Look", "Select", "Simulation", "Evidence", "Export", "Help"
    const char* text;
    const char* tip;
    const char* key;  ///< portable text; "" for none
    std::optional<widgets::Glyph> glyph;
    bool checkable = false;
    ActionPlace place = {};
};

/// One row for each id, in their order.
std::span<const ActionRow> actionTable();
/// The rows of a section of the tool bar, from the left.
std::vector<ActionRow> toolRows(ToolSection section);
/// Unset: no action has this name.
std::optional<ActionId> actionNamed(QStringView name);

/// Whether what an action does is seen in the views alone.
bool actsOnViews(ActionId id);
/// Why what acts on the views cannot be used while a page covers them.
QString viewsCovered();

/// The actions of one window, made from the table.
class Actions {
public:
    explicit Actions(QWidget& window);
    QAction& operator[](ActionId id) const { return *m_actions[static_cast<std::size_t>(id)]; }
    /// Offers an action or not. One that acts on the views is offered only while they are in front, and its tip says so.
    /// @param why  it cannot be used, for its tip and whoever presses its key; empty: that it cannot be used now
    void enable(ActionId id, bool usable, const QString& why = {});
    /// "Report: simulate first"; empty for an action that can be used, or that is none of these.
    QString refusal(const QAction& action) const;
    /// The views are in front of all pages, or one covers them.
    void setViewsInFront(bool inFront);
    bool viewsInFront() const { return m_viewsInFront; }
    /// A page that covers the views shows a model of its own: what moves the camera moves it there.
    void setModelInFront(bool inFront);

private:
    void show(ActionId id);
    void showAll();

    std::vector<QAction*> m_actions;  // by id
    std::vector<bool> m_usable;       // by id, whatever is in front
    QStringList m_tips;               // by id
    QStringList m_whys;               // by id
    bool m_viewsInFront = true;
    bool m_modelInFront = false;
};

/// The actions as a table in Markdown: a page of the manual.
QString actionReference();

}  // namespace rubble
