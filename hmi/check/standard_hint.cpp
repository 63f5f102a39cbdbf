// Whether a start panel says what to press when nothing moves: a sentence, or a state text that names a control.
#include "hmi/check/standard_parts.h"
#include "hmi/model/errors.h"
#include "hmi/model/walk.h"

#include <QRegularExpression>
#include <QSet>

#include <algorithm>

namespace plc::hmi {

namespace {

constexpr int kFewControls = 2; // start and stop say by themselves what there is to press

/// Chinese and Japanese are written without spaces.
bool hasNoSpaces(const QString& text) {
    constexpr ushort FirstOfEastAsia = 0x2E80;
    return std::any_of(text.begin(), text.end(), [](const QChar c) { return c.unicode() >= FirstOfEastAsia; });
}

QStringList wordsOf(const QString& text) {
    static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{M}\\p{N}]+"));
    return text.toLower().split(between, Qt::SkipEmptyParts);
}

/// Titles and captions do not end with a full stop.
bool isSentence(const QString& text) {
    static const QString ends = QStringLiteral(".!?…。！？।؟۔");
    constexpr int Words = 4, Signs = 8;
    const QString line = text.trimmed();
    if (line.isEmpty() || !ends.contains(line.back())) return false;
    return hasNoSpaces(line) ? line.size() >= Signs : wordsOf(line).size() >= Words;
}

/// What is written on the controls: "s1" of "S1 · one journey".
class Captions {
public:
    void add(const QString& caption) {
        if (hasNoSpaces(caption)) {
            m_whole += caption;
            return;
        }
        constexpr int Letters = 2;
        const QStringList words = wordsOf(caption);
        if (!words.isEmpty() && words.front().size() >= Letters) m_first += words.front();
    }

    bool areNamedIn(const QString& line) const {
        const QStringList words = wordsOf(line);
        constexpr int Least = 2; // "Start" alone is the name of a state
        return (words.size() >= Least &&
                std::any_of(words.begin(), words.end(), [&](const QString& word) { return m_first.contains(word); })) ||
               std::any_of(m_whole.begin(), m_whole.end(),
                           [&](const QString& one) { return line != one && line.contains(one); });
    }

private:
    QSet<QString> m_first;
    QStringList m_whole;
};

class HintSearch {
public:
    explicit HintSearch(const CheckInput& input)
        : m_input(input), m_panels(input.panelLookup()), m_language(input.texts.settings().languages.value(0)) {}

    void look(const Panel& panel) {
        for (const Element& element : panel.elements()) {
            look(element);
            if (element.kind() == ElementKind::Faceplate)
                for (const Element& inner : contentsOf(element, m_panels)) look(inner);
        }
    }

    int controls() const { return m_controls; }

    bool found() const {
        return m_hasSentence || std::any_of(m_states.begin(), m_states.end(),
                                            [&](const QString& line) { return m_captions.areNamedIn(line); });
    }

private:
    void look(const Element& element) {
        const bool isControl = !writtenBy(element).isEmpty();
        m_controls += isControl;
        const bool changes = element.kind() == ElementKind::MultiState || !element.text("visible").isEmpty();
        forEachText(element, [&](const Found& text) {
            const QString words = m_input.texts.text(text.text, m_language);
            if (isControl)
                m_captions.add(words);
            else if (changes)
                m_states += words;
            m_hasSentence = m_hasSentence || (!isControl && isSentence(words));
        });
    }

    const CheckInput& m_input;
    const PanelLookup m_panels;
    const QString m_language; // the first: “marche” is a state in French and a caption, too
    int m_controls = 0;
    bool m_hasSentence = false;
    QStringList m_states;
    Captions m_captions;
};

bool isStart(const CheckInput& input, const QString& panel) {
    return panel == input.startPanel || input.startPanels.contains(panel);
}

} // namespace

void checkHint(StandardFindings& out) {
    const CheckInput& input = out.input();
    if (!out.isChecked(StandardRule::NothingSaysWhatToPress) || !isStart(input, out.name())) return;
    HintSearch search(input);
    search.look(out.panel());
    const int controls = search.controls();
    if (controls <= kFewControls) return;
    for (const NamedPanel& one : input.panels)
        if (one.name == input.frame) search.look(one.panel);
    if (!search.found())
        out.add(StandardRule::NothingSaysWhatToPress, {}, {}, errors::NothingSaysWhatToPress(controls));
}

} // namespace plc::hmi
