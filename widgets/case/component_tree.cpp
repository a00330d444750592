#include "widgets/case/component_tree.h"

#include <QColorDialog>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/folding_bar.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/case/materials_table.h"
#include "widgets/figures/material_words.h"

namespace rubble::widgets {

namespace {

constexpr int rowRole = Qt::UserRole;

QIcon swatch(const QColor& colour, bool own) {
    QPixmap picture(28, 28);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(own ? tints().text : tints().hairline, 2.0));
    painter.setBrush(colour);
    // A chosen colour is told by shape as well.
    own ? painter.drawEllipse(3, 3, 22, 22) : painter.drawRoundedRect(3, 3, 22, 22, 4, 4);
    return QIcon(picture);
}

QString kindText(const std::string& kind) {
    return kind == "solid"   ? ComponentTree::tr("Solids")
           : kind == "shell" ? ComponentTree::tr("Shells")
           : kind == "beam"  ? ComponentTree::tr("Beams")
                             : ComponentTree::tr("Mixed");
}

QToolButton* button(const QString& text, const QString& tip) {
    auto* made = new QToolButton;
    made->setText(text);
    made->setToolTip(tip);
    made->setFocusPolicy(Qt::StrongFocus);
    return made;
}

}  // namespace

ComponentTree::ComponentTree(QWidget* parent)
    : QWidget(parent),
      m_tree(new QTreeWidget),
      m_hint(new QLabel(tr("The components of a result appear here."))),
      m_below(new QVBoxLayout),
      m_isolate(button(tr("Isolate"), tr("Hide all other components"))),
      m_all(button(tr("Show all"), tr("Show every component and element again"))),
      m_select(button(tr("Select"), tr("Select all elements of the components chosen"))),
      m_colour(button(tr("Colour…"), tr("Choose the colour of the components chosen; their own again with a second click"))) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(8);
    m_tree->setColumnCount(ColumnCount);
    m_tree->setHeaderLabels({tr("component"), tr("alive"), tr("dead")});
    m_tree->headerItem()->setToolTip(Alive, tr("Elements active in the FE result at the time shown"));
    m_tree->headerItem()->setToolTip(Dead, tr("Elements deactivated in the FE result by the time shown"));
    m_tree->headerItem()->setTextAlignment(Alive, Qt::AlignRight | Qt::AlignVCenter);
    m_tree->headerItem()->setTextAlignment(Dead, Qt::AlignRight | Qt::AlignVCenter);
    m_tree->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_tree->header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    m_tree->header()->setStretchLastSection(false);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setIconSize({14, 14});
    m_tree->setIndentation(14);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setStyleSheet(QStringLiteral("QTreeView::item { padding: 3px 0; }"));
    m_tree->setAccessibleName(tr("Components"));
    m_tree->setToolTip(tr("Tick what the views show; choose rows to isolate, select or set them"));
    m_hint->setObjectName(QStringLiteral("muted"));
    m_hint->setWordWrap(true);
    m_hint->setContentsMargins(14, 8, 14, 8);
    column->addWidget(m_hint);
    column->addWidget(m_tree, 1);
    auto* row = new FoldingBar;
    row->layout()->setContentsMargins(8, 0, 8, 0);
    row->add({m_isolate, m_all});
    row->add({m_select, m_colour});
    column->addWidget(row);
    m_below->setContentsMargins(14, 0, 14, 0);
    column->addLayout(m_below);
    setMinimumWidth(220);
    connect(m_tree, &QTreeWidget::itemChanged, this, &ComponentTree::ticked);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &ComponentTree::showEditors);
    connect(m_tree, &QTreeWidget::itemActivated, this, [this] { emit selectRequested(chosen()); });
    connect(m_isolate, &QToolButton::clicked, this, [this] { emit isolateRequested(chosen()); });
    connect(m_all, &QToolButton::clicked, this, &ComponentTree::showAllRequested);
    connect(m_select, &QToolButton::clicked, this, [this] { emit selectRequested(chosen()); });
    connect(m_colour, &QToolButton::clicked, this, &ComponentTree::chooseColour);
    build();
}

void ComponentTree::setRows(const std::vector<Row>& rows) {
    const auto sameName = [](const Row& a, const Row& b) { return a.name == b.name && a.kind == b.kind; };
    const bool same = std::equal(rows.begin(), rows.end(), m_rows.begin(), m_rows.end(), sameName);
    m_rows = rows;
    if (!same) {
        build();
    }
    m_filling = true;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_items[i]->setIcon(Name, swatch(m_rows[i].colour, m_rows[i].ownColour));
        const auto set = m_scenario.components.find(m_rows[i].name);
        const bool guessed = set == m_scenario.components.end() || !set->second.material;
        const QString material = shownName(m_rows[i].material);
        m_items[i]->setToolTip(Name, tr("%1, %2").arg(QString::fromStdString(m_rows[i].name),
                                                      guessed ? figures::guessedMaterial(material, m_rows[i].fits) : material));
    }
    m_filling = false;
    for (ParameterEditor* editor : m_editors) {
        if (editor->key().endsWith(QLatin1String(".material"))) {
            const auto row = std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& r) {
                return editor->key() == QStringLiteral("component[%1].material").arg(QString::fromStdString(r.name));
            });
            const auto set = row == m_rows.end() ? m_scenario.components.end() : m_scenario.components.find(row->name);
            const bool guessed = row != m_rows.end() && (set == m_scenario.components.end() || !set->second.material);
            editor->setAutomaticText(guessed ? automaticMaterial(row->material, row->fits) : QString());
        }
    }
}

