#include "widgets/basics/place_choice.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStandardItemModel>
#include <QVBoxLayout>

namespace rubble::widgets {

namespace {

constexpr int clusterItem = 1;

QString placeTip() {
    return PlaceChoice::tr(
        "Who simulates: this machine, or a Slurm cluster that shares the cache folder with it, with one task for each world");
}

}  // namespace

PlaceChoice::PlaceChoice(QWidget* parent)
    : QWidget(parent), m_place(new QComboBox), m_options(new QLineEdit), m_why(new QLabel), m_notReached(tr("Asking Slurm…")) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(tr("Run on"));
    label->setBuddy(m_place);
    row->addWidget(label);
    m_place->setObjectName(QStringLiteral("place"));
    m_place->addItems({tr("this machine"), tr("Slurm cluster")});
    m_place->setAccessibleName(tr("Run on"));
    row->addWidget(m_place, 1);
    column->addLayout(row);
    m_options->setObjectName(QStringLiteral("sbatch"));
    m_options->setPlaceholderText(QStringLiteral("--partition=long --account=bridges"));
    m_options->setAccessibleName(tr("Options of sbatch"));
    m_options->setToolTip(tr("More options for sbatch, separated by spaces. Time and memory are asked for by themselves"));
    column->addWidget(m_options);
    m_why->setObjectName(QStringLiteral("muted"));
    m_why->setWordWrap(true);
    column->addWidget(m_why);
    connect(m_place, &QComboBox::currentIndexChanged, this, [this] {
        showChoice();
        emit chosen();
    });
    showChoice();
}

bool PlaceChoice::onCluster() const {
    return m_place->currentIndex() == clusterItem;
}

void PlaceChoice::setOnCluster(bool onCluster) {
    m_place->setCurrentIndex(onCluster ? clusterItem : 0);
}

std::vector<std::string> PlaceChoice::sbatchOptions() const {
    std::vector<std::string> words;
    for (const QString& word : m_options->text().split(u' ', Qt::SkipEmptyParts)) {
        words.push_back(word.toStdString());
    }
    return words;
}

void PlaceChoice::setReached(const QString& why, const QString& remedy) {
    m_notReached = remedy.isEmpty() ? why : why + QLatin1Char(' ') + remedy;
    showChoice();
}

void PlaceChoice::showChoice() {
    const bool reached = m_notReached.isEmpty();
    // What keeps the cluster from being chosen stands with it, not beside a choice that works.
    QStandardItem* cluster = qobject_cast<QStandardItemModel*>(m_place->model())->item(clusterItem);
    cluster->setEnabled(reached);
    cluster->setText(reached ? tr("Slurm cluster") : tr("Slurm cluster (not reached)"));
    cluster->setToolTip(m_notReached);
    m_place->setToolTip(placeTip() + (reached ? QString() : u'\n' + tr("Slurm cluster: %1").arg(m_notReached)));
    m_options->setVisible(onCluster());
    m_why->setText(!onCluster() ? QString()
                   : reached    ? tr("The window may be closed meanwhile: the worlds go on, and the case finds them again.")
                                : tr("Slurm cluster: %1").arg(m_notReached));
    m_why->setVisible(!m_why->text().isEmpty());
}

void PlaceChoice::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    emit shown();
}

}  // namespace rubble::widgets
