#pragma once

#include <QDateTime>
#include <QImage>
#include <QString>
#include <vector>

namespace rubble {

/// A case or result that was opened before.
struct RecentCase {
    QString path;
    QString name;
    QDateTime when;
    bool missing = false;  ///< there is nothing at its place now
};

/// The cases that were opened last, in the settings of the user, with small pictures in the state folder.
class RecentCases {
public:
    static constexpr std::size_t most = 8;
    /// @param folder  for the pictures; empty: none are kept
    explicit RecentCases(const QString& folder) : m_folder(folder) {}

    /// Newest first. Entries that make no sense are left out.
    std::vector<RecentCase> list() const;
    void add(const QString& path, const QString& name);
    void forget(const QString& path);
    /// It lies elsewhere now.
    void move(const QString& from, const QString& to);
    void setPicture(const QString& path, const QImage& picture);
    QImage picture(const QString& path) const;

private:
    static void store(const std::vector<RecentCase>& cases);
    QString pictureFile(const QString& path) const;

    QString m_folder;
};

}  // namespace rubble
