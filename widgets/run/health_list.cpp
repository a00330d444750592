#include "widgets/run/health_list.h"

#include <QDateTime>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/basics/form_row.h"
#include "widgets/basics/language.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/case/run_verdict.h"
#include "widgets/figures/number_text.h"
#include "widgets/figures/shown_units.h"
#include "widgets/run/caution_words.h"

namespace rubble::widgets {

namespace {

QString interval(const HealthBreach& breach) {
    const bool brief = figures::briefSpan() > 0.0;
    if (breach.to - breach.from < 0.005 / figures::timeUnit().perSi) {
        return HealthList::tr("at %1").arg(figures::timeText(breach.from));
    }
    const QString from = brief ? figures::timeText(breach.from) : QLocale().toString(breach.from, 'f', 2);
    return HealthList::tr("%1–%2").arg(from, figures::timeText(breach.to));
}

/// Messages are parts of sentences; here they stand alone.
QString sentence(const Message& message) {
    const QString text = worded(message);
    return text.left(1).toUpper() + text.mid(1);
}

QString titleOf(const HealthBreach& breach) {
    return sentence(healthCheckTitle(breach.check));
}

/// Where the worst body was, and how many there were.
QString placeOf(const HealthBreach& breach, const Vec3& origin) {
    QStringList parts;
    if (breach.body && breach.place.allFinite()) {
        const Vec3 p = breach.place + origin;
        const auto metres = [](double value) { return shownPlace(value, 1); };
        parts << HealthList::tr("body %1 at x %2, y %3, z %4 %5")
                     .arg(shownCount(static_cast<std::int64_t>(at(*breach.body))), metres(p.x()), metres(p.y()), metres(p.z()),
                          figures::shownUnit("m").name);
    }
    if (breach.bodies > 1 && breach.check == HealthCheck::AsleepShare) {
        parts << HealthList::tr("%1 bodies at worst").arg(shownCount(breach.bodies));
    }
    return inOneLine(parts);
}

QString against(const HealthBreach& breach) {
    const QString when =
        std::isfinite(breach.worstAt) ? HealthList::tr(" at %1").arg(figures::timeText(breach.worstAt)) : QString();
    // What was measured says its limit already.
    return HealthList::tr("worst %1%2").arg(worded(healthMeasure(breach.check, breach.worst)), when);
}

/// When a limit was passed: the first intervals, and how many more there are.
QString times(const PassedLimit& limit, const std::vector<HealthBreach>& breaches) {
    constexpr std::size_t listed = 3;
    QStringList parts;
    for (std::size_t i = 0; i < std::min(listed, limit.breaches.size()); ++i) {
        parts << interval(breaches[limit.breaches[i]]);
    }
    QString text = parts.join(QStringLiteral(", "));
    if (limit.breaches.size() > listed) {
        text =
            HealthList::tr("%1 and %2 more times").arg(text, shownCount(static_cast<std::int64_t>(limit.breaches.size() - listed)));
    }
    return text;
}

QString muted(const QString& text) {
    return QStringLiteral("<span style='color:%1'>%2</span>").arg(tints().muted.name(), text.toHtmlEscaped());
}

QWidget* bare(QBoxLayout* layout) {
    auto* widget = new QWidget;
    layout->setContentsMargins(0, 0, 0, 0);
    widget->setLayout(layout);
    return widget;
}

}  // namespace

std::int64_t limitsIn(const HealthReport& health) {
    return static_cast<std::int64_t>(passedLimits(health.breaches).size());
}

bool toldByHealth(const Finding& finding) {
    static constexpr std::array<std::string_view, healthCheckCount> ids{
        "simulation.energy_gain",  "simulation.penetration",  "simulation.too_fast",  "simulation.below_ground",
        "simulation.outside_site", "simulation.not_a_number", "simulation.pile_woke", "simulation.bulking"};
    return std::find(ids.begin(), ids.end(), finding.what.id) != ids.end();
}

namespace {

QString wordsOf(const HealthBreach& breach, const QString& when, HealthGrade grade, const Vec3& origin) {
    QString text = QStringLiteral("<b>%1</b> · %2 · %3<br/>%4")
                       .arg(titleOf(breach), gradeWords(grade), when, sentence(breach.what).toHtmlEscaped());
    text += QStringLiteral("<br/>") + sentence(gradeReason(breach)).toHtmlEscaped();
    QStringList aside;
    if (const QString place = placeOf(breach, origin); !place.isEmpty()) {
        aside << place;
    }
    aside << against(breach);
    text += QStringLiteral("<br/>") + muted(inOneLine(aside));
    if (!breach.remedy.empty()) {
        const QString calm =
            grade == HealthGrade::Notice ? HealthList::tr("Nothing needs to be done. For less of it:") + u' ' : QString();
        text += QStringLiteral("<br/>") + muted(calm + sentence(breach.remedy));
    }
    return text;
}

}  // namespace

QString breachWords(const HealthBreach& breach, const Vec3& origin) {
    return wordsOf(breach, interval(breach), gradeOf(breach), origin);
}

QString limitWords(const PassedLimit& limit, const std::vector<HealthBreach>& breaches, const Vec3& origin) {
    return wordsOf(breaches[limit.worst], times(limit, breaches), limit.grade, origin);
}

std::vector<HealthMark> healthMarks(const HealthReport& health, bool acknowledged, const Vec3& origin) {
    std::vector<HealthMark> marks;
    for (const HealthBreach& breach : health.breaches) {
        QString words = breachWords(breach, origin);
        if (acknowledged) {
            words += QStringLiteral("<br/>") + muted(HealthList::tr("acknowledged"));
        }
        marks.push_back({breach.from, breach.to, titleOf(breach), words, acknowledged});
    }
    return marks;
}

HealthList::HealthList(QWidget* parent)
    : QWidget(parent),
      m_verdict(new Notice),
      m_breaches(new QVBoxLayout),
      m_form(new QWidget),
      m_name(new QLineEdit),
      m_note(new QLineEdit),
      m_button(new QPushButton(tr("Acknowledge"))),
      m_complaint(new QLabel),
      m_acknowledged(new Notice) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(m_verdict);
    m_breaches->setSpacing(8);
    column->addLayout(m_breaches);
    column->addWidget(m_acknowledged);
    auto* form = new QGridLayout(m_form);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(4);
    const auto field = [&](int row, const QString& label, QLineEdit* edit, const QString& tip) {
        auto* name = new QLabel(label);
        name->setBuddy(edit);
        edit->setToolTip(tip);
        edit->setAccessibleName(label);
        form->addWidget(name, row, 0);
        form->addWidget(edit, row, 1);
        keepAsTyped(*edit);
        connect(edit, &QLineEdit::textChanged, this, [this] { m_complaint->hide(); });
        connect(edit, &QLineEdit::returnPressed, this, &HealthList::acknowledge);
    };
    field(0, tr("Name"), m_name, tr("Who has looked at these breaches and vouches for the run"));
    field(1, tr("Note"), m_note, tr("Why the run may be used all the same"));
    m_button->setToolTip(tr("Write name, note and time beside the run file; the run no longer counts as tainted"));
    m_button->setObjectName(QStringLiteral("acknowledge"));
    m_complaint->setObjectName(QStringLiteral("complaint"));
    m_complaint->setWordWrap(true);
    m_complaint->hide();
    form->addWidget(m_button, 2, 1);
    form->addWidget(m_complaint, 3, 0, 1, 2);
    column->addWidget(m_form);
    connect(m_button, &QPushButton::clicked, this, &HealthList::acknowledge);
    setContent({});
}

