#include "editor/kit/ask_why.h"

#include "editor/kit/errors.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"

#include <QMenu>

namespace plc::kit {

void addWhyActions(QMenu& menu, const std::function<void(AskWhy)>& ask, QAction* before, const QString& language) {
    const auto add = [&](Icon which, const Message& text, const char* name, AskWhy question) {
        auto* action = new QAction(icon(which), messageText(text, language), &menu);
        action->setObjectName(name);
        QObject::connect(action, &QAction::triggered, &menu, [ask, question] { ask(question); });
        menu.insertAction(before, action);
    };
    add(Icon::Question, errors::AskWhy(), "askWhy", AskWhy::Why);
    add(Icon::Lightbulb, errors::AskWhyNot(), "askWhyNot", AskWhy::WhyNot);
    add(Icon::Write, errors::AskWho(), "askWho", AskWhy::Who);
}

} // namespace plc::kit
