#include "widgets/evidence/ensemble_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QResizeEvent>
#include <QSplitter>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/evidence/ensembles/member_doubts.h"
#include "widgets/basics/language.h"
#include "widgets/basics/map_view.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

constexpr int ensembleBesideFrom = 1400;  // px: narrower, the table stands below the map
constexpr int rowHeight = 24;
constexpr int headingHeight = 30;

/// With as many digits as the standard error of the mean leaves.
QString deserved(double value, double error, std::string_view unit) {
    if (!(error > 0.0) || !(value != 0.0)) {
        return shownIn(value, unit, 4);
    }
    const int digits =
        2 + static_cast<int>(std::floor(std::log10(std::abs(value)))) - static_cast<int>(std::floor(std::log10(error)));
    return shownIn(value, unit, std::clamp(digits, 1, 6));
}

}  // namespace

EnsemblePage::EnsemblePage(QWidget* parent)
    : QWidget(parent),
      m_sentence(new QLabel),
      m_notice(new Notice),
      m_layer(new QComboBox),
      m_onGround(new QToolButton),
      m_saveMap(new QPushButton(tr("Save map…"))),
      m_saveTable(new QPushButton(tr("Save table…"))),
      m_choices(nullptr),
      m_splitter(new QSplitter(Qt::Horizontal)),
      m_map(new MapView),
      m_spread(new QTableWidget(0, 7)),
      m_error(new QLabel) {
    QVBoxLayout* column = pageColumn(*this, tr("Where debris may lie"));
    m_sentence->setObjectName(QStringLiteral("muted"));
    m_sentence->setWordWrap(true);
    column->addWidget(m_sentence);
    column->addWidget(m_choices = buildChoices());
    column->addWidget(m_notice);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(9);
    m_splitter->addWidget(m_map);
    m_splitter->addWidget(buildSpread());
    m_splitter->setStretchFactor(0, 3);
    m_splitter->setStretchFactor(1, 2);
    column->addWidget(m_splitter, 1);
    column->addStretch();
    connect(m_saveMap, &QPushButton::clicked, this, &EnsemblePage::saveMapRequested);
    connect(m_saveTable, &QPushButton::clicked, this, &EnsemblePage::saveTableRequested);
    connect(m_onGround, &QToolButton::toggled, this, &EnsemblePage::onGroundChanged);
    connect(m_layer, &QComboBox::activated, this, [this] {
        showMap();
        emit layerChanged(layer());
    });
    setContent({});
}

QWidget* EnsemblePage::buildChoices() {
    auto* choices = new QWidget;
    auto* row = new QHBoxLayout(choices);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    auto* label = new QLabel(tr("Show"));
    label->setBuddy(m_layer);
    m_layer->setObjectName(QStringLiteral("ensembleLayer"));
    m_layer->setAccessibleName(tr("Layer of the map"));
    m_layer->setToolTip(tr("What the colours of the map say"));
    m_layer->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    row->addWidget(label);
    row->addWidget(m_layer);
    m_onGround->setText(tr("On the ground"));
    m_onGround->setObjectName(QStringLiteral("onGround"));
    m_onGround->setAccessibleName(m_onGround->text());
    m_onGround->setCheckable(true);
    m_onGround->setFocusPolicy(Qt::TabFocus);
    m_onGround->setToolTip(tr("Lay this map on the ground of the views, below the debris"));
    row->addWidget(m_onGround);
    row->addStretch();
    m_saveMap->setToolTip(tr("Save the map as GeoTIFF or CSV with all layers, or this layer as PNG"));
    m_saveTable->setToolTip(
        tr("Save what every member was given and what came of it, as CSV with the columns of rubble-cli ensemble"));
    row->addWidget(m_saveMap);
    row->addWidget(m_saveTable);
    return choices;
}

QWidget* EnsemblePage::buildSpread() {
    auto* right = new QWidget;
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* title = new QLabel(tr("Spread over the members"));
    QFont bold = textFont();
    bold.setWeight(QFont::DemiBold);
    title->setFont(bold);
    column->addWidget(title);
    m_spread->setAccessibleName(title->text());
    m_spread->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_spread->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_spread->setTabKeyNavigation(false);
    m_spread->setShowGrid(false);
    m_spread->verticalHeader()->hide();
    m_spread->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_spread->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_spread->horizontalHeader()->setHighlightSections(false);
    // All figures are seen; the map takes the rest.
    m_spread->setMinimumHeight(static_cast<int>(memberMeasureCount) * rowHeight + headingHeight);
    column->addWidget(m_spread, 1);
    m_error->setObjectName(QStringLiteral("muted"));
    m_error->setWordWrap(true);
    column->addWidget(m_error);
    return right;
}

MapLayer EnsemblePage::layer() const {
    const QVariant chosen = m_layer->currentData();
    return chosen.isValid() ? static_cast<MapLayer>(chosen.toInt()) : MapLayer::Probability;
}

void EnsemblePage::setLayer(MapLayer layer) {
    m_layer->setCurrentIndex(std::max(0, m_layer->findData(static_cast<int>(layer))));
    showMap();
    emit layerChanged(layer);
}

bool EnsemblePage::onGround() const {
    return m_onGround->isChecked();
}

void EnsemblePage::setOnGround(bool on) {
    m_onGround->setChecked(on);
}

