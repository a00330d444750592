#include "widgets/basics/parameter_editor.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QToolButton>
#include <array>
#include <cmath>

#include "widgets/basics/language.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

QString qt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// Off, on or automatic: shown as buttons, so that the choice is seen without opening a list.
bool isSwitch(const Parameter& row) {
    return row.choices == std::vector<std::string_view>{"off", "on", "auto"};
}

}  // namespace

ParameterEditor::ParameterEditor(const Parameter& row, std::string subject, QWidget* parent)
    : QWidget(parent), m_row(row), m_subject(std::move(subject)) {
    build();
    setToolTip(tip());
    setObjectName(key());
}

QString ParameterEditor::key() const {
    return qt(m_row.key).replace(QStringLiteral("[*]"), QStringLiteral("[%1]").arg(QString::fromStdString(m_subject)));
}

QString ParameterEditor::label() const {
    return said("parameters", m_row.label);
}

QString ParameterEditor::siUnit() const {
    return qt(m_row.unit).replace(QStringLiteral("x d"), QStringLiteral("× d"));
}

QString ParameterEditor::numberText(double value) const {
    return QLocale().toString(value * figures::shownUnit(m_row.unit, value).perSi, 'g', 6);
}

QString ParameterEditor::withUnit(double bound) const {
    // Zero has no size of its own: it takes the unit of the other bound.
    const double size = bound == 0.0 && std::isfinite(m_row.high) ? m_row.high : bound;
    const QString unit = figures::shownUnit(siUnit().toStdString(), size).name;
    return unit.isEmpty() ? numberText(bound) : numberText(bound) + QChar(0x00A0) + unit;
}

// What decides the unit of a time. Zero has no size: it is told as the delivered value is, or in seconds.
double ParameterEditor::shownSize() const {
    const auto* number = std::get_if<double>(&m_value);
    if (const double shown = number != nullptr ? *number : m_automaticValue; shown != 0.0) {
        return shown;
    }
    if (m_row.unit != "s") {
        return 0.0;
    }
    const ParameterValue delivered = m_row.get(Scenario(), m_subject);
    const auto* usual = std::get_if<double>(&delivered);
    return usual != nullptr && *usual != 0.0 ? *usual : 1.0;
}

QString ParameterEditor::textOf(const ParameterValue& value) const {
    const auto* number = std::get_if<double>(&value);
    return number != nullptr ? numberText(*number) : shownValue(value);
}

bool ParameterEditor::event(QEvent* event) {
    if (event->type() == unitsChanged()) {
        setToolTip(isEnabled() ? tip() : toolTip());
        if (m_field != nullptr) {
            show(m_value);
        }
        return true;
    }
    return QWidget::event(event);
}

QString ParameterEditor::tip() const {
    QString text = QStringLiteral("<p>") + shownHelp(m_row).toHtmlEscaped() + QStringLiteral("</p>");
    if (std::isfinite(m_row.low) || std::isfinite(m_row.high)) {
        const QString low = std::isfinite(m_row.low) ? withUnit(m_row.low) : QStringLiteral("−∞");
        const QString high = std::isfinite(m_row.high) ? withUnit(m_row.high) : QStringLiteral("∞");
        text += QStringLiteral("<p>") + tr("From %1 to %2").arg(low, high) + QStringLiteral("</p>");
    }
    return text + QStringLiteral("<p><code>") + key().toHtmlEscaped() + QStringLiteral("</code></p>");
}

void ParameterEditor::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    auto* line = new QHBoxLayout;
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    column->addLayout(line);
    if (m_row.kind == ParameterKind::Switch && !m_row.automatic) {
        m_switch = new QCheckBox;
        m_switch->setAccessibleName(label());
        line->addStretch();
        line->addWidget(m_switch);
        connect(m_switch, &QCheckBox::clicked, this, [this](bool on) {
            m_value = on;
            emit edited(key(), m_value);
        });
        setFocusProxy(m_switch);
    } else if (m_row.kind == ParameterKind::Choice && m_row.choices.size() < 2) {
        // Nothing to choose yet: told, not offered.
        m_only = new QLabel;
        m_only->setObjectName(QStringLiteral("value"));
        m_only->setAlignment(Qt::AlignRight);
        line->addWidget(m_only, 1);
    } else if (m_row.kind == ParameterKind::Choice && isSwitch(m_row)) {
        buildSegments(line);
    } else if (m_row.kind == ParameterKind::Choice || m_row.kind == ParameterKind::Switch) {
        buildChoice(line);
    } else {
        buildField();
        line->addWidget(m_field, 1);
        if (m_auto != nullptr) {
            line->addWidget(m_auto);
        }
        m_complaint = new QLabel(this);
        m_complaint->setObjectName(QStringLiteral("complaint"));
        m_complaint->setWordWrap(true);
        m_complaint->setAttribute(Qt::WA_TransparentForMouseEvents);
        m_complaint->hide();
        connect(this, &QObject::destroyed, m_complaint, &QObject::deleteLater);
        setFocusProxy(m_field);
    }
}

