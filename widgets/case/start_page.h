#pragma once

#include <QImage>
#include <QScrollArea>
#include <vector>

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace rubble::widgets {

class Notice;

/// A case on the start page.
struct StartCase {
    QString path;
    QString name;
    QString words;  ///< where it lies, or what it shows
    QString when;   ///< it was last opened
    QImage picture;
    bool missing = false;
    friend bool operator==(const StartCase&, const StartCase&) = default;
};

/// What stands in the centre while nothing is open: what can be opened with one click, and how to find one's way.
class StartPage : public QScrollArea {
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);

    void setRecent(const std::vector<StartCase>& cases);
    void setSamples(const std::vector<StartCase>& cases);
    /// An error in place; an empty text removes it.
    void setError(const QString& what, const QString& remedy = {});
    /// "Opening ..." while a file is read.
    void setActivity(const QString& what);

signals:
    void openRequested();
    /// A case is to be made from an FE result.
    void newRequested();
    void tourRequested();
    void recentChosen(const QString& path);
    void sampleChosen(const QString& path);
    /// The user knows where a recent case lies now.
    void locateRequested(const QString& path);
    void forgetRequested(const QString& path);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* recentRow(const StartCase& which);
    void placeSamples();

    QLabel* m_activity;
    Notice* m_error;
    QLabel* m_recentHeading;
    QVBoxLayout* m_recent;
    QGridLayout* m_samples;
    std::vector<QWidget*> m_cards;
    std::vector<QWidget*> m_rows;
    int m_columns = 0;
};

}  // namespace rubble::widgets
