#include "widgets/evidence/survey_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/evidence/no_evidence.h"
#include "widgets/basics/fixed_number.h"
#include "widgets/basics/language.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/surveys/point_box.h"
#include "widgets/evidence/surveys/reading_box.h"
#include "widgets/evidence/surveys/removal_box.h"
#include "widgets/run/caution_words.h"

namespace rubble::widgets {

namespace {

/// "NE" in the language of the window; "22°" of more than eight directions.
QString directionShown(const std::string& direction) {
    static constexpr std::array named{QT_TRANSLATE_NOOP("compass", "E"), QT_TRANSLATE_NOOP("compass", "NE"),
                                      QT_TRANSLATE_NOOP("compass", "N"), QT_TRANSLATE_NOOP("compass", "NW"),
                                      QT_TRANSLATE_NOOP("compass", "W"), QT_TRANSLATE_NOOP("compass", "SW"),
                                      QT_TRANSLATE_NOOP("compass", "S"), QT_TRANSLATE_NOOP("compass", "SE")};
    const auto* known = std::find_if(named.begin(), named.end(), [&](const char* each) { return direction == each; });
    return known != named.end() ? said("compass", *known)
                                : QString::fromStdString(direction).replace(QStringLiteral(" deg"), QStringLiteral("°"));
}

QString shown(double value, int decimals) {
    return shownFixed(value, decimals);
}

/// How well heights are known, and from where.
QString noiseWords(const SurveyNoise& noise) {
    switch (noise.source) {
        case SurveyNoise::Source::Stated:
            return SurveyBox::tr("Level of detection %1 m, by the noise that was stated.").arg(shownNumber(noise.detection(), 2));
        case SurveyNoise::Source::Estimated: {
            const QString text = SurveyBox::tr("Level of detection %1 m, estimated from %2 cells far from all debris.")
                                     .arg(shownNumber(noise.detection(), 2), shown(static_cast<double>(noise.cells), 0));
            return std::isfinite(noise.correlation)
                       ? text + QLatin1Char(' ') +
                             SurveyBox::tr("The noise hangs together over %1 m.").arg(shown(noise.correlation, 1))
                       : text;
        }
        case SurveyNoise::Source::None:
            return SurveyBox::tr("A map made of a run has no noise.");
        case SurveyNoise::Source::Unknown:
            break;
    }
    return SurveyBox::tr("The level of detection is not known: state the noise of survey and ground.");
}

void prepare(QTableWidget& table, const QStringList& headings) {
    table.setHorizontalHeaderLabels(headings);
    table.verticalHeader()->hide();
    table.setShowGrid(false);
    table.setFont(headingFont());
    table.horizontalHeader()->setFont(headingFont());
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setSelectionMode(QAbstractItemView::NoSelection);
    table.setTabKeyNavigation(false);
    table.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 7);
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table.horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table.horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table.horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void addRow(QTableWidget& table, const QStringList& cells) {
    const int row = table.rowCount();
    table.setRowCount(row + 1);
    for (int c = 0; c < cells.size(); ++c) {
        table.setItem(row, c, tableCell(cells[c], c == 0));
    }
}

void fitHeight(QTableWidget& table) {
    int height = table.horizontalHeader()->sizeHint().height() + 2 * table.frameWidth() + 2;
    for (int row = 0; row < table.rowCount(); ++row) {
        height += table.rowHeight(row);
    }
    table.setFixedHeight(height);
}

}  // namespace

SurveyBox::SurveyBox(QWidget* parent)
    : QWidget(parent),
      m_surveys(new QComboBox),
      m_add(new QPushButton(tr("Add survey…"))),
      m_remove(new QPushButton(tr("Remove"))),
      m_cell(new NumberField(tr("Cells of the survey comparison"))),
      m_least(new NumberField(tr("Least height of debris"))),
      m_place(new SurveyPlace),
      m_reading(new ReadingBox),
      m_points(new PointBox),
      m_removals(new RemovalBox),
      m_fit(new QComboBox),
      m_showsFallen(new QComboBox),
      m_withFallen(new QCheckBox(tr("Fallen structure counts as debris"))),
      m_noise(new NumberField(tr("Noise of the survey"))),
      m_groundNoise(new NumberField(tr("Noise of the ground"))),
      m_offsetError(new NumberField(tr("Offset error of the survey"))),
      m_scope(new QListWidget),
      m_addScope(new QToolButton),
      m_removeScope(new QToolButton),
      m_compare(new QPushButton(tr("Compare with survey"))),
      m_cancel(new QPushButton(tr("Cancel"))),
      m_save(new QPushButton(tr("Save difference map…"))),
      m_section(new QPushButton(tr("Section…"))),
      m_whyNot(new QLabel),
      m_notice(new Notice),
      m_noEvidence(new FindingList),
      m_findings(new FindingList),
      m_figures(new QTableWidget(0, 3)),
      m_runOut(new QTableWidget(0, 3)),
      m_words(new QLabel) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* files = new QHBoxLayout;
    m_surveys->setAccessibleName(tr("Surveys"));
    m_surveys->setToolTip(tr("The survey that is compared"));
    m_surveys->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_surveys->setMinimumContentsLength(8);
    files->addWidget(m_surveys, 1);
    files->addWidget(m_remove);
    column->addWidget(m_add);
    column->addLayout(files);
    // Before anything is stated or compared.
    column->addWidget(m_noEvidence);
    const auto takeOut = [this] { emit removeRequested(); };
    m_noEvidence->setDoings({{"evidence.of_this_run", tr("Take this survey out"), takeOut},
                             {"evidence.of_run", tr("Take this survey out"), takeOut},
                             {"evidence.ours", tr("Take this survey out"), takeOut}});
    column->addWidget(m_reading);
    column->addWidget(m_place);
    column->addWidget(m_points);
    buildFields();
    buildScope();
    buildResults();
    m_add->setToolTip(tr("Add a surveyed height model, a point cloud, or the outline of the real debris as polygons"));
    m_remove->setToolTip(tr("Take this survey out of the case; its file stays"));
    connect(m_add, &QPushButton::clicked, this, &SurveyBox::addRequested);
    connect(m_remove, &QPushButton::clicked, this, &SurveyBox::removeRequested);
    connect(m_compare, &QPushButton::clicked, this, &SurveyBox::compareRequested);
    connect(m_cancel, &QPushButton::clicked, this, &SurveyBox::cancelRequested);
    connect(m_save, &QPushButton::clicked, this, &SurveyBox::saveRequested);
    connect(m_surveys, &QComboBox::currentIndexChanged, this, [this](int survey) {
        if (!m_showing) {
            emit chosen(survey);
        }
    });
    setContent({});
}

