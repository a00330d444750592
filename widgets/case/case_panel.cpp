#include "widgets/case/case_panel.h"

#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <cmath>

#include "core/fe/unit_evidence.h"
#include "widgets/basics/table_cell.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/report/spoken_text.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

enum ComponentColumn { NameColumn, KindColumn, ElementsColumn, DeadColumn, DensityColumn, ColumnsOfComponents };

QString joined(const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names) {
        list << QString::fromStdString(name);
    }
    return list.join(QStringLiteral(", "));
}

}  // namespace

QString regroupText(const RegroupStep& step) {
    const auto name = [](const std::string& text) { return QString::fromStdString(text); };
    if (const auto* merge = std::get_if<MergeComponents>(&step)) {
        return CasePanel::tr("%1 joined into %2").arg(joined(merge->components), name(merge->newName));
    }
    if (const auto* rename = std::get_if<RenameComponent>(&step)) {
        return CasePanel::tr("%1 renamed to %2").arg(name(rename->component), name(rename->newName));
    }
    if (const auto* box = std::get_if<SplitByBox>(&step)) {
        return CasePanel::tr("%1 split by a box into %2").arg(name(box->component), name(box->newName));
    }
    if (const auto* plane = std::get_if<SplitByPlane>(&step)) {
        return CasePanel::tr("%1 split by a plane into %2").arg(name(plane->component), name(plane->newName));
    }
    return CasePanel::tr("%1 split into what hangs together").arg(name(std::get<SplitByConnectivity>(step).component));
}

void showRegrouping(QLabel& steps, QWidget& clear, const std::vector<RegroupStep>& regrouping) {
    QStringList lines;
    for (const RegroupStep& step : regrouping) {
        lines << regroupText(step);
    }
    steps.setText(lines.join(u'\n'));
    steps.setVisible(!lines.isEmpty());
    clear.setVisible(!lines.isEmpty());
}

CasePanel::CasePanel(QWidget* parent)
    : Panel(tr("Case"), tr("What was computed, and of what the structure is made."), parent),
      m_scenarios(new ScenarioList),
      m_table(new QTableWidget(0, ColumnsOfComponents)),
      m_regroup(new RegroupForm),
      m_steps(new QLabel),
      m_clear(new QPushButton(tr("Back to the parts of the file"))),
      m_findings(new FindingList) {
    buildFile();
    setTerrain(nullptr, {}, {});
    m_scenarioGroup = addGroup(tr("Scenarios"));
    m_scenarioGroup->addWide(m_scenarios);
    buildTable();
    addRemaining(Stage::Import, tr("How the file is read"));
    addRemaining(Stage::Components, tr("Assumed where nothing is known"));
    const QString site = tr("Site…");
    const QString terrain = tr("Choose a terrain…");
    const auto askSite = [this] { emit siteRequested(); };
    const auto askTerrain = [this] { emit terrainRequested(); };
    m_findings->setDoings({{"site.", site, askSite},
                           {"terrain.far_off", site, askSite},
                           {"terrain.short", terrain, askTerrain},
                           {"surroundings.no_terrain", terrain, askTerrain}});
    addWide(m_findings);
    setContent(nullptr, nullptr);
}

