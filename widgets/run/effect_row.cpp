#include "widgets/run/effect_row.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/basics/icons.h"
#include "widgets/basics/parameter_editor.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

QString shownMilliseconds(double ms) {
    if (!std::isfinite(ms)) {
        return QString(QChar(0x2013));
    }
    return ms > 0.0 && ms < 0.001 ? EffectRow::tr("below 0.001 ms")
                                  : shownNumber(ms, ms < 10.0 ? 2 : 3) + QStringLiteral("\u00A0ms");
}

QString shownStepShare(double share) {
    return std::isfinite(share) && share > 0.0 && share < 0.01 ? EffectRow::tr("below 1 %") : shownShare(share, 0);
}

ShareBar::ShareBar(QWidget* parent) : QWidget(parent) {
    setFixedHeight(6);
    setMinimumWidth(40);
}

void ShareBar::setShare(double share) {
    m_share = std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
    setAccessibleName(shownStepShare(m_share));
    update();
}

void ShareBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tints().hairline);
    painter.drawRoundedRect(QRectF(rect()), 3, 3);
    if (m_share > 0.0) {
        QColor colour = tints().accent;
        colour.setAlphaF(isEnabled() ? 1.0F : 0.45F);
        painter.setBrush(colour);
        // Something is never drawn as nothing.
        painter.drawRoundedRect(QRectF(0, 0, std::max(3.0, m_share * width()), height()), 3, 3);
    }
}

EffectRow::EffectRow(EffectKind kind, const Parameter& effect, QWidget* parent)
    : QWidget(parent),
      m_kind(kind),
      m_fold(new QToolButton),
      m_name(new QLabel),
      m_switch(new ParameterEditor(effect)),
      m_state(new QLabel),
      m_costLine(new QWidget),
      m_cost(new QLabel),
      m_shareText(new QLabel),
      m_bar(new ShareBar),
      m_settings(new PanelGroup({})) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    auto* head = new QHBoxLayout;
    head->setSpacing(4);
    m_fold->setObjectName(QStringLiteral("fold"));
    m_fold->setCheckable(true);
    m_fold->setIconSize({16, 16});
    m_fold->setFocusPolicy(Qt::StrongFocus);
    m_name->setText(m_switch->label());
    m_name->setToolTip(m_switch->toolTip());
    m_name->setWordWrap(true);
    m_name->installEventFilter(this);
    QFont bold = textFont();
    bold.setWeight(QFont::DemiBold);
    m_name->setFont(bold);
    head->addWidget(m_fold);
    head->addWidget(m_name, 1);
    head->addWidget(m_switch);
    column->addLayout(head);
    m_state->setWordWrap(true);
    m_state->setTextFormat(Qt::RichText);
    m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_state->setContentsMargins(18, 0, 0, 0);
    column->addWidget(m_state);
    auto* cost = new QHBoxLayout(m_costLine);
    cost->setContentsMargins(18, 0, 0, 0);
    cost->setSpacing(8);
    m_shareText->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_shareText->setMinimumWidth(m_shareText->fontMetrics().horizontalAdvance(tr("below 1 %")));
    m_cost->setMinimumWidth(m_cost->fontMetrics().horizontalAdvance(tr("88.88 ms per step")));
    cost->addWidget(m_cost);
    cost->addWidget(m_bar, 1);
    cost->addWidget(m_shareText);
    column->addWidget(m_costLine);
    m_settings->setContentsMargins(18, 2, 0, 4);
    column->addWidget(m_settings);
    m_settings->hide();
    connect(m_fold, &QToolButton::toggled, this, &EffectRow::setUnfolded);
    setUnfolded(false);
    // Nothing to unfold: the name stands where the others have theirs.
    m_fold->setEnabled(false);
    QPixmap nothing(m_fold->iconSize());
    nothing.fill(Qt::transparent);
    m_fold->setIcon(nothing);
    setDecision(nullptr, false);
    setCost(nullptr, false);
}

PanelGroup* EffectRow::settings() {
    m_fold->setEnabled(true);
    setUnfolded(unfolded());
    return m_settings;
}

bool EffectRow::unfolded() const {
    return m_fold->isChecked();
}

void EffectRow::setUnfolded(bool unfolded) {
    m_fold->setChecked(unfolded);
    m_fold->setIcon(glyphIcon(unfolded ? Glyph::Fold : Glyph::Unfold));
    m_fold->setAccessibleName(unfolded ? tr("Hide the settings of %1").arg(m_switch->label())
                                       : tr("Show the settings of %1").arg(m_switch->label()));
    m_settings->setVisible(unfolded);
}

void EffectRow::setDecision(const EffectDecision* decision, bool stale) {
    if (decision == nullptr) {
        m_state->setText(QStringLiteral("<span style='color:%1'>%2</span>").arg(tints().muted.name(), tr("not decided yet")));
        m_state->setToolTip({});
        return;
    }
    // Told by shape and word as well as by colour.
    const QString mark = decision->on ? QStringLiteral("●") : QStringLiteral("○");
    const QString word = decision->on ? tr("on") : tr("off");
    const QColor colour = stale || !decision->on ? tints().muted : tints().accent;
    m_state->setText(QStringLiteral("<span style='color:%1'>%2&nbsp;<b>%3</b></span>&nbsp; <span style='color:%4'>%5</span>")
                         .arg(colour.name(), mark, stale ? tr("%1 (before the change)").arg(word) : word,
                              stale ? tints().muted.name() : tints().text.name(), worded(decision->reason).toHtmlEscaped()));
    m_state->setToolTip(std::isfinite(decision->measure) && std::isfinite(decision->threshold)
                            ? tr("Measured %1, against a threshold of %2")
                                  .arg(shownNumber(decision->measure, 4), shownNumber(decision->threshold, 4))
                            : QString());
}

void EffectRow::setCost(const EffectReport* report, bool stale) {
    m_costLine->setVisible(report != nullptr && report->decision.on);
    if (report == nullptr) {
        m_cost->clear();
        m_shareText->clear();
        return;
    }
    m_cost->setText(tr("%1 per step").arg(shownMilliseconds(report->msPerStep)));
    m_shareText->setText(shownStepShare(report->share));
    m_bar->setShare(report->share);
    m_bar->setEnabled(!stale);
    QString tip = tr("Measured in the last run: %1 per step, %2 of the step")
                      .arg(shownMilliseconds(report->msPerStep), shownShare(report->share, 1));
    if (report->work != 0.0 && std::isfinite(report->work)) {
        tip += QStringLiteral("\n") + tr("Work on bodies: %1").arg(shownEnergy(report->work));
    }
    if (report->decision.kind == EffectKind::Ties || report->decision.kind == EffectKind::BreakUp) {
        tip += QStringLiteral("\n") +
               (report->decision.kind == EffectKind::Ties ? tr("Ties broken: %1") : tr("Clusters broken up: %1"))
                   .arg(shownCount(report->events));
    }
    m_costLine->setToolTip(stale ? tr("Settings have changed since.") + QStringLiteral("\n") + tip : tip);
    m_cost->setEnabled(!stale);
    m_shareText->setEnabled(!stale);
}

bool EffectRow::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_name && event->type() == QEvent::MouseButtonRelease && m_fold->isEnabled()) {
        setUnfolded(!unfolded());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

QString EffectRow::stateText() const {
    return m_state->text();
}

QString EffectRow::costText() const {
    return m_costLine->isHidden() ? QString() : m_cost->text() + QStringLiteral(", ") + m_shareText->text();
}

}  // namespace rubble::widgets
