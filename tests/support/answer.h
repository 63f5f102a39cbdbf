// Answers the dialog or menu that opens next. It runs an event loop of its own, so the answer is given before it is
// opened, and looked for until it is there: on a busy machine a check of the project may come first. GUI thread.
#pragma once
#include "tests/support/patience.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QTimer>

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace plc {

/// Calls `use` with what `find` finds, once, as soon as it finds something, in whatever event loop runs then. Until
/// then, at most as long as `context` lives. What is still in front after kPatience is not what the test expects: it is
/// closed, so that the test goes on and says so.
template <class Find, class Use> void asSoonAs(QObject* context, Find find, Use use) {
    auto* look = new QTimer(context);
    QElapsedTimer since;
    since.start();
    QObject::connect(look, &QTimer::timeout, look, [look, since, find, use] {
        auto* found = find();
        if (!found && since.elapsed() < kPatience) return;
        look->stop();
        look->deleteLater();
        if (found) return Use(use)(*found);
        QWidget* front = QApplication::activePopupWidget();
        if (!front) front = QApplication::activeModalWidget();
        if (!front) return; // nothing was asked
        ADD_FAILURE() << "something else is in front: " << front->metaObject()->className() << " "
                      << front->windowTitle().toStdString();
        front->close();
    });
    look->start(10);
}

/// The dialog that waits for an answer when it is a `Dialog`, else null.
template <class Dialog> Dialog* dialogInFront() {
    auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
    return dialog && dialog->isVisible() ? dialog : nullptr;
}
/// The menu that is open, else null.
inline QMenu* openMenu() {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    return menu && menu->isVisible() ? menu : nullptr;
}

/// `use` gets the next dialog of that class.
template <class Dialog, class Use> void inNext(QObject* context, Use use) {
    asSoonAs(context, &dialogInFront<Dialog>, std::move(use));
}
/// `use` gets the next menu.
template <class Use> void inNextMenu(QObject* context, Use use) { asSoonAs(context, &openMenu, std::move(use)); }

/// The next question is answered with the button of that text, or cancelled when it has none.
inline void pressInNext(QObject* context, const QString& button) {
    inNext<QMessageBox>(context, [button](QMessageBox& box) {
        for (QAbstractButton* each : box.buttons())
            if (each->text().remove(u'&') == button) return each->click();
        box.reject();
    });
}
/// The next question is answered with that button, or cancelled when it has none. True once it has been asked.
inline std::shared_ptr<bool> pressInNext(QObject* context, QMessageBox::StandardButton button) {
    auto wasAsked = std::make_shared<bool>(false);
    inNext<QMessageBox>(context, [button, wasAsked](QMessageBox& box) {
        *wasAsked = true;
        if (QAbstractButton* found = box.button(button)) return found->click();
        box.reject();
    });
    return wasAsked;
}
/// The next dialog with a line for a text gets that text, and is accepted.
inline void typeIntoNext(QObject* context, const QString& text) {
    const auto line = []() -> QLineEdit* {
        const auto* dialog = dialogInFront<QDialog>();
        return dialog ? dialog->findChild<QLineEdit*>() : nullptr;
    };
    asSoonAs(context, line, [text](QLineEdit& found) {
        found.setText(text);
        static_cast<QDialog*>(found.window())->accept();
    });
}

} // namespace plc
