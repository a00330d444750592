#include "widgets/evidence/report_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QUrl>

#include "widgets/basics/wording.h"

namespace rubble::widgets {

ReportPanel::ReportPanel(QWidget* parent)
    : Panel(tr("Report"), tr("What was asked, what was found, and how sure that is."), parent),
      m_question(new QPlainTextEdit),
      m_author(new QLineEdit),
      m_repeats(new QSpinBox),
      m_selfTest(new QComboBox),
      m_write(new QPushButton),
      m_written(new QLabel) {
    PanelGroup* asked = addGroup(tr("Question"));
    m_question->setObjectName(QStringLiteral("reportQuestion"));
    m_question->setAccessibleName(tr("Question of the report"));
    m_question->setToolTip(tr("What the report is to answer, in your words; it stands in its first section"));
    m_question->setPlaceholderText(tr("Where did the debris go, and how sure is that?"));
    m_question->setTabChangesFocus(true);
    m_question->setFixedHeight(84);
    // A text field wants all there is, and would keep it around itself.
    m_question->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    asked->addWide(m_question);
    m_author->setObjectName(QStringLiteral("reportAuthor"));
    // A name with its office needs the whole width.
    m_author->setPlaceholderText(tr("Who makes the report"));
    m_author->setAccessibleName(tr("Made by"));
    m_author->setToolTip(tr("Who makes the report; stands on its first page"));
    asked->addWide(m_author);
    PanelGroup* made = addGroup(tr("Made for the report"));
    m_repeats->setObjectName(QStringLiteral("reportRepeats"));
    m_repeats->setRange(0, 20);
    m_repeats->setValue(2);
    m_repeats->setAlignment(Qt::AlignRight);
    made->addField(
        tr("Repeats"), m_repeats, {},
        tr("How often the run is simulated again with births shifted by a micrometre, 0 to 20: the spread of every result. "
           "Each takes as long as the run"));
    m_cost = made->addNote({});
    m_cost->setObjectName(QStringLiteral("reportCost"));
    connect(m_repeats, &QSpinBox::valueChanged, this, &ReportPanel::showCost);
    m_selfTest->setObjectName(QStringLiteral("reportSelfTest"));
    m_selfTest->addItem(tr("laws of mechanics"), QStringLiteral("closed-form"));
    m_selfTest->addItem(tr("all cases"), QStringLiteral("all"));
    m_selfTest->addItem(tr("none"), QStringLiteral("none"));
    made->addField(tr("Self-test"), m_selfTest, {},
                   tr("Hard cases of the simulation, run on this machine: those a law predicts take seconds, all of them minutes"));
    PanelGroup* written = addGroup(tr("Report"));
    m_write->setObjectName(QStringLiteral("writeReport"));
    connect(m_write, &QPushButton::clicked, this, [this] { m_writing ? emit cancelRequested() : emit writeRequested(); });
    written->addWide(m_write);
    m_why = written->addNote({});
    m_written->setWordWrap(true);
    m_written->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    connect(m_written, &QLabel::linkActivated, this, [this](const QString& link) { emit openRequested(QUrl(link).toLocalFile()); });
    written->addWide(m_written);
    setReady({}, false);
    showCost();
    setWritten({});
}

ReportWishes ReportPanel::wishes() const {
    return {m_question->toPlainText().trimmed(), m_author->text().trimmed(), m_repeats->value(),
            m_selfTest->currentData().toString()};
}

void ReportPanel::setWishes(const ReportWishes& wishes) {
    m_question->setPlainText(wishes.question);
    m_author->setText(wishes.author);
    m_repeats->setValue(wishes.repeats);
    m_selfTest->setCurrentIndex(m_selfTest->findData(wishes.selfTest));
}

void ReportPanel::setReady(const QString& why, bool writing) {
    m_writing = writing;
    m_write->setText(writing ? tr("Cancel") : tr("Write report…"));
    m_write->setToolTip(writing ? tr("Stop; nothing half-made is left")
                                : tr("Choose a folder; it gets report.pdf and report.html, each complete in itself"));
    m_write->setEnabled(writing || why.isEmpty());
    m_why->setText(why);
    m_why->setVisible(!why.isEmpty());
}

void ReportPanel::setRunSeconds(std::optional<double> seconds) {
    m_runSeconds = seconds;
    showCost();
}

void ReportPanel::showCost() {
    if (m_repeats->value() == 0) {
        m_cost->setText(tr("Without repeats the report cannot say how far the run repeats itself."));
    } else if (m_runSeconds) {
        // The run itself is simulated again, too.
        m_cost->setText(tr("Simulates the run and its repeats again: up to about %1.")
                            .arg(shownDuration(*m_runSeconds * (m_repeats->value() + 1))));
    } else {
        m_cost->setText(tr("Simulates the run and its repeats again, each as long as the run took."));
    }
}

void ReportPanel::setWritten(const QString& folder) {
    m_written->setVisible(!folder.isEmpty());
    m_written->setText(tr("Written to <a href=\"%1\">%2</a>").arg(QUrl::fromLocalFile(folder).toString(), folder.toHtmlEscaped()));
}

}  // namespace rubble::widgets
