#include "widgets/accuracy/accuracy_page.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QResizeEvent>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/accuracy/accuracy_chart.h"
#include "widgets/accuracy/accuracy_table.h"
#include "widgets/accuracy/accuracy_words.h"
#include "widgets/basics/folding_bar.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr int besideFrom = 820;  // px: narrower, the table stands below the chart

}  // namespace

AccuracyPage::AccuracyPage(QWidget* parent)
    : QWidget(parent),
      m_accuracy(new QComboBox),
      m_costs(new QButtonGroup(this)),
      m_sentence(new QLabel),
      m_notice(new Notice),
      m_chart(new AccuracyChart),
      m_left(new QLabel),
      m_runs(new QLabel),
      m_table(new AccuracyTable),
      m_saveTable(new QPushButton(tr("Save table…"))),
      m_saveChart(new QPushButton(tr("Save chart…"))),
      m_splitter(new QSplitter(Qt::Horizontal)) {
    QVBoxLayout* column = pageColumn(*this, tr("What agreement with the reference costs"));
    m_sentence->setObjectName(QStringLiteral("muted"));
    m_sentence->setWordWrap(true);
    column->addWidget(m_sentence);
    column->addWidget(buildChoices());
    column->addWidget(m_notice);
    auto* left = new QWidget;
    auto* chart = new QVBoxLayout(left);
    chart->setContentsMargins(0, 0, 0, 0);
    chart->addWidget(m_chart, 1);
    m_left->setObjectName(QStringLiteral("muted"));
    m_left->setWordWrap(true);
    chart->addWidget(m_left);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(9);
    m_splitter->addWidget(left);
    m_splitter->addWidget(buildTable());
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setStretchFactor(1, 1);
    m_splitter->setSizes({400, 464});
    column->addWidget(m_splitter, 1);
    // Keeps the words together at the top while there is nothing below them.
    column->addStretch();
    connect(m_chart, &AccuracyChart::rowChosen, this, &AccuracyPage::rowChosen);
    connect(m_table, &AccuracyTable::rowChosen, this, &AccuracyPage::rowChosen);
    connect(m_saveTable, &QPushButton::clicked, this, &AccuracyPage::saveTableRequested);
    connect(m_saveChart, &QPushButton::clicked, this, &AccuracyPage::saveChartRequested);
    setContent({});
}

QWidget* AccuracyPage::buildChoices() {
    auto* choices = new FoldingBar;
    choices->layout()->setContentsMargins(0, 0, 0, 0);
    choices->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    QHBoxLayout* row = choices->add();
    row->setSpacing(8);
    auto* label = new QLabel(tr("Accuracy"));
    label->setBuddy(m_accuracy);
    m_accuracy->setAccessibleName(tr("Accuracy"));
    m_accuracy->setObjectName(QStringLiteral("accuracyKind"));
    m_accuracy->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    row->addWidget(label);
    row->addWidget(m_accuracy);
    row->addStretch();
    row = choices->add();
    row->setSpacing(8);
    row->addWidget(new QLabel(tr("Cost")));
    const std::array<QString, costKindCount> tips{
        tr("Clusters: each is moved by one rigid body. Known without a measurement of time"),
        tr("Milliseconds per step, mean from the first to the last birth"),
        tr("Wall time of the simulation from start to end, seconds"), tr("Frames per second of live mode: the more the better")};
    auto* segments = new QHBoxLayout;
    segments->setSpacing(0);
    for (std::size_t c = 0; c < costKindCount; ++c) {
        auto* button = new QToolButton;
        button->setText(costWords(static_cast<CostKind>(c)));
        button->setToolTip(tips[c]);
        button->setAccessibleName(tr("Cost: %1").arg(button->text()));
        button->setCheckable(true);
        button->setChecked(static_cast<CostKind>(c) == m_cost);
        button->setFocusPolicy(Qt::TabFocus);
        m_costs->addButton(button, static_cast<int>(c));
        segments->addWidget(button);
    }
    row->addLayout(segments);
    row->addStretch();
    fillKinds();
    setAccuracy({});
    connect(m_accuracy, &QComboBox::currentIndexChanged, this, &AccuracyPage::showPlot);
    connect(m_costs, &QButtonGroup::idClicked, this, [this](int id) { setCost(static_cast<CostKind>(id)); });
    return choices;
}

QWidget* AccuracyPage::buildTable() {
    auto* right = new QWidget;
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* heading = new QHBoxLayout;
    auto* title = new QLabel(tr("Settings compared"));
    QFont bold = textFont();
    bold.setWeight(QFont::DemiBold);
    title->setFont(bold);
    m_runs->setObjectName(QStringLiteral("muted"));
    heading->addWidget(title);
    heading->addWidget(m_runs);
    heading->addStretch();
    column->addLayout(heading);
    column->addWidget(m_table, 1);
    auto* buttons = new QHBoxLayout;
    m_saveTable->setToolTip(tr("Save all settings that are done as CSV, with the columns of rubble-cli accuracy"));
    m_saveChart->setToolTip(tr("Save the chart as SVG or PNG"));
    buttons->addWidget(m_saveTable);
    buttons->addWidget(m_saveChart);
    buttons->addStretch();
    column->addLayout(buttons);
    return right;
}

