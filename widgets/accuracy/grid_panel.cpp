#include "widgets/accuracy/grid_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "core/clusters/grid_bounds.h"
#include "widgets/accuracy/calibration_plot.h"
#include "widgets/accuracy/grid_words.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

constexpr int sliderSteps = 400;
constexpr double leastMultiple = 0.5;
constexpr double greatestMultiple = 50.0;
constexpr int tableColumns = 6;
constexpr std::array<const char*, 3> sizeKeys{"grid_l", "grid_w", "grid_h"};

QTableWidgetItem* figureCell(const QString& text, Qt::Alignment alignment = Qt::AlignRight | Qt::AlignVCenter) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment(alignment);
    item->setFlags(Qt::ItemIsEnabled);
    return item;
}

QString multipleText(double multiple) {
    return multiple > 0.0 ? QLocale().toString(multiple, 'f', multiple < 10.0 ? 2 : 1) : QString(QChar(0x2013));
}

/// Settings that stand with the table of sizes.
bool isOfTheSize(std::string_view key) {
    return key == "grouping" || key == "multiple" || std::find(sizeKeys.begin(), sizeKeys.end(), key) != sizeKeys.end();
}

}  // namespace

double GridPanel::multipleAt(int position) {
    const double share = std::clamp(position, 0, sliderSteps) / static_cast<double>(sliderSteps);
    const double multiple = leastMultiple * std::pow(greatestMultiple / leastMultiple, share);
    // Two decimals are what the slider can mean.
    return std::round(100.0 * multiple) / 100.0;
}

int GridPanel::positionOf(double multiple) {
    if (!(multiple > leastMultiple)) {
        return 0;
    }
    return std::min(sliderSteps, static_cast<int>(std::lround(sliderSteps * std::log(multiple / leastMultiple) /
                                                              std::log(greatestMultiple / leastMultiple))));
}

GridPanel::GridPanel(QWidget* parent)
    : Panel(tr("Basic Grid"), tr("Which fragments move together, and what that costs."), parent),
      m_advice(new QLabel),
      m_beside(new FindingList),
      m_use(new QPushButton),
      m_slider(new QSlider(Qt::Horizontal)),
      m_multipleWhy(new Notice),
      m_table(new QTableWidget(3, tableColumns)),
      m_findings(new FindingList) {
    buildTarget();
    // What is set stands above all that it changes, so that nothing moves under the mouse.
    addRemaining(Stage::Sizing, tr("Clusters"), isOfTheSize);
    addRemaining(Stage::Clusters, tr("More"), isOfTheSize);
    buildSize();
    buildResult();
    addPrediction();
    addWide(m_beside);
    addWide(m_findings);
    setAdvice({});
    setPublishedCounts({});
    setContent({});
}

void GridPanel::buildTarget() {
    PanelGroup* target = addGroup(tr("Target"));
    addParameter(target, "fps_target");
    addParameter(target, "bodies_max");
    addParameter(target, "awake_time");
    m_advice->setObjectName(QStringLiteral("muted"));
    m_advice->setWordWrap(true);
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    m_use->setObjectName(QStringLiteral("useBodies"));
    m_use->setToolTip(tr("Allow as many bodies as this machine carries at the target rate"));
    auto* calibrate = new QPushButton(tr("Calibrate this machine…"));
    calibrate->setObjectName(QStringLiteral("calibrate"));
    calibrate->setToolTip(tr("Measure how many bodies this machine carries, and see the curve"));
    row->addWidget(calibrate);
    row->addWidget(m_use);
    row->addStretch();
    target->addWide(buttons);
    target->addWide(m_advice);
    connect(m_use, &QPushButton::clicked, this, [this] { emit edited(QStringLiteral("bodies_max"), ParameterValue(m_offered)); });
    connect(calibrate, &QPushButton::clicked, this, &GridPanel::calibrationRequested);
}

