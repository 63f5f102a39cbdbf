#include "app/frame/side_bars.h"

#include "editor/kit/icons.h"
#include "editor/kit/theme.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPainter>
#include <QShortcut>
#include <QStyle>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

namespace plc::app {

namespace {

/// A pin: upright while the dock stays, lying while it hides itself.
class PinButton : public QToolButton {
public:
    PinButton(bool isPinned, QWidget* parent) : QToolButton(parent), m_isPinned(isPinned) {
        setAutoRaise(true);
        setFixedSize(20, 20);
        setFocusPolicy(Qt::TabFocus);
        setToolTip(isPinned ? SideBars::tr("Hide Automatically") : SideBars::tr("Keep Open"));
        setAccessibleName(toolTip());
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const kit::ThemeColors& c = kit::colors();
        if (underMouse() || hasFocus()) painter.fillRect(rect(), c.hover);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(rect().center() + QPointF(0.5, 0.5));
        if (!m_isPinned) painter.rotate(90);
        painter.setPen(QPen(c.muted, 1.3));
        painter.drawRect(QRectF(-2.5, -5.5, 5, 6));
        painter.drawLine(QPointF(-4.5, 0.5), QPointF(4.5, 0.5));
        painter.drawLine(QPointF(0, 0.5), QPointF(0, 5.5));
    }

private:
    bool m_isPinned;
};

QToolButton* titleButton(QStyle::StandardPixmap picture, const QString& text, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setAutoRaise(true);
    button->setFixedSize(20, 20);
    button->setFocusPolicy(Qt::TabFocus);
    button->setIcon(parent->style()->standardIcon(picture, nullptr, parent));
    button->setToolTip(text);
    button->setAccessibleName(text);
    return button;
}

QLabel* titleLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setWeight(QFont::DemiBold);
    label->setFont(font);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setMinimumWidth(10);
    return label;
}

/// The texts of the buttons at the left and right edges run along them.
class EdgeButton : public QToolButton {
public:
    EdgeButton(Qt::DockWidgetArea area, QAction* action, QWidget* parent) : QToolButton(parent), m_area(area) {
        setDefaultAction(action);
        setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        setAutoRaise(true);
        setAccessibleName(action->text());
    }
    [[nodiscard]] QSize sizeHint() const override {
        const QSize lying = QToolButton::sizeHint();
        return isUpright() ? lying.transposed() : lying;
    }
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override {
        if (!isUpright()) return QToolButton::paintEvent(event);
        QPainter painter(this);
        const kit::ThemeColors& c = kit::colors();
        if (underMouse() || hasFocus() || isChecked()) painter.fillRect(rect(), c.hover);
        painter.translate(rect().center() + QPointF(0.5, 0.5));
        painter.rotate(m_area == Qt::LeftDockWidgetArea ? -90 : 90);
        QRect room(QPoint(0, 0), size().transposed());
        room.moveCenter(QPoint(0, 0));
        room.adjust(6, 0, -6, 0);
        const QSize picture = iconSize();
        icon().paint(&painter, QRect(QPoint(room.left(), -picture.height() / 2), picture));
        painter.setPen(c.text);
        painter.drawText(room.adjusted(picture.width() + 5, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text());
    }

private:
    [[nodiscard]] bool isUpright() const {
        return m_area == Qt::LeftDockWidgetArea || m_area == Qt::RightDockWidgetArea;
    }
    Qt::DockWidgetArea m_area;
};

constexpr int kSmallest = 240; // of what slides out, in pixels

} // namespace

SideBars::SideBars(QMainWindow& window) : QObject(&window), m_window(window), m_frame(new QFrame(&window)) {
    const std::tuple<Qt::DockWidgetArea, Qt::ToolBarArea, const char*> edges[] = {
        {Qt::LeftDockWidgetArea, Qt::LeftToolBarArea, "sideBarLeft"},
        {Qt::RightDockWidgetArea, Qt::RightToolBarArea, "sideBarRight"},
        {Qt::BottomDockWidgetArea, Qt::BottomToolBarArea, "sideBarBottom"}};
    for (const auto& [area, edge, name] : edges) {
        auto* bar = new QToolBar(tr("Hidden Docks"), &window);
        bar->setObjectName(name);
        bar->setMovable(false);
        bar->toggleViewAction()->setVisible(false);
        bar->installEventFilter(this);
        window.addToolBar(edge, bar);
        bar->hide();
        m_bars[area] = bar;
    }
    m_frame->setFrameShape(QFrame::StyledPanel);
    m_frame->setAutoFillBackground(true);
    m_frame->hide();
    auto* layout = new QVBoxLayout(m_frame);
    layout->setContentsMargins(1, 1, 1, 1);
    layout->setSpacing(0);
    connect(new QShortcut(Qt::Key_Escape, m_frame, nullptr, nullptr, Qt::WidgetWithChildrenShortcut),
            &QShortcut::activated, this, &SideBars::conceal);
    window.installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        const bool isElsewhere = m_revealed && now && now->window() == &m_window && !m_frame->isAncestorOf(now) &&
                                 !dynamic_cast<EdgeButton*>(now);
        if (isElsewhere) conceal();
    });
}

