#include "widgets/views/history_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/basics/panel.h"

namespace rubble::widgets {

HistoryPanel::HistoryPanel(QWidget* parent)
    : QWidget(parent),
      m_subject(new QLabel),
      m_saveTable(new QPushButton(tr("Save table…"))),
      m_saveChart(new QPushButton(tr("Save chart…"))),
      m_notice(new Notice),
      m_chart(new HistoryChart),
      m_words(new QLabel) {
    setObjectName(QStringLiteral("panelBody"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    column->setSpacing(6);
    auto* head = new QHBoxLayout;
    m_subject->setWordWrap(true);
    m_subject->setToolTip(
        tr("Of what is selected; of all fragments while nothing is. Speeds are those of the bodies that carry them"));
    head->addWidget(m_subject, 1);
    m_saveTable->setObjectName(QStringLiteral("saveHistoryTable"));
    m_saveTable->setToolTip(tr("Save the figures of every frame as CSV"));
    m_saveChart->setObjectName(QStringLiteral("saveHistoryChart"));
    m_saveChart->setToolTip(tr("Save the chart as SVG or PNG"));
    head->addWidget(m_saveTable);
    head->addWidget(m_saveChart);
    column->addLayout(head);
    column->addWidget(m_notice);
    column->addWidget(m_chart, 1);
    m_words->setObjectName(QStringLiteral("muted"));
    m_words->setWordWrap(true);
    m_words->setToolTip(tr("Kinetic energy without spin; potential energy above the level ground"));
    column->addWidget(m_words);
    column->addStretch();
    connect(m_saveTable, &QPushButton::clicked, this, &HistoryPanel::saveTableRequested);
    connect(m_saveChart, &QPushButton::clicked, this, &HistoryPanel::saveChartRequested);
    setContent({}, tr("Simulate first: there are no curves without a run."), false);
}

void HistoryPanel::setContent(const HistoryChart::Content& content, const QString& why, bool reading) {
    m_subject->setText(reading ? tr("%1 · being read…").arg(content.subject) : content.subject);
    m_subject->setVisible(why.isEmpty());
    m_notice->set(Notice::Kind::Note, why);
    m_chart->setContent(content);
    m_chart->setVisible(why.isEmpty());
    m_words->setVisible(why.isEmpty());
    m_words->setText(m_chart->words());
    for (QPushButton* save : {m_saveTable, m_saveChart}) {
        save->setEnabled(why.isEmpty() && !reading && !content.points.empty());
    }
}

void HistoryPanel::setTime(double time) {
    m_chart->setTime(time);
    m_words->setText(m_chart->words());
}

QString HistoryPanel::words() const {
    return m_words->text();
}

}  // namespace rubble::widgets
