#include "widgets/evidence/survey_place.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "core/evidence/surveys/stated_survey.h"
#include "widgets/basics/number_field.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/unit_label.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

QString placedText(const std::optional<Registration>& registration) {
    if (!registration) {
        return SurveyPlace::tr("lies as its coordinates say");
    }
    QStringList parts;
    parts << SurveyPlace::tr("moved by %1 m, turned by %2°")
                 .arg(shownNumber(registration->shift.norm()), shownDegrees(registration->turn.norm()));
    if (registration->pairs > 0) {
        parts << SurveyPlace::tr("pairs: %1, RMS %2 m").arg(shownCount(registration->pairs), shownNumber(registration->pairsLeft));
    }
    if (registration->fitted > 0) {
        parts << SurveyPlace::tr("fitted, RMS %1 m before, %2 m after")
                     .arg(shownNumber(registration->fitBefore), shownNumber(registration->fitLeft));
    }
    if (registration->control) {
        parts << SurveyPlace::tr("control points to %1 m").arg(shownNumber(*registration->control));
    } else if (registration->pairs > 0) {
        parts << SurveyPlace::tr("control points: accuracy not known");
    }
    parts << (registration->error ? SurveyPlace::tr("known to %1 m (standard deviation)").arg(shownNumber(*registration->error))
                                  : SurveyPlace::tr("how well it is known is not known"));
    return parts.join(QStringLiteral(" · "));
}

}  // namespace

SurveyPlace::SurveyPlace(QWidget* parent)
    : QWidget(parent),
      m_taken(new QLineEdit),
      m_before(new QCheckBox(tr("Taken before the collapse"))),
      m_instant(new NumberField(tr("Instant that the survey shows"))),
      m_said(new QLabel(tr("Write date and time, such as 2021-06-25 16:30"))),
      m_placed(new QLabel),
      m_pick(new QPushButton(tr("Pick pairs…"))),
      m_pairs(new QPushButton(tr("Pairs from a table…"))),
      m_control(new NumberField(tr("Error of control points in a table"))),
      m_fit(new QPushButton(tr("Fit to what did not move…"))),
      m_unplace(new QPushButton(tr("Unplace"))) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(8);
    form->setVerticalSpacing(4);
    m_taken->setAccessibleName(tr("When the survey was taken"));
    m_taken->setPlaceholderText(tr("not known"));
    m_taken->setToolTip(
        tr("Date and time by the clock of the site, such as 2021-06-25 16:30. Places whose debris had been removed by then are "
           "left out. Kept in the case"));
    form->addRow(tr("Taken"), m_taken);
    m_said->setWordWrap(true);
    m_said->setVisible(false);
    form->addRow(m_said);
    m_before->setToolTip(tr("It shows no debris and is not compared; take it as the terrain. Kept in the case"));
    form->addRow(m_before);
    m_instant->setEmptyMeans(tr("at rest"));
    m_instant->setToolTip(
        tr("Instant on the clock of the FE result that the survey shows; empty: all lay at rest. Kept in the case"));
    m_instant->setUnit("s");
    auto* instant = new QHBoxLayout;
    instant->addWidget(m_instant, 1);
    instant->addWidget(new UnitLabel(QStringLiteral("s")));
    form->addRow(tr("Shows"), instant);
    m_placed->setWordWrap(true);
    m_placed->setObjectName(QStringLiteral("muted"));
    form->addRow(m_placed);
    form->addRow(m_pick);
    m_pick->setToolTip(
        tr("Move the survey to where it belongs: click three places or more in it and in the model, and see at once how well they "
           "fit"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_pairs, 1);
    buttons->addWidget(m_unplace);
    form->addRow(buttons);
    m_control->setRange(0.0, 1000.0);
    m_control->setEmptyMeans(tr("not known"));
    m_control->setToolTip(
        tr("Standard deviation of the places of a table along each axis, m, where it has no column deviation_m; it is part of the "
           "error of the registration"));
    form->addRow(tr("Control points to, m"), m_control);
    form->addRow(m_fit);
    m_fit->setToolTip(
        tr("Draw what did not move: the points there are fitted to the site by least squares, and what is left is told before you "
           "accept it"));
    m_pairs->setToolTip(tr(
        "Move the survey to where it belongs by three places or more, from a table with the columns survey_x, survey_y, survey_z, "
        "x_m, y_m, z_m"));
    m_unplace->setToolTip(tr("Let the survey lie as its coordinates say"));
    connect(m_taken, &QLineEdit::editingFinished, this, &SurveyPlace::takeTime);
    connect(m_before, &QCheckBox::toggled, this, &SurveyPlace::send);
    connect(m_instant, &NumberField::edited, this, &SurveyPlace::send);
    connect(m_pick, &QPushButton::clicked, this, &SurveyPlace::pickRequested);
    connect(m_pairs, &QPushButton::clicked, this, &SurveyPlace::pairsRequested);
    connect(m_fit, &QPushButton::clicked, this, &SurveyPlace::fitRequested);
    connect(m_unplace, &QPushButton::clicked, this, &SurveyPlace::unplaceRequested);
}

void SurveyPlace::setStated(const Stated& stated, bool some, bool cloud) {
    m_stated = stated;
    m_showing = true;
    m_taken->setText(QString::fromStdString(stated.taken));
    m_before->setChecked(stated.before);
    m_instant->setNumber(stated.instant);
    m_placed->setText(placedText(stated.registration));
    m_placed->setVisible(some);
    m_said->setVisible(false);
    m_showing = false;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_taken, m_before, m_pick, m_pairs, m_control}) {
        widget->setEnabled(some);
    }
    m_instant->setEnabled(some && !stated.before);
    m_fit->setVisible(some && cloud);
    m_unplace->setEnabled(some && stated.registration.has_value());
}

std::optional<double> SurveyPlace::control() const {
    return m_control->number();
}

void SurveyPlace::askTime() {
    askIn(*m_taken);
}

void SurveyPlace::takeTime() {
    const std::string text = m_taken->text().trimmed().toStdString();
    const bool sound = text.empty() || !clockTimeFrom(text).empty();
    m_said->setVisible(!sound);
    if (sound) {
        send();
    }
}

void SurveyPlace::send() {
    Stated now = m_stated;
    now.taken = clockTimeFrom(m_taken->text().trimmed().toStdString());
    now.before = m_before->isChecked();
    now.instant = m_instant->number();
    if (!m_showing && !(now == m_stated)) {
        emit edited(now);
    }
}

}  // namespace rubble::widgets