void SurveyBox::buildFields() {
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    const SurveySettings usual;
    m_cell->setRange(0.05, 10.0);
    m_cell->setNumber(usual.cell);
    m_cell->setToolTip(tr("Side of the cells that are compared, 0.05 to 10 m"));
    form->addRow(tr("Cells, m"), m_cell);
    m_least->setRange(0.0, 5.0);
    m_least->setNumber(usual.leastHeight);
    m_least->setToolTip(tr("Height above the ground from which there is debris, 0 to 5 m; what lies lower is noise of the survey"));
    form->addRow(tr("Least height, m"), m_least);
    m_fit->addItem(tr("where it was surveyed"), static_cast<int>(SurveyFit::None));
    m_fit->addItem(tr("moved to the ground beside it"), static_cast<int>(SurveyFit::Ground));
    m_fit->addItem(tr("moved to the debris"), static_cast<int>(SurveyFit::Debris));
    // Its list is wider than a narrow panel; what is chosen stands in the words of the result too.
    m_fit->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_fit->setMinimumContentsLength(12);
    m_fit->setAccessibleName(tr("Registration of the survey"));
    m_fit->setToolTip(
        tr("Where the survey is taken to lie: as it is, shifted by least squares to the ground beside the debris (errors "
           "of its place go), or to the simulated debris, at most 5 m (only the shape is compared then)"));
    form->addRow(tr("Registration"), m_fit);
    for (const QString& shows : {tr("not known"), tr("yes"), tr("no")}) {
        m_showsFallen->addItem(shows);
    }
    m_showsFallen->setAccessibleName(tr("Whether the survey shows fallen structure"));
    m_showsFallen->setToolTip(
        tr("Whether structure that fell whole lies in the survey: yes of a scan of all that was there, no where such pieces were "
           "taken "
           "out; kept in the case"));
    form->addRow(tr("Fallen structure in it"), m_showsFallen);
    m_withFallen->setChecked(usual.withFallen);
    m_withFallen->setToolTip(
        tr("Whether live structure that moved farther than 1 m belongs to the simulated debris, as it does to the "
           "surveyed; said on the result"));
    form->addRow(m_withFallen);
    for (NumberField* field : {m_noise, m_groundNoise, m_offsetError}) {
        field->setRange(0.0, 100.0);
        field->setEmptyMeans(field == m_offsetError ? tr("not known") : tr("estimated"));
        connect(field, &NumberField::edited, this,
                [this] { emit noiseChosen({m_noise->number(), m_groundNoise->number(), m_offsetError->number()}); });
    }
    m_noise->setToolTip(
        tr("Standard deviation of the surveyed heights, m. Without both, the noise is estimated where nothing fell; heights below "
           "the level of detection do not count. Kept in the case"));
    m_groundNoise->setToolTip(tr("Standard deviation of the heights of the terrain below, m; kept in the case"));
    form->addRow(tr("Noise, survey, m"), m_noise);
    form->addRow(tr("Noise, ground, m"), m_groundNoise);
    m_offsetError->setToolTip(
        tr("Standard deviation of an offset that all surveyed heights may have together, m. Without it the systematic error of "
           "volumes is not known. Kept in the case"));
    form->addRow(tr("Offset error, m"), m_offsetError);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
    for (NumberField* field : {m_cell, m_least}) {
        connect(field, &NumberField::edited, this, &SurveyBox::settingsChanged);
    }
    connect(m_fit, &QComboBox::currentIndexChanged, this, &SurveyBox::settingsChanged);
    connect(m_withFallen, &QCheckBox::toggled, this, &SurveyBox::settingsChanged);
    connect(m_showsFallen, &QComboBox::currentIndexChanged, this, [this](int shows) {
        if (!m_showing) {
            emit showsFallenChosen(shows == 0 ? std::nullopt : std::optional<bool>(shows == 1));
        }
    });
}

