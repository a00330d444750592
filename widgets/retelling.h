#pragma once

#include <QHash>
#include <QList>
#include <QRegularExpression>
#include <vector>

#include "widgets/language.h"

class QAbstractItemModel;
class QAction;
class QObject;
class QWidget;

namespace rubble::widgets {

/// Says what stands on screen again in another language: every text of a widget that was said in the first language, also with
/// values put into it and inside rich text, is said in the second. Texts of the user, numbers and names are left alone.
class Retelling {
public:
    Retelling(const Catalogue& from, const Catalogue& to);

    /// All widgets and actions of a window, and its models of table headers and choices.
    void apply(QWidget& window) const;
    /// One text. @param contexts  those it may have been said in, likeliest first; others are tried after them
    QString retold(const QString& text, const QByteArrayList& contexts) const;

private:
    struct Words {
        QByteArray context;
        QString to;
    };
    /// A text with places for values.
    struct Pattern {
        QByteArray context;
        QString longest;  ///< its longest piece between two values: what a text must hold to be tried
        int weight;       ///< how much it says besides its values
        QRegularExpression form;
        std::vector<int> places;  ///< which value each capture is
        QString to;
    };

    void learn(const SourceText& source, const QString& from, const QString& to);
    QString whole(const QString& text, const QByteArrayList& contexts) const;
    QString filled(const QString& text, const QByteArrayList& contexts) const;
    /// A text that is in the catalogue, as it stands or with values; nothing otherwise.
    QString known(const QString& text, const QByteArrayList& contexts) const;
    QString piece(const QString& text, const QByteArrayList& contexts) const;
    QString byParts(const QString& text, const QRegularExpression& joint, const QByteArrayList& contexts) const;
    void applyTo(QObject& object) const;
    void applyTo(QAction& action, const QByteArrayList& contexts) const;
    void applyTo(QAbstractItemModel& model, const QByteArrayList& contexts) const;

    QHash<QString, QList<Words>> m_words;
    std::vector<Pattern> m_patterns;
};

}  // namespace rubble::widgets