SideBars::~SideBars() { takeBack(); }

void SideBars::add(QDockWidget& dock) {
    auto* title = new QWidget(&dock);
    auto* layout = new QHBoxLayout(title);
    layout->setContentsMargins(8, 2, 4, 2);
    layout->setSpacing(0);
    QLabel* label = titleLabel(dock.windowTitle(), title);
    connect(&dock, &QDockWidget::windowTitleChanged, label, &QLabel::setText);
    layout->addWidget(label, 1);
    auto* pin = new PinButton(true, title);
    pin->setObjectName("pin");
    connect(pin, &QToolButton::clicked, this, [this, &dock] { setHidesItself(dock, true); });
    connect(&dock, &QDockWidget::topLevelChanged, pin, [pin](bool isFloating) { pin->setVisible(!isFloating); });
    layout->addWidget(pin);
    QToolButton* floats = titleButton(QStyle::SP_TitleBarNormalButton, tr("Float"), title);
    connect(floats, &QToolButton::clicked, &dock, [&dock] { dock.setFloating(!dock.isFloating()); });
    layout->addWidget(floats);
    QToolButton* closes = titleButton(QStyle::SP_TitleBarCloseButton, tr("Close"), title);
    connect(closes, &QToolButton::clicked, &dock, &QDockWidget::close);
    layout->addWidget(closes);
    dock.setTitleBarWidget(title);
    // Shown by a menu, a perspective or a restored layout: it stays where it is shown.
    connect(&dock, &QDockWidget::visibilityChanged, this, [this, &dock](bool isVisible) {
        if (isVisible && hidesItself(dock)) setHidesItself(dock, false);
    });
}

bool SideBars::hidesItself(const QDockWidget& dock) const {
    return m_buttons.contains(const_cast<QDockWidget*>(&dock));
}

void SideBars::setHidesItself(QDockWidget& dock, bool hides) {
    if (hides == hidesItself(dock)) return;
    if (hides) {
        dock.setFloating(false);
        dock.hide();
        addButton(dock);
    } else {
        if (m_revealed == &dock) takeBack();
        removeButton(dock);
        dock.show();
        dock.raise();
    }
    showBars();
}

void SideBars::toggleFocused() {
    if (m_revealed) return setHidesItself(*m_revealed, false);
    for (QWidget* at = QApplication::focusWidget(); at; at = at->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(at); dock && !dock->isFloating())
            return setHidesItself(*dock, true);
}

void SideBars::addButton(QDockWidget& dock) {
    dock.setProperty("hidesItself", true);
    const Qt::DockWidgetArea area = m_window.dockWidgetArea(&dock);
    QToolBar* bar = barOf(area) ? barOf(area) : barOf(Qt::LeftDockWidgetArea);
    auto* action = new QAction(dock.windowIcon(), dock.windowTitle(), bar);
    action->setCheckable(true);
    action->setObjectName("sideBar." + dock.objectName());
    auto* button = new EdgeButton(m_bars.key(bar), action, bar);
    button->setObjectName(action->objectName());
    QAction* inBar = bar->addWidget(button);
    connect(action, &QAction::triggered, this, [this, &dock] {
        if (m_revealed == &dock)
            conceal();
        else
            reveal(dock);
    });
    m_buttons[&dock] = inBar;
}

void SideBars::removeButton(QDockWidget& dock) {
    dock.setProperty("hidesItself", false);
    if (QAction* inBar = m_buttons.take(&dock)) {
        inBar->setParent(nullptr);
        inBar->deleteLater();
    }
}