void SurveyBox::buildScope() {
    auto* column = static_cast<QVBoxLayout*>(layout());
    auto* heading = new QHBoxLayout;
    heading->addWidget(new QLabel(tr("What is compared")), 1);
    m_addScope->setText(tr("Add"));
    m_addScope->setPopupMode(QToolButton::InstantPopup);
    m_addScope->setToolTip(tr("Add an area of interest, or what is left out, such as vehicles and trees"));
    auto* menu = new QMenu(m_addScope);
    const auto add = [&](const QString& text, auto signal, ScopePart part) {
        connect(menu->addAction(text), &QAction::triggered, this, [this, signal, part] { emit(this->*signal)(part); });
    };
    add(tr("Draw an area of interest"), &SurveyBox::scopeDrawRequested, ScopePart::Area);
    add(tr("Draw what is left out"), &SurveyBox::scopeDrawRequested, ScopePart::LeftOut);
    add(tr("Area of interest from a file…"), &SurveyBox::scopeFileRequested, ScopePart::Area);
    add(tr("What is left out from a file…"), &SurveyBox::scopeFileRequested, ScopePart::LeftOut);
    m_addScope->setMenu(menu);
    m_removeScope->setText(tr("Remove"));
    m_removeScope->setToolTip(tr("Remove the chosen polygon"));
    heading->addWidget(m_addScope);
    heading->addWidget(m_removeScope);
    column->addLayout(heading);
    m_scope->setAccessibleName(tr("Polygons that say what is compared"));
    m_scope->setToolTip(
        tr("Cells that are compared lie within an area of interest, if there is one, and in nothing that is left out"));
    column->addWidget(m_scope);
    column->addWidget(m_removals);
    connect(m_scope, &QListWidget::currentRowChanged, this, [this](int row) { m_removeScope->setEnabled(row >= 0); });
    connect(m_removeScope, &QToolButton::clicked, this, [this] {
        const int areas = static_cast<int>(m_content.scope.area.polygons.size());
        const int row = m_scope->currentRow();
        if (row >= 0) {
            row < areas ? emit scopeRemoved(ScopePart::Area, row) : emit scopeRemoved(ScopePart::LeftOut, row - areas);
        }
    });
}

