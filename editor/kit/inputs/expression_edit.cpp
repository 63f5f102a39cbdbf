#include "editor/kit/inputs/expression_edit.h"

#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/theme.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QStyledItemDelegate>

namespace plc::kit {

namespace {

constexpr int DetailRole = Qt::UserRole + 1, FromRole = Qt::UserRole + 2;

class CompletionDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const int width = option.fontMetrics.horizontalAdvance(index.data().toString() + QStringLiteral("    ") +
                                                               index.data(DetailRole).toString());
        return {width + 40, 24};
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const ThemeColors& c = colors();
        painter->fillRect(option.rect, option.state & QStyle::State_Selected ? c.selection : c.raised);
        const QRect row = option.rect.adjusted(6, 0, -8, 0);
        index.data(Qt::DecorationRole).value<QIcon>().paint(painter, QRect(row.left(), row.center().y() - 7, 16, 16));
        const QString text = index.data().toString();
        painter->setPen(c.text);
        painter->drawText(row.adjusted(24, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text);
        const int used = 24 + option.fontMetrics.horizontalAdvance(text) + 16;
        painter->setPen(c.muted);
        painter->drawText(
            row.adjusted(used, 0, 0, 0), Qt::AlignVCenter | Qt::AlignRight,
            option.fontMetrics.elidedText(index.data(DetailRole).toString(), Qt::ElideRight, row.width() - used));
    }
};

bool isNameCharacter(QChar c) { return c.isLetterOrNumber() || c == QLatin1Char('_'); }

} // namespace

ExpressionEdit::ExpressionEdit(QWidget* parent) : QLineEdit(parent) {
    m_model = new QStandardItemModel(this);
    m_completer = new QCompleter(m_model, this);
    m_completer->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    m_completer->setWidget(this);
    m_completer->setMaxVisibleItems(12);
    m_completer->popup()->setItemDelegate(new CompletionDelegate(m_completer));
    connect(m_completer, qOverload<const QModelIndex&>(&QCompleter::activated), this,
            &ExpressionEdit::insertCompletion);
    connect(this, &QLineEdit::textEdited, this, [this] { refresh(false); });
    connect(this, &QLineEdit::textChanged, this, [this] { runCheck(); });
}

void ExpressionEdit::setCompletionSource(CompletionSource source) { m_source = std::move(source); }

void ExpressionEdit::setCheck(TextCheck check) {
    m_check = std::move(check);
    runCheck();
}

bool ExpressionEdit::isCompletionShown() const { return m_completer->popup()->isVisible(); }

QStringList ExpressionEdit::shownCompletions() const {
    QStringList result;
    for (int row = 0; row < m_model->rowCount(); ++row) result += m_model->item(row)->text();
    return result;
}

void ExpressionEdit::complete() { refresh(true); }

int ExpressionEdit::wordStart() const {
    int start = cursorPosition();
    while (start > 0 && isNameCharacter(text()[start - 1])) --start;
    return start;
}

void ExpressionEdit::refresh(bool forced) {
    const int cursor = cursorPosition();
    const QString before = text().left(cursor);
    const bool inName = !before.isEmpty() && (isNameCharacter(before.back()) || before.back() == QLatin1Char('.'));
    const bool isNumber = wordStart() < cursor && text()[wordStart()].isDigit(); // 2 is not the end of ATAN2
    if (!m_source || (!forced && (!inName || isNumber))) {
        m_completer->popup()->hide();
        return;
    }
    m_model->clear();
    for (const Completion& completion : m_source(text(), cursor)) {
        auto* item = new QStandardItem(icon(completion.icon), completion.text);
        item->setData(completion.detail, DetailRole);
        item->setData(completion.replaceFrom < 0 ? wordStart() : completion.replaceFrom, FromRole);
        m_model->appendRow(item);
    }
    if (m_model->rowCount() == 0 || (!forced && m_model->rowCount() == 1 &&
                                     m_model->item(0)->text() == text().mid(wordStart(), cursor - wordStart()))) {
        m_completer->popup()->hide();
        return;
    }
    QRect at = cursorRect();
    at.setWidth(std::max(300, m_completer->popup()->sizeHintForColumn(0) +
                                  m_completer->popup()->verticalScrollBar()->sizeHint().width()));
    at.translate(0, 4);
    QPalette palette = m_completer->popup()->palette();
    palette.setColor(QPalette::Base, colors().raised);
    m_completer->popup()->setPalette(palette);
    m_completer->complete(at);
    m_completer->popup()->setCurrentIndex(m_completer->completionModel()->index(0, 0));
}