void AccuracyPage::fillKinds() {
    const std::vector<double> tolerances = m_content.report != nullptr && m_content.report->reference.done
                                               ? m_content.report->reference.difference.tolerances
                                               : MeasureSettings().tolerances;
    std::vector<AccuracyKind> kinds = accuracyKinds(tolerances);
    if (kinds == m_kinds) {
        return;
    }
    const AccuracyKind before = m_kinds.empty() ? kinds.front() : accuracy();
    m_kinds = std::move(kinds);
    const QSignalBlocker blocker(m_accuracy);
    m_accuracy->clear();
    for (const AccuracyKind& kind : m_kinds) {
        m_accuracy->addItem(accuracyWords(kind));
        m_accuracy->setItemData(m_accuracy->count() - 1, accuracyTip(kind), Qt::ToolTipRole);
    }
    setAccuracy(before);
}

AccuracyKind AccuracyPage::accuracy() const {
    return m_kinds.at(static_cast<std::size_t>(std::max(0, m_accuracy->currentIndex())));
}

void AccuracyPage::setAccuracy(const AccuracyKind& kind) {
    const auto found = std::find(m_kinds.begin(), m_kinds.end(), kind);
    m_accuracy->setCurrentIndex(found != m_kinds.end() ? static_cast<int>(found - m_kinds.begin()) : 0);
}

void AccuracyPage::setCost(CostKind kind) {
    m_costs->button(static_cast<int>(kind))->setChecked(true);
    m_cost = kind;
    m_costChosen = true;
    showPlot();
}

void AccuracyPage::takeKnownCost() {
    if (m_costChosen || m_content.report == nullptr) {
        return;
    }
    const AccuracyReport& report = *m_content.report;
    const auto known = [&report](CostKind kind) {
        const auto has = [kind](const AccuracyPoint& point) { return point.done && std::isfinite(costOf(point, kind)); };
        return has(report.reference) || std::any_of(report.points.begin(), report.points.end(), has);
    };
    static constexpr std::array wanted{CostKind::StepMean, CostKind::Wall, CostKind::Fps, CostKind::Bodies};
    const auto* const found = std::find_if(wanted.begin(), wanted.end(), known);
    m_cost = found != wanted.end() ? *found : wanted.front();
    m_costs->button(static_cast<int>(m_cost))->setChecked(true);
}

void AccuracyPage::setContent(const Content& content) {
    m_content = content;
    fillKinds();
    takeKnownCost();
    const bool have = content.report != nullptr;
    m_splitter->setVisible(have);
    static const AccuracyReport nothing;
    const AccuracyReport& report = have ? *content.report : nothing;
    m_table->setReport(report, content.inUse);
    const auto done = std::count_if(report.points.begin(), report.points.end(), [](const AccuracyPoint& p) { return p.done; });
    const std::size_t repeats = report.floor ? report.floor->repeats.size() : 0;
    m_runs->setText(tr("%1 of %2 done, repeats of the reference: %3")
                        .arg(shownCount(done), shownCount(static_cast<std::int64_t>(report.points.size())),
                             shownCount(static_cast<std::int64_t>(repeats))));
    m_saveTable->setEnabled(report.reference.done);
    if (!have) {
        m_notice->set(
            Notice::Kind::Note, tr("Nothing has been compared yet."),
            tr("Choose settings at the left and press Compare: each is simulated, measured against the reference, in which "
               "every fragment is its own body, and then timed alone."));
    } else if (content.stale) {
        m_notice->set(Notice::Kind::Note, tr("The case has changed since these settings were compared."),
                      tr("Points are shown as they were and cannot be used. Compare again to bring them up to date."));
    } else {
        m_notice->set(Notice::Kind::Note, {});
    }
    showPlot();
}

void AccuracyPage::showPlot() {
    if (m_kinds.empty()) {
        return;
    }
    const AccuracyKind kind = accuracy();
    m_accuracy->setToolTip(accuracyTip(kind));
    const QString across = m_cost == CostKind::Fps ? tr("further right") : tr("further left");
    m_sentence->setText((m_cost == CostKind::Bodies
                             ? tr("Each point is one setting. Click a point to use it. %1 and %2 is better; differences inside the "
                                  "band mean nothing.")
                             : tr("Each point is one setting, run on this machine. Click a point to use it. %1 and %2 is better; "
                                  "differences inside the band mean nothing."))
                            .arg(kind.moreIsBetter() ? tr("Higher") : tr("Lower"), across));
    PlotContent content;
    if (m_content.report != nullptr) {
        content = plotContent(*m_content.report, m_cost, kind, m_content.inUse, m_content.fpsTarget);
    }
    QStringList notes;
    if (m_cost == CostKind::Bodies && !m_costChosen) {
        notes << tr("No time was measured on this machine: bodies stand for the cost.");
    }
    if (content.left > 0) {
        const QString left = shownCount(static_cast<std::int64_t>(content.left));
        notes << (m_content.running ? tr("Settings without both figures yet: %1.").arg(left)
                                    : tr("Settings without both figures: %1, see the table.").arg(left));
    }
    if (m_content.report != nullptr && !content.points.empty()) {
        if (!content.target) {
            notes << tr("Where %1 FPS lie is not known: no two points enclose it.")
                         .arg(QLocale().toString(m_content.fpsTarget, 'g', 4));
        }
        if (!m_content.inUse && !m_content.stale) {
            notes << tr("The current setting is none of the points.");
        }
    }
    m_left->setText(notes.join(u' '));
    m_left->setVisible(!notes.isEmpty());
    m_saveChart->setEnabled(!content.points.empty());
    m_table->bringForward(m_cost, kind);
    m_chart->setContent(std::move(content));
}

void AccuracyPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_splitter->setOrientation(event->size().width() >= besideFrom ? Qt::Horizontal : Qt::Vertical);
}

}  // namespace rubble::widgets
