#include "widgets/evidence/evidence_page.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/basics/folding_bar.h"
#include "widgets/basics/theme.h"
#include "widgets/evidence/survey_view.h"
#include "widgets/views/view_widget.h"

namespace rubble::widgets {

namespace {

constexpr int steps = 100;

}  // namespace

EvidencePage::EvidencePage(QWidget* parent)
    : QWidget(parent),
      m_photo(new PhotoView),
      m_model(new ViewWidget),
      m_marks(new ModelMarks(*m_model)),
      m_splitter(new QSplitter(Qt::Horizontal)),
      m_survey(new SurveyView),
      m_surveyShown(new QToolButton),
      m_shows(new QButtonGroup(this)),
      m_beside(new QToolButton),
      m_slider(new QSlider(Qt::Horizontal)),
      m_point(new QToolButton),
      m_mask(new QComboBox),
      m_draw(new QToolButton),
      m_hint(new QLabel) {
    setObjectName(QStringLiteral("panelBody"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(buildTools());
    m_hint->setObjectName(QStringLiteral("muted"));
    m_hint->setWordWrap(true);
    m_hint->setContentsMargins(12, 0, 12, 6);
    // Its room is kept: the photograph stays where it is while points are clicked.
    m_hint->setMinimumHeight(m_hint->fontMetrics().lineSpacing() + 6);
    QSizePolicy keepsRoom = m_hint->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_hint->setSizePolicy(keepsRoom);
    column->addWidget(m_hint);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(3);
    m_splitter->addWidget(m_photo);
    m_splitter->addWidget(m_model);
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setStretchFactor(1, 1);
    m_model->setAccessibleName(tr("Model beside the photograph"));
    m_model->hide();
    m_model->installEventFilter(this);
    column->addWidget(m_splitter, 1);
    column->addWidget(m_survey, 1);
    m_survey->hide();
    connect(m_photo, &PhotoView::swipeMoved, this, [this](double share) {
        const QSignalBlocker blocker(m_slider);
        m_slider->setValue(static_cast<int>(std::lround(share * steps)));
    });
    connect(m_marks, &ModelMarks::picked, this, &EvidencePage::modelClicked);
    connect(m_photo, &PhotoView::toolLeft, this, [this] { setTool(PhotoView::Tool::Look); });
    setShow(PhotoView::Show::Photograph);
    setReady(false);
}

QWidget* EvidencePage::buildTools() {
    auto* bar = new FoldingBar;
    QHBoxLayout* row = bar->add();
    const std::array<std::pair<QString, QString>, 5> shows{
        {{tr("Photograph"), tr("The photograph alone (Ctrl+1)")},
         {tr("Swipe"), tr("Photograph left of a line, simulation right of it: drag the line (Ctrl+2)")},
         {tr("Blend"), tr("The simulation over the photograph, as strong as the slider says (Ctrl+3)")},
         {tr("Blink"), tr("Photograph and simulation in turn (Ctrl+4)")},
         {tr("Outline"), tr("The outline of the simulated debris on the photograph (Ctrl+5)")}}};
    const auto add = [&row](QToolButton* button, const QString& text, const QString& tip) {
        button->setText(text);
        button->setToolTip(tip);
        button->setAccessibleName(text);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    };
    for (std::size_t i = 0; i < shows.size(); ++i) {
        auto* button = new QToolButton;
        add(button, shows[i].first, shows[i].second);
        m_shows->addButton(button, static_cast<int>(i));
    }
    add(m_beside, tr("Beside"), tr("The model beside the photograph (Ctrl+6)"));
    m_slider->setRange(0, steps);
    m_slider->setValue(steps / 2);
    m_slider->setFixedWidth(90);
    m_slider->setAccessibleName(tr("Share of the simulation"));
    row->addWidget(m_slider);
    row->addStretch();
    row = bar->add();
    add(m_point, tr("Add point"), tr("Click a point in the photograph, then the same point in the model (Shift+A)"));
    for (const MaskClass kind : maskClasses) {
        m_mask->addItem(maskWords(kind), static_cast<int>(kind));
    }
    m_mask->setAccessibleName(tr("What is drawn"));
    m_mask->setToolTip(
        tr("What the outline that is drawn encloses: debris, what rescuers moved, what is hidden, what is no debris"));
    m_mask->setFocusPolicy(Qt::TabFocus);
    add(m_draw, tr("Draw"), tr("Draw around it: click the corners, double-click or Enter closes, Backspace takes one back"));
    // In a narrow window it gives way first: what is chosen stands in its list.
    m_mask->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_mask->setMinimumContentsLength(9);
    row->addWidget(m_mask);
    row->addStretch();
    add(m_surveyShown, tr("Survey"), tr("The difference map of the survey instead of the photograph"));
    connect(m_surveyShown, &QToolButton::clicked, this, &EvidencePage::showSurvey);
    connect(m_shows, &QButtonGroup::idClicked, this, [this](int id) { setShow(static_cast<PhotoView::Show>(id)); });
    connect(m_beside, &QToolButton::clicked, this, &EvidencePage::setBeside);
    connect(m_slider, &QSlider::valueChanged, this, [this](int value) {
        const double share = static_cast<double>(value) / steps;
        m_photo->show() == PhotoView::Show::Swipe ? m_photo->setSwipe(share) : m_photo->setBlend(share);
    });
    connect(m_point, &QToolButton::clicked, this,
            [this](bool on) { setTool(on ? PhotoView::Tool::Point : PhotoView::Tool::Look); });
    const auto draw = [this] { setTool(PhotoView::Tool::Mask, static_cast<MaskClass>(m_mask->currentData().toInt())); };
    connect(m_draw, &QToolButton::clicked, this, [this, draw](bool on) { on ? draw() : setTool(PhotoView::Tool::Look); });
    connect(m_mask, &QComboBox::activated, this, draw);
    return bar;
}

void EvidencePage::setSurvey(const std::shared_ptr<const SurveyComparison>& comparison) {
    m_survey->setComparison(comparison);
}

void EvidencePage::showSurvey(bool shown) {
    m_surveyShown->setChecked(shown);
    m_survey->setVisible(shown);
    m_splitter->setVisible(!shown);
    m_hint->setVisible(!shown && !m_hint->text().isEmpty());
}

void EvidencePage::setShow(PhotoView::Show show) {
    showSurvey(false);
    m_shows->button(static_cast<int>(show))->setChecked(true);
    m_photo->setShow(show);
    const bool slides = show == PhotoView::Show::Swipe || show == PhotoView::Show::Blend;
    m_slider->setVisible(slides);
    if (slides) {
        const QSignalBlocker blocker(m_slider);
        m_slider->setValue(static_cast<int>(std::lround((show == PhotoView::Show::Swipe ? m_photo->swipe() : 0.5) * steps)));
        m_slider->setToolTip(show == PhotoView::Show::Swipe ? tr("Where the line stands, 0 to 100 %")
                                                            : tr("How strong the simulation is, 0 to 100 %"));
        if (show == PhotoView::Show::Blend) {
            m_photo->setBlend(0.5);
        }
    }
    showHint();
    emit showChanged(show);
}

bool EvidencePage::surveyShown() const {
    return m_surveyShown->isChecked();
}

void EvidencePage::setBeside(bool beside) {
    showSurvey(false);
    m_beside->setChecked(beside);
    if (beside && m_model->isHidden()) {
        m_model->show();
        const int half = std::max(1, m_splitter->width() / 2);
        m_splitter->setSizes({half, half});
    }
    m_model->setVisible(beside);
    emit besideChanged(beside);
}

bool EvidencePage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_model && !event->spontaneous() && (event->type() == QEvent::Show || event->type() == QEvent::Hide)) {
        emit modelSeen(event->type() == QEvent::Show);
    }
    return QWidget::eventFilter(watched, event);
}

bool EvidencePage::beside() const {
    return m_beside->isChecked();
}

void EvidencePage::setReady(bool ready) {
    for (QWidget* widget : std::initializer_list<QWidget*>{m_point, m_mask, m_draw}) {
        widget->setEnabled(ready);
    }
}

void EvidencePage::setSeen(bool seen, const QString& why) {
    for (QAbstractButton* button : m_shows->buttons()) {
        const int id = m_shows->id(button);
        button->setEnabled(seen || id == static_cast<int>(PhotoView::Show::Photograph));
    }
    m_whyNotSeen = seen ? QString() : why;
    if (!seen && m_photo->show() != PhotoView::Show::Photograph) {
        setShow(PhotoView::Show::Photograph);
    }
    showHint();
}

void EvidencePage::setTool(PhotoView::Tool tool, MaskClass kind) {
    m_photo->setTool(tool, kind);
    m_marks->setPicking(tool == PhotoView::Tool::Point);
    m_point->setChecked(tool == PhotoView::Tool::Point);
    m_draw->setChecked(tool == PhotoView::Tool::Mask);
    if (tool == PhotoView::Tool::Mask) {
        m_mask->setCurrentIndex(m_mask->findData(static_cast<int>(kind)));
    }
    if (tool != PhotoView::Tool::Look) {
        showSurvey(false);
    }
    if (tool == PhotoView::Tool::Point && !beside()) {
        setBeside(true);
    }
    m_photo->setFocus();
    emit toolChanged(tool);
}

void EvidencePage::setHint(const QString& hint) {
    m_said = hint;
    showHint();
}

void EvidencePage::showHint() {
    const QString text = m_said.isEmpty() ? m_whyNotSeen : m_said;
    m_hint->setText(text);
    m_hint->setVisible(!text.isEmpty());
}

}  // namespace rubble::widgets
