#include "hmi/designer/context/keyed_text.h"

#include <QRegularExpression>

namespace plc::hmi {

namespace {

/// The part of `value` at "[2].text" or ".title"; null if there is none. The names of arguments ignore case.
Json* partAt(Json& value, const QString& path) {
    static const QRegularExpression step(QStringLiteral("\\[(\\d+)\\]|\\.?([^.\\[]+)"));
    Json* at = &value;
    for (auto found = step.globalMatch(path); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        if (match.hasCaptured(1)) {
            const size_t index = match.captured(1).toULongLong();
            if (!at->is_array() || index >= at->size()) return nullptr;
            at = &(*at)[index];
            continue;
        }
        if (!at->is_object()) return nullptr;
        Json* next = nullptr;
        for (auto it = at->begin(); it != at->end(); ++it)
            if (QString::fromStdString(it.key()).compare(match.captured(2), Qt::CaseInsensitive) == 0) next = &*it;
        if (!next) return nullptr;
        at = next;
    }
    return at;
}

} // namespace

Edit keyedText(const Finding& finding, const Panel& panel, const QString& panelName, DesignContext& context,
               QUndoStack& undo) {
    if (finding.kind != FindingKind::HardCodedText) return {};
    const Element* element = finding.element.isEmpty() ? nullptr : panel.find(finding.element);
    if (!element && !finding.element.isEmpty()) return {};
    const auto end = finding.property.indexOf(QRegularExpression(QStringLiteral("[.\\[]")));
    const std::string key = toUtf8(end < 0 ? finding.property : finding.property.left(end));
    Json value = element ? element->at(key) : panel.at(key);
    Json* text = partAt(value, end < 0 ? QString() : finding.property.mid(end));
    if (!text || !text->is_string()) return {};
    const QString typed = toQString(*text), stored = context.storeText({}, typed, panelName, undo);
    if (stored == typed) return {};
    *text = toUtf8(stored);
    return Edit{EditList{{setProperty(panel, finding.element, key, value)}}};
}

} // namespace plc::hmi
