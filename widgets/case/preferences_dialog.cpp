#include "widgets/case/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QThread>
#include <QVBoxLayout>

#include "widgets/basics/form_row.h"
#include "widgets/basics/language.h"
#include "widgets/basics/theme.h"

namespace rubble::widgets {

namespace {

QLabel* headingOf(const QString& text) {
    auto* heading = new QLabel(text);
    heading->setObjectName(QStringLiteral("groupHeading"));
    heading->setFont(groupFont());
    return heading;
}

}  // namespace

PreferencesDialog::PreferencesDialog(const Preferences& now, QWidget* parent)
    : QDialog(parent),
      m_now(now),
      m_language(new QComboBox),
      m_theme(new QComboBox),
      m_colours(new QComboBox),
      m_style(new QComboBox),
      m_units(new QComboBox),
      m_threads(new QSpinBox),
      m_memory(new QSpinBox),
      m_autosave(new QSpinBox),
      m_runs(new QSpinBox),
      m_runsFolder(new QLineEdit),
      m_copies(new QCheckBox),
      m_simplify(new QCheckBox) {
    setWindowTitle(tr("Preferences"));
    setObjectName(QStringLiteral("preferences"));
    setProperty("help", QStringLiteral("Preferences"));
    auto* column = dialogColumn(*this);
    auto* form = dialogForm();
    buildLook(*form);
    buildWork(*form);
    column->addLayout(form);
    auto* note = new QLabel(tr("In force at once, for all cases. None of this changes a result."));
    note->setObjectName(QStringLiteral("muted"));
    column->addWidget(note);
    column->addStretch();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* defaults = buttons->addButton(tr("As delivered"), QDialogButtonBox::ResetRole);
    defaults->setObjectName(QStringLiteral("defaults"));
    defaults->setToolTip(tr("Give back all preferences as Rubble comes with them"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(defaults, &QPushButton::clicked, this, [this] {
        show(Preferences{});
        emit changed(m_now);
    });
    show(now);
}

void PreferencesDialog::buildLook(QFormLayout& form) {
    form.addRow(headingOf(tr("Look")));
    m_language->setObjectName(QStringLiteral("language"));
    m_language->addItem(tr("As the system"), QStringLiteral("system"));
    for (const QString& code : languageCodes()) {
        m_language->addItem(languageName(code), code);
    }
    addRow(form, tr("Language"), m_language,
           tr("Language of the window, with its numbers and dates; files stay the same in every language"));
    m_theme->setObjectName(QStringLiteral("theme"));
    m_theme->addItem(tr("As the system"), QStringLiteral("system"));
    m_theme->addItem(tr("Light"), QStringLiteral("light"));
    m_theme->addItem(tr("Dark"), QStringLiteral("dark"));
    addRow(form, tr("Theme"), m_theme, tr("Light or dark"));
    m_colours->setObjectName(QStringLiteral("colours"));
    m_colours->addItem(tr("Vermilion on stone grey"), static_cast<int>(figures::ColourSet::Vermilion));
    m_colours->addItem(tr("Yellow on dark grey"), static_cast<int>(figures::ColourSet::Yellow));
    addRow(form, tr("Fragments and structure"), m_colours,
           tr("Colours of fragments on the active structure. Both pairs can be told apart by the colour-blind; yellow on dark grey "
              "also in print without colour"));
    m_style->setObjectName(QStringLiteral("style"));
    m_style->addItem(tr("Presentation: materials"), true);
    m_style->addItem(tr("Analysis: fragments in colour"), false);
    addRow(form, tr("Style of the views"), m_style,
           tr("What views begin with: components in the look of their materials, or fragments set off from the structure"));
    m_units->setObjectName(QStringLiteral("units"));
    m_units->addItem(tr("SI: m, kg, s"), static_cast<int>(figures::UnitSet::Si));
    m_units->addItem(tr("mm, t, s"), static_cast<int>(figures::UnitSet::MillimetreTonne));
    m_units->addItem(tr("US customary: ft, lb, s"), static_cast<int>(figures::UnitSet::UsCustomary));
    addRow(form, tr("Units on screen"), m_units,
           tr("Units of quantities that panels, docks and views show and take. Cases, runs, tables and figures stay in SI, and so "
              "do the panels Accuracy and Evidence, coordinates of a system, and every file"));
    m_simplify->setObjectName(QStringLiteral("simplify"));
    addRow(form, tr("Simplify moving views"), m_simplify,
           tr("Draw large models with less detail while they move, where this machine draws fewer than 50 pictures a second; the "
              "legend says so. Counts, picking and figures keep every detail"));
    for (QComboBox* box : {m_language, m_theme, m_colours, m_style, m_units}) {
        connect(box, &QComboBox::activated, this, &PreferencesDialog::take);
    }
    connect(m_simplify, &QCheckBox::clicked, this, &PreferencesDialog::take);
}

void PreferencesDialog::buildWork(QFormLayout& form) {
    form.addRow(headingOf(tr("Work")));
    m_threads->setObjectName(QStringLiteral("threads"));
    m_threads->setRange(0, mostThreads);
    m_threads->setSpecialValueText(tr("all (%1)").arg(QThread::idealThreadCount()));
    addRow(
        form, tr("Threads"), m_threads,
        tr("How many threads one piece of work may use, from 0 (all) to %1. No result depends on it, times do").arg(mostThreads));
    m_memory->setObjectName(QStringLiteral("memory"));
    m_memory->setRange(leastMemoryMib, mostMemoryMib);
    m_memory->setSingleStep(128);
    m_memory->setSuffix(QStringLiteral(" MiB"));
    addRow(
        form, tr("Memory for playback"), m_memory,
        tr("How much memory states of the FE result and frames of the run may take, from %1 to %2 MiB; what does not fit is read "
           "again. For results and runs opened from now on")
            .arg(leastMemoryMib)
            .arg(mostMemoryMib));
    m_autosave->setObjectName(QStringLiteral("autosave"));
    m_autosave->setRange(0, mostAutosaveSeconds);
    m_autosave->setSingleStep(30);
    m_autosave->setSuffix(QStringLiteral(" s"));
    m_autosave->setSpecialValueText(tr("off"));
    addRow(form, tr("Autosave"), m_autosave,
           tr("Seconds between two copies of a changed case that are kept for recovery, from 0 (none) to %1")
               .arg(mostAutosaveSeconds));
    m_runs->setObjectName(QStringLiteral("keepRuns"));
    m_runs->setRange(0, mostKeptGib);
    m_runs->setSuffix(QStringLiteral(" GiB"));
    m_runs->setSpecialValueText(tr("none"));
    addRow(form, tr("Keep runs, up to"), m_runs,
           tr("Room for the runs of a case, cancelled ones too, from 0 (none) to %1 GiB; the oldest make room for new ones. The "
              "Run panel lists them")
               .arg(mostKeptGib));
    auto* list = new QPushButton(tr("Kept runs…"));
    list->setObjectName(QStringLiteral("listKeptRuns"));
    list->setToolTip(tr("The runs that are kept of all cases, with their sizes: open or remove them"));
    form.addRow(QString(), list);
    connect(list, &QPushButton::clicked, this, &PreferencesDialog::keptRunsRequested);
    m_runsFolder->setObjectName(QStringLiteral("runsFolder"));
    m_runsFolder->setPlaceholderText(tr("beside each case"));
    addRow(form, tr("Folder of kept runs"), m_runsFolder,
           tr("Where runs are kept; empty: in a folder beside the case, and with the program's own state for one that was never "
              "saved"));
    connect(m_runsFolder, &QLineEdit::editingFinished, this, &PreferencesDialog::take);
    m_copies->setObjectName(QStringLiteral("copies"));
    addRow(form, tr("Keep copies of results"), m_copies,
           tr("Keep a compressed copy of every FE result that is read: it opens at once next time"));
    for (QSpinBox* box : {m_threads, m_memory, m_autosave, m_runs}) {
        box->setKeyboardTracking(false);
        connect(box, &QSpinBox::valueChanged, this, &PreferencesDialog::take);
    }
    connect(m_copies, &QCheckBox::clicked, this, &PreferencesDialog::take);
}

void PreferencesDialog::show(const Preferences& preferences) {
    m_showing = true;
    m_now = preferences;
    m_language->setCurrentIndex(m_language->findData(preferences.language));
    m_theme->setCurrentIndex(m_theme->findData(preferences.theme));
    m_colours->setCurrentIndex(m_colours->findData(static_cast<int>(preferences.colours)));
    m_style->setCurrentIndex(m_style->findData(preferences.materials));
    m_units->setCurrentIndex(m_units->findData(static_cast<int>(preferences.units)));
    m_threads->setValue(preferences.threads);
    m_memory->setValue(preferences.memoryMib);
    m_autosave->setValue(preferences.autosaveSeconds);
    m_runs->setValue(preferences.keepRunsGib);
    m_runsFolder->setText(preferences.runsFolder);
    m_copies->setChecked(preferences.keepCopies);
    m_simplify->setChecked(preferences.simplify);
    m_showing = false;
}

void PreferencesDialog::take() {
    if (m_showing) {
        return;
    }
    Preferences next = m_now;
    next.language = m_language->currentData().toString();
    next.theme = m_theme->currentData().toString();
    next.colours = static_cast<figures::ColourSet>(m_colours->currentData().toInt());
    next.materials = m_style->currentData().toBool();
    next.units = static_cast<figures::UnitSet>(m_units->currentData().toInt());
    next.threads = m_threads->value();
    next.memoryMib = m_memory->value();
    next.autosaveSeconds = m_autosave->value();
    next.keepRunsGib = m_runs->value();
    next.runsFolder = m_runsFolder->text().trimmed();
    next.keepCopies = m_copies->isChecked();
    next.simplify = m_simplify->isChecked();
    if (!(next == m_now)) {
        m_now = next;
        emit changed(m_now);
    }
}

}  // namespace rubble::widgets
