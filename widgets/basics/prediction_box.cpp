#include "widgets/basics/prediction_box.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/basics/theme.h"
#include "widgets/basics/wording.h"

namespace rubble::widgets {

namespace {

struct FigureWords {
    const char* name;
    const char* tip;
    const char* unit;
};

/// In the order of Predicted.
constexpr std::array<FigureWords, predictedCount> figureWords{{
    {QT_TRANSLATE_NOOP("prediction", "Wall time"), QT_TRANSLATE_NOOP("prediction", "Of the simulation, from start to end"), ""},
    {QT_TRANSLATE_NOOP("prediction", "Step"), QT_TRANSLATE_NOOP("prediction", "Mean from the first to the last birth"), "ms"},
    {QT_TRANSLATE_NOOP("prediction", "Live rate"),
     QT_TRANSLATE_NOOP("prediction", "Frames per second of live mode, mean from the first to the last birth"), "FPS"},
    {QT_TRANSLATE_NOOP("prediction", "Mass map difference"),
     QT_TRANSLATE_NOOP("prediction", "Share of the mass that lies in other cells of 2 m than in the reference: 0 is the same"), ""},
    {QT_TRANSLATE_NOOP("prediction", "Core overlap"),
     QT_TRANSLATE_NOOP("prediction", "Of the cells that hold 95 % of the mass, with the reference: 1 is the same"), ""},
    {QT_TRANSLATE_NOOP("prediction", "Footprint overlap"),
     QT_TRANSLATE_NOOP("prediction", "Of the cells that debris covers, with the reference: 1 is the same"), ""},
    {QT_TRANSLATE_NOOP("prediction", "Height map error"),
     QT_TRANSLATE_NOOP("prediction", "Root of the mean square difference of the heights of the pile"), "m"},
    {QT_TRANSLATE_NOOP("prediction", "Mean height error"),
     QT_TRANSLATE_NOOP("prediction", "Difference of the mean height of the mass above ground"), "m"},
}};

const FigureWords& wordsOf(Predicted what) {
    return figureWords[static_cast<std::size_t>(what)];
}

QString translated(const char* text) {
    return QCoreApplication::translate("prediction", text);
}

QString unitOf(Predicted what) {
    const QString unit = QString::fromLatin1(wordsOf(what).unit);
    return unit.isEmpty() ? QString() : QChar(0x00A0) + unit;
}

/// Without its unit.
QString figureText(Predicted what, double value, double width) {
    if (what == Predicted::WallSeconds && value >= 10.0) {
        return shownDuration(value);
    }
    const int decimals =
        width > 0.0 && std::isfinite(width) ? std::clamp(static_cast<int>(std::ceil(-std::log10(width) + 0.3)), 0, 3) : 3;
    const QString number = QLocale().toString(value, 'f', decimals);
    return what == Predicted::WallSeconds ? number + QStringLiteral("\u00A0s") : number;
}

}  // namespace

QString predictedWords(Predicted what) {
    return translated(wordsOf(what).name);
}

QString shownPredicted(Predicted what, double value, double width) {
    return figureText(what, value, width) + unitOf(what);
}

PredictionBox::PredictionBox(QWidget* parent) : QWidget(parent), m_heading(new QLabel), m_reasons(new QLabel) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    m_heading->setObjectName(QStringLiteral("groupHeading"));
    m_heading->setFont(groupFont());
    m_heading->setWordWrap(true);
    column->addWidget(m_heading);
    auto* grid = new QGridLayout;
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(0, 1);
    for (std::size_t i = 0; i < predictedCount; ++i) {
        Line& line = m_lines[i];
        const int row = 2 * static_cast<int>(i);
        line = {new QLabel, new QLabel, new QLabel};
        line.value->setObjectName(QStringLiteral("value"));
        line.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        line.interval->setObjectName(QStringLiteral("muted"));
        line.interval->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(line.name, row, 0);
        grid->addWidget(line.value, row, 1);
        grid->addWidget(line.interval, row + 1, 0, 1, 2);
    }
    column->addLayout(grid);
    m_reasons->setObjectName(QStringLiteral("muted"));
    m_reasons->setWordWrap(true);
    m_reasons->setTextFormat(Qt::RichText);
    m_reasons->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    connect(m_reasons, &QLabel::linkActivated, this, &PredictionBox::helpRequested);
    column->addWidget(m_reasons);
    setContent({});
}

