#pragma once

#include <QDialog>
#include <QString>

#include "widgets/figures/palette.h"
#include "widgets/figures/shown_units.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace rubble::widgets {

/// What a user settles for all cases. None of it changes a result.
struct Preferences {
    QString language = QStringLiteral("system");  ///< "system" or one of languageCodes()
    QString theme = QStringLiteral("system");     ///< "system", "light" or "dark"
    figures::ColourSet colours = figures::ColourSet::Vermilion;
    figures::UnitSet units = figures::UnitSet::Si;  ///< of what is shown; files are in SI
    int threads = 0;                                ///< that one piece of work may use; 0: all of the machine
    int memoryMib = 2048;                           ///< MiB that states and frames may take, so that they need not be read again
    int autosaveSeconds = 60;                       ///< s between two autosaves; 0: none
    bool keepCopies = false;                        ///< of FE results that are read
    int keepRunsGib = 20;                           ///< GiB that the kept runs of a case may take; 0: none are kept
    QString runsFolder;                             ///< where they are kept; empty: beside each case
    bool materials = true;                          ///< views show materials (presentation style), else the colours of analysis
    bool simplify = true;                           ///< views with less detail while they move, where they are slow

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// Bounds of the numbers, inclusive.
inline constexpr int mostThreads = 1024;
inline constexpr int leastMemoryMib = 128, mostMemoryMib = 1 << 20;
inline constexpr int mostAutosaveSeconds = 3600;
inline constexpr int mostKeptGib = 100'000;

/// Edits preferences; every edit is told at once, and a button gives those as delivered.
class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    explicit PreferencesDialog(const Preferences& now, QWidget* parent = nullptr);

    const Preferences& preferences() const { return m_now; }
    /// Shows preferences without emitting changed().
    void show(const Preferences& preferences);
    using QDialog::show;

signals:
    void changed(const rubble::widgets::Preferences& preferences);
    /// The list of kept runs is wanted.
    void keptRunsRequested();

private:
    void buildLook(QFormLayout& form);
    void buildWork(QFormLayout& form);
    void take();

    Preferences m_now;
    bool m_showing = false;
    QComboBox* m_language;
    QComboBox* m_theme;
    QComboBox* m_colours;
    QComboBox* m_style;
    QComboBox* m_units;
    QSpinBox* m_threads;
    QSpinBox* m_memory;
    QSpinBox* m_autosave;
    QSpinBox* m_runs;
    QLineEdit* m_runsFolder;
    QCheckBox* m_copies;
    QCheckBox* m_simplify;
};

}  // namespace rubble::widgets