void GridPanel::buildSize() {
    PanelGroup* size = addGroup(tr("Size"));
    addParameter(size, "grouping");
    addParameter(size, "multiple");
    m_slider->setRange(0, sliderSteps);
    m_slider->setPageStep(20);
    m_slider->setAccessibleName(tr("Multiple of mean distance"));
    m_slider->setToolTip(tr("Drag to set the multiple; clusters are counted and the grid is drawn anew while you drag."));
    size->addWide(m_slider);
    // Beside what is dragged, for the same look holds both.
    m_clusters = size->addValue(tr("Clusters"), {}, tr("Rigid bodies that the engine moves, counted at these sizes"));
    for (const char* key : sizeKeys) {
        addParameter(size, key);
    }
    buildTable(size);
    // Below the controls, which would move else while they are used.
    size->addWide(m_multipleWhy);
    for (Notice*& why : m_axisWhy) {
        why = new Notice;
        size->addWide(why);
    }
    connect(m_slider, &QSlider::sliderPressed, this, &GridPanel::draggingStarted);
    connect(m_slider, &QSlider::sliderReleased, this, &GridPanel::draggingEnded);
    connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
        m_slider->setAccessibleDescription(tr("%1 times the mean distance").arg(multipleText(multipleAt(position))));
        emit edited(QStringLiteral("multiple"), ParameterValue(multipleAt(position)));
    });
}

void GridPanel::buildTable(PanelGroup* group) {
    m_table->setHorizontalHeaderLabels({tr("axis"), tr("d"), tr("size"), tr("size/d"), tr("frag."), tr("comp.")});
    const std::array tips = {tr("Axis of the model"),
                             tr("Mean distance of adjacent fragments"),
                             tr("Chosen size of the Basic Grid"),
                             tr("Size over mean distance; the published method recommends two to three"),
                             tr("Largest fragment: the least sensible size"),
                             tr("Smallest component: along axes the greatest sensible size")};
    for (int column = 0; column < tableColumns; ++column) {
        m_table->horizontalHeaderItem(column)->setToolTip(tips[static_cast<std::size_t>(column)]);
        m_table->horizontalHeaderItem(column)->setTextAlignment(column == 0 ? Qt::AlignLeft : Qt::AlignRight);
    }
    m_table->verticalHeader()->hide();
    m_table->setAccessibleName(tr("Sizes of the Basic Grid and their bounds"));
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setMinimumSectionSize(24);
    m_table->horizontalHeader()->setFont(headingFont());
    m_table->setFont(headingFont());
    m_table->setShowGrid(false);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setFocusPolicy(Qt::NoFocus);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const int line = m_table->fontMetrics().height() + 10;
    m_table->verticalHeader()->setDefaultSectionSize(line);
    m_table->setFixedHeight(4 * line + 4);
    m_table->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    group->addWide(m_table);
    m_unitNote = group->addNote({});
}

void GridPanel::buildResult() {
    PanelGroup* result = addGroup(tr("Result"));
    m_fragments = result->addValue(tr("Fragments"));
    m_awake = result->addValue(tr("Awake at once"), {},
                               tr("Most of them that move at the same time, each from its birth on for the time set above; bodies "
                                  "at rest cost next to nothing, so this is what the bodies allowed are held against"));
    m_perCluster = result->addValue(tr("Fragments in a cluster, mean"));
    m_splits = result->addValue(tr("Split by component, by velocity"), {},
                                tr("Clusters added because none may span two components, or because a fragment moves otherwise"));
    m_stopped = result->addNote({});
    PanelGroup* published = addGroup(tr("Against the published two to three"));
    for (std::size_t i = 0; i < publishedMultiples.size(); ++i) {
        m_published[i] = published->addValue(tr("Clusters at %1 d").arg(QLocale().toString(publishedMultiples[i], 'g', 3)), {},
                                             tr("Counted on these fragments; within their bounds or not"));
    }
    m_ours = published->addValue(tr("As set"));
    published->addNote(
        tr("In a result with many states few fragments share a birth time. The multiple for the bodies allowed may then lie "
           "outside the two to three of the published method, on either side."));
}

