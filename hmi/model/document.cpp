#include "hmi/model/document.h"

#include "hmi/model/cells.h"
#include "hmi/model/layout.h"

#include <utility>

namespace plc::hmi {

/// Holds an edit and, once done, its inverse; undo and redo swap the two.
class EditCommand final : public QUndoCommand {
public:
    EditCommand(PanelDocument& document, const QString& title, Edit edit, int gesture)
        : QUndoCommand(title), m_document(document), m_next(std::move(edit)), m_gesture(gesture) {}

    void redo() override {
        m_next = m_document.apply(m_next);
        if (!std::exchange(m_isFirst, false)) return; // later the inverse holds both
        const Edit rest = arrangement(m_document.panel());
        if (!rest.isEmpty()) m_next = Edit{EditList{{m_document.apply(rest), m_next}}};
    }
    void undo() override {
        m_next = m_document.apply(m_next);
        setObsolete(m_gesture > 0 && m_gesture == m_document.m_takenBack); // the stack then drops it
    }
    int gesture() const { return m_gesture; }
    int id() const override { return m_gesture > 0 ? 1 : -1; }

    bool mergeWith(const QUndoCommand* other) override {
        const auto* later = static_cast<const EditCommand*>(other);
        if (later->m_gesture != m_gesture) return false;
        m_next = Edit{EditList{{later->m_next, m_next}}}; // both hold inverses: the later one is undone first
        return true;
    }

private:
    PanelDocument& m_document;
    Edit m_next;
    int m_gesture;
    bool m_isFirst = true;
};

PanelDocument::PanelDocument(const Panel& panel, QObject* parent)
    : QObject(parent), m_panel(laidOut(panel, panel.size())) {}

void PanelDocument::perform(const QString& title, const Edit& edit, int gesture) {
    if (edit.isEmpty()) return;
    m_undo.push(new EditCommand(*this, title, edit, gesture));
}

void PanelDocument::takeBack(int gesture) {
    const auto* last = dynamic_cast<const EditCommand*>(m_undo.command(m_undo.index() - 1));
    if (gesture <= 0 || m_undo.canRedo() || !last || last->gesture() != gesture) return;
    m_takenBack = gesture;
    m_undo.undo();
    m_takenBack = 0;
}

void PanelDocument::reset(const Panel& panel) {
    m_panel = laidOut(panel, panel.size());
    m_undo.clear();
    emit changed(Touched{{}, true, true});
}

Edit PanelDocument::apply(const Edit& edit) {
    Touched touched;
    Edit inverse = applyTo(m_panel, edit, &touched);
    emit changed(touched);
    return inverse;
}

} // namespace plc::hmi
