#pragma once

#include <array>
#include <memory>

#include "core/simulation/run/simulation.h"
#include "widgets/basics/panel.h"

class QLabel;

namespace rubble::widgets {

class ContactTable;
class EffectRow;
class MaterialsTable;

/// What acts on the fragments, why, and what it costs: the eight effects with their switches and settings, and the materials that
/// meet.
class EffectsPanel : public Panel {
    Q_OBJECT

public:
    explicit EffectsPanel(QWidget* parent = nullptr);

    struct Content {
        std::shared_ptr<const EffectDecisions> decisions;  ///< null: not decided yet
        bool stale = false;                                ///< decided under other settings
        std::shared_ptr<const SimulationResult> run;       ///< the last run, for what the effects cost; null: none
        bool runStale = false;                             ///< simulated under other settings
        std::shared_ptr<const Components> components;
        friend bool operator==(const Content&, const Content&) = default;
    };
    void setContent(const Content& content);
    const Content& content() const { return m_content; }
    void setScenario(const Scenario& scenario) override;
    void setEditable(bool editable) override;
    EffectRow* row(EffectKind kind) const { return m_rows[static_cast<std::size_t>(kind)]; }
    /// The line under the rows that adds up what they cost.
    QString sumText() const;

private:
    void buildRows();
    void buildMaterials();
    void showSum(const Content& content);
    void showMaterials();

    std::array<EffectRow*, effectCount> m_rows{};
    QLabel* m_summary;
    QLabel* m_sum;
    MaterialsTable* m_materials;
    ContactTable* m_contact;
    Content m_content;
    Material m_groundMaterial = Material::Soil;
};

/// Whether the Effects panel shows an unkeyed parameter.
bool isEffectParameter(std::string_view key);

}  // namespace rubble::widgets
