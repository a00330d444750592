#include "widgets/basics/language.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QMutex>
#include <QSet>

namespace rubble::widgets {

namespace {

const char* const english = "en";

/// Texts are asked for by workers too.
struct Memory {
    QMutex mutex;
    QSet<SourceText> seen;
    QList<SourceText> inOrder;
};

Memory& memory() {
    static Memory texts;
    return texts;
}

/// What is installed in the application now.
struct Spoken {
    Catalogue* own = nullptr;
    QTranslator* qt = nullptr;
};

Spoken& installed() {
    static Spoken spoken;
    return spoken;
}

}  // namespace

size_t qHash(const SourceText& text, size_t seed) {
    return qHashMulti(seed, text.context, text.text, text.comment);
}

Catalogue::Catalogue(const QString& language, QObject* parent) : QTranslator(parent), m_language(language) {
    if (language != QLatin1String(english) && !load(QStringLiteral(":/translations/rubble_%1.qm").arg(language))) {
        qWarning("no catalogue for the language %s", qPrintable(language));
    }
}

QString Catalogue::translate(const char* context, const char* source, const char* comment, int n) const {
    if (context != nullptr && source != nullptr) {
        SourceText text{context, source, comment};
        Memory& texts = memory();
        const QMutexLocker lock(&texts.mutex);
        if (!texts.seen.contains(text)) {
            texts.seen.insert(text);
            texts.inOrder << std::move(text);
        }
    }
    return QTranslator::translate(context, source, comment, n);
}

QList<SourceText> Catalogue::spoken() {
    Memory& texts = memory();
    const QMutexLocker lock(&texts.mutex);
    return texts.inOrder;
}

QStringList languageCodes() {
    return {QLatin1String(english), QStringLiteral("zh_CN")};
}

QString languageName(const QString& code) {
    return code == QLatin1String("zh_CN") ? QStringLiteral("简体中文") : QStringLiteral("English");
}

QString systemLanguage() {
    for (const QString& wanted : QLocale::system().uiLanguages()) {
        const QLocale locale(wanted);
        if (locale.language() == QLocale::English) {
            return QLatin1String(english);
        }
        // Of the two scripts of Chinese, the catalogue is in the simplified one.
        if (locale.language() == QLocale::Chinese && locale.script() == QLocale::SimplifiedHanScript) {
            return QStringLiteral("zh_CN");
        }
    }
    return QLatin1String(english);
}

QString currentLanguage() {
    return installed().own != nullptr ? installed().own->language() : QString::fromLatin1(english);
}

void speak(const QString& language) {
    const QString wanted = language == QLatin1String("system") ? systemLanguage() : language;
    const QString code = languageCodes().contains(wanted) ? wanted : QString::fromLatin1(english);
    Spoken& now = installed();
    if (now.own != nullptr && now.own->language() == code) {
        return;
    }
    const Spoken before = now;
    now = {new Catalogue(code, qApp), new QTranslator(qApp)};
    // Words and numbers go together: English words with English numbers, whatever the system counts in.
    QLocale::setDefault(code == QLatin1String(english) ? QLocale(QLocale::English) : QLocale(code));
    if (before.own != nullptr) {
        QCoreApplication::removeTranslator(before.own);
        QCoreApplication::removeTranslator(before.qt);
    }
    if (code != QLatin1String(english) &&
        now.qt->load(QStringLiteral("qtbase_%1").arg(code), QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
        QCoreApplication::installTranslator(now.qt);
    }
    QCoreApplication::installTranslator(now.own);
    delete before.own;
    delete before.qt;
}

QString said(const char* context, std::string_view english) {
    const QByteArray text(english.data(), static_cast<qsizetype>(english.size()));
    return QCoreApplication::translate(context, text.constData());
}

}  // namespace rubble::widgets
