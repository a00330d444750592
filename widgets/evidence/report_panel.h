#pragma once

#include <optional>

#include "widgets/basics/panel.h"

class QComboBox;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace rubble::widgets {

/// What a report is asked to say besides its figures.
struct ReportWishes {
    QString question;
    QString author;
    int repeats = 2;
    QString selfTest;  ///< "all", "closed-form", "none"
};

/// What the report is to answer, what is made for it, and whether the run can be reported.
class ReportPanel : public Panel {
    Q_OBJECT

public:
    explicit ReportPanel(QWidget* parent = nullptr);

    ReportWishes wishes() const;
    void setWishes(const ReportWishes& wishes);
    /// @param why  why no report can be made now; empty: it can
    /// @param writing  one is being made
    void setReady(const QString& why, bool writing);
    /// How long the run took, s: what its repeats are told to cost. Unset: not known.
    void setRunSeconds(std::optional<double> seconds);
    /// Where the last report went; empty: none was made.
    void setWritten(const QString& folder);

signals:
    void writeRequested();
    void cancelRequested();
    void openRequested(const QString& folder);

private:
    void showCost();

    QPlainTextEdit* m_question;
    QLineEdit* m_author;
    QSpinBox* m_repeats;
    QComboBox* m_selfTest;
    QPushButton* m_write;
    QLabel* m_why;
    QLabel* m_written;
    QLabel* m_cost;
    std::optional<double> m_runSeconds;
    bool m_writing = false;
};

}  // namespace rubble::widgets
