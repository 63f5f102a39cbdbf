#include "editor/kit/inputs/choice_box.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QMouseEvent>
#include <QScrollBar>
#include <QTimer>

namespace plc::kit {

ChoiceBox::ChoiceBox(QWidget* parent) : QComboBox(parent) {
    setFrame(false);
    setMaxVisibleItems(20);
}

void ChoiceBox::open() {
    if (!(QApplication::mouseButtons() & Qt::LeftButton)) return showPopup();
    // The release of the click that made this box comes to the list, which a release closes unless the box saw the
    // press.
    const QPoint at = QCursor::pos();
    QMouseEvent press(QEvent::MouseButtonPress, mapFromGlobal(at), at, Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(this, &press);
}

void ChoiceBox::showPopup() {
    view()->setMinimumWidth(view()->sizeHintForColumn(0) + 2 * view()->frameWidth() +
                            (count() > maxVisibleItems() ? view()->verticalScrollBar()->sizeHint().width() : 0));
    QComboBox::showPopup();
}

void ChoiceBox::hidePopup() {
    const bool wasShown = view()->isVisible();
    QComboBox::hidePopup();
    if (wasShown) QTimer::singleShot(0, this, &ChoiceBox::closed);
}

} // namespace plc::kit