void EnsemblePage::setContent(const Content& content) {
    m_content = content;
    const bool have = content.report != nullptr;
    const bool mapped = content.map != nullptr;
    m_splitter->setVisible(have);
    m_choices->setVisible(have);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_layer, m_onGround, m_saveMap, m_saveTable}) {
        widget->setEnabled(mapped);
    }
    if (!have) {
        m_sentence->clear();
        m_notice->set(Notice::Kind::Note, tr("No ensemble has been simulated yet."),
                      tr("State at the left what is not known and press Simulate members: the collapse is simulated again and "
                         "again, and the map shows how often debris lies where."));
    } else {
        const auto done = static_cast<std::int64_t>(content.report->done().size());
        const auto all = static_cast<std::int64_t>(content.report->members.size());
        const bool rest = content.report->instant == DebrisInstant::AtRest;
        m_sentence->setText(
            tr("%1 of %2 members done, debris %3, %4, cells of %5.")
                .arg(shownCount(done), shownCount(all),
                     !rest                        ? tr("at the end of the FE result")
                     : allAtRest(*content.report) ? tr("at rest")
                                                  : tr("where each member ended, not all at rest"),
                     content.report->surface.withFallen ? tr("fallen structure with it") : tr("fallen structure apart"),
                     QStringLiteral("%1 %2").arg(
                         QLocale().toString(content.report->surface.cell * figures::shownUnit("m").perSi, 'g', 3),
                         figures::shownUnit("m").name)));
        m_notice->set(Notice::Kind::Note,
                      content.stale ? tr("The case has changed since these members were simulated.") : QString(),
                      tr("They are shown as they were. Simulate again to bring them up to date."));
    }
    fillLayers();
    showMap();
    showSpread();
}

void EnsemblePage::fillLayers() {
    const MapLayer before = layer();
    m_layer->clear();
    if (m_content.map == nullptr) {
        return;
    }
    for (const MapLayer each : m_content.map->present()) {
        m_layer->addItem(worded(mapLayerTitle(*m_content.map, each)), static_cast<int>(each));
        m_layer->setItemData(m_layer->count() - 1, said("messages", mapLayerRow(each).help), Qt::ToolTipRole);
    }
    m_layer->setCurrentIndex(std::max(0, m_layer->findData(static_cast<int>(before))));
}

void EnsemblePage::showMap() {
    m_map->setMap(m_content.map, layer(), m_content.place);
}

void EnsemblePage::setHeads() {
    const bool many = m_content.report == nullptr || spreadOf(*m_content.report, MemberMeasure::RunOut).hasTwentieths();
    const std::array<std::pair<QString, QString>, 7> heads{
        {{tr("figure"), tr("What is measured on every member")},
         {tr("mean"), tr("Mean of the members")},
         {tr("± mean"), tr("Standard error of the mean: how far it may be off for so few members")},
         {tr("± members"), tr("Standard deviation of the members: how far one differs from another")},
         many ? std::pair{tr("5 %"), tr("One member in twenty lies below")}
              : std::pair{tr("least"), tr("Of all members, which are few")},
         {tr("median"), tr("Half of the members lie below")},
         many ? std::pair{tr("95 %"), tr("One member in twenty lies above")}
              : std::pair{tr("most"), tr("Of all members, which are few")}}};
    for (int i = 0; i < static_cast<int>(heads.size()); ++i) {
        m_spread->setHorizontalHeaderItem(
            i, tableCell(heads[static_cast<std::size_t>(i)].first, i == 0, heads[static_cast<std::size_t>(i)].second));
    }
}

void EnsemblePage::showSpread() {
    setHeads();
    m_spread->setRowCount(0);
    m_error->clear();
    if (m_content.report == nullptr) {
        return;
    }
    const EnsembleReport& report = *m_content.report;
    for (std::size_t k = 0; k < memberMeasureCount; ++k) {
        const auto measure = static_cast<MemberMeasure>(k);
        const MemberMeasureRow& row = memberMeasureRow(measure);
        const FigureSpread spread = spreadOf(report, measure);
        const int line = m_spread->rowCount();
        m_spread->insertRow(line);
        const QString name = tr("%1, %2").arg(said("messages", row.name), figures::shownUnit(row.toldUnit).name);
        const auto told = [&](double value) { return value * row.toldPerUnit; };
        const auto shown = [&](double value) { return deserved(told(value), told(spread.standardError), row.toldUnit); };
        const bool same = spread.deviation == 0.0;
        const std::array<QString, 7> texts{name,
                                           shown(spread.mean),
                                           same ? tr("none") : shownIn(told(spread.standardError), row.toldUnit, 2),
                                           same ? tr("none") : shownIn(told(spread.deviation), row.toldUnit, 2),
                                           shown(spread.lower()),
                                           shown(spread.middle),
                                           shown(spread.upper())};
        for (int i = 0; i < static_cast<int>(texts.size()); ++i) {
            const QString& text = texts[static_cast<std::size_t>(i)];
            const QString tip = same && (i == 2 || i == 3) ? tr("the same in all members") : text;
            m_spread->setItem(line, i, tableCell(text, i == 0, QStringLiteral("%1: %2").arg(name, tip)));
        }
    }
    m_spread->resizeColumnsToContents();
    const std::vector<ConvergenceRow> rows = convergenceOf(report);
    if (!rows.empty()) {
        m_error->setText(
            tr("With %1 members the probability of a cell may be off by %2 in the mean and by %3 at most, one standard "
               "error. That covers what was varied and nothing else.")
                .arg(shownCount(static_cast<std::int64_t>(rows.back().members)), shownNumber(rows.back().probabilityError, 2),
                     shownNumber(rows.back().worstError, 2)));
    }
}

void EnsemblePage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_splitter->setOrientation(event->size().width() >= ensembleBesideFrom ? Qt::Horizontal : Qt::Vertical);
}

}  // namespace rubble::widgets
