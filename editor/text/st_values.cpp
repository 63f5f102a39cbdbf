// The values of the controller beside the text of StEditor: what of them is visible, and how they are drawn.
#include "editor/text/st_editor.h"

#include "editor/kit/theme.h"
#include "editor/text/st_marks.h"

#include <QPainter>

#include <algorithm>
#include <map>

namespace plc::editor {

using S = QsciScintillaBase;

void StEditor::setOnlineValues(OnlineValues values) {
    m_onlineValues = std::move(values);
    refreshOnlineValues();
}

namespace {

/// a.b[i].c is one value: the chain that ends with this name and its indices, unless another member follows. Where it
/// begins, and its length.
std::optional<std::pair<uint32_t, uint32_t>> valueChain(const std::string& text, SourceRange name, uint32_t lineBegin,
                                                        uint32_t lineEnd) {
    const auto isWord = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)); };
    uint32_t from = name.begin;
    while (from > lineBegin) {
        const char before = text[from - 1];
        if (before == ']') { // over the indices
            uint32_t at = from - 1;
            for (int depth = 1; at > lineBegin && depth > 0;) {
                --at;
                depth += text[at] == ']' ? 1 : text[at] == '[' ? -1 : 0;
            }
            from = at;
        } else if (before == '.' || before == '^' || isWord(before)) {
            --from;
        } else {
            break;
        }
    }
    uint32_t to = name.end;
    while (to < lineEnd && (text[to] == '[' || text[to] == '^')) {
        int depth = 0;
        do depth += text[to] == '[' ? 1 : text[to] == ']' ? -1 : 0;
        while (++to < lineEnd && depth > 0);
        if (depth > 0) return std::nullopt; // goes on in the next line
    }
    if (to < text.size() && text[to] == '.') return std::nullopt;
    return std::pair(from, to - from);
}

} // namespace

void StEditor::findDeclared() {
    m_declared.clear();
    const auto file = fileId();
    if (!file) return;
    for (const sema::Symbol& symbol : m_model->checked().analysis->symbols)
        if (symbol.kind == sema::SymbolKind::Variable && symbol.declaration.file == *file && !symbol.isConstant &&
            !symbol.name.starts_with("__"))
            m_declared.push_back(&symbol);
    std::sort(m_declared.begin(), m_declared.end(),
              [](const sema::Symbol* a, const sema::Symbol* b) { return a->declaration.begin < b->declaration.begin; });
}

std::optional<StEditor::NamedValue> StEditor::variableAt(uint32_t at) const {
    const auto file = fileId();
    if (!file || !m_isAsAnalysed) return std::nullopt;
    const auto symbol = m_model->symbolAt(*file, at);
    if (!symbol || m_model->symbol(*symbol).kind != sema::SymbolKind::Variable) return std::nullopt;
    const auto isWord = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)); };
    uint32_t begin = at, end = at;
    while (begin > 0 && isWord(m_analysedText[begin - 1])) --begin;
    while (end < m_analysedText.size() && isWord(m_analysedText[end])) ++end;
    const size_t lineBegin = begin == 0 ? 0 : m_analysedText.rfind('\n', begin - 1) + 1;
    const size_t lineEnd = std::min(m_analysedText.find('\n', end), m_analysedText.size());
    const auto chain = valueChain(m_analysedText + " ", {*file, begin, end}, static_cast<uint32_t>(lineBegin),
                                  static_cast<uint32_t>(lineEnd));
    const auto [from, length] = chain.value_or(std::pair(begin, end - begin));
    return NamedValue{QString::fromStdString(m_analysedText.substr(from, length)),
                      QString::fromStdString(m_model->pouAt(*file, at))};
}

std::optional<StEditor::NamedValue> StEditor::askedAbout() const {
    const auto file = fileId();
    const QString selected = selectedText().trimmed();
    if (!selected.isEmpty() && !selected.contains(u'\n') && file && m_isAsAnalysed)
        return NamedValue{selected, QString::fromStdString(m_model->pouAt(*file, cursorOffset()))};
    return variableAt(cursorOffset());
}

