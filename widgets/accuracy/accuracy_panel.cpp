#include "widgets/accuracy/accuracy_panel.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>
#include <QStyle>
#include <algorithm>

#include "widgets/basics/place_choice.h"
#include "widgets/basics/study_start.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

constexpr double leastTolerance = 0.001;   // m
constexpr double greatestTolerance = 100;  // m
constexpr std::size_t mostTolerances = 6;

std::vector<std::string> listed(const QString& text) {
    std::vector<std::string> values;
    for (const QString& part : text.split(u',', Qt::SkipEmptyParts)) {
        if (const QString value = part.trimmed(); !value.isEmpty()) {
            values.push_back(value.toStdString());
        }
    }
    return values;
}

QString tolerancesText(const std::vector<double>& tolerances) {
    QStringList texts;
    for (const double tolerance : tolerances) {
        texts << QLocale::c().toString(tolerance, 'g', QLocale::FloatingPointShortest);
    }
    return texts.join(QStringLiteral(", "));
}

}  // namespace

AccuracyPanel::AccuracyPanel(QWidget* parent)
    : Panel(tr("Accuracy"),
            tr("Agreement with the reference (verification, no validation), what it costs in time, and which differences mean "
               "something."),
            parent),
      m_multiples(new QLineEdit(QStringLiteral("auto, 1.5, 2, 3, 4"))),
      m_varied(new QLineEdit),
      m_toleranceField(new QLineEdit(QStringLiteral("0.1, 0.2, 0.3"))),
      m_toleranceWhy(new QLabel),
      m_repeats(new QSpinBox),
      m_settingRepeats(new QSpinBox),
      m_liveFps(new QCheckBox(tr("Measure live FPS"))),
      m_retimed(new QCheckBox(tr("Measure times again"))),
      m_place(new PlaceChoice),
      m_start(
          new StudyStart({tr("Compare"),
                          tr("Simulate the reference, its repeats and every setting, measure them, and time each alone. What was "
                             "simulated before is not simulated again"),
                          tr("Stop comparing, on a cluster after a question; what is done is kept, and comparing again goes on"),
                          QStringLiteral("cancelComparison"), tr("Progress of the comparison")},
                         m_place)),
      m_findings(new FindingList) {
    addWide(m_start);
    addPrediction();
    buildChoices();
    buildMachine();
    addWide(m_findings);
    connect(m_start, &StudyStart::startRequested, this, &AccuracyPanel::compareRequested);
    connect(m_start, &StudyStart::cancelRequested, this, &AccuracyPanel::cancelRequested);
    connect(m_multiples, &QLineEdit::returnPressed, m_start, &StudyStart::start);
    connect(m_varied, &QLineEdit::returnPressed, m_start, &StudyStart::start);
    setReady(false, false, tr("Open a result first."));
}

void AccuracyPanel::buildChoices() {
    PanelGroup* group = addGroup(tr("Settings to compare"));
    const auto field = [group](const QString& name, QWidget* editor, const QString& tip) {
        auto* label = new QLabel(name);
        label->setWordWrap(true);
        label->setBuddy(editor);
        label->setToolTip(tip);
        editor->setToolTip(tip);
        editor->setAccessibleName(name);
        group->addWide(label);
        group->addWide(editor);
    };
    m_multiples->setObjectName(QStringLiteral("multiples"));
    m_varied->setObjectName(QStringLiteral("varied"));
    m_varied->setPlaceholderText(QStringLiteral("cluster_shape=oriented_box,hull"));
    field(
        tr("Multiples of the mean distance"), m_multiples,
        tr("Sizes of the Basic Grid, as multiples of the mean distance of adjacent fragments (no unit), separated by commas; auto "
           "is the size that the program finds. Empty: the grid as set"));
    field(tr("Other parameters to vary"), m_varied,
          tr("Values of other parameters in every combination, such as cluster_shape=oriented_box,hull; several parameters are "
             "separated by "
             "semicolons. The manual lists all parameters"));
    m_repeats->setRange(1, 100);
    m_repeats->setValue(2);
    m_repeats->setAlignment(Qt::AlignRight);
    field(tr("Repeats of the reference"), m_repeats,
          tr("How often the reference is repeated with births shifted by a micrometre: what its own debris differs by says what a "
             "difference means. Each takes as long as the reference"));
    m_settingRepeats->setObjectName(QStringLiteral("settingRepeats"));
    m_settingRepeats->setRange(0, 100);
    m_settingRepeats->setSpecialValueText(tr("none"));
    m_settingRepeats->setAlignment(Qt::AlignRight);
    field(
        tr("Repeats of every setting"), m_settingRepeats,
        tr("How often every setting is repeated with births shifted by a micrometre: the chart shows as a line through its point "
           "how "
           "far its own accuracy scatters, so that two settings are not told apart by chance. Each takes as long as the setting"));
    m_toleranceField->setObjectName(QStringLiteral("tolerances"));
    field(tr("Tolerances, m"), m_toleranceField,
          tr("Accuracy rates count the fragments within these distances of their place in the reference, and the view coloured by "
             "error changes colour there. Metres, separated by commas. Another comparison takes them up without simulating anew"));
    m_toleranceWhy->setObjectName(QStringLiteral("complaint"));
    m_toleranceWhy->setWordWrap(true);
    m_toleranceWhy->hide();
    group->addWide(m_toleranceWhy);
    connect(m_toleranceField, &QLineEdit::editingFinished, this, &AccuracyPanel::readTolerances);
    m_liveFps->setChecked(true);
    m_liveFps->setToolTip(tr("Draw each setting once off screen, as live mode would, and count frames per second"));
    group->addWide(m_liveFps);
    m_retimed->setToolTip(tr("Times and live FPS that are kept do not count: for a machine that is quiet now"));
    group->addWide(m_retimed);
    group->addNote(
        tr("The settings of the published method are compared too. A body for every fragment, the reference, is "
           "the slowest of all: it can take many times as long as the run itself."));
    m_folder = group->addNote({});
    m_folder->setTextInteractionFlags(Qt::TextSelectableByMouse);
}

