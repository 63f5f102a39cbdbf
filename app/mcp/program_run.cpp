#include "app/mcp/program_run.h"

#include <QProcess>

namespace plc::mcp {

namespace {

void take(std::string& into, const QByteArray& bytes, size_t limit, bool& isCut) {
    const size_t room = limit - std::min(limit, into.size());
    isCut = isCut || static_cast<size_t>(bytes.size()) > room;
    into.append(bytes.constData(), std::min(room, static_cast<size_t>(bytes.size())));
}

} // namespace

ProgramRun runProgram(const std::string& program, const std::vector<std::string>& words, RunLimits limits) {
    QStringList list;
    for (const std::string& word : words) list << QString::fromStdString(word);
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("NO_COLOR", "1");
    environment.insert("QT_QPA_PLATFORM", "offscreen");
    QProcess process;
    process.setProcessEnvironment(environment);
    process.setStandardInputFile(QProcess::nullDevice());
    process.start(QString::fromStdString(program), list, QIODevice::ReadOnly);
    ProgramRun run;
    if (!process.waitForStarted()) {
        run.hasStarted = false;
        return run;
    }
    const auto end = std::chrono::steady_clock::now() + limits.time;
    while (process.state() != QProcess::NotRunning) {
        process.waitForFinished(20);
        take(run.out, process.readAllStandardOutput(), limits.output, run.isCut);
        take(run.err, process.readAllStandardError(), limits.output, run.isCut);
        if (std::chrono::steady_clock::now() < end) continue;
        run.isTimedOut = true;
        process.kill();
        process.waitForFinished(5000);
        break;
    }
    take(run.out, process.readAllStandardOutput(), limits.output, run.isCut);
    take(run.err, process.readAllStandardError(), limits.output, run.isCut);
    run.exitCode = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    return run;
}

} // namespace plc::mcp