void ExpressionEdit::insertCompletion(const QModelIndex& index) {
    const int from = index.data(FromRole).toInt();
    const QString inserted = index.data().toString();
    QString whole = text();
    int end = cursorPosition();
    while (end < whole.size() && isNameCharacter(whole[end])) ++end;
    whole.replace(from, end - from, inserted);
    setText(whole);
    setCursorPosition(from + static_cast<int>(inserted.size()));
    emit textEdited(whole);
    m_completer->popup()->hide();
}

void ExpressionEdit::runCheck() {
    const QString complaint = m_check && !text().trimmed().isEmpty() ? m_check(text()) : QString();
    if (complaint == m_complaint) return;
    m_complaint = complaint;
    setToolTip(complaint);
    update();
    emit complaintChanged(complaint);
}

bool ExpressionEdit::isWordComplete() const {
    const QString word = text().mid(wordStart(), cursorPosition() - wordStart());
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (m_model->item(row)->text().compare(word, Qt::CaseInsensitive) == 0) return true;
    return false;
}

void ExpressionEdit::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && isCompletionShown() && isWordComplete()) m_completer->popup()->hide(); // the name is all there
    if (isCompletionShown()) {
        switch (event->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Tab: {
            const QModelIndex current = m_completer->popup()->currentIndex();
            if (current.isValid())
                insertCompletion(current);
            else
                m_completer->popup()->hide();
            if (isEnter && m_endsWithCompletion) emit returnPressed();
            event->accept();
            return;
        }
        case Qt::Key_Escape:
            m_completer->popup()->hide();
            event->accept();
            return;
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
            event->ignore();
            return; // the list moves its own row
        default:
            break;
        }
    }
    if (event->key() == Qt::Key_Space && event->modifiers() & Qt::ControlModifier) {
        refresh(true);
        return;
    }
    QLineEdit::keyPressEvent(event);
}

bool ExpressionEdit::focusNextPrevChild(bool next) {
    // Qt asks this before it passes Tab on as a key; without it Tab would leave the field with half a word in it.
    if (next && isCompletionShown()) return false;
    return QLineEdit::focusNextPrevChild(next);
}

void ExpressionEdit::focusInEvent(QFocusEvent* event) {
    m_completer->setWidget(this);
    QLineEdit::focusInEvent(event);
}

void ExpressionEdit::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (m_complaint.isEmpty()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors().bad, 1.3));
    QPolygonF wave;
    const qreal y = height() - 4.5, end = std::min<qreal>(width() - 6, 8 + fontMetrics().horizontalAdvance(text()));
    for (qreal x = 6, up = 0; x < end; x += 2, up = 1.5 - up) wave << QPointF(x, y + up);
    painter.drawPolyline(wave);
}

void ExpressionEdit::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(VariableMime) || event->mimeData()->hasText()) event->acceptProposedAction();
}

void ExpressionEdit::dropEvent(QDropEvent* event) {
    const QStringList paths = variablesOf(event->mimeData());
    if (paths.isEmpty()) return QLineEdit::dropEvent(event);
    insert(paths.first());
    event->acceptProposedAction();
    emit textEdited(text());
}

} // namespace plc::kit