void ParameterEditor::buildSegments(QBoxLayout* line) {
    m_segments = new QButtonGroup(this);
    line->addStretch();
    line->setSpacing(0);
    const std::array names = {tr("off"), tr("on"), tr("auto")};
    for (int i = 0; i < 3; ++i) {
        auto* button = new QToolButton;
        button->setText(names[static_cast<std::size_t>(i)]);
        button->setCheckable(true);
        button->setObjectName(QStringLiteral("segment"));
        button->setProperty("place", i == 0 ? QStringLiteral("first") : i == 2 ? QStringLiteral("last") : QString());
        button->setAccessibleName(QStringLiteral("%1: %2").arg(label(), button->text()));
        button->setFocusPolicy(Qt::StrongFocus);
        m_segments->addButton(button, i);
        line->addWidget(button);
    }
    connect(m_segments, &QButtonGroup::idClicked, this, [this](int id) {
        const ParameterValue chosen = std::string(m_row.choices[static_cast<std::size_t>(id)]);
        if (chosen != m_value) {
            m_value = chosen;
            emit edited(key(), m_value);
        }
    });
    setFocusProxy(m_segments->button(2));
}

void ParameterEditor::buildChoice(QBoxLayout* line) {
    m_choice = new QComboBox;
    m_choice->setAccessibleName(label());
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setMinimumContentsLength(8);
    if (m_row.automatic) {
        m_choice->addItem(tr("auto"), QString());
    }
    if (m_row.kind == ParameterKind::Switch) {
        m_choice->addItem(tr("yes"), QStringLiteral("yes"));
        m_choice->addItem(tr("no"), QStringLiteral("no"));
    }
    for (const std::string_view choice : m_row.choices) {
        m_choice->addItem(shownName(choice), qt(choice));
    }
    line->addWidget(m_choice, 1);
    connect(m_choice, &QComboBox::activated, this, [this] {
        const QString chosen = m_choice->currentData().toString();
        m_value = chosen.isEmpty()                      ? ParameterValue()
                  : m_row.kind == ParameterKind::Switch ? ParameterValue(chosen == QLatin1String("yes"))
                                                        : ParameterValue(chosen.toStdString());
        emit edited(key(), m_value);
    });
    setFocusProxy(m_choice);
}

void ParameterEditor::buildField() {
    m_field = new QLineEdit;
    m_field->setAccessibleName(label());
    m_field->setMinimumWidth(56);
    if (m_row.kind != ParameterKind::Text) {
        m_field->setAlignment(Qt::AlignRight);
    }
    connect(m_field, &QLineEdit::editingFinished, this, &ParameterEditor::commitText);
    if (m_row.automatic) {
        m_auto = new QToolButton;
        m_auto->setText(tr("auto"));
        m_auto->setCheckable(true);
        m_auto->setObjectName(QStringLiteral("autoMark"));
        m_auto->setToolTip(tr("Let Rubble choose this value"));
        connect(m_auto, &QToolButton::clicked, this, [this] {
            if (!std::holds_alternative<std::monostate>(m_value)) {
                m_value = std::monostate{};
                emit edited(key(), m_value);
            }
            show(m_value);
        });
    }
}

void ParameterEditor::setValue(const ParameterValue& value) {
    m_value = value;
    show(value);
}

void ParameterEditor::setAutomaticValue(double value) {
    m_automaticValue = std::isfinite(value) ? value : 0.0;
    setAutomaticText(std::isfinite(value) ? shownNumber(value * figures::shownUnit(m_row.unit, value).perSi) : QString());
}

void ParameterEditor::setAutomaticText(const QString& text) {
    m_automatic = text;
    if (m_choice != nullptr && m_row.automatic) {
        m_choice->setItemText(0, text.isEmpty() ? tr("auto") : tr("auto: %1").arg(text));
    }
    if (std::holds_alternative<std::monostate>(m_value)) {
        show(m_value);
    }
}

