#include "widgets/evidence/varied_table.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/scenario/parameters.h"
#include "widgets/basics/language.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/report/spoken_text.h"

namespace rubble::widgets {

namespace {

bool isNumber(const Parameter& row) {
    return row.kind == ParameterKind::Number || row.kind == ParameterKind::Integer;
}

bool mayVary(const Parameter& row) {
    return row.stage != Stage::Import && !row.keyed() && row.kind != ParameterKind::Text && row.key != "seed";
}

/// A fifth to both sides of the default, as far as the range goes; of a default that is none or zero a part of the range.
VariedSetting proposedFor(const Parameter& row) {
    VariedSetting varied;
    varied.key = std::string(row.key);
    if (!isNumber(row)) {
        varied.distribution = Distribution::Choice;
        for (const std::string_view choice : row.choices) {
            varied.choices.emplace_back(choice);
        }
        if (row.kind == ParameterKind::Switch) {
            varied.choices = {"true", "false"};
        }
        return varied;
    }
    const ParameterValue byDefault = row.get(Scenario(), {});
    const auto* whole = std::get_if<std::int64_t>(&byDefault);
    const auto* number = std::get_if<double>(&byDefault);
    const double middle = whole != nullptr ? static_cast<double>(*whole) : number != nullptr ? *number : 0.0;
    const double least = std::isfinite(row.low) ? row.low : 0.0;
    const double most = std::isfinite(row.high) ? std::min(row.high, least + 1.0) : least + 1.0;
    varied.first = middle != 0.0 ? std::max(row.low, middle - 0.2 * std::abs(middle)) : least;
    varied.second = middle != 0.0 ? std::min(row.high, middle + 0.2 * std::abs(middle)) : most;
    if (whole != nullptr) {
        varied.first = std::floor(varied.first);
        varied.second = std::max(std::ceil(varied.second), varied.first + 1.0);
    }
    return varied;
}

/// The same parameter under another distribution, over about the same values.
VariedSetting withKind(const VariedSetting& varied, Distribution kind) {
    if (kind == varied.distribution) {
        return varied;
    }
    VariedSetting after = varied;
    after.distribution = kind;
    double least = varied.first;
    double most = varied.second;
    if (varied.distribution == Distribution::Normal) {
        least = varied.first - 2.0 * varied.second;
        most = varied.first + 2.0 * varied.second;
    } else if (varied.distribution == Distribution::Choice) {
        const VariedSetting proposed = proposedFor(*findParameter(varied.key).first);
        least = proposed.first;
        most = proposed.second;
    }
    const Parameter& row = *findParameter(varied.key).first;
    least = std::max(least, row.low);
    most = std::min(most, row.high);
    const bool normal = kind == Distribution::Normal;
    after.first = normal ? 0.5 * (least + most) : least;
    after.second = normal ? 0.25 * (most - least) : most;
    after.choices.clear();
    if (kind == Distribution::Choice) {
        after.choices = {valueText(ParameterValue(least)), valueText(ParameterValue(most))};
    }
    return after;
}

}  // namespace

VariedTable::VariedTable(QWidget* parent)
    : QWidget(parent), m_rows(new QVBoxLayout), m_add(new QComboBox), m_complaint(new QLabel) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    m_rows->setSpacing(10);
    column->addLayout(m_rows);
    m_complaint->setObjectName(QStringLiteral("complaint"));
    m_complaint->setWordWrap(true);
    m_complaint->hide();
    column->addWidget(m_complaint);
    m_add->setObjectName(QStringLiteral("addVaried"));
    m_add->setAccessibleName(tr("Vary another parameter"));
    m_add->setToolTip(tr("Choose a parameter that every member gets a value of its own of"));
    m_add->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    column->addWidget(m_add);
    connect(m_add, &QComboBox::activated, this, [this](int index) {
        const QString key = m_add->itemData(index).toString();
        m_add->setCurrentIndex(0);
        if (!key.isEmpty()) {
            add(key);
        }
    });
    setContent({}, {});
}

QString VariedTable::nameOf(const std::string& key) {
    return key == scenarioKey ? tr("Scenario") : figures::spokenSetting(key);
}

void VariedTable::setContent(const std::vector<VariedSetting>& varied, const std::vector<Choice>& scenarios) {
    m_complaint->hide();
    if (m_built && varied == m_varied && scenarios == m_scenarios) {
        return;
    }
    m_varied = varied;
    m_scenarios = scenarios;
    build();
}

