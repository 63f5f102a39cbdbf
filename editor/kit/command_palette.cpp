#include "editor/kit/command_palette.h"

#include "editor/kit/fuzzy.h"
#include "editor/kit/icons.h"
#include "editor/kit/mnemonics.h"
#include "editor/kit/theme.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <set>

namespace plc::kit {

namespace {

constexpr int EntryRole = Qt::UserRole + 1, PositionsRole = Qt::UserRole + 2, ShortcutRole = Qt::UserRole + 3,
              EnabledRole = Qt::UserRole + 4;

QString plainText(const QAction* action) {
    QString text = withoutMnemonic(action->text());
    text.remove(QStringLiteral("..."));
    text.remove(QChar(0x2026));
    return text.replace(QStringLiteral("&&"), QStringLiteral("&")).trimmed();
}

/// The menu that an action lies in, for "File: Save".
QString menuOf(const QAction* action) {
    for (QObject* object : action->associatedObjects())
        if (auto* menu = qobject_cast<QMenu*>(object); menu && !menu->title().isEmpty())
            return plainText(menu->menuAction());
    return {};
}

QString keyOf(const QAction* action) {
    return action->objectName().isEmpty() ? withoutMnemonic(action->text()) : action->objectName();
}

/// One row: icon, name with the matched letters in the accent colour, shortcut on the right.
class RowDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {200, 28}; }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const ThemeColors& c = colors();
        const bool enabled = index.data(EnabledRole).toBool();
        painter->save();
        painter->setFont(option.font);
        painter->fillRect(option.rect, option.state & QStyle::State_Selected ? c.selection : c.raised);
        const QRect row = option.rect.adjusted(10, 0, -10, 0);
        if (const auto icon = index.data(Qt::DecorationRole).value<QIcon>(); !icon.isNull())
            icon.paint(painter, QRect(row.left(), row.center().y() - 7, 16, 16), Qt::AlignCenter,
                       enabled ? QIcon::Normal : QIcon::Disabled);
        const QString shortcut = index.data(ShortcutRole).toString();
        const int shortcutWidth = shortcut.isEmpty() ? 0 : option.fontMetrics.horizontalAdvance(shortcut) + 12;
        painter->setPen(c.muted);
        painter->drawText(row, Qt::AlignVCenter | Qt::AlignRight, shortcut);
        const QString text =
            option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, row.width() - 26 - shortcutWidth);
        const QVariantList positions = index.data(PositionsRole).toList();
        int x = row.left() + 26, next = 0;
        QFont bold = option.font;
        bold.setBold(true);
        for (int i = 0; i < text.size(); ++i) {
            const bool hit = next < positions.size() && positions[next].toInt() == i;
            if (hit) ++next;
            painter->setPen(!enabled ? c.disabled : hit ? c.accent : c.text);
            painter->setFont(hit ? bold : option.font);
            painter->drawText(x, row.top(), 60, row.height(), Qt::AlignVCenter | Qt::AlignLeft, text.mid(i, 1));
            x += painter->fontMetrics().horizontalAdvance(text[i]);
        }
        painter->restore();
    }
};

} // namespace