void StEditor::findShownValues() {
    m_shownValues.clear();
    const auto file = fileId();
    if (m_onlineValues && m_settings.showOnlineValues && file && m_isAsAnalysed) {
        const long top = SendScintilla(S::SCI_GETFIRSTVISIBLELINE), count = SendScintilla(S::SCI_LINESONSCREEN);
        const auto& references = m_model->checked().analysis->references;
        auto declared = m_declared.begin();
        for (long visible = top; visible <= top + count; ++visible) {
            const long line = SendScintilla(S::SCI_DOCLINEFROMVISIBLE, static_cast<unsigned long>(visible));
            const auto begin = static_cast<uint32_t>(
                           SendScintilla(S::SCI_POSITIONFROMLINE, static_cast<unsigned long>(line))),
                       end = static_cast<uint32_t>(
                           SendScintilla(S::SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line)));
            auto it = std::lower_bound(
                references.begin(), references.end(), std::pair(*file, begin),
                [](const sema::Reference& r, const auto& key) { return std::pair(r.range.file, r.range.begin) < key; });
            std::vector<std::pair<QString, QString>> wanted;
            for (; declared != m_declared.end() && (*declared)->declaration.begin < end; ++declared)
                if ((*declared)->declaration.begin >= begin)
                    wanted.emplace_back(QString::fromStdString((*declared)->name),
                                        QString::fromStdString((*declared)->owner));
            for (; !m_exact && it != references.end() && it->range.file == *file && it->range.begin < end; ++it) {
                if (!it->symbol.isValid()) continue;
                const sema::Symbol& symbol = m_model->symbol(it->symbol);
                if (symbol.kind != sema::SymbolKind::Variable || symbol.isConstant || symbol.name.starts_with("__"))
                    continue;
                // a.b.c is one value: the chain that ends here, unless another member follows.
                const auto chain = valueChain(m_analysedText, it->range, begin, end);
                if (!chain) continue;
                const std::pair entry(QString::fromStdString(m_analysedText.substr(chain->first, chain->second)),
                                      QString::fromStdString(m_model->pouAt(*file, it->range.begin)));
                if (std::find(wanted.begin(), wanted.end(), entry) == wanted.end()) wanted.push_back(entry);
            }
            std::vector<OnlineValue> values;
            if (!wanted.empty()) values = m_onlineValues(wanted);
            auto result =
                std::lower_bound(m_accumulators.begin(), m_accumulators.end(), begin,
                                 [](const analysis::AccumulatorPlace& place, uint32_t at) { return place.at < at; });
            const bool isInstruction = result != m_accumulators.end() && result->at <= end;
            for (OnlineValue& exact : exactValues(begin, end)) {
                if (isInstruction && exact.name.contains(u' ')) continue; // "LD  Start": shown as the result
                if (!exact.loop) {
                    const auto now =
                        m_onlineValues({{exact.name, QString::fromStdString(m_model->pouAt(*file, begin))}});
                    exact.isForced = !now.empty() && now.front().isForced;
                }
                values.push_back(std::move(exact));
            }
            for (; result != m_accumulators.end() && result->at <= end; ++result) { // the last one of the line counts
                if (!isRun(result->at)) continue;
                auto shown = m_onlineValues({{QString::fromStdString(result->expression),
                                              QString::fromStdString(m_model->pouAt(*file, result->at))}});
                if (shown.empty()) continue;
                if (const auto* exact = exactResult(result->at)) {
                    shown.front().value = exact->text;
                    shown.front().isTrue = exact->isTrue;
                }
                if (!values.empty() && values.front().isAccumulator) values.erase(values.begin());
                shown.front().name = tr("CR", "current result of an instruction list");
                shown.front().isAccumulator = true;
                values.insert(values.begin(), std::move(shown.front()));
            }
            if (!values.empty()) m_shownValues.emplace_back(static_cast<int>(line), std::move(values));
        }
    }
}

void StEditor::refreshOnlineValues() {
    const auto before = m_shownValues;
    atShownMoment([this] { findShownValues(); });
    if (before == m_shownValues) return;
    // Only the lines whose values changed are painted again.
    QRegion changed;
    const auto add = [&](const auto& values, const auto& others) {
        for (const auto& shown : values) {
            if (std::find(others.begin(), others.end(), shown) != others.end()) continue;
            const long at = SendScintilla(S::SCI_POSITIONFROMLINE, static_cast<unsigned long>(shown.first));
            changed +=
                QRect(0, static_cast<int>(SendScintilla(S::SCI_POINTYFROMPOSITION, 0ul, at)), viewport()->width(),
                      static_cast<int>(SendScintilla(S::SCI_TEXTHEIGHT, static_cast<unsigned long>(shown.first))));
        }
    };
    add(m_shownValues, before);
    add(before, m_shownValues);
    viewport()->update(changed);
}

