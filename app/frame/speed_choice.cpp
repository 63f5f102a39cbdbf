#include "app/frame/speed_choice.h"

#include "app/frame/status_line.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QInputDialog>

#include <algorithm>
#include <optional>

namespace plc::app {

namespace {
/// It speaks as part of the window.
struct SpeedWords {
    Q_DECLARE_TR_FUNCTIONS(plc::app::MainWindow)
};

/// What was chosen or typed; nullopt: cancelled.
std::optional<QString> askSpeed(QWidget* parent, const QStringList& choices, int present) {
    QInputDialog dialog(parent);
    dialog.setWindowTitle(SpeedWords::tr("Speed"));
    dialog.setLabelText(SpeedWords::tr("Speed of the controller; any factor can be entered:"));
    dialog.setComboBoxItems(choices);
    dialog.setComboBoxEditable(true);
    dialog.setTextValue(choices[present]);
    // A completion would take the first Enter for itself.
    if (auto* box = dialog.findChild<QComboBox*>()) box->setCompleter(nullptr);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return dialog.textValue().trimmed();
}
} // namespace

SpeedChoice chooseSpeed(QWidget* parent, session::RunMode now) {
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
    const std::optional<QString> answer = askSpeed(parent, choices, static_cast<int>(present - modes.begin()));
    if (!answer) return {};
    const QString& chosen = *answer;
    if (const auto index = choices.indexOf(chosen); index >= 0 && index < static_cast<int>(modes.size()))
        return {modes[static_cast<size_t>(index)], {}};
    const QString number = QString(chosen).remove(QChar(0xD7)).remove('x').replace(',', '.').trimmed();
    bool isNumber = false;
    const double factor = number.toDouble(&isNumber);
    if (!isNumber || !(factor >= 0.001 && factor <= 10'000))
        return {{}, SpeedWords::tr("The speed is a factor from 0.001 to 10000")};
    return {session::RunMode{factor == 1.0 ? session::Pace::Real : session::Pace::Factor, factor}, {}};
}

} // namespace plc::app
