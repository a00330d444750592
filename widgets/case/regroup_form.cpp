#include "widgets/case/regroup_form.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <cmath>
#include <optional>

#include "widgets/basics/unit_label.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

void fill(const std::array<QLineEdit*, 3>& fields, const Vec3& value, double perSi) {
    for (int i = 0; i < 3; ++i) {
        fields[static_cast<std::size_t>(i)]->setText(QLocale().toString(value[i] * perSi, 'g', 6));
    }
}

}  // namespace

RegroupForm::RegroupForm(QWidget* parent)
    : QWidget(parent),
      m_merge(new QPushButton(tr("Merge…"))),
      m_rename(new QPushButton(tr("Rename…"))),
      m_split(new QPushButton(tr("Split…"))),
      m_form(new QWidget),
      m_what(new QLabel),
      m_name(new QLineEdit),
      m_nameLabel(new QLabel(tr("New name"))),
      m_cut(new QComboBox),
      m_secondUnit(new UnitLabel({})),
      m_complaint(new QLabel) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_merge, m_rename, m_split}) {
        buttons->addWidget(button);
    }
    column->addLayout(buttons);
    column->addWidget(m_form);
    auto* form = new QVBoxLayout(m_form);
    form->setContentsMargins(0, 4, 0, 0);
    form->setSpacing(4);
    m_what->setWordWrap(true);
    form->addWidget(m_what);
    m_cut->addItem(tr("by what hangs together"));
    m_cut->addItem(tr("by a plane"));
    m_cut->addItem(tr("by a box"));
    m_cut->setAccessibleName(tr("How to split"));
    form->addWidget(m_cut);
    m_firstRow = vectorRow(tr("Point"), m_first, new UnitLabel(tr("m")));
    m_secondRow = vectorRow(tr("Normal"), m_second, m_secondUnit);
    form->addWidget(m_firstRow);
    form->addWidget(m_secondRow);
    auto* nameRow = new QHBoxLayout;
    nameRow->addWidget(m_nameLabel);
    m_name->setObjectName(QStringLiteral("newName"));
    m_name->setAccessibleName(tr("New name"));
    nameRow->addWidget(m_name, 1);
    form->addLayout(nameRow);
    m_complaint->setObjectName(QStringLiteral("complaint"));
    m_complaint->setWordWrap(true);
    m_complaint->hide();
    form->addWidget(m_complaint);
    auto* finish = new QHBoxLayout;
    auto* apply = new QPushButton(tr("Apply"));
    apply->setObjectName(QStringLiteral("primary"));
    auto* leave = new QPushButton(tr("Cancel"));
    finish->addStretch();
    finish->addWidget(leave);
    finish->addWidget(apply);
    form->addLayout(finish);
    m_form->hide();
    m_merge->setObjectName(QStringLiteral("merge"));
    m_rename->setObjectName(QStringLiteral("rename"));
    m_split->setObjectName(QStringLiteral("split"));
    connect(m_merge, &QPushButton::clicked, this, [this] { open(Task::Merge); });
    connect(m_rename, &QPushButton::clicked, this, [this] { open(Task::Rename); });
    connect(m_split, &QPushButton::clicked, this, [this] { open(Task::Split); });
    connect(leave, &QPushButton::clicked, this, [this] { open(Task::None); });
    connect(apply, &QPushButton::clicked, this, &RegroupForm::apply);
    connect(m_name, &QLineEdit::returnPressed, this, &RegroupForm::apply);
    connect(m_cut, &QComboBox::activated, this, &RegroupForm::showCut);
    setSelection({}, {});
}

QWidget* RegroupForm::vectorRow(const QString& label, std::array<QLineEdit*, 3>& fields, UnitLabel* unit) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    auto* name = new QLabel(label);
    name->setObjectName(QStringLiteral("vectorName"));
    line->addWidget(name, 2);
    for (int i = 0; i < 3; ++i) {
        auto* field = new QLineEdit;
        field->setAlignment(Qt::AlignRight);
        field->setPlaceholderText(QString(QLatin1Char("xyz"[i])));
        field->setAccessibleName(tr("%1: %2").arg(label).arg(QLatin1Char("xyz"[i])));
        fields[static_cast<std::size_t>(i)] = field;
        line->addWidget(field, 2);
    }
    line->addWidget(unit);
    return row;
}

void RegroupForm::setSelection(const QStringList& selected, const QStringList& all) {
    m_selected = selected;
    m_all = all;
    m_merge->setEnabled(selected.size() >= 2);
    m_rename->setEnabled(selected.size() == 1);
    m_split->setEnabled(selected.size() == 1);
    const QString select = tr("Select components in the table first");
    m_merge->setToolTip(selected.size() >= 2 ? tr("Join the selected components into one") : select);
    m_rename->setToolTip(selected.size() == 1 ? tr("Give the selected component another name") : select);
    m_split->setToolTip(selected.size() == 1 ? tr("Split the selected component") : select);
    open(Task::None);
}

