#pragma once

#include "widgets/basics/panel.h"

class QLineEdit;
class QPlainTextEdit;

namespace rubble::widgets {

/// Last step of a new case: its name, and what was settled on the way.
class NewCaseSummary : public Panel {
    Q_OBJECT

public:
    explicit NewCaseSummary(QWidget* parent = nullptr);

    /// Proposes names; what the user has typed stays.
    void propose(const QString& title, const QString& scenario);
    QString title() const;
    QString scenarioName() const;
    QString note() const;
    /// What was settled on the way, in words for the screen.
    struct Settled {
        QString feResult;
        QString units;
        QString upAxis;
        QString ground;
        QString components;
        QString regrouping;
        QString fragments;
    };
    void setSettled(const Settled& settled);

signals:
    /// Whether there is a name.
    void namedChanged();

private:
    QLineEdit* m_title;
    QLineEdit* m_scenario;
    QPlainTextEdit* m_note;
    QLabel* m_feResult;
    QLabel* m_units;
    QLabel* m_upAxis;
    QLabel* m_ground;
    QLabel* m_components;
    QLabel* m_regrouping;
    QLabel* m_fragments;
};

}  // namespace rubble::widgets
