#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "core/evidence/maps/run_map.h"
#include "widgets/figures/map_picture.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace rubble::widgets {

class MapView;
class Notice;
class NumberField;

/// What the map of a run is to show.
struct RunMapChoice {
    MapLayer layer = MapLayer::Height;
    bool atEnd = true;             ///< false: at the instant that is shown
    std::optional<double> cell{};  ///< m; unset: as usualMapCell()
    double contours = 0.0;         ///< m, between lines of equal height; 0: none
    bool live = true;              ///< fallen live structure in grey
    bool structure = true;         ///< outline of what stood there
    bool evidence = true;          ///< outlines of surveys and of what is compared of them
    bool onGround = false;         ///< it lies on the ground of the views

    friend bool operator==(const RunMapChoice&, const RunMapChoice&) = default;
};

/// The debris map of the run at hand, with what it is to show and how it is saved. Asks for a map where another one is needed; what
/// is drawn over it changes at once.
class RunMapPanel : public QWidget {
    Q_OBJECT

public:
    explicit RunMapPanel(QWidget* parent = nullptr);

    struct Content {
        std::shared_ptr<const RunMap> map;  ///< null: there is none yet
        figures::MapPictureStyle place;     ///< with all outlines and cautions
        QString why;                        ///< there is no map; empty: there is, or it is being made
        bool making = false;
    };
    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    const RunMapChoice& choice() const { return m_choice; }
    void setChoice(const RunMapChoice& choice);
    /// How the map is drawn now.
    figures::MapPictureStyle style() const;
    QSize sizeHint() const override { return {520, 560}; }

signals:
    /// Another instant, other cells, or live structure is wanted: the map is to be made anew.
    void mapRequested();
    /// It is drawn otherwise.
    void drawnChanged();
    void saveRequested();

private:
    QWidget* buildLayerRow();
    QWidget* buildTimeRow();
    QWidget* buildOverlayRow();
    void showChoice();
    void fillLayers();
    void draw();
    void showLedger();
    QCheckBox* overlay(const QString& text, const QString& tip, const char* name, bool RunMapChoice::* shown);

    Content m_content;
    RunMapChoice m_choice;
    QComboBox* m_layer;
    QToolButton* m_onGround;
    QPushButton* m_save;
    QComboBox* m_when;
    NumberField* m_cell;
    QComboBox* m_contours;
    QCheckBox* m_live = nullptr;
    QCheckBox* m_structure = nullptr;
    QCheckBox* m_evidence = nullptr;
    Notice* m_notice;
    MapView* m_map;
    Notice* m_cautions;
    QLabel* m_ledger;
    bool m_showing = false;
};

}  // namespace rubble::widgets
