#pragma once

#include "widgets/panel.h"

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
    /// What was settled: label and value, one row each.
    void setRows(const std::vector<std::pair<QString, QString>>& rows);

signals:
    /// Whether there is a name.
    void namedChanged();

private:
    QLineEdit* m_title;
    QLineEdit* m_scenario;
    QPlainTextEdit* m_note;
    PanelGroup* m_settled;
    std::vector<QLabel*> m_values;
};

}  // namespace rubble::widgets
