#include "widgets/basics/wording.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "core/scenario/parameters.h"
#include "core/scenario/setting_names.h"
#include "widgets/basics/fixed_number.h"
#include "widgets/basics/language.h"
#include "widgets/figures/report/spoken_text.h"
#include "widgets/figures/shown_units.h"

namespace rubble::widgets {

namespace {

/// The pattern of a message in the language of the window. Core puts some together: what was asked in front of a reason, and that a
/// value may be automatic before the last stop.
QString patternOf(const std::string& english) {
    const QString whole = said("messages", english);
    if (whole != QString::fromStdString(english)) {
        return whole;
    }
    static constexpr std::string_view orAuto = ", or auto";
    if (const std::size_t at = english.rfind(orAuto); at != std::string::npos && at + orAuto.size() + 1 == english.size()) {
        QString without = patternOf(english.substr(0, at) + english.back());
        return without.insert(without.size() - 1, said("messages", orAuto));
    }
    for (std::size_t colon = english.find(": "); colon != std::string::npos; colon = english.find(": ", colon + 2)) {
        const std::string preface = english.substr(0, colon + 2);
        if (const QString words = said("messages", preface); words != QString::fromStdString(preface)) {
            return words + patternOf(english.substr(colon + 2));
        }
    }
    return whole;
}

/// A text of a widget, with the context that it is translated in.
struct WidgetText {
    const char* context;
    const char* text;
};

/// What stands in the window for an option of the command line: the words of its field or button, and of what that stands under.
struct OptionName {
    QLatin1String option;
    WidgetText name;
    WidgetText under;
};

constexpr WidgetText evidencePanel{"rubble::PanelDeck", "Evidence"};
constexpr WidgetText reportPanel{"rubble::PanelDeck", "Report"};
constexpr WidgetText caseMenu{"actions", "Case"};
const std::array optionNames{
    OptionName{QLatin1String("--live"), {"rubble::widgets::SurveyBox", "Fallen structure counts as debris"}, evidencePanel},
    OptionName{QLatin1String("--survey-live"), {"rubble::widgets::SurveyBox", "Fallen structure in it"}, evidencePanel},
    OptionName{QLatin1String("--area"), {"rubble::widgets::SurveyBox", "Draw an area of interest"}, evidencePanel},
    OptionName{QLatin1String("--leave-out"), {"rubble::widgets::SurveyBox", "Draw what is left out"}, evidencePanel},
    OptionName{QLatin1String("--registration-error"), {"rubble::widgets::DistanceFields", "Registration error"}, evidencePanel},
    OptionName{
        QLatin1String("--mesh-offset"), {"rubble::widgets::SiteDialog", "Offsets of the surroundings"}, {"actions", "Site…"}},
    OptionName{QLatin1String("--case"), {"actions", "Save case"}, caseMenu},
    OptionName{QLatin1String("--question"), {"rubble::widgets::ReportPanel", "Question"}, reportPanel},
    OptionName{QLatin1String("--by"), {"rubble::widgets::ReportPanel", "Made by"}, reportPanel},
    OptionName{QLatin1String("--repeats"), {"rubble::widgets::ReportPanel", "Repeats"}, reportPanel},
    OptionName{QLatin1String("--self-test"), {"rubble::widgets::ReportPanel", "Self-test"}, reportPanel},
    OptionName{
        QLatin1String("--retime"), {"rubble::widgets::AccuracyPanel", "Measure times again"}, {"rubble::PanelDeck", "Accuracy"}},
    OptionName{QLatin1String("--executor commands"), {"rubble::widgets::PlaceChoice", "Run on"}, {"rubble::PanelDeck", "Accuracy"}},
};

/// "--area, --leave-out" by the words of the window; nothing where one of them is an option of another program.
QString namesOf(const QString& options, const QString& separator) {
    QStringList names;
    QString under;
    for (const QString& option : options.split(separator)) {
        const auto row =
            std::find_if(optionNames.begin(), optionNames.end(), [&](const OptionName& each) { return each.option == option; });
        if (row == optionNames.end()) {
            return {};
        }
        names << QStringLiteral("“%1”").arg(said(row->name.context, row->name.text));
        under = said(row->under.context, row->under.text);
    }
    return QCoreApplication::translate("rubble", "%1 under “%2”", "fields, and the panel or menu that they stand under")
        .arg(names.join(separator), under);
}

/// Options are words of the command line; on screen their fields are named. A command that the window lacks keeps its name, and its
/// help tells the options.
QString withNamesOfOptions(QString text) {
    if (!text.contains(QLatin1String("--"))) {
        return text;
    }
    static const QRegularExpression called(QStringLiteral("(rubble-cli [a-z-]+)(?: --[a-z-]+(?: [A-Z{][\\w={}]*)?)+"));
    static const QRegularExpression set(QStringLiteral("--set (\\w+)="));
    static const QRegularExpression listed(QStringLiteral("--[a-z-]+(?: commands)?(?:(, |、)--[a-z-]+)*"));
    text.replace(called, QStringLiteral("\\1")).replace(set, QStringLiteral("\\1 = "));
    qsizetype from = 0;
    for (auto found = listed.match(text); found.hasMatch(); found = listed.match(text, from)) {
        const QString names = namesOf(found.captured(), found.hasCaptured(1) ? found.captured(1) : QStringLiteral(", "));
        from = found.capturedStart() + (names.isEmpty() ? found.capturedLength() : names.size());
        if (!names.isEmpty()) {
            text.replace(found.capturedStart(), found.capturedLength(), names);
        }
    }
    return text;
}

/// Settings have their keys in files and on the command line; on screen they have the names that stand beside their fields.
QString withNamesOfSettings(const QString& text) {
    // Where a name stands before another, the comment tells which text of the catalogue is meant.
    [[maybe_unused]] static const auto of = QT_TRANSLATE_NOOP3("rubble", "%1 of “%2”", "setting-of-component");
    const auto say = [](std::string_view context, std::string_view english, std::string_view comment) {
        const std::string in(context);
        const std::string words(english);
        const std::string told(comment);
        return QCoreApplication::translate(in.c_str(), words.c_str(), told.empty() ? nullptr : told.c_str()).toStdString();
    };
    return QString::fromStdString(withSettingNames(text.toStdString(), say));
}

/// @param asItIs  it is a name or a key
QString shownArgument(const Argument& argument, bool asItIs) {
    QString text;
    const auto* number = std::get_if<double>(&argument.value);
    const figures::ShownUnit unit = figures::shownUnit(argument.unit, number != nullptr ? *number : 0.0);
    if (const auto* words = std::get_if<std::string>(&argument.value)) {
        text = asItIs ? QString::fromStdString(*words) : figures::spokenText(*words);
    } else if (const auto* whole = std::get_if<std::int64_t>(&argument.value)) {
        text = shownCount(*whole);
    } else {
        text = shownNumber(*number * unit.perSi, 4);
    }
    return argument.unit.empty() ? text : text + QChar(0x00A0) + unit.name;
}

}  // namespace

QString worded(const Message& message) {
    const QString pattern = figures::raisedUnits(withNamesOfSettings(withNamesOfOptions(patternOf(message.pattern))));
    QString text;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        const qsizetype close = pattern[i] == u'{' ? pattern.indexOf(u'}', i) : -1;
        bool isNumber = false;
        const int index = close > 0 ? pattern.mid(i + 1, close - i - 1).toInt(&isNumber) : -1;
        if (isNumber && index >= 0 && index < static_cast<int>(message.arguments.size())) {
            text += shownArgument(message.arguments[static_cast<std::size_t>(index)],
                                  figures::isVerbatim(message.pattern, static_cast<std::size_t>(index)));
            i = close;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

QString shownDegrees(double angle) {
    constexpr double least = 1e-4;
    const double degrees = angle * 180.0 / std::numbers::pi;
    const bool tiny = degrees != 0.0 && std::abs(degrees) < least;
    return tiny ? QStringLiteral("< ") + QLocale().toString(least, 'f', 4) : shownNumber(degrees);
}

QString shownNumber(double value, int significant) {
    if (!std::isfinite(value)) {
        return QString(QChar(0x2013));
    }
    if (value == 0.0) {
        return QStringLiteral("0");
    }
    const QLocale locale;
    const double size = std::abs(value);
    const int power = static_cast<int>(std::floor(std::log10(size)));
    if (size >= 1e7 || size < 1e-4) {
        QString raised;
        for (const QChar digit : QString::number(power)) {
            // Superscript digits are not in one row of the character set.
            raised += digit == u'-'
                          ? QChar(0x207B)
                          : QStringLiteral("\u2070\u00B9\u00B2\u00B3\u2074\u2075\u2076\u2077\u2078\u2079")[digit.digitValue()];
        }
        return locale.toString(value / std::pow(10.0, power), 'f', significant - 1) + QStringLiteral(" × 10") + raised;
    }
    if (power >= significant) {
        const double step = std::pow(10.0, power + 1 - significant);
        value = std::round(value / step) * step;
    }
    return locale.toString(value, 'f', std::max(0, significant - power - 1));
}

QString shownIn(double value, std::string_view unit, int significant) {
    return shownNumber(value * figures::shownUnit(unit).perSi, significant);
}

QString shownWith(double value, std::string_view unit, int significant) {
    const figures::ShownUnit shown = figures::shownUnit(unit, value);
    return shownNumber(value * shown.perSi, significant) + QChar(0x00A0) + shown.name;
}

QString shownLength(double metres, int significant) {
    return shownWith(metres, "m", significant);
}

QString shownPlace(double metres, int decimals) {
    const double perSi = figures::shownUnit("m").perSi;
    // A thousandth of a metre is a whole millimetre.
    const int fewer = static_cast<int>(std::lround(std::floor(std::log10(perSi) + 1e-9)));
    return shownFixed(metres * perSi, std::max(0, decimals - fewer));
}

double typedIn(double shown, std::string_view unit) {
    return shown / figures::shownUnit(unit).perSi;
}

std::optional<double> typedNumber(const QString& text, std::string_view unit, double near) {
    static const QRegularExpression form(QStringLiteral("^(.*?)\\s*([^\\d\\s.,]*)$"));
    const auto parsed = [](const QString& digits) -> std::optional<double> {
        bool ok = false;
        double number = QLocale().toDouble(digits, &ok);
        if (!ok) {
            number = QLocale::c().toDouble(digits, &ok);
        }
        return ok && std::isfinite(number) ? std::optional(number) : std::nullopt;
    };
    const QString typed = text.trimmed();
    const figures::ShownUnit shown = figures::shownUnit(unit, near);
    if (const auto plain = parsed(typed)) {
        return *plain / shown.perSi;
    }
    const QRegularExpressionMatch parts = form.match(typed);
    const auto number = parsed(parts.captured(1));
    const QString said = parts.captured(2);
    if (!number || said.isEmpty()) {
        return std::nullopt;
    }
    if (said == shown.name) {
        return *number / shown.perSi;
    }
    if (unit == "s") {
        static const std::map<QString, double> times{{QStringLiteral("s"), 1.0},
                                                     {QStringLiteral("ms"), 1e-3},
                                                     {QStringLiteral("us"), 1e-6},
                                                     {QStringLiteral("µs"), 1e-6},
                                                     {QStringLiteral("\u03BCs"), 1e-6}};
        const auto time = times.find(said);
        return time != times.end() ? std::optional(*number * time->second) : std::nullopt;
    }
    return std::nullopt;
}

QString shownEnergy(double joules, int significant) {
    if (figures::unitSet() != figures::UnitSet::Si) {
        return shownWith(joules, "J", significant);
    }
    static constexpr std::array units = {"J", "kJ", "MJ", "GJ", "TJ"};
    std::size_t unit = 0;
    while (std::abs(joules) >= 1000.0 && unit + 1 < units.size()) {
        joules /= 1000.0;
        ++unit;
    }
    return shownNumber(joules, significant) + QChar(0x00A0) + QLatin1String(units[unit]);
}

QString shownMass(double kilograms, int significant) {
    if (std::abs(kilograms) >= 1000.0) {
        return shownWith(kilograms / 1000.0, "t", significant);
    }
    if (figures::unitSet() != figures::UnitSet::Si || std::abs(kilograms) >= 1.0 || kilograms == 0.0) {
        return shownWith(kilograms, "kg", significant);
    }
    const bool grams = std::abs(kilograms) >= 1e-3;
    return shownNumber(kilograms * (grams ? 1e3 : 1e6), significant) + QChar(0x00A0) + QLatin1String(grams ? "g" : "mg");
}

QString shownCount(std::int64_t value) {
    return QLocale().toString(static_cast<qlonglong>(value));
}

QString shownShare(double share, int decimals) {
    if (!std::isfinite(share)) {
        return QString(QChar(0x2013));
    }
    // A run that has gone astray must not widen the window with its digits.
    const double percent = 100.0 * share;
    return (std::abs(percent) < 1e5 ? QLocale().toString(percent, 'f', decimals) : shownNumber(percent)) + QStringLiteral(" %");
}

QString shownDuration(double seconds) {
    if (!std::isfinite(seconds)) {
        return QString(QChar(0x2013));
    }
    if (seconds < 10.0) {
        const int places = seconds <= 0.0 || seconds >= 0.0995 ? 1 : seconds >= 0.00995 ? 2 : 3;
        return QLocale().toString(seconds, 'f', places) + QStringLiteral(" s");
    }
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    const auto two = [](const char* form, std::int64_t large, std::int64_t small) {
        return QString::fromLatin1(form).arg(large).arg(small, 2, 10, QLatin1Char('0'));
    };
    return whole < 60     ? QStringLiteral("%1 s").arg(whole)
           : whole < 3600 ? two("%1 min %2 s", whole / 60, whole % 60)
                          : two("%1 h %2 min", (whole + 30) / 3600, (whole + 30) / 60 % 60);
}

QString shownProgress(const QString& what, double secondsLeft) {
    QString text = what.left(1).toUpper() + what.mid(1);
    // Less than half a second is no time to wait for; what takes longer all the same says what it does.
    if (secondsLeft >= 0.5) {
        text += QCoreApplication::translate("rubble", " · about %1 left").arg(shownDuration(secondsLeft));
    }
    return text;
}

QString inOneLine(const QStringList& parts) {
    QString line = parts.value(0);
    for (const QString& part : parts.mid(1)) {
        line = QCoreApplication::translate("rubble", "%1; %2", "two parts of a line").arg(line, part);
    }
    return line;
}

QString shownName(std::string_view name) {
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    return said("choices", words);
}

QString shownHelp(const Parameter& row) {
    return figures::raisedUnits(withNamesOfSettings(said("parameters", row.help)));
}

QString shownValue(const ParameterValue& value) {
    if (std::holds_alternative<std::monostate>(value)) {
        return QCoreApplication::translate("rubble", "auto");
    }
    if (const auto* flag = std::get_if<bool>(&value)) {
        return *flag ? QCoreApplication::translate("rubble", "on") : QCoreApplication::translate("rubble", "off");
    }
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return shownCount(*whole);
    }
    if (const auto* number = std::get_if<double>(&value)) {
        return QLocale().toString(*number, 'g', 6);
    }
    return shownName(std::get<std::string>(value));
}

}  // namespace rubble::widgets
