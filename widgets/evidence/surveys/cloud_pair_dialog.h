#pragma once

#include <QDialog>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/evidence/clouds/cloud_distance.h"
#include "core/scenario/cloud_request.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace rubble::widgets {

class DistanceFields;
class FindingList;
class Notice;

/// Two clouds of different epochs, how one is held against the other, and what came of it.
class CloudPairDialog : public QDialog {
    Q_OBJECT

public:
    /// A cloud that can be chosen.
    struct Cloud {
        std::string path;
        std::string taken = {};  ///< date and time; empty: not known
        CloudRequest read = {};
        friend bool operator==(const Cloud&, const Cloud&) = default;
    };
    struct Content {
        bool measuring = false;
        QString said;       ///< what came of the last one
        QString complaint;  ///< what went wrong with it
        Findings findings;
        bool savable = false;
    };

    explicit CloudPairDialog(const std::vector<Cloud>& clouds, QWidget* parent = nullptr);

    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    /// Can be chosen from now on, and is. @param second  as the second
    void addCloud(const Cloud& cloud, bool second);
    std::optional<Cloud> first() const;
    std::optional<Cloud> second() const;
    CloudDistanceSettings settings() const;
    /// m, side of the cells that volumes are taken over; 0: none are.
    double cell() const;

signals:
    void fileRequested(bool second);
    void measureRequested();
    void cancelRequested();
    void saveRequested();
    /// Other clouds or settings were chosen: what was measured is of something else.
    void outdated();

private:
    void fill();
    void showState();
    void change();
    QString epochs() const;

    std::vector<Cloud> m_clouds;
    Content m_content;
    bool m_filling = false;
    QComboBox* m_first;
    QComboBox* m_second;
    DistanceFields* m_distances;
    QLabel* m_epochs;
    QLabel* m_said;
    Notice* m_notice;
    FindingList* m_findings;
    QPushButton* m_measure;
    QPushButton* m_cancel;
    QPushButton* m_save;
};

}  // namespace rubble::widgets
