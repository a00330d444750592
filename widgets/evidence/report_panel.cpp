#include "widgets/evidence/report_panel.h"

#include <QComboBox>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QUrl>
#include <utility>

#include "widgets/basics/form_row.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"
#include "widgets/figures/report/spoken_text.h"

namespace rubble::widgets {

namespace {

/// As wide as the panel, so high that its first lines are seen.
constexpr int questionHeight = 84;
constexpr int wordsHeight = 52;

struct OwnPart {
    std::string OwnWords::* words;
    const char* name;
};
constexpr std::array<OwnPart, 5> ownParts{{{&OwnWords::summary, "reportSummary"},
                                           {&OwnWords::custody, "reportCustody"},
                                           {&OwnWords::alternatives, "reportAlternatives"},
                                           {&OwnWords::change, "reportChange"},
                                           {&OwnWords::qualification, "reportQualification"}}};

}  // namespace

ReportPanel::ReportPanel(QWidget* parent)
    : Panel(tr("Report"), tr("What was asked, what was found, and how sure that is."), parent),
      m_question(nullptr),
      m_author(new QLineEdit),
      m_repeats(new QSpinBox),
      m_selfTest(new QComboBox),
      m_causes(new QComboBox),
      m_check(new QPushButton(tr("Check"))),
      m_gaps(new QLabel),
      m_checked(nullptr),
      m_unsaid(nullptr),
      m_write(new QPushButton),
      m_written(new QLabel) {
    PanelGroup* asked = addGroup(tr("Question"));
    m_question = addText(*asked, "reportQuestion", tr("Question of the report"),
                         tr("What the report is to answer, in your words; it stands in its first section"), questionHeight);
    m_question->setPlaceholderText(tr("Where did the debris go, and how sure is that?"));
    m_author->setObjectName(QStringLiteral("reportAuthor"));
    // A name with its office needs the whole width.
    m_author->setPlaceholderText(tr("Who makes the report"));
    m_author->setAccessibleName(tr("Made by"));
    m_author->setToolTip(tr("Who makes the report; stands on its first page"));
    keepAsTyped(*m_author);
    connect(m_author, &QLineEdit::textEdited, this, &ReportPanel::wishesChanged);
    asked->addWide(m_author);
    addOwnWords();
    addMade();
    addGaps();
    PanelGroup* written = addGroup(tr("Report"));
    // What a click costs stands beside the button.
    m_cost = written->addNote({});
    m_cost->setObjectName(QStringLiteral("reportCost"));
    m_write->setObjectName(QStringLiteral("writeReport"));
    connect(m_write, &QPushButton::clicked, this, [this] { m_writing ? emit cancelRequested() : emit writeRequested(); });
    written->addWide(m_write);
    m_why = written->addNote({});
    m_written->setWordWrap(true);
    m_written->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    connect(m_written, &QLabel::linkActivated, this, [this](const QString& link) { emit openRequested(QUrl(link).toLocalFile()); });
    written->addWide(m_written);
    setComparison({});
    setGaps({}, {});
    setReady({}, false);
    showCost();
    setWritten({});
}

QPlainTextEdit* ReportPanel::addText(PanelGroup& group, const char* name, const QString& label, const QString& tip, int height) {
    auto* text = new QPlainTextEdit;
    text->setObjectName(QLatin1String(name));
    text->setAccessibleName(label);
    text->setToolTip(tip);
    text->setTabChangesFocus(true);
    text->setFixedHeight(height);
    // A text field wants all there is, and would keep it around itself.
    text->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(text, &QPlainTextEdit::textChanged, this, &ReportPanel::wishesChanged);
    group.addWide(text);
    return text;
}

void ReportPanel::addOwnWords() {
    PanelGroup* own = addGroup(tr("In your words"));
    const std::array<std::pair<QString, QString>, partCount> said{
        {{tr("Summary in plain language"), tr("On one page, for readers who are no engineers; a chapter of the report")},
         {tr("Custody"), tr("Who held the material before it came here, and what was done to it")},
         {tr("Other causes"), tr("Which other causes were considered, and how each was excluded")},
         {tr("What would change the opinion"), tr("Findings that would make you say something else")},
         {tr("Qualification"),
          tr("What qualifies you for this report, and what binds you to a party; stands above the signature")}}};
    for (std::size_t part = 0; part < partCount; ++part) {
        own->addNote(said[part].first);
        m_words[part] = addText(*own, ownParts[part].name, said[part].first, said[part].second, wordsHeight);
    }
    m_causes->setObjectName(QStringLiteral("reportCauses"));
    m_causes->addItem(tr("none"), static_cast<int>(ReportedCauses::None));
    m_causes->addItem(tr("of the page Causes"), static_cast<int>(ReportedCauses::Page));
    m_causes->addItem({}, static_cast<int>(ReportedCauses::File));
    // The name of a file may be long.
    m_causes->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    own->addField(tr("Comparison"), m_causes, {},
                  tr("A comparison of causes that becomes a table of the report: that of the page Causes, or what "
                     "rubble-cli compare printed into a file"));
    connect(m_causes, &QComboBox::activated, this, [this] {
        m_causesFrom = static_cast<ReportedCauses>(m_causes->currentData().toInt());
        if (m_causesFrom == ReportedCauses::File) {
            emit causesFileRequested();
        }
        showCauses();
        emit wishesChanged();
    });
}

void ReportPanel::addMade() {
    PanelGroup* made = addGroup(tr("Made for the report"));
    m_repeats->setObjectName(QStringLiteral("reportRepeats"));
    m_repeats->setRange(0, 20);
    m_repeats->setValue(2);
    m_repeats->setAlignment(Qt::AlignRight);
    made->addField(
        tr("Repeats"), m_repeats, {},
        tr("How often the run is simulated again with births shifted by a micrometre, 0 to 20: the spread of every result. "
           "Each takes as long as the run"));
    connect(m_repeats, &QSpinBox::valueChanged, this, [this] {
        showCost();
        emit wishesChanged();
    });
    m_selfTest->setObjectName(QStringLiteral("reportSelfTest"));
    m_selfTest->addItem(tr("laws of mechanics"), QStringLiteral("closed-form"));
    m_selfTest->addItem(tr("all cases"), QStringLiteral("all"));
    m_selfTest->addItem(tr("none"), QStringLiteral("none"));
    made->addField(tr("Self-test"), m_selfTest, {},
                   tr("Hard cases of the simulation, run on this machine: those a law predicts take seconds, all of them minutes"));
    connect(m_selfTest, &QComboBox::activated, this, &ReportPanel::wishesChanged);
}

void ReportPanel::addGaps() {
    PanelGroup* lacking = addGroup(tr("What it lacks"));
    m_check->setObjectName(QStringLiteral("checkReport"));
    m_check->setToolTip(tr("Look for what standards for the reports of experts ask for; nothing is simulated and nothing written"));
    connect(m_check, &QPushButton::clicked, this, &ReportPanel::checkRequested);
    lacking->addWide(m_check);
    m_checked = lacking->addNote({});
    m_checked->setObjectName(QStringLiteral("reportChecked"));
    m_gaps->setObjectName(QStringLiteral("reportGaps"));
    m_gaps->setWordWrap(true);
    m_gaps->setTextFormat(Qt::RichText);
    lacking->addWide(m_gaps);
    m_unsaid = lacking->addNote({});
    m_unsaid->setObjectName(QStringLiteral("reportUnsaid"));
}

ReportWishes ReportPanel::wishes() const {
    ReportWishes wishes{m_question->toPlainText().trimmed(), m_author->text().trimmed(), m_repeats->value(),
                        m_selfTest->currentData().toString()};
    for (std::size_t part = 0; part < partCount; ++part) {
        wishes.words.*ownParts[part].words = m_words[part]->toPlainText().trimmed().toStdString();
    }
    wishes.causes = m_causesFrom;
    wishes.causesFile = m_causesFile;
    return wishes;
}

void ReportPanel::setWishes(const ReportWishes& wishes) {
    const QSignalBlocker quiet(this);
    m_question->setPlainText(wishes.question);
    m_author->setText(wishes.author);
    m_repeats->setValue(wishes.repeats);
    m_selfTest->setCurrentIndex(m_selfTest->findData(wishes.selfTest));
    for (std::size_t part = 0; part < partCount; ++part) {
        m_words[part]->setPlainText(QString::fromStdString(wishes.words.*ownParts[part].words));
    }
    m_causesFrom = wishes.causes;
    m_causesFile = wishes.causesFile;
    showCauses();
}

void ReportPanel::setComparison(const QString& why) {
    m_noComparison = why;
    showCauses();
}

void ReportPanel::setCausesFile(const QString& path) {
    m_causesFile = path.isEmpty() ? m_causesFile : path;
    if (m_causesFile.isEmpty()) {
        m_causesFrom = ReportedCauses::None;
    }
    showCauses();
}

void ReportPanel::showCauses() {
    const bool compared = m_noComparison.isEmpty();
    if (m_causesFrom == ReportedCauses::Page && !compared) {
        m_causesFrom = ReportedCauses::None;
    }
    const auto itemOf = [this](ReportedCauses from) { return m_causes->findData(static_cast<int>(from)); };
    QStandardItem* page = qobject_cast<QStandardItemModel*>(m_causes->model())->item(itemOf(ReportedCauses::Page));
    page->setEnabled(compared);
    page->setToolTip(m_noComparison);
    page->setText(compared ? tr("of the page Causes") : tr("of the page Causes, which has none"));
    m_causes->setItemText(itemOf(ReportedCauses::File),
                          m_causesFile.isEmpty() ? tr("of a file…") : tr("of %1…").arg(QFileInfo(m_causesFile).fileName()));
    m_causes->setItemData(itemOf(ReportedCauses::File), m_causesFile, Qt::ToolTipRole);
    m_causes->setCurrentIndex(itemOf(m_causesFrom));
}

void ReportPanel::setGaps(const std::optional<Findings>& gaps, const std::vector<Message>& words) {
    m_checked->setText(!gaps           ? tr("Not checked since the run or the case changed.")
                       : gaps->empty() ? tr("The report lacks nothing that the program can tell.")
                                       : tr("The report would lack:"));
    // A list, not notices: nothing here is wrong with what was computed.
    QString lacking;
    const Findings none;
    for (const Finding& gap : (gaps ? *gaps : none).list()) {
        const QString example = gap.example.empty() ? QString() : QStringLiteral(" (%1)").arg(figures::spokenText(gap.example));
        lacking += QStringLiteral("<p style='margin:0 0 6px 0'>– %1<br/><span style='color:%2'>%3</span></p>")
                       .arg((worded(gap.what) + example).toHtmlEscaped(), tints().muted.name(), worded(gap.remedy).toHtmlEscaped());
    }
    m_gaps->setText(lacking);
    m_gaps->setVisible(!lacking.isEmpty());
    QStringList unsaid;
    for (const Message& each : words) {
        unsaid << QStringLiteral("– ") + worded(each);
    }
    m_unsaid->setText(tr("For you to say:") + u'\n' + unsaid.join(u'\n'));
    m_unsaid->setVisible(!unsaid.isEmpty());
}

void ReportPanel::setReady(const QString& why, bool writing) {
    m_writing = writing;
    m_write->setText(writing ? tr("Cancel") : tr("Write report…"));
    m_write->setToolTip(writing ? tr("Stop; nothing half-made is left")
                                : tr("Choose a folder; it gets report.pdf and report.html, each complete in itself"));
    m_write->setEnabled(writing || why.isEmpty());
    m_check->setEnabled(!writing && why.isEmpty());
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
        m_cost->setText(tr("Simulates %1 times, the run and its repeats: up to about %2.")
                            .arg(m_repeats->value() + 1)
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
