#include "widgets/case/start_page.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/group_heading.h"
#include "widgets/basics/panel.h"
#include "widgets/basics/theme.h"
#include "widgets/case/case_card.h"

namespace rubble::widgets {

namespace {

constexpr int widest = 760;
constexpr int gap = 12;

}  // namespace

StartPage::StartPage(QWidget* parent)
    : QScrollArea(parent),
      m_activity(new QLabel),
      m_error(new Notice),
      m_recentHeading(groupHeading(tr("RECENT"))),
      m_recent(new QVBoxLayout),
      m_samples(new QGridLayout) {
    auto* body = new QWidget;
    body->setObjectName(QStringLiteral("emptyState"));
    body->setAttribute(Qt::WA_StyledBackground);
    auto* outer = new QHBoxLayout(body);
    outer->setContentsMargins(24, 28, 24, 24);
    auto* middle = new QWidget;
    middle->setMaximumWidth(widest);
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap);
    auto* title = new QLabel(tr("Where do the fragments go?"));
    title->setFont(titleFont());
    column->addWidget(title);
    auto* text = new QLabel(
        tr("Open the finished result of a collapse analysis: every deactivated element becomes a fragment that falls, hits and "
           "comes to rest, beside the conventional view in which it vanishes. A case or a result can be dropped anywhere in this "
           "window."));
    text->setWordWrap(true);
    column->addWidget(text);
    auto* buttons = new QHBoxLayout;
    auto* open = new QPushButton(tr("Open…"));
    open->setObjectName(QStringLiteral("primary"));
    open->setToolTip(tr("Open a case (*.rubble) or an FE result (Ctrl+O)"));
    auto* make = new QPushButton(tr("New case…"));
    make->setObjectName(QStringLiteral("newCase"));
    make->setToolTip(tr("Make a case from an FE result step by step (Ctrl+N)"));
    auto* tour = new QPushButton(tr("Take the tour"));
    tour->setObjectName(QStringLiteral("tour"));
    tour->setToolTip(tr("The stone arch collapses, and seven sentences say what is for what"));
    buttons->addWidget(open);
    buttons->addWidget(make);
    buttons->addWidget(tour);
    m_activity->setObjectName(QStringLiteral("muted"));
    buttons->addWidget(m_activity, 1);
    column->addLayout(buttons);
    column->addWidget(m_error);
    m_recent->setSpacing(4);
    column->addWidget(m_recentHeading);
    column->addLayout(m_recent);
    column->addWidget(groupHeading(tr("SAMPLES")));
    m_samples->setSpacing(gap);
    m_samples->setContentsMargins(0, 0, 0, 0);
    column->addLayout(m_samples);
    column->addStretch();
    outer->addStretch();
    outer->addWidget(middle, 100);
    outer->addStretch();
    setWidget(body);
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
    connect(make, &QPushButton::clicked, this, &StartPage::newRequested);
    connect(tour, &QPushButton::clicked, this, &StartPage::tourRequested);
    setRecent({});
}

QWidget* StartPage::recentRow(const StartCase& which) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    auto* card = new CaseCard(CaseCard::Form::Wide, {which.name, which.words, which.when, which.picture, which.missing});
    line->addWidget(card, 1);
    connect(card, &CaseCard::clicked, this, [this, path = which.path] { emit recentChosen(path); });
    if (which.missing) {
        auto* locate = new QPushButton(tr("Locate…"));
        locate->setObjectName(QStringLiteral("locate"));
        locate->setToolTip(tr("Choose where %1 lies now").arg(which.name));
        connect(locate, &QPushButton::clicked, this, [this, path = which.path] { emit locateRequested(path); });
        line->addWidget(locate);
    }
    auto* forget = new QPushButton(tr("Remove"));
    forget->setObjectName(QStringLiteral("forget"));
    forget->setToolTip(tr("Take %1 off this list; the file itself stays").arg(which.name));
    connect(forget, &QPushButton::clicked, this, [this, path = which.path] { emit forgetRequested(path); });
    line->addWidget(forget);
    return row;
}

void StartPage::setRecent(const std::vector<StartCase>& cases) {
    for (QWidget* row : m_rows) {
        m_recent->removeWidget(row);
        row->hide();
        row->deleteLater();
    }
    m_rows.clear();
    for (const StartCase& each : cases) {
        m_rows.push_back(recentRow(each));
        m_recent->addWidget(m_rows.back());
    }
    m_recentHeading->setVisible(!cases.empty());
}

void StartPage::setSamples(const std::vector<StartCase>& cases) {
    for (QWidget* card : m_cards) {
        card->hide();
        card->deleteLater();
    }
    m_cards.clear();
    for (const StartCase& each : cases) {
        auto* card = new CaseCard(CaseCard::Form::Tall, {each.name, each.words, each.when, each.picture, each.missing});
        connect(card, &CaseCard::clicked, this, [this, path = each.path] { emit sampleChosen(path); });
        m_cards.push_back(card);
    }
    m_columns = 0;
    placeSamples();
}

void StartPage::placeSamples() {
    if (m_cards.empty()) {
        return;
    }
    const int width = std::min(widest, viewport()->width() - 48);
    const int columns = std::max(1, (width + gap) / (m_cards.front()->sizeHint().width() + gap));
    if (columns == m_columns) {
        return;
    }
    m_columns = columns;
    for (int i = 0; i < static_cast<int>(m_cards.size()); ++i) {
        m_samples->addWidget(m_cards[static_cast<std::size_t>(i)], i / columns, i % columns, Qt::AlignLeft | Qt::AlignTop);
    }
    for (int i = 0; i < m_samples->columnCount(); ++i) {
        m_samples->setColumnStretch(i, 0);
    }
    m_samples->setColumnStretch(columns, 1);
}

void StartPage::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    placeSamples();
}

void StartPage::setError(const QString& what, const QString& remedy) {
    m_error->set(Notice::Kind::Error, what, remedy);
}

void StartPage::setActivity(const QString& what) {
    m_activity->setText(what);
}

}  // namespace rubble::widgets
