#include "hmi/designer/editors/choice_cell.h"

#include "editor/kit/word_list.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>

namespace plc::hmi {

namespace {
constexpr const char* kTyped = "typed"; // the text before something was chosen, which replaces it

/// Choosing adds a name or takes it away, which the arrow keys must not do in passing: they open the list.
class ListCombo final : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Down) return showPopup();
        QComboBox::keyPressEvent(event);
    }
    void wheelEvent(QWheelEvent*) override {}
};
} // namespace

ChoiceCell::ChoiceCell(std::function<QStringList()> choices, Takes takes, QObject* parent)
    : QStyledItemDelegate(parent), m_choices(std::move(choices)), m_takes(takes) {}

QWidget* ChoiceCell::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
    auto* combo = m_takes == Takes::One ? new QComboBox(parent) : new ListCombo(parent);
    combo->setEditable(true);
    combo->setInsertPolicy(QComboBox::NoInsert);
    combo->setFrame(false);
    combo->addItems(m_choices());
    combo->lineEdit()->setAccessibleName(index.model()->headerData(index.column(), Qt::Horizontal).toString());
    if (m_takes == Takes::One) return combo;
    combo->setCompleter(nullptr); // it would complete the whole list of names, not the last of them
    connect(combo->lineEdit(), &QLineEdit::textEdited, combo,
            [combo](const QString& text) { combo->setProperty(kTyped, text); });
    connect(combo, &QComboBox::textActivated, combo, [combo](const QString& name) {
        const QString list = kit::withToggled(combo->property(kTyped).toString(), name);
        combo->setProperty(kTyped, list);
        combo->setEditText(list);
    });
    return combo;
}

void ChoiceCell::setEditorData(QWidget* editor, const QModelIndex& index) const {
    auto* combo = qobject_cast<QComboBox*>(editor);
    const QString text = index.data(Qt::EditRole).toString();
    combo->setProperty(kTyped, text);
    combo->setCurrentIndex(combo->findText(text, Qt::MatchFixedString));
    combo->setEditText(text);
    combo->lineEdit()->selectAll();
}

void ChoiceCell::setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const {
    model->setData(index, qobject_cast<QComboBox*>(editor)->currentText());
}

} // namespace plc::hmi
