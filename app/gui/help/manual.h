#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;
class QTextBrowser;
class QUrl;

namespace rubble {

/// A page of the manual, in Markdown.
struct ManualPage {
    QString title;
    QString text;
    QString name = {};          ///< its title in English, by which it is asked for
    QStringList headings = {};  ///< all its headings in English, in their order, which is the same in every language
    bool ownLanguage = true;    ///< false: there is no version in the language asked for, and this is the English one
    QString file = {};          ///< by which other pages link to it: "survey.md"; empty for pages made from tables
};

/// The headings of a page, as they stand.
QStringList headingsOf(const QString& text);

/// The pages that are written by hand, then the reference of all parameters and of all actions, made from their tables; in the
/// language that is spoken where there is a version in it, else in English.
std::vector<ManualPage> manualPages();
/// All rows of the parameter table as Markdown.
QString parameterReference();

/// A heading of a page, or a place where words were found.
struct ManualFind {
    int page = 0;
    QString heading;  ///< the last one before it; empty at the beginning of a page
    QString line;     ///< the words around it
};

/// Where all words stand in one line or under one heading, in the order of the pages; pages that have them in their title first.
std::vector<ManualFind> findInManual(const std::vector<ManualPage>& pages, const QString& words);

/// The manual in a window of its own (F1): pages at the left, a search over all of them.
class ManualWindow : public QDialog {
    Q_OBJECT

public:
    explicit ManualWindow(QWidget* parent = nullptr);
    /// Shows the first page whose title contains a text.
    void showPage(const QString& title);
    /// Shows a page at one of its headings, with words pointed at; the beginning of the page where there is no such heading.
    void showPlace(const QString& title, const QString& heading, const QString& words);
    /// The name of the page that is shown.
    QString page() const;
    /// Puts the cursor where words to find are typed.
    void beginSearch();
    /// The words that are pointed at, as they stand in the text; empty where there are none.
    QStringList pointedAt() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void search(const QString& words);
    void openFind(int row);
    void open(int page);
    void goToHeading(const QString& heading);
    /// Opens what a page links to: "survey.md", "command-line.md#worlds-made-elsewhere", "#materials".
    void follow(const QUrl& link);
    void pointAt(const QString& words, bool go);
    void loadPages();
    /// Links and marks take the colours of now; where somebody reads stays.
    void recolour();

    std::vector<ManualPage> m_pages;
    std::vector<ManualFind> m_finds;
    QLineEdit* m_search;
    QListWidget* m_titles;
    QListWidget* m_results;
    QLabel* m_found;
    QLabel* m_language;
    QTextBrowser* m_text;
};

}  // namespace rubble
