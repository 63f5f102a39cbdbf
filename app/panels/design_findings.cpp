#include "app/panels/design_findings.h"

#include "app/panels/live_views.h"
#include "editor/kit/message_text.h"
#include "hmi/station/recipe_transfer.h"

#include <algorithm>

namespace plc::app {

DesignFindings::DesignFindings(LiveViews& live, ProblemsView& problems, QObject* parent)
    : QObject(parent), m_live(live), m_problems(problems) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(600);
    connect(&m_pause, &QTimer::timeout, this, &DesignFindings::begin);
    connect(&m_turn, &QTimer::timeout, this, &DesignFindings::continueCheck);
    connect(&live, &LiveViews::designEdited, this, &DesignFindings::schedule);
    connect(&live, &LiveViews::panelsChanged, this, &DesignFindings::schedule);
    connect(&live, &LiveViews::designsMustClose, this, [this] {
        m_turn.stop();
        m_input = {};
        schedule();
    });
}

/// Files, lines and elements that could not be read.
std::vector<PanelProblem> DesignFindings::problems() const {
    std::vector<PanelProblem> out;
    for (const Error& each : m_live.panels().problems) {
        const QString place = QString::fromStdString(each.place);
        bool hasLine = false;
        const int line = place.section(':', -1).toInt(&hasLine);
        out.push_back({m_live.panels().placeOf(hasLine ? place.section(':', 0, -2) : place),
                       kit::messageText(each.message), hasLine ? line : 0});
    }
    return out;
}

PanelProblem DesignFindings::problemOf(const QString& file) const {
    for (const PanelProblem& each : problems())
        if (each.file == file) return each;
    return {};
}

void DesignFindings::begin() {
    m_turn.stop();
    m_found.clear();
    m_next = 0;
    if (!m_live.design()) return m_problems.setOtherProblems({});
    m_input = m_live.design()->checkInput();
    m_turn.start(0);
}

void DesignFindings::continueCheck() {
    const auto take = [this](std::vector<hmi::Finding> found) {
        m_found.insert(m_found.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
    };
    if (m_next < m_input.panels.size()) {
        take(hmi::checkPanel(m_input, m_input.panels[m_next++]));
        return;
    }
    m_turn.stop();
    // Tables, alarms and fonts need all panels at once; what they say of single panels is known already.
    std::vector<hmi::Finding> rest = hmi::checkPanels(m_input);
    std::erase_if(rest, [](const hmi::Finding& each) { return each.file.endsWith(".panel.json"); });
    take(std::move(rest));
    const hmi::PanelProject& project = m_live.panels();
    take(hmi::recipeFindings(project.recipes, m_live.design()->checked(), project.placeOf(project.recipesPath())));
    std::stable_sort(m_found.begin(), m_found.end(),
                     [](const hmi::Finding& a, const hmi::Finding& b) { return a.isError > b.isError; });
    std::vector<OtherProblem> problems;
    for (const PanelProblem& each : this->problems()) {
        const QString place = each.line ? QString("%1:%2").arg(each.file).arg(each.line) : each.file;
        problems.push_back({"H1000", each.message, place, true, each.file, {}, {}});
    }
    for (const hmi::Finding& each : m_found) {
        QString place = each.file;
        if (each.line > 0) place += QString(":%1").arg(each.line);
        if (!each.element.isEmpty())
            place += "  " + each.element + (each.property.isEmpty() ? "" : "." + each.property);
        if (!each.language.isEmpty()) place += "  [" + each.language + "]";
        problems.push_back({each.code(), kit::messageText(each.message), place, each.isError, each.file, each.element,
                            kit::messageText(each.why)});
    }
    m_problems.setOtherProblems(std::move(problems));
    m_input = {};
}

} // namespace plc::app
