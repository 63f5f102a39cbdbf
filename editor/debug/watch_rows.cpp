// The rows of the watch: their values, the parts of structures and long arrays, and what is prepared in them.
#include "editor/debug/watch_rows.h"

#include "editor/debug/watch_view.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"

#include <algorithm>
#include <map>

namespace plc::editor {

void WatchView::fillRow(QTreeWidgetItem* item) {
    if (expressionOf(item).isEmpty()) return; // a stretch of an array
    const QSignalBlocker blocker(m_tree);
    const RunControl::Shown shown = m_control.value(expressionOf(item), {}, formatOf(item));
    const kit::ThemeColors& c = kit::colors();
    const auto* program = m_control.imageProgram();
    const bool known = program && shown.type.isValid();
    const types::Type* type = known ? &(*program->layout.types)[shown.type] : nullptr;
    const bool aggregate = known && program->layout.types->isAggregate(shown.type);
    const QString text = !shown.reason.isEmpty()                             ? shown.reason
                         : aggregate && type->kind == types::TypeKind::Block ? QString()
                                                                             : shown.text.left(300);
    if (item->text(Value) != text) item->setText(Value, text);
    const QString typeName = type ? QString::fromStdString(type->name) : QString();
    if ((type || !shown.reason.isEmpty()) && item->text(Type) != typeName) item->setText(Type, typeName);
    item->setForeground(Value, !shown.reason.isEmpty() ? c.muted
                               : shown.isForced        ? c.forced
                               : shown.isBool          ? (shown.isTrue ? c.good : c.muted)
                                                       : c.text);
    item->setToolTip(Value, shown.reason.isEmpty() ? shown.text.left(2000) : shown.reason);
    item->setIcon(Value, shown.isForced ? kit::icon(kit::Icon::Force) : QIcon());
    item->setChildIndicatorPolicy(aggregate ? QTreeWidgetItem::ShowIndicator : QTreeWidgetItem::DontShowIndicator);
    const qulonglong unfolded = item->data(Name, kUnfoldedRole).toULongLong();
    if (known && unfolded && unfolded != program->version + 1) unfold(item); // another version, other parts
}

QTreeWidgetItem* WatchView::addPart(QTreeWidgetItem* parent, const QString& name, const QString& expression,
                                    types::TypeId type) {
    auto* row = new QTreeWidgetItem(parent, {name});
    row->setData(Name, kExpressionRole, expression);
    row->setFlags(row->flags() | Qt::ItemIsEditable);
    row->setChildIndicatorPolicy(m_control.imageProgram()->layout.types->isAggregate(type)
                                     ? QTreeWidgetItem::ShowIndicator
                                     : QTreeWidgetItem::DontShowIndicator);
    return row;
}

/// Elements from the one with this number; of a long array stretches that unfold in their turn.
void WatchView::unfoldArray(QTreeWidgetItem* item, const types::Type& type, const QString& base, uint64_t from) {
    uint64_t count = 1;
    for (const types::Dimension& d : type.dimensions) count *= d.count();
    const auto indexOf = [&](uint64_t element) {
        QStringList parts;
        for (size_t d = type.dimensions.size(); d-- > 0;) {
            const uint64_t size = type.dimensions[d].count();
            parts.prepend(QString::number(type.dimensions[d].low + static_cast<int64_t>(element % size)));
            element /= size;
        }
        return "[" + parts.join(", ") + "]";
    };
    if (count > kStretch && !item->data(Name, kFromRole).isValid()) {
        for (uint64_t first = 0; first < count; first += kStretch) {
            auto* stretch =
                new QTreeWidgetItem(item, {tr("%1 … %2", "stretch of an array")
                                               .arg(indexOf(first), indexOf(std::min(first + kStretch, count) - 1))});
            stretch->setData(Name, kFromRole, QVariant::fromValue<qulonglong>(first));
            stretch->setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
        }
        return;
    }
    for (uint64_t element = from; element < std::min(from + kStretch, count); ++element)
        addPart(item, indexOf(element), base + indexOf(element), type.element);
}

void WatchView::unfold(QTreeWidgetItem* item) {
    const auto* program = m_control.imageProgram();
    if (!program || item->data(Name, kUnfoldedRole).toULongLong() == program->version + 1) return;
    const bool isStretch = item->data(Name, kFromRole).isValid();
    const QString base = expressionOf(isStretch ? item->parent() : item);
    const RunControl::Shown shown = m_control.value(base);
    if (!shown.type.isValid()) return;
    const types::Type& type = (*program->layout.types)[shown.type];
    const QSignalBlocker blocker(m_tree);
    std::map<QString, std::pair<bool, QString>> before; // what the user had done with the parts
    for (int i = 0; i < item->childCount(); ++i)
        before[item->child(i)->text(Name)] = {item->child(i)->isExpanded(), item->child(i)->text(Prepared)};
    qDeleteAll(item->takeChildren());
    if (type.kind == types::TypeKind::Array) {
        unfoldArray(item, type, base, item->data(Name, kFromRole).toULongLong());
    } else {
        for (const types::Field& field : type.fields)
            if (!field.isPrivate) {
                const QString name = QString::fromStdString(field.name);
                addPart(item, name, base + "." + name, field.bit >= 0 ? types::TypeId() : field.type)
                    ->setText(Comment, QString::fromStdString(field.comment));
            }
    }
    item->setData(Name, kUnfoldedRole, QVariant::fromValue<qulonglong>(program->version + 1));
    for (int i = 0; i < item->childCount(); ++i) {
        QTreeWidgetItem* part = item->child(i);
        if (const auto it = before.find(part->text(Name)); it != before.end()) {
            part->setText(Prepared, it->second.second);
            if (it->second.first) {
                unfold(part);
                part->setExpanded(true);
            }
        }
        if (i < 100) fillRow(part); // the others when they come into sight
    }
}

// ------------------------------------------------------------------ prepared values

void WatchView::applyPrepared(bool force) {
    const auto apply = [&](auto&& self, QTreeWidgetItem* item) -> void {
        if (const QString prepared = item->text(Prepared).trimmed(); !prepared.isEmpty()) {
            const auto done =
                force ? m_control.force(expressionOf(item), prepared) : m_control.write(expressionOf(item), prepared);
            const QSignalBlocker blocker(m_tree);
            item->setToolTip(Prepared, done ? QString() : kit::messageText(done.error()));
            item->setForeground(Prepared, done ? kit::colors().text : kit::colors().bad);
            if (done) item->setText(Prepared, {});
        }
        for (int i = 0; i < item->childCount(); ++i) self(self, item->child(i));
    };
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) apply(apply, m_tree->topLevelItem(i));
}

