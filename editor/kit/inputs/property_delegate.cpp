#include "editor/kit/inputs/property_delegate.h"

#include "editor/kit/inputs/choice_box.h"
#include "editor/kit/inputs/property_grid.h"
#include "editor/kit/theme.h"
#include "editor/kit/word_list.h"

#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>

namespace plc::kit {

namespace {

// Properties of an open editor: that it has its value, its row, what that had before any preview, and that it
// has been closed.
constexpr const char* kIsFilled = "isFilled";
constexpr const char* kBefore = "before";
constexpr const char* kRow = "row";
constexpr const char* kWasVarious = "wasVarious";
constexpr const char* kIsFinished = "isFinished";

QString idOf(const QModelIndex& index) {
    return index.sibling(index.row(), 0).data(PropertyDelegate::IdRole).toString();
}

/// A number field that shows numbers as short as they are.
class NumberSpin : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;
    QString textFromValue(double value) const override { return locale().toString(value, 'g', 10); }
};

/// A line with a button at its end: files, variables, long texts.
class LineWithButton : public QWidget {
public:
    LineWithButton(ExpressionEdit* line, Icon which, const QString& toolTip, QWidget* parent)
        : QWidget(parent), m_line(line) {
        auto* layout = new QHBoxLayout(this);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setSpacing(0);
        m_button = new QToolButton(this);
        m_button->setIcon(icon(which));
        m_button->setToolTip(QStringLiteral("%1 (%2)").arg(toolTip, keys().toString(QKeySequence::NativeText)));
        m_button->setFocusPolicy(Qt::NoFocus);
        layout->addWidget(line);
        layout->addWidget(m_button);
        setFocusProxy(line);
        line->installEventFilter(this);
        setAutoFillBackground(true);
    }
    ExpressionEdit* line() const { return m_line; }
    QToolButton* button() const { return m_button; }
    /// What the button does, while the line has the keyboard.
    static QKeySequence keys() { return Qt::ALT | Qt::Key_Down; }

protected:
    /// The keyboard is the line's, but what ends the editing is that this widget loses it.
    bool eventFilter(QObject* object, QEvent* event) override {
        if (object == m_line && event->type() == QEvent::FocusOut) {
            QFocusEvent left(QEvent::FocusOut, static_cast<QFocusEvent*>(event)->reason());
            QCoreApplication::sendEvent(this, &left);
        }
        return QWidget::eventFilter(object, event);
    }

private:
    ExpressionEdit* m_line = nullptr;
    QToolButton* m_button = nullptr;
};

void paintSwatch(QPainter& painter, const QRectF& box, const QColor& color) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(colors().border);
    painter.setBrush(color.isValid() ? QBrush(color) : QBrush(colors().border, Qt::BDiagPattern));
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    painter.restore();
}

QIcon iconOf(const PropertyChoice& choice) {
    if (choice.icon) return icon(*choice.icon);
    if (!choice.color.isValid()) return {};
    QPixmap swatch(16, 16);
    swatch.fill(Qt::transparent);
    {
        QPainter painter(&swatch);
        paintSwatch(painter, QRectF(0, 0, 16, 16), choice.color);
    }
    return swatch;
}

/// The colour that an enumeration's value stands for; invalid for one that has none.
QColor colorOf(const PropertyDescriptor& descriptor, const QVariant& value) {
    if (descriptor.kind != PropertyKind::Enumeration) return {};
    bool areColors = false;
    for (const PropertyChoice& choice : descriptor.choices) {
        areColors |= choice.color.isValid();
        if (choice.value == value) return choice.color;
    }
    return areColors ? QColor(value.toString()) : QColor(); // one of the user's own
}

std::optional<QString> askLongText(const QString& title, const QString& text, QWidget* parent) {
    QDialog dialog(parent);
    dialog.setWindowTitle(title);
    dialog.resize(480, 260);
    auto* edit = new QPlainTextEdit(text, &dialog);
    edit->setAccessibleName(title);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    auto* layout = new QVBoxLayout(&dialog);
    layout->addWidget(edit);
    layout->addWidget(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return edit->toPlainText();
}

/// One of the words that are offered, put into the list or taken out of it.
std::optional<QString> askWord(const std::vector<PropertyChoice>& words, const QString& list, QWidget* below) {
    QMenu menu(below);
    const QStringList chosen = wordsOf(list);
    for (const PropertyChoice& word : words) {
        QAction* action = menu.addAction(word.label);
        action->setData(word.value);
        action->setCheckable(true);
        action->setChecked(chosen.contains(word.value.toString(), Qt::CaseInsensitive));
    }
    const QAction* picked = menu.exec(below->mapToGlobal(QPoint(0, below->height())));
    if (!picked) return std::nullopt;
    return withToggled(list, picked->data().toString());
}

} // namespace