void ParameterEditor::show(const ParameterValue& value) {
    if (m_switch != nullptr) {
        m_switch->setChecked(std::holds_alternative<bool>(value) && std::get<bool>(value));
        return;
    }
    if (m_only != nullptr) {
        m_only->setText(shownValue(value));
        return;
    }
    if (m_segments != nullptr) {
        const auto* text = std::get_if<std::string>(&value);
        for (int i = 0; i < 3; ++i) {
            m_segments->button(i)->setChecked(text != nullptr && m_row.choices[static_cast<std::size_t>(i)] == *text);
        }
        return;
    }
    if (m_choice != nullptr) {
        const auto* text = std::get_if<std::string>(&value);
        const auto* flag = std::get_if<bool>(&value);
        m_choice->setCurrentIndex(m_choice->findData(text != nullptr   ? QString::fromStdString(*text)
                                                     : flag != nullptr ? (*flag ? QStringLiteral("yes") : QStringLiteral("no"))
                                                                       : QString()));
        return;
    }
    const bool automatic = std::holds_alternative<std::monostate>(value);
    if (const auto* text = std::get_if<std::string>(&value)) {
        m_field->setText(QString::fromStdString(*text));
    } else {
        m_field->setText(automatic ? QString() : textOf(value));
    }
    m_field->setPlaceholderText(automatic ? (m_automatic.isEmpty() ? tr("auto") : m_automatic) : QString());
    if (m_auto != nullptr) {
        m_auto->setChecked(automatic);
    }
    m_field->setProperty("wrong", false);
    m_complaint->hide();
    if (m_row.unit == "s") {
        emit unitShown(figures::shownUnit("s", shownSize()).name);
    }
}

void ParameterEditor::refuse(const QString& why) {
    m_field->setProperty("wrong", true);
    m_complaint->setText(why);
    // Over what stands below, so that no row moves while somebody is at work on it.
    QWidget* ground = parentWidget() != nullptr ? parentWidget() : this;
    m_complaint->setParent(ground);
    const int wide = ground == this ? width() : ground->width();
    const int high = m_complaint->heightForWidth(wide);
    const QPoint below = ground == this ? QPoint(0, height()) : QPoint(0, geometry().bottom() + 2);
    const int top = below.y() + high <= ground->height() ? below.y() : geometry().top() - high - 2;
    m_complaint->setGeometry(0, std::max(0, top), wide, high);
    m_complaint->show();
    m_complaint->raise();
}

void ParameterEditor::commitText() {
    const QString text = m_field->text().trimmed();
    if (m_row.kind == ParameterKind::Text) {
        if (ParameterValue typed = text.toStdString(); typed != m_value) {
            m_value = typed;
            emit edited(key(), m_value);
        }
        return;
    }
    if (text.isEmpty() && m_row.automatic) {
        const bool changed = !std::holds_alternative<std::monostate>(m_value);
        show(m_value = std::monostate{});
        if (changed) {
            emit edited(key(), m_value);
        }
        return;
    }
    const std::optional<double> typedValue = typedNumber(text, m_row.unit, shownSize());
    if (!typedValue) {
        refuse(tr("“%1” is not a number.").arg(text));
        return;
    }
    double number = *typedValue;
    if (m_row.kind == ParameterKind::Integer && number != std::floor(number)) {
        refuse(tr("A whole number is needed."));
        return;
    }
    // A bound as it is shown is rounded.
    for (const double bound : {m_row.low, m_row.high}) {
        if (std::abs(number - bound) <= 1e-5 * std::abs(bound)) {
            number = bound;
        }
    }
    if (number < m_row.low || number > m_row.high) {
        refuse(tr("Between %1 and %2, please.").arg(withUnit(m_row.low), withUnit(m_row.high)));
        return;
    }
    const ParameterValue typed =
        m_row.kind == ParameterKind::Integer ? ParameterValue(static_cast<std::int64_t>(number)) : ParameterValue(number);
    // What the field shows is rounded: leaving it untouched must not change the value.
    const bool changed = typed != m_value && text != textOf(m_value);
    show(changed ? typed : m_value);
    if (changed) {
        m_value = typed;
        emit edited(key(), m_value);
    }
}

void ParameterEditor::offer(const QStringList& words) {
    if (m_field != nullptr && words != m_offered) {
        m_offered = words;
        auto* completer = new QCompleter(words, m_field);
        completer->setCaseSensitivity(Qt::CaseInsensitive);
        completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
        m_field->setCompleter(completer);
    }
}

void ParameterEditor::setAvailable(bool available, const QString& reason) {
    setEnabled(available);
    setToolTip(available ? tip() : reason);
}

}  // namespace rubble::widgets
