// The families of rules behind checkStandard, and what they share: where findings go, which elements are operated or
// read. For the sources of the check; main thread.
#pragma once
#include "hmi/check/standard_check.h"

namespace plc::hmi {

/// Findings of one panel; a rule that the project has switched off says nothing.
class StandardFindings {
public:
    StandardFindings(const CheckInput& input, const NamedPanel& named) : m_input(input), m_named(named) {}

    void add(StandardRule rule, const ElementId& element, const QString& property, Message message, Edit fix = {});
    bool isChecked(StandardRule rule) const { return m_input.standard.isChecked(rule); }
    const CheckInput& input() const { return m_input; }
    const Panel& panel() const { return m_named.panel; }
    const QString& name() const { return m_named.name; }
    std::vector<Finding> take() { return std::move(m_found); }

private:
    const CheckInput& m_input;
    const NamedPanel& m_named;
    std::vector<Finding> m_found;
};

/// A contrast for messages: "4.4", never rounded up.
std::string ratioText(double contrast);
void checkColours(StandardFindings& out);
void checkSizes(StandardFindings& out);
void checkOverlaps(StandardFindings& out);
void checkOperation(StandardFindings& out);
void checkHint(StandardFindings& out);

/// What a finger touches.
bool isOperated(const Element& element);
/// Its binding is what it shows.
bool isDisplay(const Element& element);
/// The variable that it writes, or nothing.
QString writtenBy(const Element& element);
/// The panel is drawn by others and by itself shows nothing.
bool isFaceplate(const Panel& panel);
/// Hidden now and then, itself or with what it is in.
bool isSometimesHidden(const Panel& panel, const Element& element);

} // namespace plc::hmi