void AccuracyPanel::buildMachine() {
    PanelGroup* group = addGroup(tr("This machine"));
    auto* calibrate = new QPushButton(tr("Calibrate this machine…"));
    calibrate->setObjectName(QStringLiteral("calibrate"));
    calibrate->setToolTip(tr("Measure how many bodies this machine carries, and see the curve"));
    group->addWide(calibrate);
    group->addNote(
        tr("Tells how many bodies a frame rate allows, and lets time and FPS be predicted of a collapse that was not "
           "compared yet."));
    connect(calibrate, &QPushButton::clicked, this, &AccuracyPanel::calibrationRequested);
}

void AccuracyPanel::readTolerances() {
    std::vector<double> read;
    bool good = true;
    for (const std::string& part : listed(m_toleranceField->text())) {
        bool number = false;
        const double tolerance = QString::fromStdString(part).toDouble(&number);
        good = good && number && tolerance >= leastTolerance && tolerance <= greatestTolerance;
        read.push_back(tolerance);
    }
    std::sort(read.begin(), read.end());
    read.erase(std::unique(read.begin(), read.end()), read.end());
    good = good && !read.empty() && read.size() <= mostTolerances;
    m_toleranceField->setProperty("wrong", !good);
    m_toleranceField->style()->unpolish(m_toleranceField);
    m_toleranceField->style()->polish(m_toleranceField);
    m_toleranceWhy->setText(
        tr("One to %1 distances from %2 to %3 m, separated by commas, please. In force: %4.")
            .arg(mostTolerances)
            .arg(QLocale().toString(leastTolerance), QLocale().toString(greatestTolerance), tolerancesText(m_tolerances)));
    m_toleranceWhy->setVisible(!good);
    if (good && read != m_tolerances) {
        m_tolerances = std::move(read);
        emit tolerancesChanged(m_tolerances);
    }
}

AccuracyPanel::Request AccuracyPanel::request() const {
    Request request;
    request.multiples = listed(m_multiples->text());
    for (const QString& part : m_varied->text().split(u';', Qt::SkipEmptyParts)) {
        if (part.trimmed().isEmpty()) {
            continue;
        }
        const qsizetype sign = part.indexOf(u'=');
        request.varied.push_back(
            {part.left(sign).trimmed().toStdString(), sign < 0 ? std::vector<std::string>() : listed(part.mid(sign + 1))});
    }
    request.tolerances = m_tolerances;
    request.repeats = m_repeats->value();
    request.settingRepeats = m_settingRepeats->value();
    request.liveFps = m_liveFps->isChecked();
    request.retimed = m_retimed->isChecked();
    request.onCluster = m_place->onCluster();
    request.sbatchOptions = m_place->sbatchOptions();
    return request;
}

void AccuracyPanel::setRequest(const Request& request) {
    const auto joined = [](const std::vector<std::string>& values) {
        QStringList words;
        for (const std::string& value : values) {
            words << QString::fromStdString(value);
        }
        return words.join(QStringLiteral(", "));
    };
    m_multiples->setText(joined(request.multiples));
    QStringList varied;
    for (const VariedParameter& parameter : request.varied) {
        varied << QString::fromStdString(parameter.key) + u'=' + joined(parameter.values);
    }
    m_varied->setText(varied.join(QStringLiteral("; ")));
    m_repeats->setValue(request.repeats);
    m_settingRepeats->setValue(request.settingRepeats);
    m_toleranceField->setText(tolerancesText(request.tolerances));
    readTolerances();
    m_liveFps->setChecked(request.liveFps);
    m_place->setOnCluster(request.onCluster);
}

void AccuracyPanel::setReady(bool ready, bool running, const QString& why) {
    m_start->setReady(ready, running, why);
    for (QWidget* editor : std::initializer_list<QWidget*>{m_multiples, m_varied, m_toleranceField, m_repeats, m_settingRepeats,
                                                           m_liveFps, m_retimed}) {
        editor->setEnabled(!running);
    }
}

void AccuracyPanel::setProgress(const QString& what, double fraction, double secondsLeft) {
    m_start->setProgress(what, fraction, secondsLeft);
}

void AccuracyPanel::setFindings(const Findings& findings) {
    m_findings->set(findings);
}

void AccuracyPanel::setFolder(const QString& folder) {
    m_folder->setText(tr("What is done is kept in %1, so that a second start goes on from there.").arg(folder));
    m_folder->setVisible(!folder.isEmpty());
}

}  // namespace rubble::widgets