void StEditor::paintEvent(QPaintEvent* event) {
    QsciScintilla::paintEvent(event);
    if (m_shownValues.empty()) return;
    QPainter painter(viewport());
    drawOnlineValues(painter);
}

namespace {
/// The last member, with its indices whole.
QString shortName(const QString& chain) {
    int depth = 0;
    for (qsizetype i = chain.size(); i-- > 0;) {
        depth += chain[i] == ']' ? 1 : chain[i] == '[' ? -1 : 0;
        if (depth == 0 && chain[i] == '.') return chain.mid(i + 1);
    }
    return chain;
}
} // namespace

void StEditor::drawOnlineValues(QPainter& painter) {
    const kit::ThemeColors& c = kit::colors();
    m_passBoxes.clear();
    QFont font = m_lexer->defaultFont(0);
    font.setPointSizeF(std::max(6.0, font.pointSizeF() - 1 + static_cast<double>(SendScintilla(S::SCI_GETZOOM))));
    painter.setFont(font);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetrics metrics(font);
    // The results of an instruction list stand under each other: a column that is read downwards.
    std::map<int, int> columns; // line → x
    const auto endOf = [&](int line) {
        return static_cast<int>(
                   SendScintilla(S::SCI_POINTXFROMPOSITION, 0ul,
                                 SendScintilla(S::SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line)))) +
               24;
    };
    for (size_t i = 0; i < m_shownValues.size();) {
        size_t next = i;
        int x = 0;
        while (next < m_shownValues.size() && m_shownValues[next].second.front().isAccumulator &&
               m_shownValues[next].first <= m_shownValues[i].first + static_cast<int>(next - i) + 3)
            x = std::max(x, endOf(m_shownValues[next++].first));
        for (size_t k = i; k < next && x < viewport()->width() * 2 / 3; ++k)
            columns[m_shownValues[k].first] = x; // not beyond long comments
        i = std::max(next, i + 1);
    }
    for (const auto& [line, values] : m_shownValues) {
        const auto end = SendScintilla(S::SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line));
        const auto column = columns.find(line);
        int x = column != columns.end() ? column->second : endOf(line);
        const int y = static_cast<int>(SendScintilla(S::SCI_POINTYFROMPOSITION, 0ul, end)),
                  height = static_cast<int>(SendScintilla(S::SCI_TEXTHEIGHT, static_cast<unsigned long>(line)));
        for (const OnlineValue& value : values) {
            const bool isNamed = values.size() > 1 || value.isAccumulator || value.loop;
            const QString name = isNamed ? shortName(value.name) + " " : QString();
            const QString shown = value.loop               ? QStringLiteral("◂ %1 ▸").arg(value.value)
                                  : value.before.isEmpty() ? value.value
                                                           : QStringLiteral("%1 → %2").arg(value.before, value.value);
            const int nameWidth = metrics.horizontalAdvance(name), valueWidth = metrics.horizontalAdvance(shown);
            const QRectF box(x, y + 1.5, nameWidth + valueWidth + 10, height - 3);
            if (value.loop) m_passBoxes.emplace_back(box.toAlignedRect(), *value.loop);
            QColor ground = value.isForced ? c.forced : value.isBool ? (value.isTrue ? c.good : c.muted) : c.online;
            QColor fill = ground;
            fill.setAlpha(value.isForced ? 90 : 38);
            painter.setPen(Qt::NoPen);
            painter.setBrush(fill);
            painter.drawRoundedRect(box, 4, 4);
            if (value.isAccumulator) { // a frame of its own, so that the column of results is read downwards
                painter.setPen(QPen(ground, 1));
                painter.setBrush(Qt::NoBrush);
                painter.drawRoundedRect(box, 4, 4);
            }
            painter.setPen(c.muted);
            painter.drawText(QRectF(x + 5, y, nameWidth, height), Qt::AlignVCenter | Qt::AlignLeft, name);
            painter.setPen(value.isBool && !value.isTrue && !value.isForced ? c.text
                           : value.isForced                                 ? c.text
                                                                            : ground.darker(c.dark ? 90 : 125));
            painter.drawText(QRectF(x + 5 + nameWidth, y, valueWidth + 2, height), Qt::AlignVCenter | Qt::AlignLeft,
                             shown);
            x += static_cast<int>(box.width()) + 6;
        }
    }
}

} // namespace plc::editor
