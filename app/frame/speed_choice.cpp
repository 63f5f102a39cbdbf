#include "app/frame/speed_choice.h"

#include "app/frame/status_line.h"
#include "editor/kit/inputs/text_question.h"

#include <QComboBox>
#include <QCoreApplication>

#include <algorithm>
#include <optional>

namespace plc::app {

namespace {
/// It speaks as part of the window.
struct SpeedWords {
    Q_DECLARE_TR_FUNCTIONS(plc::app::MainWindow)
};

/// The factor in what was typed: comma and letter as people type them.
std::optional<session::RunMode> factorIn(const QString& typed) {
    const QString number = QString(typed).remove(QChar(0xD7)).remove('x').replace(',', '.').trimmed();
    bool isNumber = false;
    const double factor = number.toDouble(&isNumber);
    if (!isNumber || !(factor >= 0.001 && factor <= 10'000)) return std::nullopt;
    return session::RunMode{factor == 1.0 ? session::Pace::Real : session::Pace::Factor, factor};
}
} // namespace

std::optional<session::RunMode> chooseSpeed(QWidget* parent, session::RunMode now) {
    std::vector<session::RunMode> modes;
    for (const double factor : {0.1, 0.5, 1.0, 2.0, 5.0, 10.0, 100.0})
        modes.push_back({factor == 1.0 ? session::Pace::Real : session::Pace::Factor, factor});
    modes.push_back({session::Pace::Fastest, 1.0});
    QStringList choices;
    for (const session::RunMode& mode : modes)
        choices << (mode.pace == session::Pace::Real      ? SpeedWords::tr("Real time")
                    : mode.pace == session::Pace::Fastest ? SpeedWords::tr("As fast as possible")
                                                          : StatusLine::speedText(mode));
    const auto present = std::find_if(modes.begin(), modes.end(), [&](const session::RunMode& each) {
        return each.pace == now.pace && (each.pace != session::Pace::Factor || each.factor == now.factor);
    });
    if (present == modes.end()) choices << StatusLine::speedText(now);

    std::optional<session::RunMode> chosen;
    const auto take = [&](const QString& text) {
        const auto index = choices.indexOf(text);
        chosen =
            index >= 0 && index < static_cast<int>(modes.size()) ? modes[static_cast<size_t>(index)] : factorIn(text);
        return chosen ? QString() : SpeedWords::tr("The speed is a factor from 0.001 to 10000");
    };
    kit::TextQuestion question(SpeedWords::tr("Speed"),
                               SpeedWords::tr("Speed of the controller; any factor can be entered:"), {}, take, parent);
    question.setComboBoxItems(choices);
    question.setComboBoxEditable(true);
    question.setTextValue(choices[present - modes.begin()]);
    // A completion would take the first Enter for itself.
    if (auto* box = question.findChild<QComboBox*>()) box->setCompleter(nullptr);
    return question.ask() ? chosen : std::nullopt;
}

} // namespace plc::app
