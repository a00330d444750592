#pragma once

#include <QWidget>
#include <vector>

#include "core/base/finding.h"
#include "core/validation/validation_record.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace rubble::widgets {

class FindingList;
class Notice;
class ProgressLabel;

/// How far simulated falls are from measured ones: the known rate of error of this program, in the terms of ASME V&V 20, and the
/// button that finds it.
class ValidationView : public QWidget {
    Q_OBJECT

public:
    explicit ValidationView(QWidget* parent = nullptr);

    struct Content {
        std::vector<ValidationRecord> records;  ///< empty: this build was not held against measured falls here
        Findings findings;
        bool running = false;
    };
    void setContent(const Content& content);
    /// @param secondsLeft  NaN: not known yet
    void setProgress(const QString& what, double fraction, double secondsLeft);
    void setError(const QString& what, const QString& remedy = {});
    QTableWidget& figures() { return *m_figures; }
    QTableWidget& parameters() { return *m_parameters; }

signals:
    void validateRequested();
    void cancelRequested();

private:
    void fillTables(const std::vector<ValidationRecord>& records);

    Notice* m_notice;
    FindingList* m_findings;
    QLabel* m_sets;
    QTableWidget* m_figures;
    QTableWidget* m_parameters;
    QPushButton* m_validate;
    QPushButton* m_cancel;
    QProgressBar* m_bar;
    ProgressLabel* m_progress;
    bool m_failed = false;
};

}  // namespace rubble::widgets
