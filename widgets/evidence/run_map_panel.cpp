#include "widgets/evidence/run_map_panel.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "widgets/basics/folding_bar.h"
#include "widgets/basics/language.h"
#include "widgets/basics/map_view.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

constexpr std::array contourSteps{0.0, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0};  // m
constexpr double smallestCell = 1e-4;                                   // m
constexpr double largestCell = 100.0;                                   // m

/// Groups of fields beside each other; below each other where the map has little room, so that the window need not grow.
FoldingBar* newRow() {
    auto* row = new FoldingBar;
    row->layout()->setContentsMargins(0, 0, 0, 0);
    // What is left over belongs to the map.
    row->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    return row;
}

QHBoxLayout* groupOf(FoldingBar& row) {
    QHBoxLayout* group = row.add();
    group->setSpacing(8);
    return group;
}

void addNamed(QHBoxLayout& row, const QString& name, QWidget* field, const QString& tip) {
    auto* label = new QLabel(name);
    label->setBuddy(field);
    label->setToolTip(tip);
    field->setToolTip(tip);
    field->setAccessibleName(name);
    row.addWidget(label);
    row.addWidget(field);
}

}  // namespace

RunMapPanel::RunMapPanel(QWidget* parent)
    : QWidget(parent),
      m_layer(new QComboBox),
      m_onGround(new QToolButton),
      m_save(new QPushButton(tr("Save map…"))),
      m_when(new QComboBox),
      m_cell(new NumberField(tr("Cells"))),
      m_contours(new QComboBox),
      m_notice(new Notice),
      m_map(new MapView),
      m_cautions(new Notice),
      m_ledger(new QLabel) {
    setObjectName(QStringLiteral("panelBody"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    column->setSpacing(6);
    column->addWidget(buildLayerRow());
    column->addWidget(buildTimeRow());
    column->addWidget(buildOverlayRow());
    column->addWidget(m_notice);
    m_map->setObjectName(QStringLiteral("runMap"));
    column->addWidget(m_map, 1);
    m_cautions->setObjectName(QStringLiteral("mapCautions"));
    column->addWidget(m_cautions);
    m_ledger->setObjectName(QStringLiteral("muted"));
    m_ledger->setWordWrap(true);
    column->addWidget(m_ledger);
    // Without a map the rows stay together at the top.
    column->addStretch();
    showChoice();
    setContent({});
}

QWidget* RunMapPanel::buildLayerRow() {
    FoldingBar* widget = newRow();
    QHBoxLayout* row = groupOf(*widget);
    m_layer->setObjectName(QStringLiteral("mapLayer"));
    m_layer->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    addNamed(*row, tr("Show"), m_layer, tr("What the colours of the map say"));
    row->setStretchFactor(m_layer, 1);
    row = groupOf(*widget);
    m_onGround->setText(tr("On the ground"));
    m_onGround->setObjectName(QStringLiteral("mapOnGround"));
    m_onGround->setAccessibleName(m_onGround->text());
    m_onGround->setCheckable(true);
    m_onGround->setFocusPolicy(Qt::TabFocus);
    m_onGround->setToolTip(tr("Lay this map on the ground of the views, below the debris"));
    row->addWidget(m_onGround);
    m_save->setObjectName(QStringLiteral("saveMap"));
    m_save->setToolTip(tr("Save the map as GeoTIFF, GeoPackage or CSV with all layers, or as the picture that stands here"));
    row->addWidget(m_save);
    row->addStretch();
    connect(m_layer, &QComboBox::activated, this, [this] {
        m_choice.layer = static_cast<MapLayer>(m_layer->currentData().toInt());
        draw();
        emit drawnChanged();
    });
    connect(m_onGround, &QToolButton::toggled, this, [this](bool on) {
        if (!m_showing) {
            m_choice.onGround = on;
            emit drawnChanged();
        }
    });
    connect(m_save, &QPushButton::clicked, this, &RunMapPanel::saveRequested);
    return widget;
}

QWidget* RunMapPanel::buildTimeRow() {
    FoldingBar* widget = newRow();
    QHBoxLayout* row = groupOf(*widget);
    m_when->setObjectName(QStringLiteral("mapWhen"));
    m_when->addItem(tr("at the end"));
    m_when->addItem(tr("as the views"));
    addNamed(*row, tr("Debris"), m_when, tr("At the end of the run, or at the instant that the views show"));
    m_cell->setObjectName(QStringLiteral("mapCell"));
    m_cell->setUnit("m");
    m_cell->setRange(smallestCell, largestCell);
    m_cell->setMinimumWidth(84);
    addNamed(*row, tr("Cells [%1]").arg(figures::shownUnit("m").name), m_cell,
             tr("Side of a cell of the map. Left empty it is 0.25 m, or less where the fragments are smaller"));
    row->addStretch();
    row = groupOf(*widget);
    m_contours->setObjectName(QStringLiteral("mapContours"));
    for (const double step : contourSteps) {
        m_contours->addItem(step == 0.0 ? tr("none") : shownLength(step, 2), step);
    }
    addNamed(*row, tr("Contours"), m_contours, tr("Lines of equal height of the debris, so far apart"));
    row->addStretch(1);
    connect(m_when, &QComboBox::activated, this, [this](int index) {
        m_choice.atEnd = index == 0;
        emit mapRequested();
    });
    connect(m_cell, &NumberField::edited, this, [this](std::optional<double> cell) {
        m_choice.cell = cell;
        emit mapRequested();
    });
    connect(m_contours, &QComboBox::activated, this, [this] {
        m_choice.contours = m_contours->currentData().toDouble();
        draw();
        emit drawnChanged();
    });
    return widget;
}

QCheckBox* RunMapPanel::overlay(const QString& text, const QString& tip, const char* name, bool RunMapChoice::* shown) {
    auto* box = new QCheckBox(text);
    box->setObjectName(QLatin1String(name));
    box->setToolTip(tip);
    connect(box, &QCheckBox::toggled, this, [this, shown](bool on) {
        if (m_showing) {
            return;
        }
        m_choice.*shown = on;
        if (shown == &RunMapChoice::live) {
            emit mapRequested();
        } else {
            draw();
            emit drawnChanged();
        }
    });
    return box;
}

QWidget* RunMapPanel::buildOverlayRow() {
    FoldingBar* widget = newRow();
    QHBoxLayout* row = groupOf(*widget);
    m_live =
        overlay(tr("Fallen live structure"), tr("Live elements that fell, in layers of their own"), "mapLive", &RunMapChoice::live);
    m_structure = overlay(tr("Structure"), tr("Outlines in plan: of what collapsed, as it stood, and of what still stands"),
                          "mapStructure", &RunMapChoice::structure);
    m_evidence = overlay(tr("Evidence"), tr("Outlines that were surveyed, and the areas in which surveys are compared"),
                         "mapEvidence", &RunMapChoice::evidence);
    row->addWidget(m_live);
    row = groupOf(*widget);
    row->addWidget(m_structure);
    row->addWidget(m_evidence);
    row->addStretch(1);
    return widget;
}

void RunMapPanel::setChoice(const RunMapChoice& choice) {
    m_choice = choice;
    showChoice();
    draw();
}

void RunMapPanel::showChoice() {
    const QScopedValueRollback showing(m_showing, true);
    m_onGround->setChecked(m_choice.onGround);
    m_when->setCurrentIndex(m_choice.atEnd ? 0 : 1);
    m_cell->setNumber(m_choice.cell);
    m_contours->setCurrentIndex(std::max(0, m_contours->findData(m_choice.contours)));
    m_live->setChecked(m_choice.live);
    m_structure->setChecked(m_choice.structure);
    m_evidence->setChecked(m_choice.evidence);
}

void RunMapPanel::setContent(const Content& content) {
    m_content = content;
    const bool mapped = content.map != nullptr;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_layer, m_onGround, m_save}) {
        widget->setEnabled(mapped);
    }
    m_map->setVisible(mapped);
    m_notice->set(Notice::Kind::Note, content.making && !mapped ? tr("Mapping the debris …") : content.why);
    m_cautions->set(Notice::Kind::Finding, mapped ? QString::fromStdString(content.place.cautions) : QString());
    const bool usual = mapped && content.map->cellFrom > 0.0;
    m_cell->setEmptyMeans(usual ? tr("auto: %1").arg(shownNumber(content.map->map.cell * figures::shownUnit("m").perSi, 2))
                                : tr("auto"));
    fillLayers();
    draw();
    showLedger();
}

