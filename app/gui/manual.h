#pragma once

#include <QDialog>
#include <QString>
#include <vector>

class QListWidget;
class QTextBrowser;

namespace rubble {

/// A page of the manual, in Markdown.
struct ManualPage {
    QString title;
    QString text;
};

/// The pages that are written by hand, then the reference of all parameters and of all actions, made from their tables.
std::vector<ManualPage> manualPages();
/// All rows of the parameter table as Markdown.
QString parameterReference();

/// The manual in a window of its own (F1).
class ManualWindow : public QDialog {
    Q_OBJECT

public:
    explicit ManualWindow(QWidget* parent = nullptr);
    /// Shows the first page whose title contains a text.
    void showPage(const QString& title);

private:
    std::vector<ManualPage> m_pages;
    QListWidget* m_titles;
    QTextBrowser* m_text;
};

}  // namespace rubble
