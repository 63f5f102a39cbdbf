// Undo of edits that are data: an edit applied gives its inverse. One generic command for every model.
// The stack is the window's; the model that `apply` changes must outlive the commands. GUI thread.
#pragma once

#include <QUndoCommand>
#include <QUndoStack>

#include <functional>
#include <optional>
#include <utility>

namespace plc::kit {

/// `Apply` performs an edit and returns the edit that takes it back.
template <class Edit> class EditCommand : public QUndoCommand {
public:
    using Apply = std::function<Edit(const Edit&)>;

    EditCommand(const QString& text, Edit edit, Apply apply, int mergeId = -1)
        : QUndoCommand(text), m_next(std::move(edit)), m_apply(std::move(apply)), m_mergeId(mergeId) {}

    void redo() override { swap(); }
    void undo() override { swap(); }
    int id() const override { return m_mergeId; }

    /// Two edits of one gesture (a drag, typing in a field) become one step: the older one's inverse is kept.
    bool mergeWith(const QUndoCommand* other) override {
        return m_mergeId >= 0 && other->id() == m_mergeId && other->text() == text();
    }

private:
    void swap() { m_next = m_apply(std::exchange(m_next, Edit{})); }

    Edit m_next; // what the next redo or undo applies
    Apply m_apply;
    int m_mergeId;
};

/// Two closures as a command, for edits that have no data type of their own.
class ClosureCommand : public QUndoCommand {
public:
    ClosureCommand(const QString& text, std::function<void()> redo, std::function<void()> undo, int mergeId = -1)
        : QUndoCommand(text), m_redo(std::move(redo)), m_undo(std::move(undo)), m_mergeId(mergeId) {}

    void redo() override { m_redo(); }
    void undo() override { m_undo(); }
    int id() const override { return m_mergeId; }
    bool mergeWith(const QUndoCommand* other) override {
        if (m_mergeId < 0 || other->id() != m_mergeId || other->text() != text()) return false;
        m_redo = static_cast<const ClosureCommand*>(other)->m_redo;
        return true;
    }

private:
    std::function<void()> m_redo, m_undo;
    int m_mergeId;
};

/// Groups what is pushed during its life into one step.
class MacroScope {
public:
    MacroScope(QUndoStack& stack, const QString& text) : m_stack(stack) { m_stack.beginMacro(text); }
    ~MacroScope() { m_stack.endMacro(); }
    MacroScope(const MacroScope&) = delete;
    MacroScope& operator=(const MacroScope&) = delete;

private:
    QUndoStack& m_stack;
};

/// Undo and redo as menu actions with the studio's icons, shortcuts and texts.
QAction* makeUndoAction(QUndoStack& stack, QObject* parent);
QAction* makeRedoAction(QUndoStack& stack, QObject* parent);

} // namespace plc::kit