void VariedTable::build() {
    m_built = true;
    while (QLayoutItem* item = m_rows->takeAt(0)) {
        // A row may be where the edit came from that takes it away.
        item->widget()->hide();
        item->widget()->deleteLater();
        delete item;
    }
    for (std::size_t i = 0; i < m_varied.size(); ++i) {
        m_rows->addWidget(rowOf(i));
    }
    if (m_varied.empty()) {
        auto* none = new QLabel(tr("Nothing is varied: members differ by a micrometre at birth, as the repeats of a run do."));
        none->setObjectName(QStringLiteral("muted"));
        none->setWordWrap(true);
        m_rows->addWidget(none);
    }
    fillAdditions();
}

void VariedTable::fillAdditions() {
    m_add->clear();
    m_add->addItem(tr("Vary another parameter…"));
    const auto known = [this](std::string_view key) {
        return std::any_of(m_varied.begin(), m_varied.end(), [&](const VariedSetting& each) { return each.key == key; });
    };
    if (m_scenarios.size() > 1 && !known(scenarioKey)) {
        m_add->addItem(tr("Scenario"), QString::fromUtf8(scenarioKey.data(), static_cast<qsizetype>(scenarioKey.size())));
    }
    for (const Parameter& row : parameterTable()) {
        if (mayVary(row) && !known(row.key)) {
            const std::string key(row.key);
            m_add->addItem(nameOf(key), QString::fromStdString(key));
            m_add->setItemData(m_add->count() - 1, shownHelp(row), Qt::ToolTipRole);
        }
    }
}

QWidget* VariedTable::rowOf(std::size_t place) {
    const VariedSetting& varied = m_varied[place];
    const QString name = nameOf(varied.key);
    const Parameter* row = varied.key == scenarioKey ? nullptr : findParameter(varied.key).first;
    auto* made = new QWidget;
    auto* column = new QVBoxLayout(made);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* first = new QHBoxLayout;
    auto* label = new QLabel(name);
    label->setWordWrap(true);
    label->setToolTip(row != nullptr ? said("parameters", row->help) : tr("Which scenario of the case a member is of"));
    first->addWidget(label, 1);
    if (row != nullptr && isNumber(*row)) {
        QComboBox* kind = kindOf(place);
        label->setBuddy(kind);
        first->addWidget(kind);
    }
    auto* remove = new QToolButton;
    remove->setText(QStringLiteral("×"));
    remove->setAccessibleName(tr("Do not vary %1").arg(name));
    remove->setToolTip(tr("Do not vary %1: every member has the value of the scenario").arg(name));
    remove->setFocusPolicy(Qt::TabFocus);
    connect(remove, &QToolButton::clicked, this, [this, place, name] {
        std::vector<VariedSetting> after = m_varied;
        after.erase(after.begin() + static_cast<std::ptrdiff_t>(place));
        propose(std::move(after), [key = m_varied[place].key] { return tr("%1 not varied").arg(nameOf(key)); });
    });
    first->addWidget(remove);
    column->addLayout(first);
    column->addWidget(varied.distribution == Distribution::Choice ? choicesOf(place) : numbersOf(place));
    return made;
}

QComboBox* VariedTable::kindOf(std::size_t place) {
    const VariedSetting& varied = m_varied[place];
    auto* kind = new QComboBox;
    kind->addItems({tr("uniform"), tr("normal"), tr("one of")});
    kind->setCurrentIndex(static_cast<int>(varied.distribution));
    kind->setAccessibleName(tr("Distribution of %1").arg(nameOf(varied.key)));
    kind->setToolTip(
        tr("uniform: every value from the least to the greatest is as likely. normal: around a mean with a "
           "standard deviation, cut at the range of the parameter. one of: the values given, all as likely"));
    connect(kind, &QComboBox::activated, this,
            [this, place](int index) { edit(place, withKind(m_varied[place], static_cast<Distribution>(index))); });
    return kind;
}