void HealthList::setContent(const Content& content) {
    showBreaches(content);
    const std::int64_t count = limitsIn(content.health);
    const bool waits = content.health.tainted() && !content.acknowledged;
    const QString passed = limitsPassed(count);
    if (count == 0) {
        m_verdict->set(
            Notice::Kind::Note,
            content.upTo
                ? tr("No limit of health was passed up to %1, where the run was stopped.").arg(figures::timeText(*content.upTo))
                : tr("No limit of health was passed."));
    } else if (waits && content.upTo) {
        m_verdict->set(Notice::Kind::Finding,
                       tr("%1 up to %2, where the run was stopped: it is tainted.").arg(passed, figures::timeText(*content.upTo)));
    } else if (waits) {
        m_verdict->set(Notice::Kind::Finding, tr("%1: this run is tainted until someone acknowledges it.").arg(passed));
    } else if (gravestGrade(content.health.breaches) == HealthGrade::Finding) {
        m_verdict->set(Notice::Kind::Finding, tr("%1: single bodies are not as they should be.").arg(passed));
    } else {
        m_verdict->set(Notice::Kind::Note, passed + u'.');
    }
    m_form->setVisible(waits && !content.upTo);
    if (content.acknowledged && count > 0) {
        const Acknowledgement& a = *content.acknowledged;
        const QDateTime when = QDateTime::fromString(QString::fromStdString(a.when), Qt::ISODate);
        m_acknowledged->set(
            Notice::Kind::Note,
            tr("Acknowledged by %1, %2")
                .arg(QString::fromStdString(a.by), when.isValid() ? QLocale().toString(when.toLocalTime(), QLocale::ShortFormat)
                                                                  : QString::fromStdString(a.when)),
            QString::fromStdString(a.note));
    } else {
        m_acknowledged->set(Notice::Kind::Note, {});
    }
    m_complaint->hide();
}

