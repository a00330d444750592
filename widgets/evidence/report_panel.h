#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/evidence/report_facts.h"
#include "widgets/basics/panel.h"

class QComboBox;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QSpinBox;

namespace rubble::widgets {

/// Which comparison of causes stands in a report.
enum class ReportedCauses { None, Page, File };

/// What a report is asked to say besides its figures.
struct ReportWishes {
    QString question;
    QString author;
    int repeats = 2;
    QString selfTest;  ///< "all", "closed-form", "none"
    OwnWords words{};
    ReportedCauses causes = ReportedCauses::None;
    QString causesFile{};  ///< that was chosen for File
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
    /// @param why  why the page Causes has nothing to report; empty: it has
    void setComparison(const QString& why);
    /// The file of a comparison that was asked for; empty: none was chosen.
    void setCausesFile(const QString& path);
    /// @param gaps  what the report lacks; unset: it was not looked for
    /// @param words  what its author has not said
    void setGaps(const std::optional<Findings>& gaps, const std::vector<Message>& words);
    /// Where the last report went; empty: none was made.
    void setWritten(const QString& folder);

signals:
    void writeRequested();
    void cancelRequested();
    void checkRequested();
    void causesFileRequested();
    /// By the user, not by setWishes().
    void wishesChanged();
    void openRequested(const QString& folder);

private:
    /// The four parts of what only the author can say.
    static constexpr std::size_t partCount = 5;

    QPlainTextEdit* addText(PanelGroup& group, const char* name, const QString& label, const QString& tip, int height);
    void addOwnWords();
    void addMade();
    void addGaps();
    void showCost();
    void showCauses();

    QPlainTextEdit* m_question;
    QLineEdit* m_author;
    QSpinBox* m_repeats;
    QComboBox* m_selfTest;
    std::array<QPlainTextEdit*, partCount> m_words{};
    QComboBox* m_causes;
    ReportedCauses m_causesFrom = ReportedCauses::None;
    QString m_causesFile;
    QString m_noComparison;
    QPushButton* m_check;
    QLabel* m_gaps;
    QLabel* m_checked;
    QLabel* m_unsaid;
    QPushButton* m_write;
    QLabel* m_why;
    QLabel* m_written;
    QLabel* m_cost;
    std::optional<double> m_runSeconds;
    bool m_writing = false;
};

}  // namespace rubble::widgets
