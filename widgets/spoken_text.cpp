#include "widgets/spoken_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <array>

#include "widgets/language.h"

namespace rubble::widgets {

namespace {

/// Places and reasons that core makes into texts before they become part of a message.
constexpr std::array madeTexts = {QT_TRANSLATE_NOOP("messages", "element {0} ({1}) at state {2}"),
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
                                  QT_TRANSLATE_NOOP("messages", "density {0} of \"{1}\" is {2}, {3}"),
                                  QT_TRANSLATE_NOOP("messages", "solid"),
                                  QT_TRANSLATE_NOOP("messages", "shell"),
                                  QT_TRANSLATE_NOOP("messages", "beam"),
                                  QT_TRANSLATE_NOOP("messages", "mixed")};

/// What a made text says, if it is one: its values go from the English pattern into the one of the window.
QString filledText(const QString& english) {
    static const QRegularExpression place(QStringLiteral("\\\\\\{(\\d)\\\\\\}"));
    for (const char* made : madeTexts) {
        QString form = QRegularExpression::escape(QString::fromUtf8(made));
        form.replace(place, QStringLiteral("(?<v\\1>.+?)"));
        const QRegularExpressionMatch match = QRegularExpression(u'^' + form + u'$').match(english);
        if (!match.hasMatch()) {
            continue;
        }
        QString text = said("messages", made);
        for (int i = 0; i < 4; ++i) {
            const QString value = match.captured(QStringLiteral("v%1").arg(i));
            text.replace(QStringLiteral("{%1}").arg(i), value.isEmpty() ? value : spokenText(value.toStdString()));
        }
        return text;
    }
    return english;
}

}  // namespace

QString spokenText(const std::string& english) {
    const QString text = QString::fromStdString(english);
    if (const QString whole = said("messages", english); whole != text || text.isEmpty()) {
        return whole;
    }
    QStringList parts;
    for (const QString& part : text.split(QStringLiteral("; "))) {
        const QString exact = said("messages", part.toStdString());
        parts << (exact != part ? exact : filledText(part));
    }
    return parts.join(QStringLiteral("; "));
}

}  // namespace rubble::widgets
