#pragma once

#include <QDateTime>
#include <QDialog>
#include <vector>

class QLabel;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace rubble::widgets {

/// A kept run of whatever case.
struct KeptRunLine {
    QString path;
    QString casePath;  ///< empty: not known
    QString scenario;
    QString state;  ///< what came of it
    QDateTime when;
    qint64 bytes = 0;
    bool shown = false;  ///< in the views, or beside them
    bool busy = false;   ///< another program writes it
    friend bool operator==(const KeptRunLine&, const KeptRunLine&) = default;
};

/// The kept runs of all cases: what they are, how much room they take and may take. Enter opens one, Delete removes those that are
/// selected; Ctrl+Z brings them back as long as the dialog is open.
class KeptRunsDialog : public QDialog {
    Q_OBJECT

public:
    explicit KeptRunsDialog(QWidget* parent);

    /// @param capGib  room for the runs of each case, GiB; 0: none are kept
    void setContent(std::vector<KeptRunLine> lines, int capGib);
    /// How many runs Undo would bring back.
    void setUndo(int runs);

signals:
    void openRequested(const QString& path);
    /// The user has agreed to it.
    void removeRequested(const QStringList& paths);
    void undoRequested();

private:
    void buildButtons(QVBoxLayout& column);
    void fill();
    void say();
    void choose();
    void openChosen();
    void remove();
    std::vector<const KeptRunLine*> chosen() const;

    std::vector<KeptRunLine> m_lines;
    int m_capGib = 0;
    QLabel* m_total;
    QTableWidget* m_table;
    QLabel* m_details;
    QPushButton* m_open;
    QPushButton* m_remove;
    QPushButton* m_undo;
};

}  // namespace rubble::widgets
