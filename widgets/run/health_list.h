#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "core/base/finding.h"
#include "core/pipeline/remedies.h"
#include "core/scenario/parameters.h"
#include "core/scenario/scenario.h"
#include "core/simulation/health/passed_limits.h"
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
        Vec3 origin = Vec3::Zero();       ///< m, of the local frame: places are shown in coordinates of the file
        RemedyGrounds grounds = {};       ///< of the run
        Scenario scenario = {};           ///< as it is set now: what a remedy asks for may be set already
        std::optional<double> upTo = {};  ///< s, where the run was stopped; unset: it is complete
    };
    void setContent(const Content& content);
    /// Settings that its buttons offer, each once.
    const std::vector<RemedySetting>& offered() const { return m_offered; }
    /// What went wrong with an acknowledgement; empty takes it away.
    void setComplaint(const QString& complaint);

signals:
    /// Show this breach: its instant and its body.
    void breachChosen(std::size_t breach);
    /// Set this, as the remedy of a breach says.
    void remedyChosen(const QString& key, const rubble::ParameterValue& value);
    void acknowledgeRequested(const QString& name, const QString& note);

private:
    void showBreaches(const Content& content);
    void addRemedy(QVBoxLayout& row, const HealthBreach& breach, const Content& content);
    void acknowledge();

    std::vector<RemedySetting> m_offered;
    Notice* m_verdict;
    QVBoxLayout* m_breaches;
    QWidget* m_form;
    QLineEdit* m_name;
    QLineEdit* m_note;
    QPushButton* m_button;
    QLabel* m_complaint;
    Notice* m_acknowledged;
};

/// How many limits were passed, however often each.
std::int64_t limitsIn(const HealthReport& health);
/// Whether a finding says what a breach of the list says.
bool toldByHealth(const Finding& finding);
/// A breach in words: what, its grade and why, where and when, worst against limit, remedy; rich text.
QString breachWords(const HealthBreach& breach, const Vec3& origin);
/// The same of a limit with all its times and its worst breach.
QString limitWords(const PassedLimit& limit, const std::vector<HealthBreach>& breaches, const Vec3& origin);
/// The breaches of a run as marks of the timeline.
std::vector<HealthMark> healthMarks(const HealthReport& health, bool acknowledged, const Vec3& origin);

}  // namespace rubble::widgets
