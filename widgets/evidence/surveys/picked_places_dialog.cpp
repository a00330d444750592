#include "widgets/evidence/surveys/picked_places_dialog.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "widgets/basics/theme.h"
#include "widgets/evidence/model_marks.h"
#include "widgets/views/view_widget.h"

namespace rubble::widgets {

namespace {

constexpr int rowsInSight = 5;

}  // namespace

PickedPlacesDialog::PickedPlacesDialog(const QString& title, const QString& model, QWidget* parent)
    : QDialog(parent),
      m_hint(new QLabel(this)),
      m_model(new ViewWidget(this)),
      m_marks(new ModelMarks(*m_model)),
      m_table(new QTableWidget(this)),
      m_undo(new QPushButton(tr("Undo"), this)),
      m_remove(new QPushButton(this)),
      m_clear(new QPushButton(tr("Remove all"), this)) {
    setWindowTitle(title);
    m_hint->setWordWrap(true);
    // Room for two lines, so that nothing moves with what it says.
    m_hint->setMinimumHeight(2 * m_hint->fontMetrics().lineSpacing());
    m_hint->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_model->setAccessibleName(model);
    m_model->setMinimumSize(240, 160);
    m_marks->setPicking(true);
    connect(m_marks, &ModelMarks::picked, this, [this](const QPointF& at) {
        if (const auto hit = m_model->hitAt(at)) {
            placePicked(hit->point);
        } else {
            m_said = tr("There is nothing of the model there: click on the structure, a fragment or the ground.");
            showMarks();
        }
    });
}

void PickedPlacesDialog::setModel(const render::SceneData& scene, render::View view) {
    m_model->setData(scene);
    view.legends = false;
    view.theme = currentTheme();
    m_model->setView(view);
    m_model->fit();
}

void PickedPlacesDialog::prepareTable(const QStringList& heads, const QString& name, const QString& tip) {
    m_table->setColumnCount(static_cast<int>(heads.size()));
    m_table->setHorizontalHeaderLabels(heads);
    m_table->setAccessibleName(name);
    m_table->setToolTip(tip);
    m_table->verticalHeader()->hide();
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    const int rowHeight = m_table->fontMetrics().height() + 7;
    m_table->verticalHeader()->setDefaultSectionSize(rowHeight);
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() + rowsInSight * rowHeight + 4);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, [this] { showMarks(); });
}

QBoxLayout* PickedPlacesDialog::changeButtons(const QString& undoTip, const QString& remove) {
    auto* row = new QHBoxLayout;
    m_undo->setToolTip(undoTip);
    m_remove->setText(remove);
    for (QPushButton* button : {m_undo, m_remove, m_clear}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    connect(m_undo, &QPushButton::clicked, this, [this] { undo(); });
    connect(m_remove, &QPushButton::clicked, this, [this] { removeChosen(); });
    connect(m_clear, &QPushButton::clicked, this, [this] { removeAll(); });
    return row;
}

QDialogButtonBox* PickedPlacesDialog::endButtons(const QString& take) {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    for (const auto which : {QDialogButtonBox::Ok, QDialogButtonBox::Cancel}) {
        buttons->button(which)->setAutoDefault(false);
        buttons->button(which)->setDefault(false);
    }
    buttons->button(QDialogButtonBox::Ok)->setText(take);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons->button(QDialogButtonBox::Cancel), &QPushButton::clicked, this, &QDialog::reject);
    return buttons;
}

void PickedPlacesDialog::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        leave();
    } else if (event->matches(QKeySequence::Undo)) {
        undo();
    } else if (event->matches(QKeySequence::Delete)) {
        removeChosen();
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        // Only a button that has the focus is pressed by it.
        if (auto* button = qobject_cast<QPushButton*>(focusWidget())) {
            button->click();
        }
    } else {
        QDialog::keyPressEvent(event);
    }
}

}  // namespace rubble::widgets