void SurveyBox::showScope() {
    m_scope->clear();
    for (const ScopePart part : {ScopePart::Area, ScopePart::LeftOut}) {
        for (const OutlinePolygon& polygon : m_content.scope.part(part).polygons) {
            const std::size_t corners = polygon.empty() ? 0 : polygon.front().size();
            m_scope->addItem(
                (part == ScopePart::Area ? tr("area of interest, corners: %1") : tr("left out, corners: %1")).arg(corners));
        }
    }
    const int count = m_scope->count();
    m_scope->setVisible(count > 0);
    m_scope->setFixedHeight(std::clamp(count, 1, 4) * (m_scope->fontMetrics().height() + 6) + 4);
    m_removeScope->setVisible(count > 0);
    m_removeScope->setEnabled(false);
}

void SurveyBox::buildResults() {
    auto* column = static_cast<QVBoxLayout*>(layout());
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_compare, 1);
    buttons->addWidget(m_cancel);
    column->addLayout(buttons);
    m_compare->setToolTip(tr("Hold the debris at rest against the survey"));
    m_cancel->setToolTip(tr("Stop comparing"));
    m_whyNot->setObjectName(QStringLiteral("muted"));
    m_whyNot->setWordWrap(true);
    column->addWidget(m_whyNot);
    column->addWidget(m_notice);
    prepare(*m_figures, {tr("debris"), tr("surveyed"), tr("simulated")});
    m_figures->setAccessibleName(tr("Surveyed and simulated debris"));
    column->addWidget(m_figures);
    prepare(*m_runOut, {tr("run-out, m"), tr("surveyed"), tr("simulated")});
    m_runOut->setAccessibleName(tr("Run-out by direction"));
    m_runOut->setToolTip(
        tr("Distance from the middle of the structure's plan within which 95 % of the covered area in that direction "
           "lies, m"));
    column->addWidget(m_runOut);
    m_words->setObjectName(QStringLiteral("muted"));
    m_words->setWordWrap(true);
    column->addWidget(m_words);
    auto* uses = new QHBoxLayout;
    uses->addWidget(m_save, 1);
    uses->addWidget(m_section);
    column->addLayout(uses);
    m_save->setToolTip(tr("Save the difference map as GeoTIFF or as a picture"));
    m_section->setToolTip(tr(
        "Draw a line on the difference map: run and survey are cut along it, drawn and measured together. Measured points without "
        "a map are cut along themselves."));
    connect(m_section, &QPushButton::clicked, this, &SurveyBox::sectionRequested);
    column->addWidget(m_findings);
    const auto focused = [](QWidget* field) { return [field] { askIn(*field); }; };
    m_findings->setDoings({{"survey.offset", tr("Register it to the ground and compare"),
                            [this] {
                                m_fit->setCurrentIndex(m_fit->findData(static_cast<int>(SurveyFit::Ground)));
                                emit compareRequested();
                            }},
                           {"survey.fallen_unknown", tr("Say what it shows"), focused(m_showsFallen)},
                           {"survey.removal_unknown", tr("Say when it was taken"), [this] { m_place->askTime(); }},
                           {"survey.far", tr("Pick pairs…"), [this] { emit m_place->pickRequested(); }}});
}

