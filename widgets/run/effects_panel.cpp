#include "widgets/run/effects_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>
#include <set>

#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/case/contact_table.h"
#include "widgets/case/materials_table.h"
#include "widgets/run/effect_row.h"

namespace rubble::widgets {

namespace {

using Keys = std::vector<std::string_view>;

/// The settings of each effect besides its switch, in the order of EffectKind.
const std::array<Keys, effectCount>& settingsOf() {
    static const std::array<Keys, effectCount> keys{{{"ground_height"},
                                                     {"terrain_roughness", "terrain_roughness_spacing", "terrain_roughness_seed"},
                                                     {"pieces", "piece_size"},
                                                     {"overlap_speed", "overlap_time"},
                                                     {"water_level", "water_density", "water_current_x", "water_current_y",
                                                      "water_drag", "water_linear_drag", "water_added_mass"},
                                                     {"air_density", "air_drag_coefficient"},
                                                     {"tie_ratio", "tie_strength", "tie_elongation"},
                                                     {"break_up_speed"}}};
    return keys;
}

const Keys& contactKeys() {
    static const Keys keys{"ground_material", "friction", "restitution", "bounce_friction"};
    return keys;
}

QWidget* hairline() {
    auto* line = new QFrame;
    line->setObjectName(QStringLiteral("hairline"));
    line->setFixedHeight(1);
    return line;
}

}  // namespace

bool isEffectParameter(std::string_view key) {
    for (std::size_t i = 0; i < effectCount; ++i) {
        const Keys& keys = settingsOf()[i];
        if (key == effectName(static_cast<EffectKind>(i)) || std::find(keys.begin(), keys.end(), key) != keys.end()) {
            return true;
        }
    }
    return std::find(contactKeys().begin(), contactKeys().end(), key) != contactKeys().end();
}

EffectsPanel::EffectsPanel(QWidget* parent)
    : Panel(tr("Effects"), tr("What acts on the fragments, why, and what it costs."), parent),
      m_summary(new QLabel),
      m_sum(new QLabel),
      m_materials(new MaterialsTable),
      m_contact(new ContactTable) {
    m_summary->setObjectName(QStringLiteral("muted"));
    m_summary->setWordWrap(true);
    addWide(m_summary);
    buildRows();
    addPrediction();
    buildMaterials();
    setContent({});
}

void EffectsPanel::buildRows() {
    auto* list = new QWidget;
    auto* column = new QVBoxLayout(list);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    for (std::size_t i = 0; i < effectCount; ++i) {
        const auto kind = static_cast<EffectKind>(i);
        auto* row = new EffectRow(kind, *findParameter(effectName(kind)).first);
        m_rows[i] = row;
        takeEditor(row->switchEditor());
        for (const std::string_view key : settingsOf()[i]) {
            addParameter(row->settings(), std::string(key));
        }
        column->addWidget(row);
        column->addWidget(hairline());
    }
    m_sum->setWordWrap(true);
    m_sum->setTextFormat(Qt::RichText);
    m_sum->setAccessibleName(tr("What all effects cost"));
    column->addWidget(m_sum);
    addWide(list);
}

void EffectsPanel::buildMaterials() {
    PanelGroup* materials = addGroup(tr("Materials"));
    materials->addWide(m_materials);
    addParameter(materials, "ground_material");
    PanelGroup* contact = addGroup(tr("Where materials meet"));
    contact->addWide(m_contact);
    contact->addNote(tr("One number for all pairs, in place of the table:"));
    addParameter(contact, "friction");
    addParameter(contact, "restitution");
    addParameter(contact, "bounce_friction");
    connect(m_materials, &MaterialsTable::edited, this, &Panel::edited);
    connect(m_contact, &ContactTable::edited, this, &Panel::edited);
}

void EffectsPanel::setScenario(const Scenario& scenario) {
    Panel::setScenario(scenario);
    editor(QStringLiteral("overlap_time"))->setAutomaticValue(overlapTimeOf(scenario));
    m_materials->setScenario(scenario);
    m_contact->setScenario(scenario);
    m_groundMaterial = scenario.effects.groundMaterial;
    showMaterials();
}

void EffectsPanel::setEditable(bool editable) {
    Panel::setEditable(editable);
    m_materials->setEditable(editable);
    m_contact->setEditable(editable);
}

void EffectsPanel::setContent(const Content& content) {
    m_content = content;
    std::size_t taking = 0;
    for (EffectRow* row : m_rows) {
        const auto i = static_cast<std::size_t>(row->kind());
        const EffectDecision* decision = content.decisions != nullptr ? &(*content.decisions)[i] : nullptr;
        const EffectReport* report = nullptr;
        if (content.run != nullptr) {
            for (const EffectReport& each : content.run->effects) {
                if (each.decision.kind == row->kind()) {
                    report = &each;
                }
            }
        }
        taking += decision != nullptr && decision->on ? 1 : 0;
        row->setDecision(decision, content.stale);
        row->setCost(report, content.runStale);
    }
    m_summary->setText(content.decisions == nullptr
                           ? tr("Open a result: which effects its scene calls for appears here, with the reasons, before any run.")
                           : tr("%1 of %2 take part in this scene. One that is off costs nothing.").arg(taking).arg(effectCount));
    setStale(content.decisions != nullptr && content.stale, tr("Settings have changed: decided anew when what runs is through."));
    showSum(content);
    showMaterials();
}

void EffectsPanel::showSum(const Content& content) {
    if (content.run == nullptr || content.run->effects.empty()) {
        m_sum->setText(QStringLiteral("<span style='color:%1'>%2</span>")
                           .arg(tints().muted.name(), tr("What each costs, in ms per step, is measured in a run.")));
        return;
    }
    double ms = 0.0;
    double share = 0.0;
    for (const EffectReport& report : content.run->effects) {
        ms += report.msPerStep;
        share += report.share;
    }
    const QString colour = (content.runStale ? tints().muted : tints().text).name();
    QString text = tr("Together <b>%1</b> per step").arg(shownMilliseconds(ms));
    if (share > 0.0) {
        text += tr(", <b>%1</b> of a step of %2, in the mean of the whole run; the rest is motion and bookkeeping.")
                    .arg(shownStepShare(share), shownMilliseconds(ms / share));
    }
    if (content.runStale) {
        text += QLatin1Char(' ') + tr("Measured before the settings changed.");
    }
    m_sum->setText(QStringLiteral("<span style='color:%1'>%2</span>").arg(colour, text));
}

QString EffectsPanel::sumText() const {
    return m_sum->text();
}

void EffectsPanel::showMaterials() {
    m_materials->setComponents(m_content.components.get());
    std::set<Material> present;
    if (m_content.components != nullptr && !m_content.components->list.empty()) {
        present.insert(m_groundMaterial);
        for (const Component& component : m_content.components->list) {
            present.insert(component.material);
        }
    }
    m_contact->setMaterials(present);
}

}  // namespace rubble::widgets
