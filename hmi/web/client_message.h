// What a browser may say, parsed from a text that anybody may have sent: a message of this list with sound values, or
// nothing. Values; any thread.
#pragma once
#include <QByteArrayView>
#include <QPointF>
#include <QString>

#include <optional>

namespace plc::hmi::web {

enum class ClientWord : uint8_t {
    Hello,    // text: panel, more: language, number: pixels of the screen per pixel of the panel
    Drawn,    // number: of the frame that is on the screen
    Down,     // at
    Move,     // at
    Up,       // at
    Cancel,   // the finger or the window went away
    Wheel,    // at, number: steps
    Key,      // text: "a", "Enter", "Backspace", "Escape"
    Activate, // number: element, by keyboard or screen reader
    Panel,    // text
    Language, // text
    Scale,    // number
    LogIn,    // text: the secret, more: the name
    LogOut,
    Motion, // number: 0 for a person who asked the browser for less movement
};

struct ClientMessage {
    ClientWord word = ClientWord::Cancel;
    QString text, more;
    QPointF at;
    double number = 0;
};

inline constexpr qsizetype kLargestClientMessage = 4096;
[[nodiscard]] std::optional<ClientMessage> parseClientMessage(QByteArrayView text);

} // namespace plc::hmi::web
