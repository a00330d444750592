#include "widgets/evidence/figure_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

#include "widgets/basics/form_row.h"
#include "widgets/basics/panel.h"
#include "widgets/run/caution_words.h"

namespace rubble::widgets {

namespace {

constexpr QSize previewPixels(560, 350);
constexpr int restMs = 250;
constexpr int automaticHeight = 99;  // px, below the least that can be asked for

QSpinBox* spin(const char* name, int low, int high, int value, const QString& unit) {
    auto* box = new QSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setRange(low, high);
    box->setValue(value);
    box->setSuffix(unit);
    box->setGroupSeparatorShown(false);
    return box;
}

}  // namespace

FigureDialog::FigureDialog(const FigureChoice& choice, QWidget* parent)
    : QDialog(parent),
      m_preset(new QComboBox),
      m_width(spin("figureWidth", 100, 8000, choice.pixels.width(), tr(" px"))),
      m_height(spin("figureHeight", automaticHeight, 8000, std::max(automaticHeight, choice.pixels.height()), tr(" px"))),
      m_dpi(spin("figureDpi", 50, 1200, choice.dpi, tr(" dpi"))),
      m_selection(new QCheckBox(tr("Show what is selected"))),
      m_print(new QLabel),
      m_cautions(new Notice),
      m_preview(new QLabel) {
    setWindowTitle(tr("Figure for print"));
    setObjectName(QStringLiteral("figureDialog"));
    m_preset->setObjectName(QStringLiteral("figurePreset"));
    m_preset->addItem(tr("As the views are"), -1);
    m_preset->addItem(tr("FE against fragments"), static_cast<int>(figures::FigurePreset::Pairs));
    m_preset->addItem(tr("At the end"), static_cast<int>(figures::FigurePreset::End));
    m_preset->addItem(tr("In its surroundings"), static_cast<int>(figures::FigurePreset::Surroundings));
    m_preset->addItem(tr("Stages"), static_cast<int>(figures::FigurePreset::Stages));
    m_preset->setCurrentIndex(choice.preset ? m_preset->findData(static_cast<int>(*choice.preset)) : 0);
    auto* column = dialogColumn(*this);
    m_preview->setMinimumSize(previewPixels);
    // The picture follows the room that there is; it asks for none.
    m_preview->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    m_preview->installEventFilter(this);
    m_preview->setAlignment(Qt::AlignCenter);
    m_preview->setWordWrap(true);
    m_preview->setAccessibleName(tr("Preview of the figure"));
    m_preview->setText(tr("Drawing the preview …"));
    column->addWidget(m_preview, 1);
    auto* form = dialogForm();
    addRow(*form, tr("Arrangement"), m_preset,
           tr("The panes as they are, or the arrangement of a figure of the published method with its instants"));
    addRow(*form, tr("Width"), m_width, tr("Pixels from left to right, 100 to 8000"));
    addRow(*form, tr("Height"), m_height,
           tr("Pixels from top to bottom, 100 to 8000; below that as high as what the pictures show needs"));
    addRow(*form, tr("Resolution"), m_dpi, tr("Pixels per inch in print, 50 to 1200: text is 9 pt high whatever the size"));
    m_height->setSpecialValueText(tr("as the pictures need"));
    m_selection->setObjectName(QStringLiteral("figureSelection"));
    m_selection->setToolTip(tr("Selected elements in their colour; without it the figure is as if nothing were selected"));
    m_selection->setChecked(choice.selection);
    form->addRow(QString(), m_selection);
    column->addLayout(form);
    m_print->setObjectName(QStringLiteral("muted"));
    column->addWidget(m_print);
    column->addWidget(m_cautions);
    setCautions({});
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    auto* save = buttons->addButton(tr("Save figure…"), QDialogButtonBox::AcceptRole);
    save->setObjectName(QStringLiteral("primary"));
    save->setToolTip(tr("Write it as PNG, or as SVG or PDF with text and lines as vectors"));
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMs);
    connect(&m_rest, &QTimer::timeout, this, [this] { emit previewRequested(this->choice()); });
    const auto changed = [this] {
        showSize();
        m_rest.start();
    };
    // A size that nobody chose is that of the arrangement.
    connect(m_preset, &QComboBox::currentIndexChanged, this, [this, before = choice.preset]() mutable {
        const FigureChoice now = this->choice();
        if (now.pixels == figures::usualSize(before)) {
            m_height->setValue(figures::usualSize(now.preset).height());
        }
        before = now.preset;
    });
    connect(m_preset, &QComboBox::currentIndexChanged, this, changed);
    for (QSpinBox* box : {m_width, m_height, m_dpi}) {
        connect(box, &QSpinBox::valueChanged, this, changed);
    }
    connect(m_selection, &QCheckBox::toggled, this, changed);
    showSize();
}

void FigureDialog::setCautions(const QString& cautions) {
    showCautions(*m_cautions, cautions);
}

FigureChoice FigureDialog::choice() const {
    FigureChoice choice;
    if (const int preset = m_preset->currentData().toInt(); preset >= 0) {
        choice.preset = static_cast<figures::FigurePreset>(preset);
    }
    choice.pixels = {m_width->value(), m_height->value() > automaticHeight ? m_height->value() : 0};
    choice.dpi = m_dpi->value();
    choice.selection = m_selection->isChecked();
    return choice;
}

void FigureDialog::setPreview(const QImage& picture, const QString& problem) {
    m_picture = picture;
    if (picture.isNull()) {
        m_preview->setPixmap({});
        m_preview->setText(problem);
        return;
    }
    fitPreview();
}

void FigureDialog::fitPreview() {
    if (m_picture.isNull() || m_preview->width() < 1 || m_preview->height() < 1) {
        return;
    }
    const double ratio = devicePixelRatioF();
    QImage fitted = m_picture.scaled((QSizeF(m_preview->size()) * ratio).toSize(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
    fitted.setDevicePixelRatio(ratio);
    m_preview->setPixmap(QPixmap::fromImage(fitted));
}

bool FigureDialog::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_preview && event->type() == QEvent::Resize) {
        fitPreview();
    }
    return QDialog::eventFilter(watched, event);
}

void FigureDialog::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    m_rest.start();
}

void FigureDialog::showSize() {
    const auto millimetres = [this](int pixels) { return QLocale().toString(25.4 * pixels / m_dpi->value(), 'f', 0); };
    m_print->setText(m_height->value() > automaticHeight
                         ? tr("In print %1 × %2 mm").arg(millimetres(m_width->value()), millimetres(m_height->value()))
                         : tr("In print %1 mm wide").arg(millimetres(m_width->value())));
}

}  // namespace rubble::widgets
