#include "app/cli/remote/commands.h"

#include "projects/debug_adapter/adapter.h"
#include "projects/protocol/connection.h"
#include "runtime/platform/streams.h"

namespace plc::cli {

namespace {

int serveDebugger(const Arguments&) {
    platform::ignoreLostReaders();
    protocol::Connection connection(protocol::Framing::Heads, platform::kStandardInput, platform::kStandardOutput);
    dap::Adapter adapter([&](const dap::Json& message) { connection.send(protocol::toText(message)); });
    using std::chrono::milliseconds;
    while (!adapter.isOver()) {
        const auto message = connection.next(adapter.hasWork() ? std::optional(milliseconds(2)) : std::nullopt);
        if (message)
            adapter.receive(*message);
        else if (!connection.isOpen())
            return kProgramWrong; // the client is gone without a good-bye
        adapter.work();
    }
    return kGood;
}

} // namespace

Command dapCommand() {
    return {{"dap",
             "[OPTIONS]",
             "Debugs a project for an editor, with the Debug Adapter Protocol on standard input and output.",
             {{"--stdio", "", "as some editors want it said; there is no other way"}},
             "stepwise dap"},
            serveDebugger};
}

} // namespace plc::cli
