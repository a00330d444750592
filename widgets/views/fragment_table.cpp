#include "widgets/views/fragment_table.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/number_field.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr int rowHeight = 22;   // px
constexpr int fieldWidth = 76;  // px

/// Keys by which one goes through the rows: no transport while the table has the focus.
bool ofTheTable(const QKeyEvent& key) {
    switch (key.key()) {
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Home:
        case Qt::Key_End:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return true;
        case Qt::Key_A:
            return key.modifiers() == Qt::ControlModifier;
        default:
            return false;
    }
}

/// Rows one after another as ranges: choosing 50,000 of them is one.
QItemSelection rangesOf(const QAbstractItemModel& model, const std::vector<int>& rows) {
    QItemSelection ranges;
    for (std::size_t i = 0; i < rows.size();) {
        std::size_t end = i + 1;
        while (end < rows.size() && rows[end] == rows[end - 1] + 1) {
            ++end;
        }
        ranges.append(QItemSelectionRange(model.index(rows[i], 0), model.index(rows[end - 1], model.columnCount() - 1)));
        i = end;
    }
    return ranges;
}

}  // namespace

FragmentTable::FragmentTable(QWidget* parent)
    : QWidget(parent),
      m_model(new FragmentModel(this)),
      m_rows(new QTableView),
      m_component(new QComboBox),
      m_clear(new QPushButton(tr("Show all"))),
      m_count(new QLabel) {
    setObjectName(QStringLiteral("panelBody"));
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 8, 12, 8);
    row->setSpacing(12);
    row->addWidget(buildBounds());
    m_rows->setModel(m_model);
    m_rows->setObjectName(QStringLiteral("fragmentRows"));
    m_rows->setAccessibleName(tr("Fragments"));
    m_rows->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_rows->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_rows->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_rows->setTabKeyNavigation(false);
    m_rows->setShowGrid(false);
    m_rows->setWordWrap(false);
    m_rows->setSortingEnabled(true);
    m_rows->sortByColumn(FragmentModel::Number, Qt::AscendingOrder);
    m_rows->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_rows->verticalHeader()->hide();
    m_rows->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_rows->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_rows->horizontalHeader()->setHighlightSections(false);
    m_rows->setToolTip(tr("A row selects the fragment in the views, Ctrl and Shift choose several; Enter goes to its birth"));
    m_rows->installEventFilter(this);
    row->addWidget(m_rows, 1);
    connect(m_rows, &QTableView::doubleClicked, this, &FragmentTable::birthRequested);
    connect(m_rows->selectionModel(), &QItemSelectionModel::selectionChanged, this, &FragmentTable::tellSelection);
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] { showSelection(false); });
    setFocusProxy(m_rows);
    setData({});
}

void FragmentTable::addBounds(QGridLayout& grid, int row, const QString& name, const char* unit, const QString& tip,
                              render::FilterRange render::FragmentFilter::* range) {
    auto* label = new QLabel(name);
    label->setToolTip(tip);
    const auto field = [&](const QString& called, const QString& empty, std::optional<double> render::FilterRange::* bound) {
        auto* made = new NumberField(called);
        made->setToolTip(tip);
        made->setUnit(unit);
        made->setEmptyMeans(empty);
        made->setMinimumWidth(fieldWidth);
        made->setMaximumWidth(fieldWidth);
        connect(made, &NumberField::edited, this, [this, range, bound](std::optional<double> number) {
            render::FragmentFilter filter = m_filter;
            (filter.*range).*bound = number;
            edit(filter);
        });
        return made;
    };
    NumberField* low = field(tr("%1 from").arg(name), tr("least"), &render::FilterRange::low);
    NumberField* high = field(tr("%1 to").arg(name), tr("greatest"), &render::FilterRange::high);
    low->setObjectName(QStringLiteral("filterLow%1").arg(row));
    high->setObjectName(QStringLiteral("filterHigh%1").arg(row));
    label->setBuddy(low);
    grid.addWidget(label, row, 0);
    grid.addWidget(low, row, 1);
    grid.addWidget(new QLabel(QStringLiteral("–")), row, 2);
    grid.addWidget(high, row, 3);
    grid.addWidget(new UnitLabel(QString::fromLatin1(unit)), row, 4);
    m_bounds.push_back({range, low, high});
}

QWidget* FragmentTable::buildBounds() {
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    addBounds(*grid, 0, tr("speed"), "m/s", tr("Shown are fragments as fast as this at the time shown"),
              &render::FragmentFilter::speed);
    addBounds(*grid, 1, tr("mass"), "kg", tr("Shown are fragments as heavy as this"), &render::FragmentFilter::mass);
    addBounds(*grid, 2, tr("longest side"), "m", tr("Shown are fragments whose box has a longest side like this"),
              &render::FragmentFilter::size);
    addBounds(*grid, 3, tr("born"), "s", tr("Shown are fragments born within these times"), &render::FragmentFilter::birth);
    auto* label = new QLabel(tr("component"));
    label->setBuddy(m_component);
    m_component->setObjectName(QStringLiteral("filterComponent"));
    m_component->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_component->setMinimumContentsLength(8);
    m_component->setAccessibleName(tr("Component"));
    m_component->setToolTip(tr("Shown are fragments of this component"));
    grid->addWidget(label, 4, 0);
    grid->addWidget(m_component, 4, 1, 1, 4);
    connect(m_component, &QComboBox::activated, this, [this] {
        render::FragmentFilter filter = m_filter;
        filter.component = m_component->currentData().toString().toStdString();
        edit(filter);
    });
    column->addLayout(grid);
    auto* foot = new QHBoxLayout;
    m_count->setObjectName(QStringLiteral("fragmentsShown"));
    m_count->setWordWrap(true);
    foot->addWidget(m_count, 1);
    m_clear->setObjectName(QStringLiteral("clearFilter"));
    m_clear->setToolTip(tr("Take all bounds away"));
    connect(m_clear, &QPushButton::clicked, this, [this] { edit({}); });
    foot->addWidget(m_clear);
    column->addLayout(foot);
    column->addStretch();
    side->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    return side;
}