SurveySettings SurveyBox::settings() const {
    SurveySettings settings;
    settings.cell = m_cell->number().value_or(settings.cell);
    settings.leastHeight = m_least->number().value_or(settings.leastHeight);
    settings.fit = static_cast<SurveyFit>(m_fit->currentData().toInt());
    settings.withFallen = m_withFallen->isChecked();
    return settings;
}

void SurveyBox::setSettings(const SurveySettings& settings) {
    const QSignalBlocker quiet(this);
    m_cell->setNumber(settings.cell);
    m_least->setNumber(settings.leastHeight);
    m_fit->setCurrentIndex(m_fit->findData(static_cast<int>(settings.fit)));
    m_withFallen->setChecked(settings.withFallen);
}

void SurveyBox::setContent(const Content& content) {
    m_content = content;
    m_showing = true;
    m_surveys->clear();
    m_surveys->addItems(content.names);
    m_surveys->setCurrentIndex(content.chosen);
    m_showsFallen->setCurrentIndex(!content.showsFallen ? 0 : *content.showsFallen ? 1 : 2);
    m_noise->setNumber(content.errors.noise);
    m_groundNoise->setNumber(content.errors.groundNoise);
    m_offsetError->setNumber(content.errors.offset);
    m_place->setStated(content.stated, content.chosen >= 0, content.cloud);
    showScope();
    m_removals->setRemovals(content.removals, content.available);
    m_showing = false;
    const bool some = content.chosen >= 0;
    m_add->setEnabled(content.available);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_surveys, m_remove, m_cell, m_least, m_fit, m_showsFallen, m_withFallen,
                                                           m_compare, m_noise, m_groundNoise, m_offsetError, m_addScope}) {
        widget->setEnabled(some);
    }
    m_compare->setEnabled(some && content.noComparison.isEmpty() && !content.comparing);
    m_cancel->setVisible(content.comparing);
    m_whyNot->setText(!some ? tr("A height model or an outline of the real debris, measured after the collapse, is compared here.")
                            : content.noComparison);
    m_whyNot->setVisible(!m_whyNot->text().isEmpty());
    m_noEvidence->set(noEvidenceOf(content.findings));
    m_findings->set(otherThanNoEvidence(content.findings));
    showResults();
}