void CasePanel::buildFile() {
    PanelGroup* file = addGroup(tr("File"));
    m_note = file->addNote(tr("Open a case or an FE result, or drop one anywhere in the window. The sample is in the Case menu."));
    m_name = file->addValue(tr("Name"));
    m_format = file->addValue(tr("Format"));
    m_elements = file->addValue(tr("Elements"));
    m_dead = file->addValue(tr("Deactivated"), {}, tr("Inactive at the last state and active before"));
    m_nodes = file->addValue(tr("Nodes"));
    m_states = file->addValue(tr("States"));
    m_span = file->addValue(tr("Time"));
    m_units = file->addValue(tr("Units"), {}, tr("What the file was taken to count in; chosen below"));
    m_flag = file->addValue(tr("Active flag"), {}, tr("How the file says which elements are active"));
    m_terrain = file->addValue(tr("Terrain"), {}, tr("What debris falls on; Terrain… in the Case menu chooses it"));
    m_cells = file->addValue(tr("Terrain cells"), {},
                             tr("Side of the cells that the heights of the terrain stand for, and how many of those about the "
                                "structure had no height: these were filled from their neighbours, from the rim inwards"));
    m_surroundings = file->addValue(
        tr("Surroundings"), {}, tr("What is drawn around the structure; Orthophoto… and Surroundings… in the Case menu choose it"));
    m_velocity = file->addValue(tr("Velocity"), {}, tr("Nodal velocities; else differences of positions at active states"));
}

void CasePanel::buildTable() {
    PanelGroup* group = addGroup(tr("Components"));
    m_table->setHorizontalHeaderLabels({tr("name"), tr("kind"), tr("elem."), tr("dead"), tr("kg/m³")});
    m_table->horizontalHeaderItem(DensityColumn)->setToolTip(tr("Density; double-click to change, empty for what the file says"));
    for (int column = ElementsColumn; column < ColumnsOfComponents; ++column) {
        m_table->horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    m_table->horizontalHeaderItem(NameColumn)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeaderItem(KindColumn)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 9);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(24);
    m_table->horizontalHeader()->setFont(headingFont());
    m_table->setFont(headingFont());
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setTextElideMode(Qt::ElideMiddle);  // numbers at the end of names tell them apart
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setAccessibleName(tr("Components"));
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                             QAbstractItemView::AnyKeyPressed);
    group->addWide(m_table);
    group->addWide(m_regroup);
    m_steps->setObjectName(QStringLiteral("muted"));
    m_steps->setWordWrap(true);
    group->addWide(m_steps);
    group->addWide(m_clear);
    connect(m_table, &QTableWidget::cellChanged, this, &CasePanel::densityTyped);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, [this] {
        QStringList all;
        for (int row = 0; row < m_table->rowCount(); ++row) {
            all << m_table->item(row, NameColumn)->text();
        }
        const QStringList selected = selectedComponents();
        m_regroup->setSelection(selected, all);
        if (selected.size() == 1 && m_components != nullptr) {
            for (const Component& component : m_components->list) {
                if (component.name == selected.front().toStdString()) {
                    m_regroup->setBounds(component.bounds);
                }
            }
        }
    });
    connect(m_regroup, &RegroupForm::regroupRequested, this, &CasePanel::regroupRequested);
    connect(m_clear, &QPushButton::clicked, this, &CasePanel::regroupingCleared);
}

QStringList CasePanel::selectedComponents() const {
    QStringList names;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        if (m_table->item(row, NameColumn) != nullptr && m_table->item(row, NameColumn)->isSelected()) {
            names << m_table->item(row, NameColumn)->text();
        }
    }
    return names;
}

void CasePanel::setContent(const std::shared_ptr<const FeResult>& fe, const std::shared_ptr<const Components>& components) {
    m_components = components;
    showFile(fe.get());
    showComponents(fe.get(), components.get());
    Findings findings;
    if (fe != nullptr) {
        findings.append(fe->contents().findings);
    }
    findings.append(m_terrainFindings);
    if (components != nullptr) {
        findings.append(components->findings);
    }
    m_findings->set(findings);
}

void CasePanel::setTerrain(const std::shared_ptr<const TerrainGrid>& terrain, const QString& path, const Findings& findings) {
    m_terrainFindings = findings;
    const QString name = m_terrain->fontMetrics().elidedText(QFileInfo(path).fileName(), Qt::ElideMiddle, 150);
    m_terrain->setText(terrain != nullptr ? name : path.isEmpty() ? tr("level") : tr("%1, not read").arg(name));
    m_terrain->setToolTip(terrain == nullptr
                              ? path
                              : tr("%1\n%2 × %3 heights, %4 apart, %5 to %6")
                                    .arg(path, shownCount(static_cast<std::int64_t>(terrain->nx())),
                                         shownCount(static_cast<std::int64_t>(terrain->ny())), shownLength(terrain->cell(), 4),
                                         shownLength(terrain->lowest(), 4), shownLength(terrain->highest(), 4)));
    showCells(terrain.get());
}

