#pragma once

#include <QAbstractButton>
#include <QImage>

namespace rubble::widgets {

/// A case that can be opened: a small picture, its name, and a line or two about it. A button by mouse and keyboard.
class CaseCard : public QAbstractButton {
    Q_OBJECT

public:
    enum class Form : std::uint8_t {
        Tall,  ///< picture above the words
        Wide   ///< picture beside the words, one row of a list
    };
    /// @param aside  at the right of the name: when it was opened
    struct Content {
        QString name;
        QString words;
        QString aside;
        QImage picture;
        bool missing = false;  ///< it is not there any more: grey, and said so
    };

    CaseCard(Form form, const Content& content, QWidget* parent = nullptr);
    const Content& content() const { return m_content; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRect pictureRect() const;
    void paintPicture(QPainter& painter, const QRect& at) const;
    void paintWords(QPainter& painter, const QRect& at) const;

    Form m_form;
    Content m_content;
};

}  // namespace rubble::widgets