void FragmentTable::setData(const render::SceneData& scene) {
    if (m_component->count() == 0 || scene.components != m_data.components) {
        m_component->clear();
        m_component->addItem(tr("any"), QString());
        for (std::size_t c = 0; scene.components != nullptr && c < scene.components->list.size(); ++c) {
            const QString name = QString::fromStdString(scene.components->list[c].name);
            m_component->addItem(name, name);
        }
        const QString wanted = QString::fromStdString(m_filter.component);
        m_component->setCurrentIndex(std::max(0, m_component->findData(wanted)));
    }
    const bool first = m_model->fragmentCount() == 0;
    m_data = scene;
    m_model->setData(scene);
    sift();
    if (first && m_model->rowCount() > 0) {
        m_rows->resizeColumnsToContents();
    }
}

void FragmentTable::setSpeeds(std::vector<double> speeds) {
    m_model->setSpeeds(std::move(speeds));
    if (!m_filter.speed.empty()) {
        sift();
    }
}

void FragmentTable::setFilter(const render::FragmentFilter& filter) {
    if (filter == m_filter) {
        return;
    }
    m_filter = filter;
    for (const Bounds& bounds : m_bounds) {
        bounds.low->setNumber((filter.*bounds.range).low);
        bounds.high->setNumber((filter.*bounds.range).high);
    }
    m_component->setCurrentIndex(std::max(0, m_component->findData(QString::fromStdString(filter.component))));
    sift();
}

void FragmentTable::edit(const render::FragmentFilter& filter) {
    setFilter(filter);
    emit filterEdited(m_filter);
}

/// Rows of what meets the bounds.
void FragmentTable::sift() {
    const bool all = m_data.fragments == nullptr || m_filter.empty();
    m_model->setShown(all ? std::vector<std::uint8_t>()
                          : render::meeting(m_filter, *m_data.fragments, m_data.components.get(), m_model->speeds()));
    showCount();
}

QString FragmentTable::countWords() const {
    const auto all = static_cast<std::int64_t>(m_model->fragmentCount());
    if (all == 0) {
        return tr("There are no fragments yet: open a result whose elements die.");
    }
    return tr("%1 of %2 fragments shown").arg(shownCount(m_model->rowCount()), shownCount(all));
}

void FragmentTable::showCount() {
    m_count->setText(countWords());
    m_clear->setEnabled(!m_filter.empty());
}

void FragmentTable::setSelection(const std::vector<ElementIndex>& elements) {
    if (elements != m_selection) {
        m_selection = elements;
        showSelection(true);
    }
}

/// @param inSight  the first of the chosen rows is brought into sight: not while rows come and go by themselves
void FragmentTable::showSelection(bool inSight) {
    const QScopedValueRollback showing(m_showing, true);
    const std::vector<int> rows = m_model->rowsOf(m_selection);
    m_rows->selectionModel()->select(rangesOf(*m_model, rows), QItemSelectionModel::ClearAndSelect);
    if (!rows.empty()) {
        m_rows->selectionModel()->setCurrentIndex(m_model->index(rows.front(), 0), QItemSelectionModel::NoUpdate);
        if (inSight) {
            m_rows->scrollTo(m_model->index(rows.front(), 0));
        }
    }
}

void FragmentTable::tellSelection() {
    if (m_showing) {
        return;
    }
    m_selection.clear();
    for (const QItemSelectionRange& range : m_rows->selectionModel()->selection()) {
        for (int row = range.top(); row <= range.bottom(); ++row) {
            m_selection.push_back(m_model->elementAt(row));
        }
    }
    std::sort(m_selection.begin(), m_selection.end());
    m_selection.erase(std::unique(m_selection.begin(), m_selection.end()), m_selection.end());
    emit selectionRequested(m_selection);
}

bool FragmentTable::event(QEvent* event) {
    if (event->type() == unitsChanged()) {
        m_rows->horizontalHeader()->viewport()->update();
        m_rows->viewport()->update();
    }
    return QWidget::event(event);
}

bool FragmentTable::eventFilter(QObject* watched, QEvent* event) {
    const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (key && ofTheTable(*static_cast<QKeyEvent*>(event))) {
        const int pressed = static_cast<QKeyEvent*>(event)->key();
        if (event->type() == QEvent::ShortcutOverride) {
            event->accept();
            return true;
        }
        if ((pressed == Qt::Key_Return || pressed == Qt::Key_Enter) && !m_selection.empty()) {
            emit birthRequested();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace rubble::widgets