void CasePanel::showCells(const TerrainGrid* terrain) {
    QString text = terrain != nullptr ? shownLength(terrain->cell(), 3) : QStringLiteral("–");
    if (const std::int64_t filled = m_terrainFindings.count("terrain.filled"); terrain != nullptr && filled > 0) {
        text = tr("%1, %2 filled").arg(text, shownCount(filled));
    }
    m_cells->setText(text);
}

void CasePanel::setSurroundings(bool orthophoto, std::size_t meshes, bool collided) {
    QStringList parts;
    if (orthophoto) {
        parts << tr("orthophoto");
    }
    if (meshes > 0) {
        parts << (collided ? tr("meshes that debris falls on: %1").arg(meshes) : tr("meshes: %1").arg(meshes));
    }
    m_surroundings->setText(parts.isEmpty() ? tr("none") : parts.join(QStringLiteral(", ")));
}

void CasePanel::showFile(const FeResult* fe) {
    const QString none(QChar(0x2013));
    m_note->setVisible(fe == nullptr);
    if (fe == nullptr || fe->stateCount() == 0) {
        for (QLabel* label : {m_name, m_format, m_elements, m_nodes, m_states, m_span, m_units, m_flag, m_velocity, m_dead}) {
            label->setText(none);
        }
        return;
    }
    const FeResult::Contents& c = fe->contents();
    const QString path = QString::fromStdString(c.path);
    m_name->setText(m_name->fontMetrics().elidedText(QFileInfo(path).fileName(), Qt::ElideMiddle, 150));
    m_name->setToolTip(path);
    m_format->setText(figures::spokenText(c.format));
    m_elements->setText(shownCount(static_cast<std::int64_t>(fe->mesh().elementCount())));
    m_nodes->setText(shownCount(static_cast<std::int64_t>(fe->mesh().nodeCount())));
    m_states->setText(shownCount(static_cast<std::int64_t>(fe->stateCount())));
    m_span->setText(QStringLiteral("%1 – %2").arg(figures::timeText(fe->times().front()), figures::timeText(fe->times().back())));
    showUnits(c);
    // What is in brackets says how it was recognised: the tip has room for that. The catalogue knows the whole alone.
    const QString flag = figures::spokenText(c.activityFrom);
    static const QRegularExpression bracket(QStringLiteral("\\s*[(（]"));
    m_flag->setText(flag.left(flag.indexOf(bracket)));
    m_flag->setToolTip(flag);
    m_velocity->setText(c.hasVelocity ? tr("in the file") : tr("from positions"));
    std::int64_t dead = 0;
    for (std::size_t e = 0; e < fe->mesh().elementCount(); ++e) {
        const auto element = idAt<ElementIndex>(e);
        dead += fe->activity().active(0, element) && !fe->activity().active(fe->stateCount() - 1, element) ? 1 : 0;
    }
    m_dead->setText(shownCount(dead));
}

// What the file fits is said where it is not what was taken.
void CasePanel::showUnits(const FeResult::Contents& contents) {
    const UnitSystem* taken = systemOf(contents.units);
    const UnitEvidence evidence = evidenceInFile(evidenceOf(contents), contents.units, contents.frame);
    const Proposal proposal = proposeUnits(evidence);
    const QString name =
        taken != nullptr ? QString::fromUtf8(taken->id.data(), static_cast<qsizetype>(taken->id.size())) : tr("own");
    const QString fitting = QString::fromStdString(proposal.choice);
    const bool other = !fitting.isEmpty() && fitting != name;
    m_units->setText(other ? tr("%1, fits %2").arg(name, fitting) : name);
    const QString reason = worded(proposal.reason);
    m_units->setToolTip(tr("Taken: %1.\nWhat the file fits: %2.").arg(figures::spokenText(contents.unitsFrom), reason));
}