/// First the other value, then the present one, then none.
void WatchView::togglePrepared(QTreeWidgetItem* item, bool isTrue) {
    const QString other = isTrue ? "FALSE" : "TRUE", same = isTrue ? "TRUE" : "FALSE";
    const QString prepared = item->text(Prepared).trimmed();
    item->setText(Prepared, prepared.isEmpty() ? other : prepared.compare(other, Qt::CaseInsensitive) == 0 ? same : "");
}

/// A double click on a value: a BOOL is prepared to be the other, of anything else the value is there to be changed.
void WatchView::prepare(QTreeWidgetItem* item) {
    const RunControl::Shown shown = m_control.value(expressionOf(item));
    if (shown.text.isEmpty() || item->childIndicatorPolicy() == QTreeWidgetItem::ShowIndicator) return;
    if (shown.isBool) return togglePrepared(item, shown.isTrue);
    if (item->text(Prepared).isEmpty()) item->setText(Prepared, shown.text);
    m_tree->editItem(item, Prepared);
}

void WatchView::checkPrepared(QTreeWidgetItem* item) {
    const QString prepared = item->text(Prepared).trimmed();
    const bool isChecked = m_control.session() && !prepared.isEmpty();
    const auto value = isChecked ? m_control.parse(expressionOf(item), prepared) : Result<types::Value>(types::Value());
    const QSignalBlocker blocker(m_tree);
    item->setToolTip(Prepared, value ? QString() : kit::messageText(value.error()));
    item->setForeground(Prepared, value ? kit::colors().text : kit::colors().bad);
}

} // namespace plc::editor