PropertyDelegate::PropertyDelegate(PropertyGrid& grid) : QStyledItemDelegate(&grid), m_grid(grid) {}

QSize PropertyDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    return {QStyledItemDelegate::sizeHint(option, index).width(), 27};
}

void PropertyDelegate::finish(QWidget* editor) const {
    // Closed before the commit is announced: its receivers may give the grid other rows.
    const QString id = editor->property(kRow).toString();
    auto* self = const_cast<PropertyDelegate*>(this);
    const std::optional<QVariant> value = valueOf(editor, id);
    takePreviewBack(editor, id);
    editor->setProperty(kIsFinished, true);
    emit self->closeEditor(editor);
    commit(id, value);
}

QWidget* PropertyDelegate::makeTextEditor(QWidget* parent, const QString& id) const {
    const PropertyDescriptor& d = *m_grid.descriptor(id);
    auto* line = new ExpressionEdit(parent);
    line->setFrame(false);
    line->setPlaceholderText(d.placeholder);
    if (d.kind == PropertyKind::Expression) {
        line->setCompletionSource(m_grid.m_completions);
        if (m_grid.m_check)
            line->setCheck([check = m_grid.m_check, id](const QString& text) { return check(id, text); });
    }
    auto withButton = [&](Icon which, const QString& toolTip,
                          std::function<std::optional<QString>(const QString&)> ask) -> QWidget* {
        auto* editor = new LineWithButton(line, which, toolTip, parent);
        connect(editor->button(), &QToolButton::clicked, editor, [this, editor, ask] {
            // The dialog takes the focus away; the editor must stay until it is answered.
            editor->setProperty("asking", true);
            const auto answer = ask(editor->line()->text());
            editor->setProperty("asking", false);
            if (answer) editor->line()->setText(*answer);
            finish(editor);
        });
        return editor;
    };
    switch (d.kind) {
    case PropertyKind::Expression:
        if (!m_grid.m_picker) return line;
        return withButton(Icon::Watch, PropertyGrid::tr("Choose a variable"), m_grid.m_picker);
    case PropertyKind::File:
        return withButton(Icon::Folder, PropertyGrid::tr("Choose a file"),
                          [this, filter = d.fileFilter](const QString& current) -> std::optional<QString> {
                              const QDir folder(m_grid.m_folder);
                              const QString path = QFileDialog::getOpenFileName(
                                  &m_grid, PropertyGrid::tr("Choose a file"), folder.absoluteFilePath(current), filter);
                              if (path.isEmpty()) return std::nullopt;
                              return m_grid.m_folder.isEmpty() ? path : folder.relativeFilePath(path);
                          });
    case PropertyKind::LongText:
        return withButton(Icon::Edit, PropertyGrid::tr("Edit in a window"), [this, label = d.label](const QString&) {
            return askLongText(label, m_grid.value(idOf(m_grid.currentIndex())).toString(), &m_grid);
        });
    case PropertyKind::Text:
        if (!d.words.isEmpty())
            line->setCompletionSource([words = d.words](const QString& text, int) {
                std::vector<Completion> out;
                for (const QString& word : words.filter(text, Qt::CaseInsensitive))
                    out.push_back({word, {}, Icon::Variable, 0});
                return out;
            });
        if (d.choices.empty()) return line;
        return withButton(Icon::Menu, PropertyGrid::tr("Choose from a list"),
                          [words = d.choices, parent](const QString& list) { return askWord(words, list, parent); });
    default:
        return line;
    }
}

