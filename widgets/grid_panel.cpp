#include "widgets/grid_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QTableWidget>
#include <cmath>

#include "widgets/parameter_editor.h"
#include "widgets/theme.h"
#include "widgets/wording.h"

namespace rubble::widgets {

namespace {

constexpr int sliderSteps = 400;
constexpr double leastMultiple = 0.5;
constexpr double greatestMultiple = 50.0;

QTableWidgetItem* figureCell(const QString& text, Qt::Alignment alignment = Qt::AlignRight | Qt::AlignVCenter) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment(alignment);
    item->setFlags(Qt::ItemIsEnabled);
    return item;
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
      m_slider(new QSlider(Qt::Horizontal)),
      m_table(new QTableWidget(3, 5)),
      m_clamps(new Notice),
      m_findings(new FindingList) {
    PanelGroup* target = addGroup(tr("Target"));
    addParameter(target, "fps_target");
    addParameter(target, "bodies_max");
    PanelGroup* size = addGroup(tr("Size"));
    addParameter(size, "multiple");
    m_slider->setRange(0, sliderSteps);
    m_slider->setAccessibleName(tr("Multiple of mean distance"));
    m_slider->setToolTip(tr("Drag to set the multiple; the clusters are counted anew while you drag."));
    size->addWide(m_slider);
    buildTable(size);
    size->addWide(m_clamps);
    connect(m_slider, &QSlider::sliderPressed, this, &GridPanel::draggingStarted);
    connect(m_slider, &QSlider::sliderReleased, this, &GridPanel::draggingEnded);
    connect(m_slider, &QSlider::valueChanged, this,
            [this](int position) { emit edited(QStringLiteral("multiple"), ParameterValue(multipleAt(position))); });

    PanelGroup* result = addGroup(tr("Result"));
    m_fragments = result->addValue(tr("Fragments"));
    m_clusters = result->addValue(tr("Clusters"), {}, tr("Rigid bodies that the engine moves, counted at these sizes"));
    m_perCluster = result->addValue(tr("Fragments in a cluster, mean"));
    m_splits = result->addValue(tr("Split by component, by velocity"), {},
                                tr("Clusters added because none may span two components, or because a fragment moves otherwise"));
    m_stopped = result->addNote({});
    addWide(m_findings);
    addRemaining(Stage::Sizing, tr("By hand"));
    addRemaining(Stage::Clusters, tr("Clusters"));
    setContent({});
}

void GridPanel::buildTable(PanelGroup* group) {
    m_table->setHorizontalHeaderLabels({tr("axis"), tr("d"), tr("size"), tr("fragment"), tr("component")});
    const std::array tips = {tr("Axis of the model"), tr("Mean distance of adjacent fragments, m"),
                             tr("Chosen size of the Basic Grid, m"), tr("Largest fragment: the least sensible size, m"),
                             tr("Smallest component: the greatest sensible size, m")};
    for (int column = 0; column < 5; ++column) {
        m_table->horizontalHeaderItem(column)->setToolTip(tips[static_cast<std::size_t>(column)]);
        m_table->horizontalHeaderItem(column)->setTextAlignment(column == 0 ? Qt::AlignLeft : Qt::AlignRight);
    }
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(4, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setMinimumSectionSize(24);
    m_table->horizontalHeader()->setFont(headingFont());
    m_table->setShowGrid(false);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setFocusPolicy(Qt::NoFocus);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const int line = m_table->fontMetrics().height() + 10;
    m_table->verticalHeader()->setDefaultSectionSize(line);
    m_table->setFixedHeight(4 * line + 4);
    group->addWide(m_table);
    group->addNote(tr("metres; d is the mean distance of adjacent fragments"));
}

void GridPanel::setScenario(const Scenario& scenario) {
    Panel::setScenario(scenario);
    if (scenario.grid.multiple) {
        const QSignalBlocker quiet(m_slider);
        m_slider->setValue(positionOf(*scenario.grid.multiple));
    }
}

void GridPanel::setContent(const Content& content) {
    QString sentences;
    for (int row = 0; row < 3; ++row) {
        const char name = "xyz"[row];
        m_table->setItem(row, 0, figureCell(QString(QLatin1Char(name)), Qt::AlignLeft | Qt::AlignVCenter));
        if (content.sizing == nullptr) {
            for (int column = 1; column < 5; ++column) {
                m_table->setItem(row, column, figureCell(QString(QChar(0x2013))));
            }
            continue;
        }
        const AxisSizing& axis = content.sizing->axis[static_cast<std::size_t>(row)];
        showAxis(row, axis, content);
        if (const QString sentence = clampSentence(name, axis, content); !sentence.isEmpty()) {
            sentences += (sentences.isEmpty() ? QString() : QStringLiteral("\n")) + sentence;
        }
    }
    m_clamps->set(Notice::Kind::Finding, sentences);
    showResult(content);
}

void GridPanel::showAxis(int row, const AxisSizing& axis, const Content& content) {
    const std::array values = {axis.meanDistance, axis.size, axis.accuracyMin, axis.accuracyMax};
    for (int column = 1; column < 5; ++column) {
        m_table->setItem(row, column, figureCell(shownNumber(values[static_cast<std::size_t>(column - 1)])));
    }
    QFont bold = m_table->font();
    bold.setWeight(QFont::DemiBold);
    m_table->item(row, 2)->setFont(bold);
    const int limiting = axis.clampedBy == ClampedBy::FragmentSize ? 3 : axis.clampedBy == ClampedBy::ComponentSize ? 4 : -1;
    if (limiting > 0) {
        m_table->item(row, limiting)->setForeground(tints().finding);
    }
    if (axis.largestFragment && content.fragments != nullptr && content.mesh != nullptr) {
        const Fragment& fragment = content.fragments->list[at(*axis.largestFragment)];
        m_table->item(row, 3)->setToolTip(tr("Element %1").arg(shownCount(content.mesh->elementIds[at(fragment.element)])));
    }
    if (axis.smallestComponent && content.components != nullptr) {
        m_table->item(row, 4)->setToolTip(QString::fromStdString(content.components->list[at(*axis.smallestComponent)].name));
    }
}

QString GridPanel::clampSentence(char name, const AxisSizing& axis, const Content& content) const {
    const QString component = axis.smallestComponent && content.components != nullptr
                                  ? QString::fromStdString(content.components->list[at(*axis.smallestComponent)].name)
                                  : tr("the smallest component");
    const QString least = shownNumber(axis.accuracyMin);
    const QString most = shownNumber(axis.accuracyMax);
    const QChar which = QLatin1Char(name);
    switch (axis.clampedBy) {
        case ClampedBy::FragmentSize:
            return axis.accuracyMin > axis.accuracyMax ? tr("%1: the largest fragment (%2 m) exceeds the smallest component (%3, "
                                                            "%4 m). Clusters stay within one component "
                                                            "all the same.")
                                                             .arg(which)
                                                             .arg(least, component, most)
                                                       : tr("%1: held at the largest fragment, %2 m.").arg(which).arg(least);
        case ClampedBy::ComponentSize:
            return tr("%1: held at the smallest component (%2, %3 m).").arg(which).arg(component, most);
        case ClampedBy::Spacing:
            return tr("%1: the mean distance (%2 m) exceeds the smallest component (%3, %4 m).")
                .arg(which)
                .arg(shownNumber(axis.meanDistance), component, most);
        case ClampedBy::None:
            break;
    }
    return {};
}

void GridPanel::showResult(const Content& content) {
    const QString none(QChar(0x2013));
    const Sizing* sizing = content.sizing.get();
    m_fragments->setText(sizing != nullptr ? shownCount(static_cast<std::int64_t>(sizing->fragments)) : none);
    m_clusters->setText(sizing != nullptr ? shownCount(static_cast<std::int64_t>(sizing->clusters)) : none);
    m_perCluster->setText(sizing != nullptr && sizing->clusters > 0
                              ? shownNumber(static_cast<double>(sizing->fragments) / static_cast<double>(sizing->clusters))
                              : none);
    const Clustering* clustering = content.clustering.get();
    m_splits->setText(clustering != nullptr
                          ? QStringLiteral("%1, %2").arg(shownCount(static_cast<std::int64_t>(clustering->splitByComponent)),
                                                         shownCount(static_cast<std::int64_t>(clustering->splitByVelocity)))
                          : none);
    QString stopped;
    if (sizing == nullptr) {
        stopped = tr("Open a result: the sizes that meet the live frame rate appear here.");
    } else if (sizing->stoppedBy == StoppedBy::Efficiency) {
        stopped = tr("The search stopped at the smallest multiple that keeps to the bodies allowed.");
    } else if (sizing->stoppedBy == StoppedBy::FpsUnreachable) {
        stopped = tr("%1 FPS is out of reach within the bounds of the sizes: about %2 FPS is. The run goes on at the upper bounds.")
                      .arg(shownNumber(sizing->fpsTarget), shownNumber(sizing->reachableFps, 2));
    } else {
        stopped = tr("Set by hand.");
    }
    if (sizing != nullptr) {
        stopped += QLatin1Char(' ') + tr("Few fragments share a birth time in a result with many states, so the multiple is larger "
                                         "than the two to three of the published method.");
        editor(QStringLiteral("multiple"))->setAutomaticValue(sizing->commonMultiple);
        const std::array<const char*, 3> keys = {"grid_l", "grid_w", "grid_h"};
        for (std::size_t i = 0; i < 3; ++i) {
            if (ParameterEditor* field = editor(QLatin1String(keys[i]))) {
                field->setAutomaticValue(sizing->axis[i].size);
            }
        }
        if (!m_slider->isSliderDown()) {
            const QSignalBlocker quiet(m_slider);
            m_slider->setValue(positionOf(sizing->commonMultiple));
        }
    }
    m_slider->setEnabled(sizing != nullptr && sizing->fragments > 0);
    m_stopped->setText(stopped);
    Findings findings;
    if (sizing != nullptr) {
        findings.append(sizing->findings);
    }
    if (clustering != nullptr) {
        findings.append(clustering->findings);
    }
    m_findings->set(findings);
}

}  // namespace rubble::widgets