QWidget* VariedTable::numbersOf(std::size_t place) {
    const VariedSetting& varied = m_varied[place];
    const Parameter& row = *findParameter(varied.key).first;
    const bool normal = varied.distribution == Distribution::Normal;
    const QString name = nameOf(varied.key);
    const QString range = tr("From %1 to %2").arg(shownNumber(row.low, 6), shownNumber(row.high, 6));
    auto* made = new QWidget;
    auto* line = new QHBoxLayout(made);
    line->setContentsMargins(0, 0, 0, 0);
    const std::string unit(row.unit);
    const auto field = [&](const QString& words, const QString& tip, double value, double VariedSetting::* member) {
        auto* editor = new NumberField(QStringLiteral("%1, %2").arg(name, words));
        editor->setUnit(unit);
        editor->setToolTip(tip);
        editor->setNumber(value);
        connect(editor, &NumberField::edited, this, [this, place, member](std::optional<double> number) {
            VariedSetting after = m_varied[place];
            after.*member = *number;
            edit(place, after);
        });
        line->addWidget(editor, 1);
    };
    field(normal ? tr("mean") : tr("least"), (normal ? tr("Mean of the members.") : tr("Least value of a member.")) + u' ' + range,
          varied.first, &VariedSetting::first);
    line->addWidget(new QLabel(normal ? QStringLiteral("±") : tr("to")));
    field(normal ? tr("standard deviation") : tr("greatest"),
          normal ? tr("Standard deviation of the members, above zero") : tr("Greatest value of a member.") + u' ' + range,
          varied.second, &VariedSetting::second);
    auto* of = new UnitLabel(QString::fromStdString(unit));
    of->setMinimumWidth(28);
    line->addWidget(of);
    return made;
}

QWidget* VariedTable::choicesOf(std::size_t place) {
    const VariedSetting& varied = m_varied[place];
    const QString name = nameOf(varied.key);
    const Parameter* row = varied.key == scenarioKey ? nullptr : findParameter(varied.key).first;
    auto* made = new QWidget;
    auto* line = new QVBoxLayout(made);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(2);
    if (row != nullptr && isNumber(*row)) {
        QStringList values;
        for (const std::string& choice : varied.choices) {
            values << QString::fromStdString(choice);
        }
        auto* field = new QLineEdit(values.join(QStringLiteral(", ")));
        field->setAccessibleName(tr("Values of %1").arg(name));
        field->setToolTip(tr("Values separated by commas, with a point as decimal sign; all as likely. From %1 to %2")
                              .arg(shownNumber(row->low, 6), shownNumber(row->high, 6)));
        connect(field, &QLineEdit::editingFinished, this, [this, place, field] {
            if (!field->isModified()) {
                return;
            }
            field->setModified(false);
            VariedSetting after = m_varied[place];
            after.choices.clear();
            for (const QString& each : field->text().split(u',')) {
                after.choices.push_back(each.trimmed().toStdString());
            }
            edit(place, after);
        });
        line->addWidget(field);
        return made;
    }
    std::vector<Choice> all = m_scenarios;
    if (row != nullptr) {
        all.clear();
        for (const std::string& choice : proposedFor(*row).choices) {
            all.push_back({QString::fromStdString(choice), choice == "true"    ? tr("on")
                                                           : choice == "false" ? tr("off")
                                                                               : shownName(choice)});
        }
    }
    for (const Choice& choice : all) {
        auto* box = new QCheckBox(choice.name);
        const std::string id = choice.id.toStdString();
        box->setChecked(std::find(varied.choices.begin(), varied.choices.end(), id) != varied.choices.end());
        box->setToolTip(tr("Members may have this; all that are ticked are as likely"));
        connect(box, &QCheckBox::clicked, this, [this, place, id](bool on) {
            VariedSetting after = m_varied[place];
            std::erase(after.choices, id);
            if (on) {
                after.choices.push_back(id);
            }
            edit(place, after);
        });
        line->addWidget(box);
    }
    return made;
}

void VariedTable::add(const QString& key) {
    VariedSetting added;
    added.key = key.toStdString();
    if (added.key == scenarioKey) {
        added.distribution = Distribution::Choice;
        for (const Choice& scenario : m_scenarios) {
            added.choices.push_back(scenario.id.toStdString());
        }
    } else {
        added = proposedFor(*findParameter(added.key).first);
    }
    std::vector<VariedSetting> after = m_varied;
    after.push_back(std::move(added));
    propose(std::move(after), [key = key.toStdString()] { return tr("%1 varied").arg(nameOf(key)); });
}

void VariedTable::edit(std::size_t place, const VariedSetting& after) {
    std::vector<VariedSetting> all = m_varied;
    all[place] = after;
    propose(std::move(all), [key = after.key] { return tr("distribution of %1").arg(nameOf(key)); });
}

void VariedTable::propose(std::vector<VariedSetting> varied, const Wording& what) {
    m_complaint->hide();
    if (varied == m_varied) {
        return;
    }
    try {
        EnsembleSettings settings;
        settings.varied = varied;
        checkEnsemble(settings);
    } catch (const UsageError& error) {
        m_complaint->setText(worded(error.message()) + u' ' + worded(error.remedy()));
        m_complaint->show();
        return;
    }
    emit variedEdited(varied, what);
}

}  // namespace rubble::widgets
