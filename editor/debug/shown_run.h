// What every view shows: the run of the controller or one from a recording, at its newest scan or at the one that was
// chosen, and the values of expressions in it. Owned by RunControl; GUI thread.
#pragma once
#include "projects/session/recorded_run.h"

#include <QElapsedTimer>
#include <QString>

#include <functional>
#include <set>

namespace plc::editor {

class ShownRun {
public:
    struct Value {
        QString text; // "" = no value
        QString reason;
        types::Value value;
        types::TypeId type;
        bool isBool = false, isTrue = false, isForced = false;
    };
    /// An image to show in the place of the one that everybody is shown.
    struct Moment {
        std::vector<std::byte> image;
        std::shared_ptr<const image::CompiledProgram> program;
    };

    /// The run that goes on, or none; it must outlive its stay here.
    void setLive(const session::Run* live) { m_live = live; }
    /// A recording in its place; null goes back.
    void setRecorded(std::shared_ptr<const session::RecordedRun> recorded, const QString& name);
    [[nodiscard]] const session::Run* run() const; // null: there is none
    [[nodiscard]] const std::shared_ptr<const session::RecordedRun>& recorded() const { return m_recorded; }
    [[nodiscard]] const QString& recordedName() const { return m_name; }
    [[nodiscard]] const history::History* history() const { return run() ? &run()->history() : nullptr; }

    /// None: the newest scan.
    [[nodiscard]] std::optional<history::Position> viewed() const { return m_viewed; }
    /// False: it is shown already, or there is nothing to look back at.
    bool view(std::optional<history::Position> position);
    void clear(); // no scan is shown until the next refresh
    /// The image as it is now.
    void refresh();
    [[nodiscard]] const std::vector<std::byte>& image() const { return m_now.image; }
    [[nodiscard]] const std::shared_ptr<const image::CompiledProgram>& program() const { return m_now.program; }
    /// While `read` runs, values are those of the moment.
    void atMoment(Moment& moment, const std::function<void()>& read);

    /// Folded paths.
    void setForced(std::set<std::string> forced) { m_forced = std::move(forced); }
    [[nodiscard]] Value value(const QString& expression, const QString& scope, types::NumberFormat format) const;
    /// A value of the program that is shown, as text.
    [[nodiscard]] Value shown(const types::Value& value) const;

    /// The scan that whoever looks inside the running controller looks at, so that all of them show the same one;
    /// another one ten times a second. Stopped, the newest. Only where something is recorded.
    [[nodiscard]] history::Position sampled() const;
    void takeSample(bool isRunning);

private:
    const session::Run* m_live = nullptr;
    std::shared_ptr<const session::RecordedRun> m_recorded;
    QString m_name;
    std::optional<history::Position> m_viewed;
    Moment m_now;
    std::set<std::string> m_forced;
    history::Position m_sampled = 0;
    QElapsedTimer m_sinceSample;
};

} // namespace plc::editor
