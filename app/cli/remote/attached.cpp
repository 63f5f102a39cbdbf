#include "app/cli/remote/attached.h"

#include "app/cli/kit/command.h"
#include "app/cli/kit/errors.h"
#include "projects/remote/errors.h"
#include "projects/remote/scan_stream.h"

#include <QEventLoop>
#include <QTimer>

#include <cerrno>
#include <fstream>

namespace plc::cli {

using editor::RemoteController;

namespace {

/// Turns the event loop until it is so, or the connection is gone, or the time is over, or by Ctrl+C.
void waitFor(const RemoteController& controller, const std::function<bool()>& isDone, std::chrono::nanoseconds most) {
    QEventLoop loop;
    QTimer look;
    const auto end = std::chrono::steady_clock::now() + most;
    const auto ends = [&] {
        const bool isGone = controller.state() == RemoteController::State::Lost ||
                            controller.state() == RemoteController::State::Detached;
        if (isDone() || isGone || isInterrupted() || std::chrono::steady_clock::now() > end) loop.quit();
    };
    QObject::connect(&look, &QTimer::timeout, &loop, ends);
    look.start(2);
    loop.exec();
}

} // namespace

Result<void> Attached::attach(RemoteController::Address address) {
    if (auto good = m_controller.attach(std::move(address)); !good) return good;
    waitFor(
        m_controller, [&] { return m_controller.state() == RemoteController::State::Attached; },
        std::chrono::seconds(20));
    if (m_controller.state() == RemoteController::State::Attached) return {};
    const Message why = m_controller.problem();
    return Error{why.isEmpty() ? remote::errors::NoAnswer(m_controller.host().toStdString()) : why, {}};
}

Result<remote::Json> Attached::ask(remote::Json request) {
    std::optional<Result<remote::Json>> answer;
    m_controller.ask(std::move(request), [&](const Result<remote::Json>& given) { answer = given; });
    waitFor(
        m_controller, [&] { return answer.has_value(); }, std::chrono::minutes(5));
    if (answer) return *answer;
    return Error{remote::errors::NoAnswer(m_controller.host().toStdString()), {}};
}

Result<QByteArray> Attached::fetchRecording() {
    QByteArray bytes;
    const auto listening =
        QObject::connect(&m_controller, &RemoteController::bytesArrived, &m_controller, [&](const QByteArray& piece) {
            if (piece.front() == static_cast<char>(remote::Piece::Recording)) bytes += piece.mid(1);
        });
    const auto begun = ask({{"do", "recording"}});
    const uint64_t size = begun ? remote::numberAt(*begun, "bytes") : 0;
    if (begun)
        waitFor(
            m_controller, [&] { return static_cast<uint64_t>(bytes.size()) >= size; }, std::chrono::minutes(10));
    QObject::disconnect(listening);
    if (!begun) return begun.error();
    if (static_cast<uint64_t>(bytes.size()) == size) return bytes;
    return Error{remote::errors::ConnectionLost(m_controller.host().toStdString()), {}};
}

Result<QString> Attached::readCode(const std::string& path) {
    std::ifstream file(path);
    std::string code;
    if (!file || !std::getline(file, code)) return Error{errors::FileNotRead(errors::ofSystem(errno)), path};
    return QString::fromStdString(code).trimmed();
}

void Attached::wait(std::chrono::nanoseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    waitFor(
        m_controller, [&] { return std::chrono::steady_clock::now() >= end; }, time);
}

} // namespace plc::cli
