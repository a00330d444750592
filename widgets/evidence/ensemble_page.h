#pragma once

#include <QWidget>
#include <memory>

#include "core/evidence/ensembles/probability_map.h"
#include "widgets/figures/map_picture.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSplitter;
class QTableWidget;
class QToolButton;

namespace rubble::widgets {

class MapView;
class Notice;

/// What an ensemble tells: a map of probabilities, and beside it the spread of the figures over its members.
class EnsemblePage : public QWidget {
    Q_OBJECT

public:
    explicit EnsemblePage(QWidget* parent = nullptr);

    struct Content {
        std::shared_ptr<const EnsembleReport> report;  ///< null: nothing was simulated yet
        std::shared_ptr<const DebrisMap> map;          ///< of its members that are done; null: none are
        figures::MapPictureStyle place;                ///< origin, coordinate system, class of what is shown
        bool stale = false;                            ///< of other settings of the case
        bool running = false;
    };
    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    MapLayer layer() const;
    void setLayer(MapLayer layer);
    /// Whether the layer is to lie on the ground of the views.
    bool onGround() const;
    void setOnGround(bool on);
    QTableWidget& spread() { return *m_spread; }

signals:
    void layerChanged(rubble::MapLayer layer);
    void onGroundChanged(bool on);
    void saveMapRequested();
    void saveTableRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* buildChoices();
    QWidget* buildSpread();
    void fillLayers();
    void showMap();
    void setHeads();
    void showSpread();

    Content m_content;
    QLabel* m_sentence;
    Notice* m_notice;
    QComboBox* m_layer;
    QToolButton* m_onGround;
    QPushButton* m_saveMap;
    QPushButton* m_saveTable;
    QWidget* m_choices;
    QSplitter* m_splitter;
    MapView* m_map;
    QTableWidget* m_spread;
    QLabel* m_error;
};

}  // namespace rubble::widgets