void SideBars::reveal(QDockWidget& dock) {
    if (!hidesItself(dock)) return;
    if (m_revealed == &dock) return;
    takeBack();
    m_revealed = &dock;
    auto* layout = static_cast<QVBoxLayout*>(m_frame->layout());
    auto* title = new QWidget(m_frame);
    title->setObjectName("slidOutTitle");
    auto* row = new QHBoxLayout(title);
    row->setContentsMargins(8, 2, 4, 2);
    row->setSpacing(0);
    row->addWidget(titleLabel(dock.windowTitle(), title), 1);
    auto* pin = new PinButton(false, title);
    pin->setObjectName("pin");
    connect(pin, &QToolButton::clicked, this, [this, &dock] { setHidesItself(dock, false); });
    row->addWidget(pin);
    layout->addWidget(title);
    if (QWidget* content = dock.widget()) {
        layout->addWidget(content, 1);
        content->show();
        content->setFocus(Qt::OtherFocusReason);
    }
    placeFrame();
    m_frame->show();
    m_frame->raise();
    checkButtonOf(&dock);
}

void SideBars::conceal() {
    takeBack();
    checkButtonOf(nullptr);
}

/// The button of that dock alone is down; null: none.
void SideBars::checkButtonOf(const QDockWidget* dock) {
    for (auto it = m_buttons.cbegin(); it != m_buttons.cend(); ++it)
        if (auto* button =
                qobject_cast<QToolButton*>(static_cast<QToolBar*>(it.value()->parent())->widgetForAction(it.value())))
            button->defaultAction()->setChecked(it.key() == dock);
}

/// What slid out is the dock's again.
void SideBars::takeBack() {
    if (!m_revealed) return;
    QDockWidget* dock = std::exchange(m_revealed, nullptr);
    m_frame->hide();
    while (QLayoutItem* item = m_frame->layout()->takeAt(0)) {
        QWidget* widget = item->widget();
        delete item;
        if (widget && widget->objectName() == "slidOutTitle")
            widget->deleteLater();
        else if (widget)
            dock->setWidget(widget);
    }
}

/// Over the documents and docks, from the edge of its button; as wide as the dock was.
void SideBars::placeFrame() {
    if (!m_revealed || !m_window.centralWidget()) return;
    QRect room = m_window.rect();
    room.setTop(m_window.centralWidget()->mapTo(&m_window, QPoint(0, 0)).y());
    for (QToolBar* bar : m_bars)
        if (bar->isVisible())
            room.setBottom(std::min(room.bottom(), bar == barOf(Qt::BottomDockWidgetArea) ? bar->geometry().top() - 1
                                                                                          : bar->geometry().bottom()));
    const QToolBar* left = barOf(Qt::LeftDockWidgetArea);
    const QToolBar* right = barOf(Qt::RightDockWidgetArea);
    if (left->isVisible()) room.setLeft(left->geometry().right() + 1);
    if (right->isVisible()) room.setRight(right->geometry().left() - 1);
    const QSize wanted = m_revealed->size().expandedTo(QSize(kSmallest, kSmallest)).boundedTo(room.size() * 2 / 3);
    QRect place = room;
    switch (m_window.dockWidgetArea(m_revealed)) {
    case Qt::RightDockWidgetArea:
        place.setLeft(room.right() - wanted.width() + 1);
        break;
    case Qt::BottomDockWidgetArea:
        place.setTop(room.bottom() - wanted.height() + 1);
        break;
    default:
        place.setWidth(wanted.width());
    }
    m_frame->setGeometry(place);
}

QStringList SideBars::stored() const {
    QStringList names;
    for (const QDockWidget* dock : m_buttons.keys()) names << dock->objectName();
    names.sort();
    return names;
}

void SideBars::restore(const QStringList& names) {
    takeBack();
    for (QDockWidget* dock : m_buttons.keys()) removeButton(*dock);
    for (const QString& name : names)
        if (auto* dock = m_window.findChild<QDockWidget*>(name, Qt::FindDirectChildrenOnly))
            setHidesItself(*dock, true);
    showBars();
}

/// A bar is there as long as it has a button, whatever a restored layout says of it.
void SideBars::showBars() {
    m_isPlacing = true;
    for (auto it = m_bars.cbegin(); it != m_bars.cend(); ++it) {
        const bool isUsed = std::any_of(m_buttons.cbegin(), m_buttons.cend(),
                                        [&](const QAction* inBar) { return inBar->parent() == it.value(); });
        it.value()->setVisible(isUsed);
    }
    m_isPlacing = false;
    placeFrame();
}

bool SideBars::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_window && event->type() == QEvent::Resize) placeFrame();
    const bool isOfBar = event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent;
    if (isOfBar && !m_isPlacing && watched != &m_window)
        QTimer::singleShot(0, this, &SideBars::showBars); // not in the middle of a layout being restored
    return QObject::eventFilter(watched, event);
}

} // namespace plc::app
