// A panel that is being edited: the panel, its undo history and the signal that views follow. Owned by the designer's
// window (or a test); main thread.
#pragma once
#include "hmi/model/edit.h"

#include <QObject>
#include <QUndoStack>

namespace plc::hmi {

class PanelDocument final : public QObject {
    Q_OBJECT
public:
    explicit PanelDocument(const Panel& panel, QObject* parent = nullptr);

    const Panel& panel() const { return m_panel; }
    QUndoStack& undoStack() { return m_undo; }
    /// Performs an edit as one undo step, with what rows and grids move after it. Steps in a row with the same gesture
    /// (above 0) become one.
    void perform(const QString& title, const Edit& edit, int gesture = 0);
    int newGesture() { return ++m_lastGesture; }
    /// Undoes a gesture that is the last step, as if it had never been: the file is unchanged, nothing can be redone.
    void takeBack(int gesture);
    /// Replaces everything, for a file that changed on disk; the undo history is dropped.
    void reset(const Panel& panel);
    bool isClean() const { return m_undo.isClean(); }
    void setClean() { m_undo.setClean(); }

signals:
    void changed(const plc::hmi::Touched& touched);

private:
    friend class EditCommand;
    Edit apply(const Edit& edit);

    Panel m_panel;
    QUndoStack m_undo;
    int m_lastGesture = 0;
    int m_takenBack = 0; // the gesture that is being taken back
};

} // namespace plc::hmi
