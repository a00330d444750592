#pragma once

#include <QWidget>
#include <optional>

#include "core/simulation/health/health.h"
#include "core/simulation/run/acknowledgement.h"
#include "widgets/views/timeline.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace rubble::widgets {

class Notice;

/// Whether a run is sound: the limits that were passed, each with what, where, when and the remedy, and the form with which someone
/// vouches for the run all the same.
class HealthList : public QWidget {
    Q_OBJECT

public:
    explicit HealthList(QWidget* parent = nullptr);

    struct Content {
        HealthReport health;
        std::optional<Acknowledgement> acknowledged;
        Vec3 origin = Vec3::Zero();  ///< m, of the local frame: places are shown in coordinates of the file
    };
    void setContent(const Content& content);
    /// What went wrong with an acknowledgement; empty takes it away.
    void setComplaint(const QString& complaint);

signals:
    /// Show this breach: its instant and its body.
    void breachChosen(std::size_t breach);
    void acknowledgeRequested(const QString& name, const QString& note);

private:
    void showBreaches(const Content& content);
    void acknowledge();

    Notice* m_verdict;
    QVBoxLayout* m_breaches;
    QWidget* m_form;
    QLineEdit* m_name;
    QLineEdit* m_note;
    QPushButton* m_button;
    QLabel* m_complaint;
    Notice* m_acknowledged;
};

/// "2 limits passed"
QString limitsPassed(std::int64_t count);
/// A breach in words: what, where and when, worst against limit, remedy; rich text.
QString breachWords(const HealthBreach& breach, const Vec3& origin);
/// The breaches of a run as marks of the timeline.
std::vector<HealthMark> healthMarks(const HealthReport& health, bool acknowledged, const Vec3& origin);

}  // namespace rubble::widgets
