#include "widgets/figures/report/spoken_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/scenario/parameters.h"
#include "widgets/figures/shown_units.h"

namespace rubble::figures {

namespace {

QString inSpokenLanguage(const char* context, const QByteArray& english, const char* comment) {
    return QCoreApplication::translate(context, english.constData(), comment);
}

/// Places and reasons that core makes into texts before they become part of a message.
constexpr std::array madeTexts = {
    QT_TRANSLATE_NOOP("messages", "{0} lay {1} deep in another for over 0.5 s, {2} of its smallest side; the limit is {3} ({4})"),
    QT_TRANSLATE_NOOP("messages",
                      "{0} lay {1} deep in another for over 0.5 s, {2} times its smallest side: it has gone through; the limit is "
                      "{3} of that side ({4})"),
    QT_TRANSLATE_NOOP("messages",
                      "{0} at once lay more than 5 % of a smallest side inside another for over 0.5 s, {1} of all; {2} worst"),
    QT_TRANSLATE_NOOP("messages",
                      "energy rose by {0} of the work of gravity beyond gravity, births, overlap, pieces and effects; the limit is "
                      "{1} ({2} gained most)"),
    QT_TRANSLATE_NOOP("messages", "{0} was {1} times as fast as its birth and its fall allow; the limit is {2} ({3})"),
    QT_TRANSLATE_NOOP("messages", "the centre of {0} was {1} below the ground ({2})"),
    QT_TRANSLATE_NOOP(
        "messages",
        "{0} was {1} from the structure; 10 times its height (taken as 1 m at least) and the drop of the terrain are {2} ({3})"),
    QT_TRANSLATE_NOOP("messages", "{0} at x = {1} m, y = {2} m"),
    QT_TRANSLATE_NOOP("messages", "place or velocity of {0} was no number: it was taken out ({1})"),
    QT_TRANSLATE_NOOP("messages", "the share of bodies at rest fell to {0} after it had reached {1}"),
    QT_TRANSLATE_NOOP("messages", "the pile has {0} times the volume of its material, less than {1}: it is squeezed into itself"),
    QT_TRANSLATE_NOOP("messages", "the pile has {0} times the volume of its material, more than {1}: its shapes are inflated"),
    QT_TRANSLATE_NOOP("messages", "{0} ({1}), up is {2} ({3})"),
    QT_TRANSLATE_NOOP("messages", "{0}; {1} of {2} active at the first state"),
    QT_TRANSLATE_NOOP("messages", "{0} of {1} active at the first state"),
    QT_TRANSLATE_NOOP("messages", "{0}, {1} is active ({2})"),
    QT_TRANSLATE_NOOP("messages", "{0}, {1} is active"),
    QT_TRANSLATE_NOOP("messages", "{0}, {1} times its first volume"),
    QT_TRANSLATE_NOOP("messages", "{0}, {1} thick per length"),
    QT_TRANSLATE_NOOP("messages", "{0}, {1} s, but reported at state {2}"),
    QT_TRANSLATE_NOOP("messages", "element {0} ({1}), {2} s"),
    QT_TRANSLATE_NOOP("messages", "element {0} ({1}) at state {2}"),
    QT_TRANSLATE_NOOP("messages", "element {0} ({1})"),
    QT_TRANSLATE_NOOP("messages", "element {0} of type {1}"),
    QT_TRANSLATE_NOOP("messages", "element {0} at state {1}: {2}"),
    QT_TRANSLATE_NOOP("messages", "element {0}"),
    QT_TRANSLATE_NOOP("messages", "node {0}"),
    QT_TRANSLATE_NOOP("messages", "body {0}"),
    QT_TRANSLATE_NOOP("messages", "the fragment of {0}"),
    QT_TRANSLATE_NOOP("messages", "{0} of time are {1}"),
    QT_TRANSLATE_NOOP("messages", "size {0} is {1}"),
    QT_TRANSLATE_NOOP("messages", "free nodes fall at {0}, which is {1}"),
    QT_TRANSLATE_NOOP("messages", "free nodes fall along {0}"),
    QT_TRANSLATE_NOOP("messages", "free nodes fall at {0} in the file, {1} m/s2"),
    QT_TRANSLATE_NOOP("messages", "what comes down gathers speed at {0} in the file, {1} m/s2"),
    QT_TRANSLATE_NOOP("messages", "what comes down gathers speed at {0}, which is {1}"),
    QT_TRANSLATE_NOOP("messages", "what comes down gathers speed along {0}"),
    QT_TRANSLATE_NOOP("messages", "density {0} of \"{1}\" is {2}, {3}"),
    QT_TRANSLATE_NOOP("messages", "1 body"),
    QT_TRANSLATE_NOOP("messages", "{0} bodies"),
    QT_TRANSLATE_NOOP("messages", "once"),
    QT_TRANSLATE_NOOP("messages", "{0} times"),
    QT_TRANSLATE_NOOP("messages", "1 limit of health"),
    QT_TRANSLATE_NOOP("messages", "{0} limits of health"),
    QT_TRANSLATE_NOOP("messages", "solid"),
    QT_TRANSLATE_NOOP("messages", "shell"),
    QT_TRANSLATE_NOOP("messages", "beam"),
    QT_TRANSLATE_NOOP("messages", "mixed")};

/// A made text, and the form that finds its values in English.
struct MadeForm {
    const char* text;
    QRegularExpression form;
};

/// Compiled once: a panel that is shown asks for hundreds of texts, and forms made for each took half of the window's time.
const std::vector<MadeForm>& madeForms() {
    static const std::vector<MadeForm> forms = [] {
        const QRegularExpression place(QStringLiteral("\\\\\\{(\\d)\\\\\\}"));
        std::vector<MadeForm> made;
        for (const char* text : madeTexts) {
            QString form = QRegularExpression::escape(QString::fromUtf8(text));
            form.replace(place, QStringLiteral("(?<v\\1>.+?)"));
            made.push_back({text, QRegularExpression(u'^' + form + u'$')});
            made.back().form.optimize();
        }
        return made;
    }();
    return forms;
}

/// The row of a key and what it is of; null where there is no such setting.
std::pair<const Parameter*, std::string> settingOf(const std::string& key) {
    try {
        return findParameter(key);
    } catch (const UsageError&) {
        return {nullptr, std::string()};
    }
}

/// "element 12 (deck)"
bool namesComponent(std::string_view text) {
    return text.starts_with("element {0} ({1})");
}

/// What a made text says, if it is one: its values go from the English pattern into the one of the window.
QString filledText(const QString& english, const SaidIn& say) {
    for (const MadeForm& made : madeForms()) {
        const QRegularExpressionMatch match = made.form.match(english);
        if (!match.hasMatch()) {
            continue;
        }
        QString text = raisedUnits(say("messages", made.text, nullptr));
        for (int i = 0; i < 5; ++i) {
            const QString value = match.captured(QStringLiteral("v%1").arg(i));
            const bool asItIs =
                value.isEmpty() || isVerbatim(made.text, static_cast<std::size_t>(i)) || (i == 1 && namesComponent(made.text));
            text.replace(QStringLiteral("{%1}").arg(i), asItIs ? value : spokenTextIn(value.toStdString(), say));
        }
        return text;
    }
    return english;
}

}  // namespace

bool isVerbatim(const std::string& pattern, std::size_t argument) {
    const std::string placeholder = '{' + std::to_string(argument) + '}';
    return pattern.find('"' + placeholder + '"') != std::string::npos || pattern.find('[' + placeholder + ']') != std::string::npos;
}

void sayArguments(Message& message, const std::function<std::string(const std::string&)>& say) {
    for (std::size_t i = 0; i < message.arguments.size(); ++i) {
        auto* words = std::get_if<std::string>(&message.arguments[i].value);
        if (words != nullptr && !isVerbatim(message.pattern, i)) {
            *words = say(*words);
        }
    }
}

QString spokenSetting(const std::string& key) {
    const auto [row, subject] = settingOf(key);
    if (row == nullptr) {
        return QString::fromStdString(key);
    }
    const QString name = QCoreApplication::translate("parameters", std::string(row->label).c_str());
    return subject.empty() ? name : QStringLiteral("%1, %2").arg(name, QString::fromStdString(subject));
}

QString spokenValue(const std::string& key, const std::string& value) {
    const Parameter* row = settingOf(key).first;
    if (row != nullptr && row->kind == ParameterKind::Switch && (value == "true" || value == "false")) {
        return value == "true" ? QCoreApplication::translate("rubble", "on") : QCoreApplication::translate("rubble", "off");
    }
    if (row != nullptr && row->kind == ParameterKind::Choice) {
        std::string words = value;
        std::replace(words.begin(), words.end(), '_', ' ');
        return QCoreApplication::translate("choices", words.c_str());
    }
    return QString::fromStdString(value);
}

QString spokenText(const std::string& english) {
    return spokenTextIn(english, inSpokenLanguage);
}

QString spokenTextIn(const std::string& english, const SaidIn& say) {
    const QString text = QString::fromStdString(english);
    if (const QString whole = say("messages", text.toUtf8(), nullptr); whole != text || text.isEmpty()) {
        return whole;
    }
    if (const QString filled = filledText(text, say); filled != text) {
        return filled;
    }
    QString line;
    for (const QString& part : text.split(QStringLiteral("; "))) {
        const QString exact = say("messages", part.toUtf8(), nullptr);
        const QString words = exact != part ? exact : filledText(part, say);
        line = line.isNull() ? words : say("rubble", "%1; %2", "two parts of a line").arg(line, words);
    }
    return line;
}

}  // namespace rubble::figures