bool GridPanel::dragging() const {
    return m_slider->isSliderDown();
}

void GridPanel::setScenario(const Scenario& scenario) {
    Panel::setScenario(scenario);
    m_settings = scenario.grid;
    m_use->setVisible(m_offered > 0 && m_offered != m_settings.bodiesMax);
    m_multipleWhy->set(Notice::Kind::Note, multipleReason(m_settings));
    const bool decides = !m_settings.oneBodyPerFragment && !(m_settings.length && m_settings.width && m_settings.height);
    m_slider->setEnabled(decides);
    m_slider->setToolTip(decides ? tr("Drag to set the multiple; clusters are counted and the grid is drawn anew while you drag.")
                                 : multipleReason(m_settings));
    if (scenario.grid.multiple && !dragging()) {
        const QSignalBlocker quiet(m_slider);
        m_slider->setValue(positionOf(*scenario.grid.multiple));
    }
}

void GridPanel::setAdvice(const MachineAdvice& advice) {
    const QString target = QLocale().toString(advice.target, 'g', 4);
    m_offered = 0;
    if (!advice.calibrated) {
        m_advice->setText(tr("This machine is not calibrated: 4,500 bodies at 24 FPS is the published figure."));
    } else if (advice.disturbed || !advice.typical) {
        m_advice->setText(
            tr("The calibration of this machine says nothing here: other programs worked meanwhile, or it has too few "
               "points."));
    } else {
        m_advice->setText(
            tr("This machine carries %1 bodies at %2 FPS where some of them rest, %3 where none does.")
                .arg(bodiesWords(*advice.typical), target, advice.worst ? bodiesWords(*advice.worst) : tr("an unknown number")));
        m_offered = roundedBodies(*advice.typical);
    }
    m_use->setText(tr("Allow %1").arg(shownCount(m_offered)));
    m_use->setVisible(m_offered > 0 && m_offered != m_settings.bodiesMax);
}

void GridPanel::setBeside(const std::optional<Finding>& caution) {
    // It comes with each prediction, while a slider moves as well.
    const QString words = caution ? worded(caution->what) : QString();
    if (words == m_besideWords) {
        return;
    }
    m_besideWords = words;
    Findings findings;
    if (caution) {
        findings.add(caution->what, caution->remedy);
    }
    m_beside->set(findings);
}

void GridPanel::setPublishedCounts(const std::vector<PublishedCount>& counts) {
    for (std::size_t i = 0; i < m_published.size(); ++i) {
        m_published[i]->setText(i < counts.size() ? shownCount(static_cast<std::int64_t>(counts[i].clusters))
                                                  : QString(QChar(0x2013)));
    }
}

void GridPanel::setContent(const Content& content) {
    m_unitNote->setText(tr("in %1; d is the mean distance of adjacent fragments").arg(figures::shownUnit("m").name));
    for (int row = 0; row < 3; ++row) {
        m_table->setItem(row, 0, figureCell(QString(QLatin1Char("xyz"[row])), Qt::AlignLeft | Qt::AlignVCenter));
        if (content.sizing == nullptr) {
            for (int column = 1; column < tableColumns; ++column) {
                m_table->setItem(row, column, figureCell(QString(QChar(0x2013))));
            }
        } else {
            showAxis(row, content.sizing->axis[static_cast<std::size_t>(row)], content);
        }
    }
    showReasons(content);
    showResult(content);
}

void GridPanel::showReasons(const Content& content) {
    const std::array byHand{m_settings.length, m_settings.width, m_settings.height};
    for (std::size_t i = 0; i < 3; ++i) {
        const bool set = byHand[i].has_value() || (m_settings.multiple.has_value() && content.sizing != nullptr &&
                                                   content.sizing->stoppedBy == StoppedBy::User);
        m_axisWhy[i]->set(Notice::Kind::Finding, content.sizing == nullptr || m_settings.oneBodyPerFragment
                                                     ? QString()
                                                     : axisReason("xyz"[i], content.sizing->axis[i], set,
                                                                  boundByComponents(m_settings), content.components.get()));
    }
}

