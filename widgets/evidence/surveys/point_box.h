#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/base/finding.h"
#include "core/evidence/clouds/cloud_distance.h"
#include "widgets/render/basics/view.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace rubble::widgets {

class DistanceFields;
class FindingList;
class Notice;
class ScannerField;

/// The points of a surveyed cloud in the views: whether they are drawn, what their colours say, how many are there, and the
/// distances from them to the simulated site (M3C2).
class PointBox : public QWidget {
    Q_OBJECT

public:
    explicit PointBox(QWidget* parent = nullptr);

    struct Content {
        bool cloud = false;  ///< the chosen survey is a cloud; else nothing of this is there
        bool shown = false;
        render::PointColour colour = render::PointColour::Own;
        int photographs = 0;  ///< in the cloud with their cameras, that the case has not
        QString adding;       ///< how far adding them is; empty: none are being added
        QString status;       ///< how many are drawn, where the octree lies; or what is being done
        QString complaint;    ///< what went wrong
        Findings findings;
        std::vector<Vec3> scanners;  ///< that were given, m, in the system of the case
        QString noMeasuring;         ///< why no distances can be measured; empty: they can
        bool measuring = false;
        QString measured;      ///< what came of it
        bool savable = false;  ///< distances were measured, of what is there now
    };
    void setContent(const Content& content);
    ScannerField& scanners() { return *m_scanners; }
    /// What distances are asked with.
    DistanceFields& distances() const { return *m_distances; }

signals:
    void shownChosen(bool shown);
    void colourChosen(rubble::render::PointColour colour);
    void photographsRequested();
    void photographsCancelled();
    void measureRequested();
    void cancelRequested();
    /// Distances are to be written to a file.
    void saveRequested();

private:
    void buildMeasuring();

    Content m_content;
    bool m_showing = false;
    QCheckBox* m_shown;
    QComboBox* m_colour;
    QLabel* m_status;
    Notice* m_complaint;
    FindingList* m_findings;
    DistanceFields* m_distances;
    ScannerField* m_scanners;
    QPushButton* m_photographs;
    QPushButton* m_noPhotographs;
    QPushButton* m_measure;
    QPushButton* m_cancel;
    QPushButton* m_save;
    QLabel* m_said;
};

}  // namespace rubble::widgets
