#include "widgets/case/contact_table.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/icons.h"
#include "widgets/basics/language.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr int changedRole = Qt::UserRole;

/// Numbers with, on changed cells, a mark at the left that gives the default back.
class ValueDelegate : public QStyledItemDelegate {
public:
    ValueDelegate(ContactTable& table) : QStyledItemDelegate(&table), m_table(table) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        if (index.data(changedRole).toBool()) {
            painter->setPen(tints().accent);
            drawGlyph(*painter, Glyph::Reset, markOf(option.rect));
        }
    }
    bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                     const QModelIndex& index) override {
        if (event->type() == QEvent::MouseButtonRelease && index.data(changedRole).toBool() &&
            markOf(option.rect).adjusted(-3, -6, 3, 6).contains(static_cast<QMouseEvent*>(event)->position().toPoint())) {
            m_table.reset(index.row(), index.column());
            return true;
        }
        return QStyledItemDelegate::editorEvent(event, model, option, index);
    }
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QWidget* editor = QStyledItemDelegate::createEditor(parent, option, index);
        if (auto* field = qobject_cast<QLineEdit*>(editor)) {
            field->setAlignment(Qt::AlignRight);
            field->setStyleSheet(QStringLiteral("padding: 0 2px;"));
        }
        return editor;
    }

private:
    static QRect markOf(const QRect& cell) { return {cell.left() + 3, cell.center().y() - 5, 11, 11}; }

    ContactTable& m_table;
};

QString keyOf(MaterialPair pair, int column) {
    return QStringLiteral("pair[%1].%2")
        .arg(QString::fromStdString(pairName(pair)),
             column == ContactTable::Friction ? QStringLiteral("friction") : QStringLiteral("restitution"));
}

double valueOf(const PairProperties& properties, int column) {
    return column == ContactTable::Friction ? properties.friction : properties.restitution;
}

QString shownCoefficient(double value) {
    return QLocale().toString(value, 'g', 4);
}

}  // namespace

ContactTable::ContactTable(QWidget* parent)
    : QWidget(parent),
      m_table(new QTableWidget(0, ColumnCount)),
      m_all(new QCheckBox(tr("All pairs"))),
      m_complaint(new QLabel),
      m_sources(new QLabel) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_table->setHorizontalHeaderLabels({tr("pair"), tr("friction"), tr("restitution"), tr("source")});
    m_table->horizontalHeaderItem(Friction)->setToolTip(tr("Coulomb coefficient; an empty cell gives the default back"));
    m_table->horizontalHeaderItem(Restitution)->setToolTip(tr("Normal restitution of a hit; an empty cell gives the default back"));
    m_table->horizontalHeaderItem(Source)->setToolTip(tr("Where the defaults of friction and restitution come from: listed below"));
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 9);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(Pair, QHeaderView::Stretch);
    m_table->horizontalHeader()->setFont(headingFont());
    m_table->horizontalHeader()->setHighlightSections(false);
    for (int i = 0; i < ColumnCount; ++i) {
        m_table->horizontalHeaderItem(i)->setTextAlignment((i == Pair ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
    m_table->setFont(headingFont());
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setTabKeyNavigation(false);
    m_table->setAccessibleName(tr("Friction and restitution of pairs of materials"));
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                             QAbstractItemView::AnyKeyPressed | QAbstractItemView::SelectedClicked);
    auto* delegate = new ValueDelegate(*this);
    m_table->setItemDelegateForColumn(Friction, delegate);
    m_table->setItemDelegateForColumn(Restitution, delegate);
    m_table->installEventFilter(this);
    m_all->setToolTip(tr("Also the pairs of materials that this scene does not have"));
    m_complaint->setObjectName(QStringLiteral("complaint"));
    m_complaint->setWordWrap(true);
    m_complaint->hide();
    m_sources->setObjectName(QStringLiteral("muted"));
    m_sources->setFont(headingFont());
    m_sources->setWordWrap(true);
    m_sources->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_all);
    column->addWidget(m_table);
    column->addWidget(m_complaint);
    column->addWidget(m_sources);
    connect(m_table, &QTableWidget::cellChanged, this, &ContactTable::typed);
    connect(m_all, &QCheckBox::toggled, this, &ContactTable::fill);
    fill();
}

void ContactTable::setScenario(const Scenario& scenario) {
    m_pairs = scenario.effects.pairs;
    m_acting = actingPairs(scenario);
    m_friction = scenario.simulation.friction;
    m_restitution = scenario.simulation.restitution;
    m_complaint->hide();
    fill();
}

void ContactTable::setMaterials(const std::set<Material>& materials) {
    if (materials != m_materials) {
        m_materials = materials;
        fill();
    }
}

void ContactTable::setEditable(bool editable) {
    m_table->setEnabled(editable);
    m_table->setToolTip(editable ? QString() : tr("Open a result first"));
}

bool ContactTable::changed(MaterialPair pair, int column) const {
    static const PairTable defaults;
    return valueOf(m_pairs.of(pair.first, pair.second), column) != valueOf(defaults.of(pair.first, pair.second), column);
}

QString ContactTable::cite(const QString& source) {
    if (!m_cited.contains(source)) {
        m_cited << source;
    }
    return QString::number(m_cited.indexOf(source) + 1);
}