void GridPanel::showAxis(int row, const AxisSizing& axis, const Content& content) {
    const std::array texts = {shownIn(axis.meanDistance, "m"), shownIn(axis.size, "m"), multipleText(axis.multiple),
                              shownIn(axis.accuracyMin, "m"), shownIn(axis.accuracyMax, "m")};
    for (int column = 1; column < tableColumns; ++column) {
        m_table->setItem(row, column, figureCell(texts[static_cast<std::size_t>(column - 1)]));
    }
    QFont bold = m_table->font();
    bold.setWeight(QFont::DemiBold);
    m_table->item(row, 2)->setFont(bold);
    const int limiting = axis.clampedBy == ClampedBy::FragmentSize ? 4 : axis.clampedBy == ClampedBy::ComponentSize ? 5 : -1;
    if (limiting > 0) {
        m_table->item(row, limiting)->setForeground(tints().finding);
    }
    if (axis.largestFragment && content.fragments != nullptr && content.mesh != nullptr) {
        const Fragment& fragment = content.fragments->list[at(*axis.largestFragment)];
        m_table->item(row, 4)->setToolTip(tr("Element %1").arg(shownCount(content.mesh->elementIds[at(fragment.element)])));
    }
    if (axis.smallestComponent && content.components != nullptr) {
        m_table->item(row, 5)->setToolTip(QString::fromStdString(content.components->list[at(*axis.smallestComponent)].name));
    }
}

void GridPanel::showAutomatic(const Sizing& sizing) {
    editor(QStringLiteral("multiple"))->setAutomaticValue(sizing.commonMultiple);
    for (std::size_t i = 0; i < 3; ++i) {
        editor(QLatin1String(sizeKeys[i]))->setAutomaticValue(sizing.axis[i].size);
    }
    if (!dragging() && sizing.commonMultiple > 0.0) {
        const QSignalBlocker quiet(m_slider);
        m_slider->setValue(positionOf(sizing.commonMultiple));
    }
}

void GridPanel::showResult(const Content& content) {
    const QString none(QChar(0x2013));
    const Sizing* sizing = content.sizing.get();
    m_fragments->setText(sizing != nullptr ? shownCount(static_cast<std::int64_t>(sizing->fragments)) : none);
    m_clusters->setText(sizing != nullptr ? shownCount(static_cast<std::int64_t>(sizing->clusters)) : none);
    m_awake->setText(sizing != nullptr ? shownCount(static_cast<std::int64_t>(sizing->awake)) : none);
    m_perCluster->setText(sizing != nullptr && sizing->clusters > 0
                              ? shownNumber(static_cast<double>(sizing->fragments) / static_cast<double>(sizing->clusters))
                              : none);
    const Clustering* clustering = content.clustering.get();
    m_splits->setText(clustering != nullptr && !content.counted
                          ? QStringLiteral("%1, %2").arg(shownCount(static_cast<std::int64_t>(clustering->splitByComponent)),
                                                         shownCount(static_cast<std::int64_t>(clustering->splitByVelocity)))
                          : none);
    m_stopped->setText(sizing != nullptr ? stopReason(*sizing)
                                         : tr("Open a result: the sizes that meet the live frame rate appear here."));
    m_ours->setText(
        sizing == nullptr
            ? none
            : tr("%1 at %2 d").arg(shownCount(static_cast<std::int64_t>(sizing->clusters)), multipleText(sizing->commonMultiple)));
    if (sizing != nullptr) {
        showAutomatic(*sizing);
    }
    Findings findings;
    if (sizing != nullptr) {
        findings.append(sizing->findings);
    }
    if (clustering != nullptr && !content.counted) {
        findings.append(clustering->findings);
    }
    // While the slider moves, only figures do: notices that come and go would move what is under the mouse.
    if (!content.counted) {
        m_findings->set(findings);
    }
}

}  // namespace rubble::widgets
