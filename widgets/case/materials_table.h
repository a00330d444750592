#pragma once

#include <QWidget>
#include <string_view>
#include <vector>

#include "core/fe/components.h"
#include "core/scenario/parameters.h"

class QGridLayout;

namespace rubble::widgets {

class ParameterEditor;

/// What every component is made of, and whether it is reinforced: a row for each component.
class MaterialsTable : public QWidget {
    Q_OBJECT

public:
    explicit MaterialsTable(QWidget* parent = nullptr);

    /// Null: none are known.
    void setComponents(const Components* components);
    void setScenario(const Scenario& scenario);
    void setEditable(bool editable);
    const std::vector<ParameterEditor*>& editors() const { return m_editors; }

signals:
    /// The user changed the material or the reinforcement of a component.
    void edited(const QString& key, const rubble::ParameterValue& value);

private:
    void build(const std::vector<std::string>& names);
    ParameterEditor* addEditor(const std::string& key, int row, int column);

    QGridLayout* m_grid;
    std::vector<std::string> m_names;
    std::vector<ParameterEditor*> m_editors;  // material and reinforcement in turn
    Scenario m_scenario;
    bool m_editable = true;
};

/// What a field says of a material that was guessed: "concrete"; "as concrete" where none fits the density.
QString automaticMaterial(std::string_view material, bool fits);

}  // namespace rubble::widgets