QWidget* PropertyDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                        const QModelIndex& index) const {
    const QString id = idOf(index);
    const PropertyDescriptor* d = m_grid.descriptor(id);
    if (!d || index.column() != 1) return nullptr;
    PropertyGrid* grid = &m_grid;
    switch (d->kind) {
    case PropertyKind::Integer: {
        auto* spin = new QSpinBox(parent);
        spin->setFrame(false);
        spin->setRange(static_cast<int>(std::max(d->minimum, -2147483648.0)),
                       static_cast<int>(std::min(d->maximum, 2147483647.0)));
        spin->setSingleStep(std::max(1, static_cast<int>(d->step)));
        spin->setSuffix(d->suffix);
        connect(spin, &QSpinBox::valueChanged, grid, [grid, id](int value) { emit grid->previewed(id, value); });
        return spin;
    }
    case PropertyKind::Number: {
        auto* spin = new NumberSpin(parent);
        spin->setFrame(false);
        spin->setDecimals(d->decimals);
        spin->setRange(d->minimum, d->maximum);
        spin->setSingleStep(d->step);
        spin->setSuffix(d->suffix);
        connect(spin, &QDoubleSpinBox::valueChanged, grid,
                [grid, id](double value) { emit grid->previewed(id, value); });
        return spin;
    }
    case PropertyKind::Enumeration: {
        auto* combo = new ChoiceBox(parent);
        for (const PropertyChoice& choice : d->choices) combo->addItem(iconOf(choice), choice.label, choice.value);
        connect(combo, &QComboBox::highlighted, grid,
                [grid, id, combo](int row) { emit grid->previewed(id, combo->itemData(row)); });
        connect(combo, &QComboBox::activated, this, [this, combo] { finish(combo); });
        connect(combo, &ChoiceBox::closed, this, [this, combo] {
            if (!combo->property(kIsFinished).toBool()) finish(combo); // nothing chosen
        });
        QTimer::singleShot(0, combo, &ChoiceBox::open);
        return combo;
    }
    case PropertyKind::Text:
    case PropertyKind::LongText:
    case PropertyKind::Expression:
    case PropertyKind::File:
        return makeTextEditor(parent, id);
    case PropertyKind::Bool:
    case PropertyKind::Color:
    case PropertyKind::Action:
        return nullptr;
    }
    return QStyledItemDelegate::createEditor(parent, option, index);
}

void PropertyDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    const QVariant value = m_grid.value(idOf(index));
    if (const PropertyDescriptor* described = m_grid.descriptor(idOf(index)))
        (editor->focusProxy() ? editor->focusProxy() : editor)->setAccessibleName(described->label);
    // What is previewed comes back as the value of the row; whoever is typing must not have it written over.
    if (editor->property(kIsFilled).toBool()) return;
    editor->setProperty(kIsFilled, true);
    m_open = editor;
    editor->setProperty(kRow, idOf(index));
    editor->setProperty(kBefore, value);
    editor->setProperty(kWasVarious, m_grid.isVarious(idOf(index)));
    const QSignalBlocker quiet(editor);
    if (auto* spin = qobject_cast<QSpinBox*>(editor)) {
        spin->setValue(value.toInt());
        spin->selectAll();
    } else if (auto* number = qobject_cast<QDoubleSpinBox*>(editor)) {
        number->setValue(value.toDouble());
        number->selectAll();
    } else if (auto* combo = qobject_cast<QComboBox*>(editor)) {
        combo->setCurrentIndex(combo->findData(value));
    } else if (auto* line = qobject_cast<ExpressionEdit*>(editor)) {
        line->setText(value.toString());
        line->selectAll();
    } else if (auto* both = dynamic_cast<LineWithButton*>(editor)) {
        both->line()->setText(value.toString());
        both->line()->selectAll();
    }
}

std::optional<QVariant> PropertyDelegate::valueOf(QWidget* editor, const QString& id) const {
    if (auto* spin = qobject_cast<QSpinBox*>(editor)) {
        spin->interpretText();
        return spin->value();
    }
    if (auto* number = qobject_cast<QDoubleSpinBox*>(editor)) {
        number->interpretText();
        return number->value();
    }
    if (auto* combo = qobject_cast<QComboBox*>(editor))
        return combo->currentIndex() >= 0 ? std::optional(combo->currentData()) : std::nullopt;
    auto* line = qobject_cast<ExpressionEdit*>(editor);
    if (auto* both = dynamic_cast<LineWithButton*>(editor)) line = both->line();
    if (!line || (m_grid.isVarious(id) && line->text().isEmpty())) return std::nullopt;
    return line->text();
}

