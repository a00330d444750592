#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "core/evidence/photographs/camera_match.h"
#include "widgets/basics/wording.h"

class QLineEdit;
class QPushButton;
class QTableWidget;

namespace rubble::widgets {

class Notice;
class NumberField;

/// The point pairs of a photograph with their residuals; wrong ones are pointed out in words. Names and coordinates of the chosen
/// pair can be edited, pairs deleted (Delete).
class PhotoPairs : public QWidget {
    Q_OBJECT

public:
    explicit PhotoPairs(QWidget* parent = nullptr);

    /// @param match  null: no camera was found
    void setContent(const std::vector<PointPair>& pairs, const CameraMatch* match, int chosen);
    void setAdding(bool adding);

signals:
    /// @param what  names the edit for undo
    void pairsEdited(const std::vector<rubble::PointPair>& pairs, const rubble::widgets::Wording& what);
    void pairChosen(int pair);
    void addToggled(bool adding);
    void readRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showTable(const CameraMatch* match);
    void showWrong(const CameraMatch* match);
    void showFields();
    void removeChosen();
    void setNumber(std::size_t field, double value);

    std::vector<PointPair> m_pairs;
    int m_chosen = -1;
    bool m_showing = false;
    QTableWidget* m_table;
    Notice* m_notice;
    QPushButton* m_add;
    QPushButton* m_read;
    QPushButton* m_remove;
    QWidget* m_fields;
    QLineEdit* m_name;
    std::array<NumberField*, 5> m_numbers{};  // picture x, y; model x, y, z
};

}  // namespace rubble::widgets
