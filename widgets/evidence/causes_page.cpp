#include "widgets/evidence/causes_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/map_view.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/evidence/cause_chart.h"

namespace rubble::widgets {

namespace {

constexpr int causesBesideFrom = 1300;  // px: narrower, the map stands below the chart

void prepare(QTableWidget& table, const QString& name) {
    table.setAccessibleName(name);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setTabKeyNavigation(false);
    table.setShowGrid(false);
    table.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table.verticalHeader()->hide();
    table.verticalHeader()->setDefaultSectionSize(26);
    table.horizontalHeader()->setHighlightSections(false);
}

void setHeads(QTableWidget& table, const std::vector<std::pair<QString, QString>>& heads) {
    table.setColumnCount(static_cast<int>(heads.size()));
    for (int i = 0; i < table.columnCount(); ++i) {
        const auto& [text, tip] = heads[static_cast<std::size_t>(i)];
        table.setHorizontalHeaderItem(i, tableCell(text, i == 0, tip));
    }
}

/// As tall as its rows.
void fitHeight(QTableWidget& table) {
    const int rows = std::min(table.rowCount(), 12);
    table.setFixedHeight(rows * 26 + table.horizontalHeader()->sizeHint().height() + 18);
}

QString withSpread(const FigureSpread& spread) {
    return std::isfinite(spread.deviation)
               ? QStringLiteral("%1 ± %2").arg(shownNumber(spread.mean, 3), shownNumber(spread.deviation, 2))
               : shownNumber(spread.mean, 3);
}

QString fileOf(const std::string& evidence) {
    return QString::fromStdString(evidence).section(u'/', -1);
}

}  // namespace

CausesPage::CausesPage(QWidget* parent)
    : QWidget(parent),
      m_sentence(new QLabel),
      m_verdict(new Notice),
      m_stale(new Notice),
      m_saveTable(new QPushButton(tr("Save table…"))),
      m_saveChart(new QPushButton(tr("Save chart…"))),
      m_saveMap(new QPushButton(tr("Save map…"))),
      m_splitter(new QSplitter(Qt::Vertical)),
      m_chart(new CauseChart),
      m_mapSide(new QWidget),
      m_map(new MapView),
      m_telling(new QLabel),
      m_table(new QTableWidget),
      m_blindTitle(new QLabel),
      m_blind(new QTableWidget),
      m_furtherTitle(new QLabel),
      m_further(new QTableWidget) {
    QVBoxLayout* column = pageColumn(*this, tr("Which cause explains the evidence"));
    m_sentence->setObjectName(QStringLiteral("muted"));
    m_sentence->setWordWrap(true);
    column->addWidget(m_sentence);
    column->addWidget(m_verdict);
    column->addWidget(m_stale);
    auto* side = new QVBoxLayout(m_mapSide);
    side->setContentsMargins(0, 0, 0, 0);
    side->addWidget(m_map, 1);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(9);
    m_splitter->addWidget(m_chart);
    m_splitter->addWidget(m_mapSide);
    column->addWidget(m_splitter, 1);
    m_telling->setWordWrap(true);
    m_telling->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_telling);
    prepare(*m_table, tr("Ranking of the causes"));
    column->addWidget(m_table);
    QFont bold = textFont();
    bold.setWeight(QFont::DemiBold);
    m_blindTitle->setFont(bold);
    m_blindTitle->setWordWrap(true);
    m_furtherTitle->setFont(bold);
    m_furtherTitle->setWordWrap(true);
    column->addWidget(m_furtherTitle);
    prepare(*m_further, tr("Which evidence would tell"));
    column->addWidget(m_further);
    column->addWidget(m_blindTitle);
    prepare(*m_blind, tr("Blind test"));
    column->addWidget(m_blind);
    column->addWidget(m_buttons = buildButtons());
    column->addStretch();
    setContent({});
}

QWidget* CausesPage::buildButtons() {
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    m_saveTable->setToolTip(tr("Save the ranking as CSV, with the columns of rubble-cli compare"));
    m_saveChart->setToolTip(tr("Save the chart as SVG or PNG"));
    m_saveMap->setToolTip(tr("Save the map of what tells the first two causes apart as GeoTIFF, CSV or PNG"));
    row->addWidget(m_saveTable);
    row->addWidget(m_saveChart);
    row->addWidget(m_saveMap);
    row->addStretch();
    connect(m_saveTable, &QPushButton::clicked, this, &CausesPage::saveTableRequested);
    connect(m_saveChart, &QPushButton::clicked, this, &CausesPage::saveChartRequested);
    connect(m_saveMap, &QPushButton::clicked, this, &CausesPage::saveMapRequested);
    return buttons;
}

const FileChart& CausesPage::chart() const {
    return *m_chart;
}

void CausesPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_splitter->setOrientation(event->size().width() >= causesBesideFrom ? Qt::Horizontal : Qt::Vertical);
}

