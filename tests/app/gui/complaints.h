#pragma once

#include <QMutex>
#include <QString>
#include <QStringList>
#include <cstdio>

namespace rubble {

/// What Qt complains of while one lives.
class Complaints {
public:
    Complaints() {
        list().clear();
        m_before = qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
            if (type != QtDebugMsg && type != QtInfoMsg) {
                const QMutexLocker lock(&mutex());
                list() << text;
                std::fprintf(stderr, "%s\n", qPrintable(text));
            }
        });
    }
    ~Complaints() { qInstallMessageHandler(m_before); }
    static QStringList all() {
        const QMutexLocker lock(&mutex());
        return list();
    }

private:
    static QStringList& list() {
        static QStringList complaints;
        return complaints;
    }
    static QMutex& mutex() {
        static QMutex mutex;
        return mutex;
    }
    QtMessageHandler m_before;
};

}  // namespace rubble
