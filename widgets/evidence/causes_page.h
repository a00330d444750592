#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "core/evidence/ensembles/cause_comparison.h"
#include "core/evidence/ensembles/telling_evidence.h"
#include "widgets/figures/map_picture.h"

class QLabel;
class QPushButton;
class QSplitter;
class QTableWidget;

namespace rubble::widgets {

class CauseChart;
class FileChart;
class MapView;
class Notice;

/// Which cause: the verdict, how close each comes, and where and by what they are told apart; or what a blind test gives.
class CausesPage : public QWidget {
    Q_OBJECT

public:
    explicit CausesPage(QWidget* parent = nullptr);

    struct Content {
        std::shared_ptr<const CauseComparison> comparison;  ///< null: there was no evidence, or nothing was compared
        std::shared_ptr<const DebrisMap> separation;        ///< null: no evidence on the ground
        std::vector<BlindTest> blind;
        std::shared_ptr<const TellingEvidence> further;  ///< null: it was not looked for
        std::vector<std::string> causes;                 ///< in the order of the blind tests
        figures::MapPictureStyle place;
        bool stale = false;  ///< of other causes, evidence or settings
    };
    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    const FileChart& chart() const;
    QTableWidget& ranking() { return *m_table; }

signals:
    void saveMapRequested();
    void saveTableRequested();
    void saveChartRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* buildButtons();
    void showVerdict();
    void showTelling();
    void showRanking();
    void showBlind();
    void showFurther();

    Content m_content;
    QLabel* m_sentence;
    Notice* m_verdict;
    Notice* m_stale;
    QWidget* m_buttons = nullptr;
    QPushButton* m_saveTable;
    QPushButton* m_saveChart;
    QPushButton* m_saveMap;
    QSplitter* m_splitter;
    CauseChart* m_chart;
    QWidget* m_mapSide;
    MapView* m_map;
    QLabel* m_telling;
    QTableWidget* m_table;
    QLabel* m_blindTitle;
    QTableWidget* m_blind;
    QLabel* m_furtherTitle;
    QTableWidget* m_further;
};

}  // namespace rubble::widgets