void ComponentTree::build() {
    m_filling = true;
    m_tree->clear();
    m_items.clear();
    m_counts.clear();
    m_hint->setVisible(m_rows.empty());
    m_tree->setVisible(!m_rows.empty());
    for (QToolButton* each : {m_isolate, m_all, m_select, m_colour}) {
        each->setVisible(!m_rows.empty());
    }
    std::vector<std::pair<std::string, QTreeWidgetItem*>> kinds;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == m_rows[i].kind; });
        if (kind == kinds.end()) {
            auto* top = new QTreeWidgetItem(m_tree, {kindText(m_rows[i].kind)});
            top->setData(Name, rowRole, -1);
            top->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsAutoTristate | Qt::ItemIsSelectable);
            top->setExpanded(true);
            kind = kinds.insert(kinds.end(), {m_rows[i].kind, top});
        }
        auto* item = new QTreeWidgetItem(kind->second, {QString::fromStdString(m_rows[i].name)});
        item->setData(Name, rowRole, static_cast<int>(i));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        item->setCheckState(Name, m_hidden.contains(m_rows[i].name) ? Qt::Unchecked : Qt::Checked);
        item->setTextAlignment(Alive, Qt::AlignRight | Qt::AlignVCenter);
        item->setTextAlignment(Dead, Qt::AlignRight | Qt::AlignVCenter);
        m_items.push_back(item);
    }
    m_filling = false;
    showEditors();
}

void ComponentTree::setCounts(const std::vector<Count>& counts) {
    if (counts == m_counts || counts.size() != m_items.size()) {
        return;
    }
    m_filling = true;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (i >= m_counts.size() || !(counts[i] == m_counts[i])) {
            m_items[i]->setText(Alive, shownCount(static_cast<std::int64_t>(counts[i].alive)));
            m_items[i]->setText(Dead, shownCount(static_cast<std::int64_t>(counts[i].dead)));
        }
    }
    m_filling = false;
    m_counts = counts;
}

void ComponentTree::setHidden(const std::vector<std::string>& names) {
    m_hidden = {names.begin(), names.end()};
    m_filling = true;
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        m_items[i]->setCheckState(Name, m_hidden.contains(m_rows[i].name) ? Qt::Unchecked : Qt::Checked);
    }
    m_filling = false;
}

void ComponentTree::ticked(QTreeWidgetItem*) {
    if (m_filling) {
        return;
    }
    std::set<std::string> hidden;
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        if (m_items[i]->checkState(Name) == Qt::Unchecked) {
            hidden.insert(m_rows[i].name);
        }
    }
    if (hidden != m_hidden) {
        m_hidden = hidden;
        emit hiddenChanged({hidden.begin(), hidden.end()});
    }
}

std::vector<std::string> ComponentTree::chosen() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        if (m_items[i]->isSelected() || m_items[i]->parent()->isSelected()) {
            names.push_back(m_rows[i].name);
        }
    }
    return names;
}

void ComponentTree::chooseColour() {
    const std::vector<std::string> names = chosen();
    const auto row =
        std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& r) { return !names.empty() && r.name == names.front(); });
    if (row == m_rows.end()) {
        return;
    }
    const QColor colour =
        row->ownColour ? QColor()
                       : QColorDialog::getColor(row->colour, this, tr("Colour of %1").arg(QString::fromStdString(row->name)));
    if (row->ownColour || colour.isValid()) {
        for (const std::string& name : names) {
            emit colourChosen(QString::fromStdString(name), colour);
        }
    }
}

void ComponentTree::showEditors() {
    delete m_group;
    m_group = nullptr;
    m_editors.clear();
    const std::vector<std::string> names = chosen();
    for (QToolButton* each : {m_isolate, m_select, m_colour}) {
        each->setEnabled(!names.empty());
    }
    if (names.size() != 1) {
        return;
    }
    auto* group = new PanelGroup(QString::fromStdString(names.front()));
    std::vector<const char*> fields{"material", "reinforced", "structural", "density"};
    const auto row = std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& each) { return each.name == names.front(); });
    if (row != m_rows.end() && row->kind != "solid") {
        fields.push_back("section");
    }
    for (const char* field : fields) {
        const auto [parameter, subject] = findParameter("component[" + names.front() + "]." + field);
        ParameterEditor* editor = group->addParameter(*parameter, subject);
        connect(editor, &ParameterEditor::edited, this, &ComponentTree::edited);
        m_editors.push_back(editor);
    }
    m_group = group;
    m_below->addWidget(group);
    setScenario(m_scenario);
    setEditable(m_editable);
    setRows(std::vector<Row>(m_rows));
}

void ComponentTree::setScenario(const Scenario& scenario) {
    m_scenario = scenario;
    for (ParameterEditor* editor : m_editors) {
        editor->setValue(parameterValue(scenario, editor->key().toStdString()));
    }
}

void ComponentTree::setEditable(bool editable) {
    m_editable = editable;
    for (ParameterEditor* editor : m_editors) {
        editor->setAvailable(editable, tr("Open a result first"));
    }
}

}  // namespace rubble::widgets
