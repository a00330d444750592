#include "widgets/case/new_case_ground.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

// Of the height of the structure: a ground so far from its lowest point is worth a word.
constexpr double worthAWord = 1e-3;

/// m. What gaps below a structure are held against: its height, or a little of its length where it is flat.
double heightOf(const Aabb& structure) {
    return std::max(structure.sizes().z(), 0.01 * structure.sizes().maxCoeff());
}

/// m. The lowest point in round numbers: whole millimetres, of a small structure a ten-thousandth of its height at most.
double roundedLowest(const Aabb& structure) {
    const double finest = 0.1 * worthAWord * heightOf(structure);
    const double parts = std::pow(10.0, std::clamp(std::ceil(-std::log10(finest)), 3.0, 9.0));
    return std::floor(structure.min().z() * parts) / parts;
}

}  // namespace

NewCaseGround::NewCaseGround(QWidget* parent)
    : Panel(tr("Ground"), tr("On what the debris falls."), parent),
      m_gap(new Notice),
      m_terrainGap(new Notice),
      m_toLowest(new QPushButton(tr("Put it at the lowest point"))),
      m_drop(new QPushButton(tr("Without terrain"))),
      m_findings(new FindingList) {
    PanelGroup* level = addGroup(tr("Level ground"));
    addParameter(level, "ground_height");
    addParameter(level, "ground_material");
    m_lowest = level->addValue(tr("Lowest point of the structure"), tr("m"), tr("z of its lowest node at rest"));
    level->addWide(m_gap);
    m_toLowest->setToolTip(tr("Let the level ground pass through the lowest node of the structure at rest"));
    m_toLowest->setObjectName(QStringLiteral("toLowest"));
    level->addWide(m_toLowest);
    PanelGroup* terrain = addGroup(tr("Terrain"));
    terrain->addNote(tr("A raster of heights takes the place of the level ground where it covers the site."));
    m_terrain = terrain->addValue(tr("Raster of heights"));
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    auto* choose = new QPushButton(tr("Choose…"));
    choose->setObjectName(QStringLiteral("chooseTerrain"));
    choose->setToolTip(tr("Choose the raster of heights that the debris falls on"));
    m_drop->setToolTip(tr("Let the debris fall on level ground again"));
    row->addWidget(choose);
    row->addWidget(m_drop);
    row->addStretch();
    terrain->addWide(buttons);
    terrain->addWide(m_terrainGap);
    PanelGroup* water = addGroup(tr("Water"));
    addParameter(water, "water_level");
    addWide(m_findings);
    connect(choose, &QPushButton::clicked, this, &NewCaseGround::terrainRequested);
    connect(m_drop, &QPushButton::clicked, this, &NewCaseGround::terrainDropped);
    connect(m_toLowest, &QPushButton::clicked, this, [this] {
        if (!m_structure.isEmpty()) {
            // More would only be noise in the field.
            emit edited(QStringLiteral("ground_height"), ParameterValue(roundedLowest(m_structure)));
        }
    });
    setStructure(Aabb());
    setTerrain({}, std::nullopt, {});
}

void NewCaseGround::setStructure(const Aabb& structure) {
    m_structure = structure;
    m_lowest->setText(structure.isEmpty() ? QString(QChar(0x2013)) : shownIn(structure.min().z(), "m", 4));
    showGap();
}

void NewCaseGround::setScenario(const Scenario& scenario) {
    Panel::setScenario(scenario);
    m_height = scenario.simulation.groundHeight;
    showGap();
}

void NewCaseGround::showGap() {
    const double gap = m_structure.isEmpty() ? 0.0 : m_structure.min().z() - m_height;
    const bool told = !m_structure.isEmpty() && !m_hasTerrain && std::abs(gap) > worthAWord * heightOf(m_structure);
    m_toLowest->setVisible(told);
    m_gap->set(Notice::Kind::Finding, !told     ? QString()
                                      : gap > 0 ? tr("The structure ends %1 above this ground.").arg(shownLength(gap))
                                                : tr("The structure reaches %1 below this ground.").arg(shownLength(-gap)));
    const double above = m_hasTerrain ? m_clearance.value_or(0.0) : 0.0;
    if (std::abs(above) <= worthAWord * heightOf(m_structure)) {
        m_terrainGap->set(Notice::Kind::Note, {});
    } else if (above > 0.0) {
        m_terrainGap->set(Notice::Kind::Finding,
                          tr("The structure ends %1 above this terrain, where it is nearest.").arg(shownLength(above)));
    } else {
        // As foundations do.
        m_terrainGap->set(Notice::Kind::Note,
                          tr("The structure reaches %1 below this terrain, where it is deepest.").arg(shownLength(-above)));
    }
}

void NewCaseGround::setTerrain(const QString& path, const std::optional<double>& clearance, const Findings& findings) {
    m_hasTerrain = !path.isEmpty();
    m_clearance = clearance;
    m_terrain->setText(path.isEmpty() ? tr("none") : QFileInfo(path).fileName());
    m_terrain->setToolTip(path);
    m_drop->setEnabled(!path.isEmpty());
    m_findings->set(findings);
    showGap();
}

}  // namespace rubble::widgets