/// Names of layers of one word, which are told from keys nowhere else.
[[maybe_unused]] static constexpr const char* namesOfLayers[] = {QT_TRANSLATE_NOOP("messages", "Height"),
                                                                 QT_TRANSLATE_NOOP("messages", "Fragments")};

void RunMapPanel::fillLayers() {
    m_layer->clear();
    if (m_content.map == nullptr) {
        return;
    }
    const DebrisMap& map = m_content.map->map;
    for (const MapLayer each : map.present()) {
        m_layer->addItem(worded(mapLayerTitle(map, each)), static_cast<int>(each));
        m_layer->setItemData(m_layer->count() - 1, said("messages", mapLayerRow(each).help), Qt::ToolTipRole);
    }
    // Its longest name is read whole, in the field and in the list, however narrow the panel.
    int longest = 0;
    for (int i = 0; i < m_layer->count(); ++i) {
        longest = std::max(longest, static_cast<int>(m_layer->itemText(i).size()));
    }
    m_layer->setMinimumContentsLength(longest);
    // Qt keeps the least width that it found before.
    m_layer->setMinimumWidth(m_layer->sizeHint().width());
    m_layer->view()->setMinimumWidth(m_layer->view()->sizeHintForColumn(0) + 2 * m_layer->view()->frameWidth() +
                                     m_layer->style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    m_layer->setCurrentIndex(std::max(0, m_layer->findData(static_cast<int>(m_choice.layer))));
    if (m_layer->count() > 0) {
        m_choice.layer = static_cast<MapLayer>(m_layer->currentData().toInt());
    }
}

figures::MapPictureStyle RunMapPanel::style() const {
    figures::MapPictureStyle style = m_content.place;
    style.contours = m_choice.contours;
    std::erase_if(style.outlines, [this](const figures::MapOutline& outline) {
        const bool ofStructure =
            outline.of == figures::MapOutline::Of::Structure || outline.of == figures::MapOutline::Of::Standing;
        return ofStructure ? !m_choice.structure : !m_choice.evidence;
    });
    return style;
}

void RunMapPanel::draw() {
    const std::shared_ptr<const RunMap>& made = m_content.map;
    figures::MapPictureStyle drawn = style();
    drawn.cautions.clear();  // they stand below, in words of their own size
    m_map->setMap(made != nullptr ? std::shared_ptr<const DebrisMap>(made, &made->map) : nullptr, m_choice.layer, drawn);
}

void RunMapPanel::showLedger() {
    if (m_content.map == nullptr) {
        m_ledger->clear();
        return;
    }
    const MapLedger& ledger = m_content.map->map.ledger;
    QStringList parts{
        tr("fragments: %1").arg(shownCount(ledger.fragments)), shownMass(ledger.mass, 6),
        tr("%1 of solid material").arg(shownWith(ledger.volume, "m3", 6)),
        tr("on %1 by cells of %2").arg(shownWith(ledger.footprintArea, "m2", 6), shownLength(m_content.map->map.cell, 2))};
    if (m_content.map->map.live && ledger.liveElements > 0) {
        parts << tr("fallen live structure beside them, moved farther than %1: %2")
                     .arg(shownLength(m_content.map->map.liveThreshold, 2), shownMass(ledger.liveMass, 4));
    }
    if (m_content.map->cellFrom > 0.0) {
        parts << tr("cells of %1 by a typical fragment of %2")
                     .arg(shownLength(m_content.map->map.cell, 2), shownLength(m_content.map->cellFrom, 2));
    }
    if (m_content.making) {
        parts << tr("mapping anew …");
    }
    m_ledger->setText(inOneLine(parts));
}

}  // namespace rubble::widgets