void ContactTable::fill() {
    m_filling = true;
    const int row = m_table->currentRow();
    const int column = m_table->currentColumn();
    m_all->setVisible(!m_materials.empty());
    m_shown.clear();
    for (const MaterialPair& pair : materialPairs()) {
        const bool ofScene = m_materials.contains(pair.first) && m_materials.contains(pair.second);
        // What was changed is never hidden.
        if (m_materials.empty() || m_all->isChecked() || ofScene || changed(pair, Friction) || changed(pair, Restitution)) {
            m_shown.push_back(pair);
        }
    }
    m_cited.clear();
    m_table->setRowCount(static_cast<int>(m_shown.size()));
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
        fillRow(static_cast<int>(i), m_shown[i]);
    }
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() +
                            static_cast<int>(m_shown.size()) * m_table->verticalHeader()->defaultSectionSize() + 4);
    QStringList lines;
    for (qsizetype i = 0; i < m_cited.size(); ++i) {
        lines << QStringLiteral("%1  %2").arg(i + 1).arg(m_cited[i]);
    }
    m_sources->setText(lines.join(QLatin1Char('\n')));
    m_sources->setVisible(!lines.isEmpty());
    if (row >= 0 && row < m_table->rowCount()) {
        m_table->setCurrentCell(row, column);
    }
    m_filling = false;
}

void ContactTable::fillRow(int row, MaterialPair pair) {
    const auto plain = [&](int column, const QString& text, const QString& tip) {
        QTableWidgetItem* item = fixedCell(text, column == Pair, tip);
        m_table->setItem(row, column, item);
        return item;
    };
    const QString name = tr("%1 on %2").arg(shownName(materialName(pair.first)), shownName(materialName(pair.second)));
    plain(Pair, name, name);
    const PairSource* source = pairSource(pair);
    QStringList cited;
    QString tip;
    for (const int column : {Friction, Restitution}) {
        const std::optional<double> held = column == Friction ? m_friction : m_restitution;
        const QString what = column == Friction ? tr("Friction") : tr("Restitution");
        auto* item = plain(column, shownCoefficient(valueOf(m_acting.of(pair.first, pair.second), column)), {});
        const bool own = changed(pair, column) && !held;
        const QString words =
            source != nullptr ? said("messages", column == Friction ? source->friction : source->restitution) : QString();
        const QString range = source != nullptr
                                  ? worded(rangeText(column == Friction ? source->frictionRange : source->restitutionRange))
                                  : QString();
        if (held) {
            item->setForeground(tints().muted);
            item->setToolTip(tr("One %1 is set for all pairs; give it back to automatic to use the table.").arg(what.toLower()));
        } else {
            item->setFlags(item->flags() | Qt::ItemIsEditable);
            item->setData(changedRole, own);
            item->setToolTip(own && source != nullptr ? tr("Set here. Default %1: Delete or the mark gives it back.")
                                                            .arg(shownCoefficient(valueOf(source->value, column)))
                                                      : inOneLine({words, range}));
        }
        QFont font = m_table->font();
        font.setWeight(own ? QFont::DemiBold : QFont::Normal);
        item->setFont(font);
        const QString mark = own || held ? tr("set") : words.isEmpty() ? QString(QChar(0x2013)) : cite(words);
        cited << mark;
        tip += (tip.isEmpty() ? QString() : QStringLiteral("\n")) +
               QStringLiteral("%1: %2").arg(what, own || held ? tr("set by you") : inOneLine({words, range}));
    }
    plain(Source, cited[0] == cited[1] ? cited[0] : cited.join(QStringLiteral(", ")), tip);
}

void ContactTable::typed(int row, int column) {
    if (m_filling || (column != Friction && column != Restitution)) {
        return;
    }
    const MaterialPair pair = m_shown[static_cast<std::size_t>(row)];
    const QString key = keyOf(pair, column);
    const QString text = m_table->item(row, column)->text().trimmed();
    if (text.isEmpty()) {
        reset(row, column);
        return;
    }
    bool ok = false;
    double value = QLocale().toDouble(text, &ok);
    if (!ok) {
        value = QLocale::c().toDouble(text, &ok);
    }
    const Parameter& parameter = *findParameter(key.toStdString()).first;
    const double before = valueOf(m_acting.of(pair.first, pair.second), column);
    const bool good = ok && std::isfinite(value) && value >= parameter.low && value <= parameter.high;
    const bool same = text == shownCoefficient(before);
    // The scenario says what is shown: a value that is refused goes back.
    fill();
    m_complaint->setVisible(!good);
    if (!good) {
        m_complaint->setText(tr("“%1” is not a number from %2 to %3; %4 stays.")
                                 .arg(text, QLocale().toString(parameter.low, 'g', 4), QLocale().toString(parameter.high, 'g', 4),
                                      shownCoefficient(before)));
    } else if (!same) {
        emit edited(key, ParameterValue(value));
    }
}

void ContactTable::reset(int row, int column) {
    const MaterialPair pair = m_shown.at(static_cast<std::size_t>(row));
    m_complaint->hide();
    fill();
    if (changed(pair, column)) {
        emit edited(keyOf(pair, column), ParameterValue());
    }
}

bool ContactTable::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int column = m_table->currentColumn();
        if ((key == Qt::Key_Delete || key == Qt::Key_Backspace) && m_table->currentRow() >= 0 &&
            (column == Friction || column == Restitution)) {
            reset(m_table->currentRow(), column);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace rubble::widgets