void SurveyBox::showResults() {
    const SurveyComparison* made = m_content.comparison.get();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_figures, m_runOut, m_words, m_save}) {
        widget->setVisible(made != nullptr);
    }
    m_section->setVisible(made != nullptr || m_content.cutsAlong);
    m_section->setEnabled(made == nullptr || !m_content.stale);
    if (!m_content.complaint.isEmpty()) {
        m_notice->set(Notice::Kind::Error, m_content.complaint);
    } else if (made != nullptr && m_content.stale) {
        m_notice->set(Notice::Kind::Finding, tr("Of another run or other settings: compare again."));
    } else {
        // As below the map of the run: what must be known beside the figures.
        const QString cautions = made != nullptr ? cautionWords(m_content.cautions) : QString();
        m_notice->set(cautions.isEmpty() ? Notice::Kind::Note : Notice::Kind::Finding, cautions);
    }
    if (made == nullptr) {
        return;
    }
    m_figures->setRowCount(0);
    addRow(*m_figures, {tr("area, m²"), shown(made->survey.area, 0), shown(made->simulated.area, 0)});
    if (!made->isFootprint) {
        addRow(*m_figures, {tr("volume, m³"), shown(made->survey.volume, 0), shown(made->simulated.volume, 0)});
    }
    if (made->seen) {
        addRow(*m_figures, {tr("area surveyed alike, m²"), shown(made->survey.area, 0), shown(made->seen->area, 0)});
    }
    addRow(*m_figures, {tr("centroid x, m"), shown(made->survey.centroid.x(), 2), shown(made->simulated.centroid.x(), 2)});
    addRow(*m_figures, {tr("centroid y, m"), shown(made->survey.centroid.y(), 2), shown(made->simulated.centroid.y(), 2)});
    fitHeight(*m_figures);
    m_runOut->setRowCount(0);
    for (int s = 0; s < made->settings.sectors; ++s) {
        const auto at = static_cast<std::size_t>(s);
        addRow(*m_runOut, {directionShown(sectorName(s, made->settings.sectors)), shown(made->survey.runOut[at], 1),
                           shown(made->simulated.runOut[at], 1)});
    }
    fitHeight(*m_runOut);
    m_words->setText(wordsOf(*made).join(QLatin1Char(' ')));
}

QStringList SurveyBox::wordsOf(const SurveyComparison& made) const {
    const bool any = std::isfinite(made.iou);
    QStringList words{any ? tr("Overlap of the footprints (IoU): %1.").arg(shown(made.iou, 3))
                          : tr("Neither side has debris: there is no overlap, and heights are not compared.")};
    if (any && made.seen && std::isfinite(made.seen->reachableIou) && std::isfinite(made.seen->alikeIou)) {
        words << tr("A perfect simulation reaches %1 on this grid; with both sides surveyed alike it is %2.")
                     .arg(shown(made.seen->reachableIou, 3), shown(made.seen->alikeIou, 3));
    }
    if (!made.isFootprint) {
        if (any) {
            words
                << tr("Heights differ by %1 m RMS, by %2 m in the mean.").arg(shown(made.heightRms, 2), shown(made.heightMean, 2));
        }
        words << tr("Volumes hold the voids.");
        words << tr("Surveyed surface against the ground: %1 m³ above it (fill), %2 m³ below it (cut), net %3 m³.")
                     .arg(shown(made.volumes.fill, 0), shown(made.volumes.cut, 0), shown(made.volumes.net(), 0));
        words << noiseWords(made.noise);
        if (made.noise.source == SurveyNoise::Source::Stated || made.noise.source == SurveyNoise::Source::Estimated) {
            words << tr("Below it also lie fill %1, cut %2, net %3 m³, which are not counted.")
                         .arg(shown(made.volumes.undetectedFill, 1), shown(made.volumes.undetectedCut, 1),
                              shown(made.volumes.undetectedNet(), 1));
        }
    }
    if (!made.settings.scope.whole()) {
        words << tr("Not compared: %1 m² of surveyed and %2 m² of simulated debris.")
                     .arg(shown(made.leftOut.surveyedArea, 0), shown(made.leftOut.simulatedArea, 0));
    }
    if (std::isfinite(made.centroidDistance)) {
        words << tr("Centroids lie %1 m apart.").arg(shown(made.centroidDistance, 2));
    } else if (any) {
        words << tr("How far centroids lie apart is not known: one side has no debris.");
    }
    words << (made.settings.fit == SurveyFit::None
                  ? tr("The survey lies where it was surveyed.")
                  : tr("The survey was moved by %1, %2, %3 m; what was fitted went from %4 to %5 RMS.")
                        .arg(shown(made.shift.by.x(), 2), shown(made.shift.by.y(), 2), shown(made.shift.by.z(), 2),
                             shown(made.shift.before, 3), shown(made.shift.after, 3)));
    words << worded(made.words);
    return words;
}

}  // namespace rubble::widgets