void CausesPage::setContent(const Content& content) {
    m_content = content;
    const bool compared = content.comparison != nullptr;
    const bool mapped = compared && content.separation != nullptr;
    m_splitter->setVisible(compared);
    m_table->setVisible(compared);
    m_mapSide->setVisible(mapped);
    m_buttons->setVisible(compared);
    m_saveMap->setEnabled(mapped);
    m_chart->setComparison(content.comparison);
    figures::MapPictureStyle style = content.place;
    if (mapped && content.comparison->place) {
        const TellingPlace& place = *content.comparison->place;
        style.ring = figures::MapRing{place.middle, place.radius()};
    }
    m_map->setMap(mapped ? content.separation : nullptr, MapLayer::Separation, style);
    showVerdict();
    showTelling();
    showRanking();
    showFurther();
    showBlind();
}

void CausesPage::showVerdict() {
    const auto& made = m_content.comparison;
    const bool any = made != nullptr || !m_content.blind.empty();
    m_stale->set(Notice::Kind::Note, any && m_content.stale ? tr("Causes, evidence or settings have changed since.") : QString(),
                 tr("What is shown is as it was. Compare again to bring it up to date."));
    if (!any) {
        m_sentence->clear();
        m_verdict->set(Notice::Kind::Note, tr("No causes have been compared yet."),
                       tr("Tick the supposed causes at the left, add what was found on the site, and press Compare causes. Every "
                          "cause gets an ensemble; those that come closest to what was found come first, or it is said that they "
                          "cannot be told apart."));
        return;
    }
    if (made == nullptr) {
        m_sentence->setText(tr("There was no evidence: the blind tests below say what evidence could tell at best."));
        m_verdict->set(Notice::Kind::Note, {});
        return;
    }
    m_sentence->setText(tr("Each dot is one member of an ensemble, held against the evidence that was chosen."));
    m_verdict->set(made->ranking.decided() && !made->unexplained ? Notice::Kind::Note : Notice::Kind::Finding,
                   worded(made->verdict));
}

void CausesPage::showTelling() {
    const auto& made = m_content.comparison;
    QStringList parts;
    if (made != nullptr && made->ranking.causes.size() > 1) {
        const Superiority& best = made->ranking.causes[1].bestOverEvidence[made->telling];
        // Half of the pairs is what chance gives.
        parts << (best.share > 0.5
                      ? tr("%1 tells most: there the closest cause is closer than the next in %2 of the pairs of members.")
                            .arg(fileOf(made->evidence[made->telling]), shownShare(best.share))
                      : tr("No evidence tells the first two apart: at best the closest cause is closer than the next in %1 of the "
                           "pairs of members.")
                            .arg(shownShare(best.share)));
        if (made->place) {
            parts << tr("On the ground %1 of what speaks for it lies around x = %2, y = %3, on %4 (ringed).")
                         .arg(shownShare(made->place->share, 0), shownLength(made->place->middle.x()),
                              shownLength(made->place->middle.y()), shownWith(made->place->area, "m2"));
        }
    }
    m_telling->setText(parts.join(u' '));
    m_telling->setVisible(!parts.isEmpty());
}

void CausesPage::showRanking() {
    m_table->setRowCount(0);
    const auto& made = m_content.comparison;
    if (made == nullptr) {
        return;
    }
    const bool many =
        std::ranges::all_of(made->ranking.causes, [](const RankedCause& cause) { return cause.score.hasTwentieths(); });
    std::vector<std::pair<QString, QString>> heads{
        {tr("cause"), tr("The closest first")},
        {tr("members"), tr("Members that could be held against the evidence")},
        {tr("score"), tr("Median over the members of the mean departure, in units of its scatter; less is closer")},
        many ? std::pair{tr("5 to 95 %"), tr("All but one member in ten lie in between")}
             : std::pair{tr("least to most"), tr("All members lie in between")},
        {tr("closest over it"), tr("How often a member of the closest cause is closer than one of this, over all pairs")},
        {tr("at least"), tr("The lower end of its interval, 95 % for all comparisons together. Above 70 % they are told apart")},
        {tr("told apart"), tr("Whether the evidence tells it from the closest cause")}};
    for (std::size_t e = 0; e < made->evidence.size(); ++e) {
        heads.emplace_back(fileOf(made->evidence[e]),
                           tr("Departure from %1, 0 the same, 1 nothing in common: mean ± standard deviation of the members")
                               .arg(QString::fromStdString(made->evidence[e])));
    }
    setHeads(*m_table, heads);
    for (std::size_t r = 0; r < made->ranking.causes.size(); ++r) {
        const RankedCause& cause = made->ranking.causes[r];
        const int line = m_table->rowCount();
        m_table->insertRow(line);
        const QString dash(QChar(0x2013));
        QStringList texts{QString::fromStdString(made->hypotheses[cause.hypothesis]),
                          shownCount(static_cast<std::int64_t>(cause.score.count)),
                          shownNumber(cause.score.middle),
                          tr("%1 to %2")
                              .arg(shownNumber(many ? cause.score.low : cause.score.least),
                                   shownNumber(many ? cause.score.high : cause.score.most)),
                          r == 0 ? dash : shownShare(cause.bestOver.share, 0),
                          r == 0 ? dash : shownShare(cause.bestOver.low, 0),
                          standingWords(*made, r)};
        for (const FigureSpread& spread : cause.departures) {
            texts << withSpread(spread);
        }
        for (int i = 0; i < texts.size(); ++i) {
            m_table->setItem(line, i, tableCell(texts[i], i == 0, texts[i]));
        }
    }
    m_table->resizeColumnsToContents();
    fitHeight(*m_table);
}