void HealthList::showBreaches(const Content& content) {
    while (QLayoutItem* item = m_breaches->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_offered.clear();
    const std::vector<HealthBreach>& breaches = content.health.breaches;
    for (const PassedLimit& limit : passedLimits(breaches)) {
        const HealthBreach& breach = breaches[limit.worst];
        auto* row = new QVBoxLayout;
        row->setSpacing(3);
        auto* words = new QLabel(limitWords(limit, breaches, content.origin));
        words->setWordWrap(true);
        words->setTextFormat(Qt::RichText);
        words->setTextInteractionFlags(Qt::TextSelectableByMouse);
        words->setObjectName(QStringLiteral("breach"));
        row->addWidget(words);
        addRemedy(*row, breach, content);
        auto* show = new QPushButton(tr("Show %1").arg(figures::timeText(breach.from)));
        show->setToolTip(breach.body ? tr("Go to the worst of its times and point out the body")
                                     : tr("Go to the worst of its times"));
        show->setAccessibleName(tr("Show %1, %2").arg(titleOf(breach), times(limit, breaches)));
        connect(show, &QPushButton::clicked, this, [this, worst = limit.worst] { emit breachChosen(worst); });
        row->addWidget(show, 0, Qt::AlignLeft);
        m_breaches->addWidget(bare(row));
    }
}

void HealthList::addRemedy(QVBoxLayout& row, const HealthBreach& breach, const Content& content) {
    const auto setting = remedySettingOf(breach, content.grounds);
    if (setting && std::find(m_offered.begin(), m_offered.end(), *setting) == m_offered.end()) {
        m_offered.push_back(*setting);
        auto* apply = new RemedyButton(*setting);
        apply->setScenario(content.scenario);
        connect(apply, &RemedyButton::chosen, this, &HealthList::remedyChosen);
        row.addWidget(apply, 0, Qt::AlignLeft);
    }
}

void HealthList::setComplaint(const QString& complaint) {
    m_complaint->setText(complaint);
    m_complaint->setVisible(!complaint.isEmpty());
}

void HealthList::acknowledge() {
    const QString name = m_name->text().trimmed();
    if (name.isEmpty()) {
        setComplaint(tr("A name is needed: who vouches for this run?"));
        m_name->setFocus();
        return;
    }
    if (m_note->text().trimmed().isEmpty()) {
        setComplaint(tr("A note is needed: why may this run be used all the same?"));
        m_note->setFocus();
        return;
    }
    emit acknowledgeRequested(name, m_note->text().trimmed());
}

}  // namespace rubble::widgets
