// What a recorded scan did in the text of StEditor: exact values, conditions, dimmed statements, passes of loops.
#include "editor/text/st_editor.h"

#include "editor/text/st_marks.h"

#include <algorithm>
#include <map>

namespace plc::editor {

using S = QsciScintillaBase;

namespace {
constexpr int kCoverageWidth = 6;
}

void StEditor::setExactText(std::optional<ExactText> exact, AtMoment atMoment) {
    const bool isSame = exact == m_exact;
    if (isSame && !atMoment && !m_atMoment) return;
    m_exact = std::move(exact);
    m_atMoment = std::move(atMoment);
    if (!isSame) showExactMarks();
    refreshOnlineValues();
}

void StEditor::atShownMoment(const std::function<void()>& read) const {
    if (m_exact && m_atMoment)
        m_atMoment(read);
    else
        read();
}

std::pair<uint32_t, uint32_t> StEditor::visibleRange() const {
    const long top = SendScintilla(S::SCI_GETFIRSTVISIBLELINE), count = SendScintilla(S::SCI_LINESONSCREEN);
    const auto lineAt = [&](long visible) {
        return static_cast<unsigned long>(
            SendScintilla(S::SCI_DOCLINEFROMVISIBLE, static_cast<unsigned long>(std::max(0L, visible))));
    };
    const long end = SendScintilla(S::SCI_GETLINEENDPOSITION, lineAt(top + count + 1));
    return {static_cast<uint32_t>(SendScintilla(S::SCI_POSITIONFROMLINE, lineAt(top))), static_cast<uint32_t>(end)};
}

void StEditor::showExactMarks() {
    const auto length = SendScintilla(S::SCI_GETLENGTH);
    for (const int indicator : {int(kNotRun), int(kHeld), int(kNotHeld)}) {
        SendScintilla(S::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(indicator));
        SendScintilla(S::SCI_INDICATORCLEARRANGE, 0ul, static_cast<long>(length));
    }
    if (!m_exact) return;
    const auto fill = [&](int indicator, uint32_t begin, uint32_t end) {
        SendScintilla(S::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(indicator));
        SendScintilla(S::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(begin), static_cast<long>(end - begin));
    };
    for (const auto& [begin, end] : m_exact->notRun) fill(kNotRun, begin, end);
    for (const ExactText::Condition& condition : m_exact->conditions)
        fill(condition.isTrue ? kHeld : kNotHeld, condition.begin, condition.end);
}

/// The values of a line: each variable once, in the order of the text, with what it was before where the line changed
/// it; passes of its loops.
std::vector<OnlineValue> StEditor::exactValues(uint32_t begin, uint32_t end) const {
    std::vector<OnlineValue> values;
    if (!m_exact) return values;
    std::map<QString, uint32_t> places;
    for (const ExactText::Loop& loop : m_exact->loops) {
        if (loop.begin < begin || loop.begin >= end) continue;
        OnlineValue value;
        value.name = tr("pass", "of a loop");
        value.value = tr("%1 of %2").arg(loop.pass + 1).arg(loop.count);
        value.loop = loop.begin;
        values.push_back(std::move(value));
    }
    for (const ExactText::Value& each : m_exact->values) {
        if (each.begin < begin || each.begin >= end || each.end > m_analysedText.size()) continue;
        const QString name = QString::fromStdString(m_analysedText.substr(each.begin, each.end - each.begin));
        const uint32_t first = places.try_emplace(name, each.begin).first->second;
        places[name] = std::min(first, each.begin);
        auto known = std::find_if(values.begin(), values.end(),
                                  [&](const OnlineValue& value) { return value.name == name && !value.loop; });
        if (known == values.end()) {
            OnlineValue fresh;
            fresh.name = name;
            fresh.value = each.text;
            fresh.isBool = each.isBool;
            fresh.isTrue = each.isTrue;
            values.push_back(std::move(fresh));
            continue;
        }
        if (known->value == each.text) continue;
        if (known->before.isEmpty()) known->before = known->value;
        known->value = each.text;
        known->isTrue = each.isTrue;
    }
    // They come in the order of their computation: of an assignment the right side first.
    std::stable_sort(values.begin(), values.end(), [&](const OnlineValue& a, const OnlineValue& b) {
        if (bool(a.loop) != bool(b.loop)) return bool(a.loop);
        return !a.loop && places[a.name] < places[b.name];
    });
    return values;
}

/// What an instruction came to; null: not known.
const ExactText::Value* StEditor::exactResult(uint32_t at) const {
    if (!m_exact) return nullptr;
    const auto found = m_exact->results.find(at);
    return found == m_exact->results.end() ? nullptr : &found->second;
}

void StEditor::setCoverage(const std::map<int, LineCoverage>& lines) {
    for (const int marker : {int(kCovered), int(kPartlyCovered), int(kNotCovered)}) markerDeleteAll(marker);
    m_coverage.clear();
    setMarginWidth(kCoverage, lines.empty() ? 0 : kCoverageWidth);
    for (const auto& [line, coverage] : lines) {
        const int marker = coverage.state == LineCoverage::State::Run      ? kCovered
                           : coverage.state == LineCoverage::State::Partly ? kPartlyCovered
                                                                           : kNotCovered;
        m_coverage[markerAdd(line - 1, marker)] = coverage;
    }
}

std::optional<LineCoverage> StEditor::coverageOf(int line) const {
    for (const auto& [handle, coverage] : m_coverage)
        if (markerLine(handle) == line) return coverage;
    return std::nullopt;
}

QString StEditor::coverageAt(int line) const {
    const auto coverage = coverageOf(line);
    return coverage ? coverage->text : QString();
}

bool StEditor::isRun(uint32_t at) const {
    return !m_exact || std::none_of(m_exact->notRun.begin(), m_exact->notRun.end(),
                                    [&](const auto& range) { return range.first <= at && at <= range.second; });
}

/// A click on the passes of a loop: on its left half to the pass before, else to the next.
bool StEditor::clickPass(const QPoint& at) {
    for (const auto& [box, loop] : m_passBoxes) {
        if (!box.contains(at) || !m_exact) continue;
        for (const ExactText::Loop& each : m_exact->loops) {
            if (each.begin != loop) continue;
            const bool back = at.x() < box.center().x();
            if (back && each.pass > 0) emit passRequested(loop, each.pass - 1);
            if (!back && each.pass + 1 < each.count) emit passRequested(loop, each.pass + 1);
        }
        return true;
    }
    return false;
}

} // namespace plc::editor
