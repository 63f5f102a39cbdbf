// A panel operated with keys alone. Tab goes from one element that reacts to the next; Space or Enter press it as long
// as they are held; arrows and Page Up and Down turn it as a wheel does; Ctrl with an arrow chooses the place inside of
// it, for lists and rows of buttons. Owned by the view, which it watches; main thread.
#pragma once
#include <QCoreApplication>
#include <QObject>
#include <QPointF>

#include <vector>

class QKeyEvent;
class QWidget;

namespace plc::hmi {

class ElementView;
class PanelView;

class PanelKeys final : public QObject {
    Q_DECLARE_TR_FUNCTIONS(plc::hmi::PanelKeys)
public:
    explicit PanelKeys(PanelView& view);
    /// What the keys are for at present; null: nothing has the focus.
    [[nodiscard]] ElementView* focused() const;
    /// Where Space presses, in coordinates of the panel.
    [[nodiscard]] QPointF place() const;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    [[nodiscard]] std::vector<ElementView*> stops() const;
    bool pressed(const QKeyEvent& event);
    bool go(int by);
    void movePlace(QPointF by);
    void letGo();
    void show();

    PanelView& m_view;
    QWidget* m_frame = nullptr;
    const ElementView* m_at = nullptr; // looked up in the scene before it is used: panels change
    QPointF m_offset;                  // of the place, from the middle of the element
    bool m_isPressed = false;
};

} // namespace plc::hmi
