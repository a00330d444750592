#include "widgets/views/scenario_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace rubble::widgets {

ScenarioBar::ScenarioBar(QWidget* parent)
    : QFrame(parent), m_words(new QLabel), m_names(new QComboBox), m_open(new QPushButton(tr("Open a kept run…"))) {
    setObjectName(QStringLiteral("bottom"));
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Another scenario"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 4, 12, 4);
    row->setSpacing(8);
    m_words->setWordWrap(true);
    m_names->setAccessibleName(tr("Scenario in the right view"));
    m_names->setToolTip(tr("Newest complete run of this scenario; camera, time and selection are those of the left view"));
    m_names->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_open->setToolTip(tr("Choose a run file (*.run.h5) of the FE result that is open"));
    row->addWidget(m_words, 1);
    row->addWidget(m_names);
    row->addWidget(m_open);
    connect(m_names, &QComboBox::activated, this, [this] { emit scenarioChosen(m_names->currentText()); });
    connect(m_open, &QPushButton::clicked, this, &ScenarioBar::openRequested);
    setScenarios({}, {});
}

void ScenarioBar::setScenarios(const QStringList& names, const QString& chosen) {
    m_names->clear();
    m_names->addItems(names);
    m_names->setCurrentIndex(static_cast<int>(names.indexOf(chosen)));
    m_names->setVisible(!names.isEmpty());
    m_words->setText(names.isEmpty() ? tr("No other scenario has a run yet: simulate one, go on with another scenario and simulate "
                                          "that, or open a run that was kept.")
                                     : tr("Left: what was simulated last. Right, from the same place and at the same time:"));
}

QString ScenarioBar::chosen() const {
    return m_names->currentText();
}

}  // namespace rubble::widgets
