#pragma once

#include <QDialog>
#include <cstdint>
#include <optional>

#include "core/base/finding.h"
#include "core/evidence/clouds/site_scan.h"

class QLabel;
class QPushButton;

namespace rubble::widgets {

class FindingList;
class Notice;
class NumberField;
class ScannerField;

/// How the site of the run is scanned, and what came of it.
class ScanDialog : public QDialog {
    Q_OBJECT

public:
    explicit ScanDialog(QWidget* parent = nullptr);

    struct Content {
        bool scanning = false;
        QString said;       ///< what came of the last one
        QString complaint;  ///< what went wrong with it
        Findings findings;
    };
    void setContent(const Content& content);
    /// How many bodies still move at the end of the run, and of how many.
    void setMoving(std::int64_t moving, std::int64_t bodies);
    const Content& content() const { return m_content; }
    /// What the fields say. Scanners are in the system of the case.
    ScanSettings settings() const;
    /// s, on the clock of the FE file: the instant that is scanned; unset: the end.
    std::optional<double> instant() const;
    ScannerField& scanners() { return *m_scanners; }

signals:
    void scanRequested();
    void cancelRequested();

private:
    Content m_content;
    ScannerField* m_scanners;
    NumberField* m_instant;
    Notice* m_moving;
    NumberField* m_step;
    NumberField* m_range;
    NumberField* m_noise;
    NumberField* m_seed;
    QLabel* m_said;
    Notice* m_notice;
    FindingList* m_findings;
    QPushButton* m_scan;
    QPushButton* m_cancel;
};

}  // namespace rubble::widgets
