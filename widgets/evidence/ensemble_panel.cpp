#include "widgets/evidence/ensemble_panel.h"

#include <QCheckBox>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>
#include <cmath>

#include "widgets/basics/number_field.h"
#include "widgets/basics/place_choice.h"
#include "widgets/basics/study_start.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

EnsemblePanel::EnsemblePanel(QWidget* parent)
    : Panel(tr("Ensemble"), tr("How sure is it where debris lies, with what is not known drawn anew?"), parent),
      m_place(new PlaceChoice),
      m_start(new StudyStart(
          {tr("Simulate members"),
           tr("Simulate every member, with values drawn from the distributions below. Members that were simulated before are taken "
              "from the cache"),
           tr("Stop, on a cluster after a question; members that are done are kept, and simulating again goes on"),
           QStringLiteral("cancelEnsemble"), tr("Progress of the ensemble")},
          m_place)),
      m_varied(new VariedTable),
      m_members(new QSpinBox),
      m_seed(new NumberField(tr("Seed"))),
      m_cell(new NumberField(tr("Cells"))),
      m_withFallen(new QCheckBox(tr("Fallen structure counts as debris"))),
      m_atFeEnd(new QCheckBox(tr("At the end of the FE result"))),
      m_findings(new FindingList) {
    addWide(m_start);
    PanelGroup* varied = addGroup(tr("What is varied"));
    varied->addWide(m_varied);
    buildMembers();
    buildDebris();
    addWide(m_findings);
    connect(m_varied, &VariedTable::variedEdited, this, [this](const std::vector<VariedSetting>& after, const Wording& what) {
        EnsembleSettings settings = m_content.settings;
        settings.varied = after;
        emit settingsEdited(settings, what);
    });
    connect(m_start, &StudyStart::startRequested, this, &EnsemblePanel::simulateRequested);
    connect(m_start, &StudyStart::cancelRequested, this, &EnsemblePanel::cancelRequested);
    setContent({});
}

void EnsemblePanel::buildMembers() {
    PanelGroup* group = addGroup(tr("Members"));
    m_members->setObjectName(QStringLiteral("members"));
    m_members->setRange(1, static_cast<int>(ensembleMembersMax));
    m_members->setAccessibleName(tr("Members"));
    m_members->setKeyboardTracking(false);
    m_members->setAlignment(Qt::AlignRight);
    group->addField(
        tr("Members"), m_members, {},
        tr("How often the collapse is simulated, 1 to 10,000. The probability of a cell is sure to about 0.5 / √(n + 4): "
           "0.11 with 16 members, 0.06 with 64"));
    m_seed->setRange(0.0, 4294967295.0);
    group->addField(tr("Seed"), m_seed, {}, tr("Of what is drawn: the same seed gives the same members. 0 to 4,294,967,295"));
    m_cost = group->addNote({});
    m_folder = group->addNote({});
    m_folder->setTextInteractionFlags(Qt::TextSelectableByMouse);
    connect(m_members, &QSpinBox::valueChanged, this, [this](int members) {
        EnsembleSettings settings = m_content.settings;
        settings.members = members;
        emit settingsEdited(settings, [] { return tr("members of the ensemble"); });
    });
    connect(m_seed, &NumberField::edited, this, [this](std::optional<double> seed) {
        EnsembleSettings settings = m_content.settings;
        settings.seed = std::llround(*seed);
        emit settingsEdited(settings, [] { return tr("seed of the ensemble"); });
    });
}

void EnsemblePanel::buildDebris() {
    PanelGroup* group = addGroup(tr("Debris on the ground"));
    m_cell->setRange(0.05, 100.0);
    m_cell->setUnit("m");
    m_cell->setNumber(SurfaceSettings().cell);
    group->addField(tr("Cells"), m_cell, tr("m"), tr("Side of the cells of the maps. From 0.05 to 100 m"));
    m_withFallen->setChecked(true);
    m_withFallen->setToolTip(tr("Live elements that moved farther than %1 are debris").arg(shownLength(1.0)));
    group->addWide(m_withFallen);
    m_atFeEnd->setToolTip(tr("Maps show the debris at the last FE state, not where it comes to rest"));
    group->addWide(m_atFeEnd);
    connect(m_cell, &NumberField::edited, this, &EnsemblePanel::surfaceChanged);
    connect(m_withFallen, &QCheckBox::clicked, this, &EnsemblePanel::surfaceChanged);
    connect(m_atFeEnd, &QCheckBox::clicked, this, &EnsemblePanel::surfaceChanged);
}

SurfaceSettings EnsemblePanel::surface() const {
    SurfaceSettings surface;
    surface.cell = m_cell->number().value_or(surface.cell);
    surface.withFallen = m_withFallen->isChecked();
    return surface;
}

void EnsemblePanel::setSurface(const SurfaceSettings& surface, DebrisInstant instant) {
    m_cell->setNumber(surface.cell);
    m_withFallen->setChecked(surface.withFallen);
    m_atFeEnd->setChecked(instant == DebrisInstant::AtFeEnd);
}

DebrisInstant EnsemblePanel::instant() const {
    return m_atFeEnd->isChecked() ? DebrisInstant::AtFeEnd : DebrisInstant::AtRest;
}

void EnsemblePanel::setContent(const Content& content) {
    m_content = content;
    m_varied->setContent(content.settings.varied, content.scenarios);
    const QSignalBlocker blocker(m_members);
    m_members->setValue(static_cast<int>(content.settings.members));
    if (const auto seed = static_cast<double>(content.settings.seed); m_seed->number() != seed) {
        m_seed->setNumber(seed);
    }
    for (QWidget* editor : std::initializer_list<QWidget*>{m_varied, m_members, m_seed}) {
        editor->setEnabled(content.available && !content.running);
    }
    for (QWidget* editor : std::initializer_list<QWidget*>{m_cell, m_withFallen, m_atFeEnd}) {
        editor->setEnabled(!content.running);
    }
    m_start->setReady(content.ready, content.running, content.why);
    m_findings->set(content.findings);
    showCost();
}

void EnsemblePanel::showCost() {
    const double seconds = m_content.runSeconds * static_cast<double>(m_content.settings.members);
    m_cost->setText(m_content.runSeconds < 0.0
                        ? tr("Each member takes about as long as a run.")
                        : tr("Each member takes about as long as the last run: %1 in all, unless members are kept from before.")
                              .arg(shownDuration(seconds)));
}

void EnsemblePanel::setProgress(const QString& what, double fraction, double secondsLeft) {
    m_start->setProgress(what, fraction, secondsLeft);
}

void EnsemblePanel::setFolder(const QString& folder) {
    m_folder->setText(tr("Members that are done are kept in %1, so that a second start goes on from there.").arg(folder));
    m_folder->setVisible(!folder.isEmpty());
}

}  // namespace rubble::widgets