void CausesPage::showFurther() {
    constexpr std::size_t shown = 8;
    m_further->setRowCount(0);
    const auto& further = m_content.further;
    const bool any = further != nullptr && !further->ranked.empty();
    m_further->setVisible(any);
    m_furtherTitle->setVisible(any);
    if (!any) {
        return;
    }
    QStringList causes;
    for (const std::size_t cause : further->causes) {
        causes << QString::fromStdString(cause < m_content.causes.size() ? m_content.causes[cause] : std::string());
    }
    m_furtherTitle->setText(
        tr("Which evidence would tell %1 apart. Each of %2 members in turn is what happened, seen without error.")
            .arg(causes.join(QStringLiteral(", ")), shownCount(further->ranked.front().named.trials)));
    setHeads(*m_further,
             {{tr("evidence"), tr("The one that names the cause most often first; the first of many is flattered by chance")},
              {tr("named rightly"), tr("Trials in which the true cause is told from the others, with what is at hand")},
              {tr("95 %"), tr("Interval of that share")},
              {tr("named wrongly"), tr("Trials in which another cause is told from the others")}});
    const auto add = [&](const QString& name, const BlindShare& named) {
        const int line = m_further->rowCount();
        m_further->insertRow(line);
        const double wrong = static_cast<double>(named.wrong) / static_cast<double>(std::max<std::int64_t>(named.trials, 1));
        m_further->setItem(line, 0, tableCell(name, true, name));
        m_further->setItem(line, 1, tableCell(shownShare(named.share(), 0), false, {}));
        m_further->setItem(line, 2,
                           tableCell(tr("%1 to %2").arg(shownShare(named.low(), 0), shownShare(named.high(), 0)), false, {}));
        m_further->setItem(line, 3, tableCell(shownShare(wrong, 0), false, {}));
    };
    if (further->atHand.trials > 0) {
        add(tr("what is at hand"), further->atHand);
    }
    for (std::size_t k = 0; k < std::min(shown, further->ranked.size()); ++k) {
        const QString name = worded(further->ranked[k].words());
        add(further->atHand.trials > 0 ? tr("and %1").arg(name) : name, further->ranked[k].named);
    }
    m_further->resizeColumnsToContents();
    fitHeight(*m_further);
}

void CausesPage::showBlind() {
    m_blind->setRowCount(0);
    const auto& names = m_content.causes;
    m_blind->setVisible(!m_content.blind.empty());
    m_blindTitle->setVisible(!m_content.blind.empty());
    if (m_content.blind.empty()) {
        return;
    }
    std::vector<std::pair<QString, QString>> heads{
        {tr("true cause"), tr("The cause that a member of was taken for what was found")}};
    for (const std::string& name : names) {
        heads.emplace_back(tr("named %1").arg(QString::fromStdString(name)), tr("Trials in which this cause was named"));
    }
    heads.emplace_back(tr("not told apart"), tr("Trials without a verdict"));
    heads.emplace_back(tr("closest rightly"), tr("Trials in which the true cause was the closest, told apart or not"));
    heads.emplace_back(
        tr("noticed if left out"),
        tr("Trials in which, with the true cause not among the hypotheses, perhaps none of them would be the verdict"));
    setHeads(*m_blind, heads);
    QStringList sums;
    for (const BlindTest& test : m_content.blind) {
        const QString kind = test.kind == EvidenceKind::Footprint ? tr("footprint") : tr("heights");
        sums << tr("%1: %2 of %3 named rightly, %4 wrongly")
                    .arg(kind, shownCount(test.right()), shownCount(test.trials()), shownCount(test.wrong()));
        for (std::size_t h = 0; h < names.size(); ++h) {
            const int line = m_blind->rowCount();
            m_blind->insertRow(line);
            m_blind->setItem(line, 0, tableCell(tr("%1, by %2").arg(QString::fromStdString(names[h]), kind), true, {}));
            int column = 1;
            for (const std::int64_t count : test.named[h]) {
                m_blind->setItem(line, column++, tableCell(shownCount(count), false, {}));
            }
            m_blind->setItem(line, column++, tableCell(shownCount(test.undecided[h]), false, {}));
            m_blind->setItem(line, column++, tableCell(shownCount(test.closest[h]), false, {}));
            m_blind->setItem(line, column,
                             tableCell(test.noticed.empty() ? tr("not known") : shownCount(test.noticed[h]), false, {}));
        }
    }
    m_blindTitle->setText(tr("Blind test, each member in turn is what was found. %1").arg(inOneLine(sums)));
    m_blind->resizeColumnsToContents();
    fitHeight(*m_blind);
}

}  // namespace rubble::widgets