CommandPalette::CommandPalette(QWidget* window, ActionSource source)
    : QFrame(window), m_window(window), m_source(std::move(source)) {
    setObjectName(QStringLiteral("commandPalette"));
    setAccessibleName(tr("Command palette"));
    m_input = new QLineEdit(this);
    m_input->setPlaceholderText(tr("Type to find a command"));
    m_input->setAccessibleName(tr("Command"));
    m_input->addAction(icon(Icon::Command), QLineEdit::LeadingPosition);
    m_list = new QListView(this);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setUniformItemSizes(true);
    m_list->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list->setItemDelegate(new RowDelegate(m_list));
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setAccessibleName(tr("Commands"));
    m_model = new QStandardItemModel(this);
    m_list->setModel(m_model);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->addWidget(m_input);
    layout->addWidget(m_list);
    m_input->installEventFilter(this);
    connect(m_input, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(m_list, &QListView::clicked, this, [this](const QModelIndex& index) {
        m_list->setCurrentIndex(index);
        runCurrent();
    });
    hide();
}

void CommandPalette::open(const QString& text) {
    if (!isAncestorOf(m_window->focusWidget())) m_before = m_window->focusWidget();
    collect();
    const int width = std::min(620, m_window->width() - 40);
    QPalette p = palette();
    p.setColor(QPalette::Base, colors().raised);
    m_list->setPalette(p);
    m_input->setText(text);
    filter(text);
    const int rows = std::clamp(m_model->rowCount(), 3, 12);
    resize(width, m_input->sizeHint().height() + rows * 28 + 26);
    move((m_window->width() - width) / 2, std::min(64, m_window->height() / 8));
    show();
    raise();
    m_input->setFocus(Qt::PopupFocusReason);
    m_input->selectAll();
}

void CommandPalette::collect() {
    m_entries.clear();
    const QList<QAction*> actions = m_source ? m_source() : m_window->findChildren<QAction*>();
    std::set<QString> seen;
    for (QAction* action : actions) {
        if (!action || action->isSeparator() || action->menu() || !action->isVisible()) continue;
        const QString text = plainText(action);
        if (text.isEmpty()) continue;
        const QString menu = menuOf(action);
        const QString full = menu.isEmpty() ? text : tr("%1: %2", "menu and command").arg(menu, text);
        if (!seen.insert(full).second) continue;
        m_entries.push_back({action, full});
    }
}

void CommandPalette::filter(const QString& text) {
    struct Hit {
        const Entry* entry;
        FuzzyMatch match;
    };
    std::vector<Hit> hits;
    for (const Entry& entry : m_entries) {
        if (!entry.action) continue;
        auto match = fuzzyMatch(text, entry.text);
        if (!match) continue;
        const qsizetype recent = m_recent.indexOf(keyOf(entry.action));
        if (recent >= 0) match->score += text.trimmed().isEmpty() ? 100 - static_cast<int>(recent) : 3;
        if (!entry.action->isEnabled()) match->score -= 50;
        hits.push_back({&entry, std::move(*match)});
    }
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return a.match.score != b.match.score ? a.match.score > b.match.score
                                              : a.entry->text.localeAwareCompare(b.entry->text) < 0;
    });
    m_model->clear();
    for (const Hit& hit : hits) {
        auto* item = new QStandardItem(hit.entry->action->icon(), hit.entry->text);
        QVariantList positions;
        for (int p : hit.match.positions) positions.append(p);
        item->setData(positions, PositionsRole);
        item->setData(hit.entry->action->shortcut().toString(QKeySequence::NativeText), ShortcutRole);
        item->setData(hit.entry->action->isEnabled(), EnabledRole);
        item->setData(static_cast<int>(hit.entry - m_entries.data()), EntryRole);
        item->setToolTip(hit.entry->action->toolTip());
        m_model->appendRow(item);
    }
    if (m_model->rowCount() > 0) m_list->setCurrentIndex(m_model->index(0, 0));
}

QStringList CommandPalette::shownTexts() const {
    QStringList result;
    for (int row = 0; row < m_model->rowCount(); ++row) result += m_model->item(row)->text();
    return result;
}

void CommandPalette::runCurrent() {
    const QModelIndex index = m_list->currentIndex();
    if (!index.isValid()) return;
    QPointer<QAction> action = m_entries[static_cast<size_t>(index.data(EntryRole).toInt())].action;
    if (!action || !action->isEnabled()) return;
    const QString key = keyOf(action);
    m_recent.removeAll(key);
    m_recent.prepend(key);
    while (m_recent.size() > 12) m_recent.removeLast();
    hide();
    action->trigger();
    if (action) emit ran(action);
}

void CommandPalette::moveCurrent(int rows) {
    const int count = m_model->rowCount();
    if (count == 0) return;
    const int row = (m_list->currentIndex().row() + rows % count + count) % count;
    m_list->setCurrentIndex(m_model->index(row, 0));
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_input && event->type() == QEvent::FocusOut && isVisible()) {
        if (!isAncestorOf(QApplication::focusWidget())) hide();
    }
    if (watched != m_input || event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Down:
        moveCurrent(1);
        return true;
    case Qt::Key_Up:
        moveCurrent(-1);
        return true;
    case Qt::Key_PageDown:
        moveCurrent(std::min(10, std::max(0, m_model->rowCount() - 1 - m_list->currentIndex().row())));
        return true;
    case Qt::Key_PageUp:
        moveCurrent(-std::min(10, m_list->currentIndex().row()));
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        runCurrent();
        return true;
    case Qt::Key_Escape:
        hide();
        return true;
    default:
        return QFrame::eventFilter(watched, event);
    }
}

void CommandPalette::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        hide();
    else
        QFrame::keyPressEvent(event);
}

void CommandPalette::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    if (m_input->hasFocus()) (m_before ? m_before.data() : m_window)->setFocus(Qt::OtherFocusReason);
}

void CommandPalette::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), colors().window);
    painter.setPen(colors().border);
    painter.setBrush(colors().raised);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
}

} // namespace plc::kit
