#include "hmi/view/panel_keys.h"

#include "hmi/view/panel_view.h"
#include "hmi/view/scene/element_view.h"

#include <QAccessible>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace plc::hmi {

namespace {

constexpr double kRow = 24;  // elements whose middles differ by less stand in one row
constexpr double kStep = 12; // of the place inside of an element

/// Lies over the view and draws the frame; the mouse goes through it.
class FocusFrame final : public QWidget {
public:
    FocusFrame(PanelView& view, const PanelKeys& keys) : QWidget(&view), m_view(view), m_keys(keys) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
        hide();
    }

protected:
    void paintEvent(QPaintEvent*) override {
        const ElementView* at = m_keys.focused();
        if (!at) return;
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QRectF around = m_view.toWidget(m_view.scene().shownRect(*at)).adjusted(-3, -3, 3, 3);
        // Light and dark beside each other: to be seen on every ground.
        painter.setPen(QPen(Qt::white, 4));
        painter.drawRoundedRect(around, 4, 4);
        painter.setPen(QPen(Qt::black, 2));
        painter.drawRoundedRect(around, 4, 4);
        const QPointF middle = m_view.toWidget(QRectF(m_keys.place(), QSizeF())).topLeft();
        if ((middle - around.center()).manhattanLength() < 2) return;
        painter.setBrush(Qt::white);
        painter.drawEllipse(middle, 4, 4);
    }

private:
    PanelView& m_view;
    const PanelKeys& m_keys;
};

} // namespace

PanelKeys::PanelKeys(PanelView& view) : QObject(&view), m_view(view), m_frame(new FocusFrame(view, *this)) {
    view.setFocusPolicy(Qt::TabFocus); // a touch leaves the focus where it was
    view.setAccessibleName(tr("Panel"));
    setObjectName("panelKeys");
    view.installEventFilter(this);
    connect(&view.scene(), &PanelScene::dirtied, m_frame, qOverload<>(&QWidget::update)); // elements move
}

/// In the order of reading.
std::vector<ElementView*> PanelKeys::stops() const {
    const PanelScene& scene = m_view.scene();
    std::vector<ElementView*> out;
    for (const auto& each : scene.views())
        if (each->isInteractive() && scene.isShown(*each) && scene.isEnabled(*each)) out.push_back(each.get());
    std::stable_sort(out.begin(), out.end(), [&](const ElementView* a, const ElementView* b) {
        const QPointF left = scene.shownRect(*a).center(), right = scene.shownRect(*b).center();
        return std::pair(std::floor(left.y() / kRow), left.x()) < std::pair(std::floor(right.y() / kRow), right.x());
    });
    return out;
}

ElementView* PanelKeys::focused() const {
    const std::vector<ElementView*> all = stops();
    const auto found = std::find(all.begin(), all.end(), m_at);
    return m_at && found != all.end() ? *found : nullptr;
}

QPointF PanelKeys::place() const {
    const ElementView* at = focused();
    return at ? m_view.scene().shownRect(*at).center() + m_offset : QPointF();
}

bool PanelKeys::go(int by) {
    letGo();
    const std::vector<ElementView*> all = stops();
    const auto now = std::find(all.begin(), all.end(), m_at);
    const auto count = static_cast<std::ptrdiff_t>(all.size());
    const auto next = m_at && now != all.end() ? now - all.begin() + by : by > 0 ? 0 : count - 1;
    m_at = next >= 0 && next < count ? all[static_cast<size_t>(next)] : nullptr;
    m_offset = {};
    show();
    return m_at != nullptr; // else Tab leaves the panel
}

void PanelKeys::show() {
    m_frame->setGeometry(m_view.rect());
    m_frame->raise();
    m_frame->setVisible(m_at != nullptr);
    m_frame->update();
    std::vector<TextBox> texts;
    if (const ElementView* at = focused()) at->collectTexts(m_view.scene().language(), texts);
    m_view.setAccessibleDescription(texts.empty() ? QString() : texts.front().text);
    QAccessibleEvent told(&m_view, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&told);
}

void PanelKeys::movePlace(QPointF by) {
    const ElementView* at = focused();
    if (!at) return;
    const double over = at->overhang(); // is painted, and not pressed
    const QRectF room = m_view.scene().shownRect(*at).adjusted(over, over, -over, -over);
    const QPointF to = room.center() + m_offset + by;
    m_offset = QPointF(std::clamp(to.x(), room.left() + 2, std::max(room.left() + 2, room.right() - 2)),
                       std::clamp(to.y(), room.top() + 2, std::max(room.top() + 2, room.bottom() - 2))) -
               room.center();
    m_frame->update();
}

/// A key that is lost with the focus must not keep a button pressed.
void PanelKeys::letGo() {
    if (std::exchange(m_isPressed, false) && m_view.scene().pressedView()) m_view.scene().release(QPointF(-1e6, -1e6));
}

bool PanelKeys::pressed(const QKeyEvent& event) {
    const bool isPlace = event.modifiers() & Qt::ControlModifier;
    const auto turn = [&](double steps, QPointF by) {
        if (!focused()) return false;
        if (isPlace)
            movePlace(by);
        else
            m_view.scene().wheel(place(), steps);
        m_view.frame();
        return true;
    };
    switch (event.key()) {
    case Qt::Key_Tab:
        return !isPlace && go(1);
    case Qt::Key_Backtab:
        return !isPlace && go(-1);
    case Qt::Key_Up:
        return turn(1, {0, -kStep});
    case Qt::Key_Right:
        return turn(1, {kStep, 0});
    case Qt::Key_Down:
        return turn(-1, {0, kStep});
    case Qt::Key_Left:
        return turn(-1, {-kStep, 0});
    case Qt::Key_PageUp:
        return turn(10, {0, -kStep});
    case Qt::Key_PageDown:
        return turn(-10, {0, kStep});
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!focused()) return false;
        if (event.isAutoRepeat()) return true;
        m_isPressed = true;
        m_view.scene().press(place());
        m_view.frame();
        return true;
    default:
        return false;
    }
}

bool PanelKeys::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
    case QEvent::KeyPress:
        return pressed(*static_cast<QKeyEvent*>(event));
    case QEvent::KeyRelease:
        if (!m_isPressed || static_cast<QKeyEvent*>(event)->isAutoRepeat()) return false;
        m_isPressed = false;
        m_view.scene().release(place());
        m_view.frame();
        return true;
    case QEvent::FocusIn:
        if (const auto reason = static_cast<QFocusEvent*>(event)->reason(); !focused())
            go(reason == Qt::BacktabFocusReason ? -1 : 1);
        else
            show();
        return false;
    case QEvent::Hide:
    case QEvent::FocusOut:
        letGo();
        m_frame->hide();
        return false;
    case QEvent::Resize:
        m_frame->setGeometry(m_view.rect());
        return false;
    default:
        return QObject::eventFilter(watched, event);
    }
}

} // namespace plc::hmi