void CasePanel::showComponents(const FeResult* fe, const Components* components) {
    m_filling = true;
    m_table->horizontalHeaderItem(DensityColumn)->setText(figures::shownUnit("kg/m3").name);
    m_table->clearSelection();
    m_table->setRowCount(components != nullptr ? static_cast<int>(components->list.size()) : 0);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const Component& component = components->list[static_cast<std::size_t>(row)];
        std::int64_t dead = 0;
        for (const ElementIndex e : component.elements) {
            dead += fe != nullptr && !fe->activity().active(fe->stateCount() - 1, e) ? 1 : 0;
        }
        m_table->setItem(row, NameColumn, fixedCell(QString::fromStdString(component.name), true));
        m_table->item(row, NameColumn)->setToolTip(QString::fromStdString(component.name));
        m_table->setItem(row, KindColumn, fixedCell(figures::spokenText(component.kind), true));
        m_table->setItem(row, ElementsColumn, fixedCell(shownCount(static_cast<std::int64_t>(component.elements.size())), false));
        m_table->setItem(row, DeadColumn, fixedCell(shownCount(dead), false));
        auto* density = fixedCell(shownIn(component.density, "kg/m3", 4), false);
        density->setFlags(density->flags() | Qt::ItemIsEditable);
        m_table->setItem(row, DensityColumn, density);
        const Vec3 size = component.bounds.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(component.bounds.sizes());
        m_table->item(row, NameColumn)
            ->setToolTip(tr("%1: %2, %3 × %4 × %5")
                             .arg(QString::fromStdString(component.name), shownMass(component.mass), shownIn(size.x(), "m"),
                                  shownIn(size.y(), "m"), shownLength(size.z())));
    }
    const int lines = std::min(12, std::max(1, m_table->rowCount()));
    m_table->setFixedHeight((lines + 1) * (m_table->fontMetrics().height() + 9) + 8);
    m_filling = false;
    m_regroup->setSelection({}, {});
}

void CasePanel::setScenario(const Scenario& scenario) {
    Panel::setScenario(scenario);
    showRegrouping(*m_steps, *m_clear, scenario.regrouping);
}

void CasePanel::setEditable(bool editable) {
    Panel::setEditable(editable);
    m_scenarioGroup->setVisible(editable);
}

void CasePanel::densityTyped(int row, int column) {
    if (m_filling || column != DensityColumn || m_components == nullptr) {
        return;
    }
    const Component& component = m_components->list[static_cast<std::size_t>(row)];
    const QString text = m_table->item(row, column)->text().trimmed();
    const QString key = QStringLiteral("component[%1].density").arg(QString::fromStdString(component.name));
    bool ok = false;
    const double density = typedIn(QLocale().toDouble(text, &ok), "kg/m3");
    const Parameter& parameter = *findParameter(key.toStdString()).first;
    m_filling = true;
    m_table->item(row, column)->setText(shownIn(component.density, "kg/m3", 4));
    m_filling = false;
    if (text.isEmpty()) {
        emit edited(key, ParameterValue());
    } else if (ok && density >= parameter.low && density <= parameter.high && text != shownIn(component.density, "kg/m3", 4)) {
        emit edited(key, ParameterValue(density));
    } else if (!ok || density < parameter.low || density > parameter.high) {
        setError(tr("“%1” is not a density from %2 to %3.")
                     .arg(text, shownWith(parameter.low, "kg/m3"), shownWith(parameter.high, "kg/m3", 5)),
                 tr("The density of %1 stays as it was.").arg(QString::fromStdString(component.name)));
    }
}

}  // namespace rubble::widgets