void RegroupForm::setBounds(const Aabb& bounds) {
    m_bounds = bounds;
}

void RegroupForm::open(Task task) {
    m_task = task;
    m_complaint->hide();
    m_form->setVisible(task != Task::None);
    if (task == Task::None || m_selected.isEmpty()) {
        return;
    }
    const QString first = m_selected.front();
    m_cut->setVisible(task == Task::Split);
    m_firstRow->hide();
    m_secondRow->hide();
    m_nameLabel->show();
    m_name->show();
    if (task == Task::Merge) {
        m_what->setText(tr("Join %1 into one component").arg(m_selected.join(QStringLiteral(", "))));
        m_name->setText(first);
    } else if (task == Task::Rename) {
        m_what->setText(tr("Rename %1").arg(first));
        m_name->setText(first);
    } else {
        m_what->setText(tr("Split %1").arg(first));
        m_name->setText(tr("%1 part").arg(first));
        showCut();
    }
    m_name->selectAll();
    m_name->setFocus();
}

void RegroupForm::showCut() {
    const auto cut = static_cast<Cut>(m_cut->currentIndex());
    m_firstRow->setVisible(cut != Cut::Connectivity);
    m_secondRow->setVisible(cut != Cut::Connectivity);
    // Pieces that hang together are numbered, not named.
    m_name->setVisible(cut != Cut::Connectivity);
    m_nameLabel->setVisible(cut != Cut::Connectivity);
    m_firstRow->findChild<QLabel*>(QStringLiteral("vectorName"))->setText(cut == Cut::Box ? tr("From") : tr("Point"));
    m_secondRow->findChild<QLabel*>(QStringLiteral("vectorName"))->setText(cut == Cut::Box ? tr("To") : tr("Normal"));
    m_secondUnit->setUnit(cut == Cut::Box ? tr("m") : QString());
    if (!m_bounds.isEmpty()) {
        const Vec3 centre = m_bounds.center();
        const double perMetre = figures::shownUnit("m").perSi;
        fill(m_first, cut == Cut::Box ? Vec3(m_bounds.min()) : centre, perMetre);
        fill(m_second, cut == Cut::Box ? centre : Vec3(Vec3::UnitX()), cut == Cut::Box ? perMetre : 1.0);
    }
}

std::optional<Vec3> RegroupForm::vector(const std::array<QLineEdit*, 3>& fields) const {
    Vec3 value = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        bool ok = false;
        value[i] = QLocale().toDouble(fields[static_cast<std::size_t>(i)]->text(), &ok);
        if (!ok || !std::isfinite(value[i])) {
            return std::nullopt;
        }
    }
    return value;
}

void RegroupForm::refuse(const QString& why) {
    m_complaint->setText(why);
    m_complaint->show();
}

std::optional<RegroupStep> RegroupForm::splitStep() {
    const std::string component = m_selected.front().toStdString();
    const std::string name = m_name->text().trimmed().toStdString();
    const auto cut = static_cast<Cut>(m_cut->currentIndex());
    if (cut == Cut::Connectivity) {
        return SplitByConnectivity{component};
    }
    auto first = vector(m_first);
    auto second = vector(m_second);
    if (!first || !second) {
        refuse(tr("Three numbers are needed in each row."));
        return std::nullopt;
    }
    *first = *first / figures::shownUnit("m").perSi;
    if (cut == Cut::Box) {
        *second = *second / figures::shownUnit("m").perSi;
        if (((*second - *first).array() <= 0.0).any()) {
            refuse(tr("“To” must lie beyond “From” along every axis."));
            return std::nullopt;
        }
        return SplitByBox{component, *first, *second, name};
    }
    if (second->norm() < 1e-9) {
        refuse(tr("The normal must not be zero."));
        return std::nullopt;
    }
    return SplitByPlane{component, *first, second->normalized(), name};
}

void RegroupForm::apply() {
    const QString name = m_name->text().trimmed();
    const bool named = !m_name->isHidden();
    const bool takesOwn = m_task == Task::Merge && m_selected.contains(name);
    if (named && name.isEmpty()) {
        refuse(tr("A name is needed."));
        return;
    }
    if (named && m_all.contains(name) && !takesOwn) {
        refuse(tr("There is a component “%1” already.").arg(name));
        return;
    }
    std::optional<RegroupStep> step;
    if (m_task == Task::Merge) {
        MergeComponents merge;
        for (const QString& component : std::as_const(m_selected)) {
            merge.components.push_back(component.toStdString());
        }
        merge.newName = name.toStdString();
        step = merge;
    } else if (m_task == Task::Rename) {
        step = RenameComponent{m_selected.front().toStdString(), name.toStdString()};
    } else {
        step = splitStep();
    }
    if (step) {
        open(Task::None);
        emit regroupRequested(*step);
    }
}

}  // namespace rubble::widgets