void PredictionBox::setContent(const PredictionContent& content) {
    using State = PredictionContent::State;
    setVisible(content.state != State::None);
    const QString heading = content.state == State::Afterwards ? tr("Said before the run, and measured")
                            : content.state == State::Pending  ? tr("Predicted for this setting …")
                                                               : tr("Predicted for this setting");
    m_heading->setText(heading);
    for (std::size_t i = 0; i < predictedCount; ++i) {
        const auto found = std::find_if(content.figures.begin(), content.figures.end(),
                                        [i](const PredictedFigure& figure) { return static_cast<std::size_t>(figure.what) == i; });
        Line& line = m_lines[i];
        const bool shown = found != content.figures.end() && (found->prediction.known || found->measured);
        for (QLabel* label : {line.name, line.value, line.interval}) {
            label->setVisible(shown);
        }
        line.name->setText(translated(figureWords[i].name));
        line.name->setToolTip(translated(figureWords[i].tip));
        // What is not shown keeps nothing of an earlier setting or language.
        for (QLabel* label : {line.value, line.interval}) {
            label->clear();
            label->setToolTip({});
        }
        if (shown) {
            showFigure(line, *found, content.state);
        }
    }
    showReasons(content);
    setAccessibleName(m_heading->text());
    setAccessibleDescription(text());
}

void PredictionBox::showFigure(Line& line, const PredictedFigure& figure, PredictionContent::State state) {
    const Prediction& prediction = figure.prediction;
    const double width = 0.5 * (prediction.high - prediction.low);
    const bool afterwards = state == PredictionContent::State::Afterwards;
    if (afterwards) {
        line.value->setText(figure.measured ? shownPredicted(figure.what, *figure.measured, prediction.known ? width : 0.0)
                                            : tr("not measured"));
    } else {
        line.value->setText(shownPredicted(figure.what, prediction.value, width));
    }
    if (!prediction.known) {
        line.interval->setText(tr("was not predicted"));
        return;
    }
    const QString range =
        tr("%1 to %2").arg(figureText(figure.what, prediction.low, width), shownPredicted(figure.what, prediction.high, width));
    if (afterwards) {
        // As both are shown: what reads as an end of the interval lies in it.
        const auto reads = [&](double value) { return figureText(figure.what, value, width); };
        const bool held = figure.measured &&
                          ((*figure.measured >= prediction.low && *figure.measured <= prediction.high) ||
                           reads(*figure.measured) == reads(prediction.low) || reads(*figure.measured) == reads(prediction.high));
        line.interval->setText(!figure.measured ? tr("said: %1").arg(range)
                               : held           ? tr("said: %1 – held").arg(range)
                                                : tr("said: %1 – missed").arg(range));
    } else {
        line.interval->setText(prediction.fromSpeed ? tr("crude: %1").arg(range) : range);
    }
    const QString rests = prediction.fromSpeed ? tr("Crude: from bodies, their births and what this machine did within a second. "
                                                    "Settings that were compared make it better.")
                          : prediction.fromRun ? tr("From a run of these very settings on this machine.")
                          : prediction.fromCalibration ? tr("From the calibration of this machine alone: piles of other collapses.")
                                                       : tr("From %1 earlier points of this collapse.").arg(prediction.points);
    const QString meant = prediction.fromRun
                              ? tr("Two thirds to one and a half of its wall time: room for a busier or idler machine, not a "
                                   "measured probability.")
                              : tr("Four runs in five end in this interval.");
    line.value->setToolTip(prediction.fromRun ? rests + QLatin1Char(' ') + meant : meant + QLatin1Char(' ') + rests);
    line.interval->setToolTip(line.value->toolTip());
}

void PredictionBox::showReasons(const PredictionContent& content) {
    // One sentence for all figures that are not known for the same reason.
    std::vector<std::pair<QString, QStringList>> reasons;
    for (const PredictedFigure& figure : content.figures) {
        if (figure.prediction.known || content.state == PredictionContent::State::Afterwards) {
            continue;
        }
        const QString reason = worded(figure.prediction.reason);
        const auto found = std::find_if(reasons.begin(), reasons.end(), [&](const auto& r) { return r.first == reason; });
        const QString name = predictedWords(figure.what).toLower();
        if (found == reasons.end()) {
            reasons.push_back({reason, {name}});
        } else {
            found->second << name;
        }
    }
    QStringList lines;
    for (const auto& [reason, names] : reasons) {
        lines << tr("Not known: %1 (%2).").arg(names.join(QStringLiteral(", ")), reason).toHtmlEscaped();
    }
    if (!lines.isEmpty()) {
        lines << QStringLiteral("<a href='help' style='color:%1'>%2</a>").arg(tints().accent.name(), tr("How to find out"));
    }
    m_reasons->setText(lines.join(QStringLiteral("<br/>")));
    m_reasons->setVisible(!lines.isEmpty());
}

QString PredictionBox::text() const {
    QStringList lines;
    for (const Line& line : m_lines) {
        if (!line.name->isHidden()) {
            lines << QStringLiteral("%1: %2 (%3)").arg(line.name->text(), line.value->text(), line.interval->text());
        }
    }
    if (!m_reasons->isHidden()) {
        lines << m_reasons->text();
    }
    return lines.join(u'\n');
}

}  // namespace rubble::widgets
