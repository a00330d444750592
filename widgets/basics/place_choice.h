#pragma once

#include <QWidget>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;

namespace rubble::widgets {

/// Where the worlds of a study are simulated: on this machine or on a Slurm cluster.
class PlaceChoice : public QWidget {
    Q_OBJECT

public:
    explicit PlaceChoice(QWidget* parent = nullptr);

    bool onCluster() const;
    void setOnCluster(bool onCluster);
    /// Words for sbatch, as typed.
    std::vector<std::string> sbatchOptions() const;
    /// @param why  the cluster cannot be chosen; empty: it can
    void setReached(const QString& why, const QString& remedy = {});

signals:
    /// Somebody chose where.
    void chosen();
    /// It came into sight: whether the cluster answers should be found out.
    void shown();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void showChoice();

    QComboBox* m_place;
    QLineEdit* m_options;
    QLabel* m_why;
    QString m_notReached;
};

}  // namespace rubble::widgets