void PropertyDelegate::setModelData(QWidget* editor, QAbstractItemModel*, const QModelIndex& index) const {
    const QString id = idOf(index);
    const auto value = valueOf(editor, id);
    takePreviewBack(editor, id);
    editor->setProperty(kIsFinished, true);
    commit(id, value);
}

void PropertyDelegate::finishOpen() {
    if (m_open && !m_open->isHidden() && !m_open->property(kIsFinished).toBool()) finish(m_open);
}

void PropertyDelegate::commit(const QString& id, const std::optional<QVariant>& value) const {
    if (value)
        m_grid.commit(id, *value);
    else
        emit m_grid.previewWithdrawn(id);
}

/// A commit is one step from the value before any preview.
void PropertyDelegate::takePreviewBack(const QWidget* editor, const QString& id) const {
    if (editor->property(kWasVarious).toBool())
        m_grid.setVarious(id);
    else
        m_grid.setValue(id, editor->property(kBefore));
}

bool PropertyDelegate::eventFilter(QObject* object, QEvent* event) {
    auto* editor = qobject_cast<QWidget*>(object);
    if (editor && event->type() == QEvent::FocusOut && editor->property("asking").toBool()) return false;
    if (editor && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        auto* line = qobject_cast<ExpressionEdit*>(editor);
        if (auto* both = dynamic_cast<LineWithButton*>(editor)) {
            line = both->line();
            if (QKeySequence(static_cast<QKeyEvent*>(event)->keyCombination()) == LineWithButton::keys()) {
                both->button()->click();
                return true;
            }
        }
        if (line && line->isCompletionShown() &&
            (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab || key == Qt::Key_Escape))
            return false;
        if ((key == Qt::Key_Return || key == Qt::Key_Enter) && !qobject_cast<QComboBox*>(editor)) {
            finish(editor); // at once: the key must not reach the grid, which would open the editor again
            return true;
        }
        if (key == Qt::Key_Escape) {
            const QString id = editor->property(kRow).toString();
            if (!editor->property(kWasVarious).toBool()) emit m_grid.previewed(id, editor->property(kBefore));
            emit m_grid.previewWithdrawn(id);
        }
    }
    return QStyledItemDelegate::eventFilter(object, event);
}

void PropertyDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const PropertyDescriptor* d = index.column() == 1 ? m_grid.descriptor(idOf(index)) : nullptr;
    const QColor chosen = d && !m_grid.isVarious(d->id) ? colorOf(*d, m_grid.value(d->id)) : QColor();
    if (!d || (d->kind != PropertyKind::Bool && d->kind != PropertyKind::Color && d->kind != PropertyKind::Action &&
               !chosen.isValid()))
        return QStyledItemDelegate::paint(painter, option, index);
    QStyleOptionViewItem plain(option);
    initStyleOption(&plain, index);
    plain.text.clear();
    QApplication::style()->drawControl(QStyle::CE_ItemViewItem, &plain, painter, &m_grid);
    const QRect box(option.rect.left() + 6, option.rect.center().y() - 7, 16, 16);
    const QVariant value = m_grid.value(d->id);
    const bool various = m_grid.isVarious(d->id);
    QString text = index.data().toString();
    if (d->kind == PropertyKind::Bool) {
        QStyleOptionButton check;
        check.rect = box;
        check.state =
            (d->isReadOnly ? QStyle::State_None : QStyle::State_Enabled) | (various          ? QStyle::State_NoChange
                                                                            : value.toBool() ? QStyle::State_On
                                                                                             : QStyle::State_Off);
        QApplication::style()->drawPrimitive(QStyle::PE_IndicatorCheckBox, &check, painter, &m_grid);
        if (!various) text.clear();
    } else if (d->kind == PropertyKind::Color || chosen.isValid()) {
        paintSwatch(*painter, QRectF(box), chosen.isValid() ? chosen : value.value<QColor>());
    } else {
        paintIcon(painter, QRectF(option.rect.right() - 20, option.rect.center().y() - 7, 16, 16), Icon::More);
    }
    painter->setPen(index.data(Qt::ForegroundRole).value<QBrush>().color());
    const int left = d->kind == PropertyKind::Action ? 5 : 28;
    painter->drawText(option.rect.adjusted(left, 0, -24, 0), Qt::AlignVCenter | Qt::AlignLeft,
                      option.fontMetrics.elidedText(text, Qt::ElideRight, option.rect.width() - left - 24));
}

} // namespace plc::kit
