#include "widgets/case/materials_table.h"

#include <QGridLayout>
#include <QLabel>

#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

MaterialsTable::MaterialsTable(QWidget* parent) : QWidget(parent), m_grid(new QGridLayout(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(8);
    m_grid->setVerticalSpacing(4);
    m_grid->setColumnStretch(0, 2);
    m_grid->setColumnStretch(1, 3);
    build({});
}

ParameterEditor* MaterialsTable::addEditor(const std::string& key, int row, int column) {
    const auto [parameter, subject] = findParameter(key);
    auto* editor = new ParameterEditor(*parameter, subject);
    connect(editor, &ParameterEditor::edited, this, &MaterialsTable::edited);
    m_grid->addWidget(editor, row, column);
    m_editors.push_back(editor);
    return editor;
}

void MaterialsTable::build(const std::vector<std::string>& names) {
    while (QLayoutItem* item = m_grid->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_editors.clear();
    m_names = names;
    const auto label = [](const QString& text, bool small) {
        auto* made = new QLabel(text);
        if (small) {
            made->setObjectName(QStringLiteral("muted"));
            made->setFont(headingFont());
        }
        made->setWordWrap(!small);
        return made;
    };
    if (names.empty()) {
        auto* none = label(tr("The components of a result appear here."), true);
        none->setWordWrap(true);
        m_grid->addWidget(none, 0, 0, 1, 3);
        return;
    }
    const std::array heads = {tr("component"), tr("material"), tr("reinforced")};
    for (int column = 0; column < 3; ++column) {
        m_grid->addWidget(label(heads[static_cast<std::size_t>(column)], true), 0, column);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int row = static_cast<int>(i) + 1;
        const QString name = QString::fromStdString(names[i]);
        m_grid->addWidget(label(name, false), row, 0);
        ParameterEditor* material = addEditor("component[" + names[i] + "].material", row, 1);
        ParameterEditor* reinforced = addEditor("component[" + names[i] + "].reinforced", row, 2);
        for (ParameterEditor* editor : {material, reinforced}) {
            if (QWidget* field = editor->focusProxy()) {
                field->setAccessibleName(tr("%1 of %2").arg(editor->label(), name));
            }
        }
    }
}

void MaterialsTable::setComponents(const Components* components) {
    std::vector<std::string> names;
    if (components != nullptr) {
        for (const Component& component : components->list) {
            names.push_back(component.name);
        }
    }
    if (names != m_names) {
        build(names);
        setScenario(m_scenario);
        setEditable(m_editable);
    }
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        const auto set = m_scenario.components.find(m_names[i]);
        const bool guessed = set == m_scenario.components.end() || !set->second.material;
        const Component& component = components->list[i];
        m_editors[2 * i]->setAutomaticText(
            guessed ? automaticMaterial(materialName(component.material), someMaterialFits(component.density)) : QString());
    }
}

QString automaticMaterial(std::string_view material, bool fits) {
    const QString name = shownName(material);
    return fits ? name : MaterialsTable::tr("as %1").arg(name);
}

void MaterialsTable::setScenario(const Scenario& scenario) {
    m_scenario = scenario;
    for (ParameterEditor* editor : m_editors) {
        editor->setValue(parameterValue(scenario, editor->key().toStdString()));
    }
}

void MaterialsTable::setEditable(bool editable) {
    m_editable = editable;
    for (ParameterEditor* editor : m_editors) {
        editor->setAvailable(editable, tr("Open a result first"));
    }
}

}  // namespace rubble::widgets
