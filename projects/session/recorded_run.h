// A run that is over: what `stepwise run --record`, a server or the studio saved. Its program is built again from the
// sources in the file. Nothing in it changes once it is open; any thread.
#pragma once
#include "projects/session/run.h"
#include "runtime/compiler/driver/driver.h"

namespace plc::session {

class RecordedRun final : public Run {
public:
    [[nodiscard]] static Result<std::shared_ptr<RecordedRun>> open(const std::string& path,
                                                                   Progress* progress = nullptr);
    /// Of a history that was made elsewhere: measured values, another tool's trace.
    [[nodiscard]] static std::shared_ptr<RecordedRun> of(driver::Built built,
                                                         std::unique_ptr<history::History> history);

    [[nodiscard]] const history::History& history() const override { return *m_history; }
    [[nodiscard]] std::shared_ptr<const image::CompiledProgram> program() const override { return m_program; }
    [[nodiscard]] Status status() const override;
    void latest(Snapshot& into) const override;
    [[nodiscard]] bool isLive() const override { return false; }

private:
    RecordedRun() = default;

    std::unique_ptr<history::History> m_history;
    std::shared_ptr<const image::CompiledProgram> m_program; // the newest version
};

} // namespace plc::session
