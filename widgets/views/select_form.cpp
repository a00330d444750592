#include "widgets/views/select_form.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/theme.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr std::array<char, 3> axes{'x', 'y', 'z'};

}  // namespace

bool SelectForm::Criteria::empty() const {
    bool none = component.empty() && !bornFrom && !bornTo && !cluster;
    for (std::size_t i = 0; i < 3; ++i) {
        none = none && !low[i] && !high[i];
    }
    return none;
}

QLineEdit* SelectForm::addField(const QString& name, const QString& tip) {
    auto* field = new QLineEdit(this);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    field->setAlignment(Qt::AlignRight);
    field->setMaximumWidth(90);
    connect(field, &QLineEdit::returnPressed, this, [this] { ask(How::Replace); });
    return field;
}

SelectForm::SelectForm(QWidget* parent) : QWidget(parent), m_component(new QComboBox), m_found(new QLabel) {
    const QString open = tr("empty: no bound");
    // Long names widen the list that opens, not the form.
    m_component->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_component->setMinimumContentsLength(10);
    m_component->setAccessibleName(tr("Component"));
    m_component->setToolTip(tr("Elements of this component"));
    m_bornFrom = addField(tr("Born from"), tr("Fragments born at or after this time; %1").arg(open));
    m_bornTo = addField(tr("Born to"), tr("Fragments born at or before this time; %1").arg(open));
    m_cluster = addField(tr("Cluster"), tr("Fragments of the cluster with this number; empty: any"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(6);
    const auto put = [grid](int row, const QString& label, QWidget* first, QWidget* second, const QString& unit) {
        auto* name = new QLabel(label);
        name->setBuddy(first);
        grid->addWidget(name, row, 0);
        grid->addWidget(first, row, 1, 1, second == nullptr ? 3 : 1);
        if (second != nullptr) {
            grid->addWidget(new QLabel(QStringLiteral("–")), row, 2);
            grid->addWidget(second, row, 3);
        }
        auto* of = new UnitLabel(unit);
        grid->addWidget(of, row, 4);
    };
    put(0, tr("component"), m_component, nullptr, {});
    put(1, tr("born"), m_bornFrom, m_bornTo, QStringLiteral("s"));
    put(2, tr("cluster"), m_cluster, nullptr, {});
    for (std::size_t i = 0; i < 3; ++i) {
        const QString axis{QLatin1Char(axes[i])};
        const QString tip =
            tr("Centres with %1 within these bounds at the time shown, counted as exported tables do; %2").arg(axis, open);
        m_low[i] = addField(tr("%1 from").arg(axis), tip);
        m_high[i] = addField(tr("%1 to").arg(axis), tip);
        put(3 + static_cast<int>(i), axis, m_low[i], m_high[i], tr("m"));
    }
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 10, 14, 10);
    column->addLayout(grid);
    auto* row = new QHBoxLayout;
    const std::array<std::pair<QString, How>, 3> buttons{
        {{tr("Select"), How::Replace}, {tr("Add"), How::Add}, {tr("Take out"), How::Remove}}};
    for (const auto& [text, how] : buttons) {
        auto* button = new QPushButton(text);
        button->setToolTip(how == How::Replace ? tr("Select what fits, and nothing else")
                           : how == How::Add   ? tr("Add what fits to the selection")
                                               : tr("Take what fits out of the selection"));
        connect(button, &QPushButton::clicked, this, [this, how = how] { ask(how); });
        row->addWidget(button);
    }
    row->addStretch();
    column->addLayout(row);
    m_found->setObjectName(QStringLiteral("muted"));
    m_found->setWordWrap(true);
    column->addWidget(m_found);
    column->addStretch();
    setComponents({});
}

// A time that was typed for one result would be read in the unit of another.
bool SelectForm::event(QEvent* event) {
    if (event->type() == unitsChanged()) {
        m_bornFrom->clear();
        m_bornTo->clear();
        m_found->clear();
    }
    return QWidget::event(event);
}

void SelectForm::setComponents(const std::vector<std::string>& names) {
    const QString before = m_component->currentText();
    m_component->clear();
    m_component->addItem(tr("any"));
    for (const std::string& name : names) {
        m_component->addItem(QString::fromStdString(name), QString::fromStdString(name));
    }
    m_component->setCurrentIndex(std::max(0, m_component->findText(before)));
}

void SelectForm::setFound(std::size_t count) {
    m_found->setText(count == 0 ? tr("Nothing fits.") : tr("%1 elements fit.").arg(shownCount(static_cast<std::int64_t>(count))));
}

std::optional<double> SelectForm::numberIn(const QLineEdit* field, const QString& name, QString& complaint,
                                           const char* unit) const {
    const QString text = field->text().trimmed();
    if (text.isEmpty()) {
        return std::nullopt;
    }
    const std::optional<double> value = typedNumber(text, unit);
    if (!value) {
        complaint = tr("%1: “%2” is no number.").arg(name, text);
    }
    return value;
}

SelectForm::Criteria SelectForm::criteria() const {
    QString complaint;
    Criteria criteria;
    criteria.component = m_component->currentData().toString().toStdString();
    criteria.bornFrom = numberIn(m_bornFrom, tr("Born from"), complaint, "s");
    criteria.bornTo = numberIn(m_bornTo, tr("Born to"), complaint, "s");
    if (const auto number = numberIn(m_cluster, tr("Cluster"), complaint)) {
        if (*number < 0.0 || *number != std::floor(*number) || *number > 4e9) {
            complaint = tr("A cluster has a whole number from 0.");
        } else {
            criteria.cluster = static_cast<std::size_t>(*number);
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto metres = [&](const QLineEdit* field) {
            const auto typed = numberIn(field, field->accessibleName(), complaint);
            return typed ? std::optional(typedIn(*typed, "m")) : std::nullopt;
        };
        criteria.low[i] = metres(m_low[i]);
        criteria.high[i] = metres(m_high[i]);
    }
    m_found->setText(complaint);
    return criteria;
}

void SelectForm::ask(How how) {
    Criteria asked = criteria();
    if (!m_found->text().isEmpty()) {
        return;
    }
    if (asked.empty()) {
        m_found->setText(tr("Give at least one of these."));
        return;
    }
    asked.how = how;
    emit selectRequested(asked);
}

}  // namespace rubble::widgets
