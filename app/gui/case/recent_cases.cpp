#include "app/gui/case/recent_cases.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>

namespace rubble {

namespace {

constexpr QSize pictureSize(440, 248);
const QString group = QStringLiteral("recent");

}  // namespace

std::vector<RecentCase> RecentCases::list() const {
    std::vector<RecentCase> found;
    QSettings settings;
    const int count = std::min(settings.beginReadArray(group), static_cast<int>(most));
    for (int i = 0; i < count; ++i) {
        settings.setArrayIndex(i);
        RecentCase each;
        each.path = settings.value(QStringLiteral("path")).toString();
        each.name = settings.value(QStringLiteral("name")).toString();
        each.when = QDateTime::fromString(settings.value(QStringLiteral("when")).toString(), Qt::ISODate);
        if (!each.path.isEmpty() && QFileInfo(each.path).isAbsolute()) {
            if (each.name.isEmpty()) {
                each.name = QFileInfo(each.path).completeBaseName();
            }
            each.missing = !QFileInfo::exists(each.path);
            found.push_back(each);
        }
    }
    settings.endArray();
    return found;
}

void RecentCases::store(const std::vector<RecentCase>& cases) {
    QSettings settings;
    settings.remove(group);
    settings.beginWriteArray(group, static_cast<int>(cases.size()));
    for (int i = 0; i < static_cast<int>(cases.size()); ++i) {
        const RecentCase& each = cases[static_cast<std::size_t>(i)];
        settings.setArrayIndex(i);
        settings.setValue(QStringLiteral("path"), each.path);
        settings.setValue(QStringLiteral("name"), each.name);
        settings.setValue(QStringLiteral("when"), each.when.toString(Qt::ISODate));
    }
    settings.endArray();
}

void RecentCases::add(const QString& path, const QString& name) {
    std::vector<RecentCase> all = list();
    std::erase_if(all, [&](const RecentCase& each) { return each.path == path; });
    all.insert(all.begin(), {path, name, QDateTime::currentDateTimeUtc(), false});
    if (all.size() > most) {
        QFile::remove(pictureFile(all.back().path));
        all.pop_back();
    }
    store(all);
}

void RecentCases::forget(const QString& path) {
    std::vector<RecentCase> all = list();
    std::erase_if(all, [&](const RecentCase& each) { return each.path == path; });
    QFile::remove(pictureFile(path));
    store(all);
}

void RecentCases::move(const QString& from, const QString& to) {
    std::vector<RecentCase> all = list();
    std::erase_if(all, [&](const RecentCase& each) { return each.path == to; });
    for (RecentCase& each : all) {
        if (each.path == from) {
            each.path = to;
            QFile::rename(pictureFile(from), pictureFile(to));
        }
    }
    store(all);
}

QString RecentCases::pictureFile(const QString& path) const {
    const QByteArray key = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha256).toHex().left(16);
    return m_folder + u'/' + QString::fromLatin1(key) + QStringLiteral(".png");
}

void RecentCases::setPicture(const QString& path, const QImage& picture) {
    if (!m_folder.isEmpty() && !picture.isNull() && QDir().mkpath(m_folder)) {
        // A picture that cannot be kept is not missed.
        picture.scaled(pictureSize, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation).save(pictureFile(path), "PNG");
    }
}

QImage RecentCases::picture(const QString& path) const {
    return m_folder.isEmpty() ? QImage() : QImage(pictureFile(path));
}

}  // namespace rubble
