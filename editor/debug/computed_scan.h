// What the scan that is shown computed, place by place in the texts: a sample of the running controller, taken again
// and again, the scan that stands at a breakpoint, or the one at the time slider. The scan is run again on a thread of
// its own (D13), only for the files that somebody asks for. Owned by the window beside the RunControl; GUI thread.
#pragma once
#include "editor/debug/run_control.h"
#include "runtime/inside/place_values.h"
#include "runtime/inside/standing.h"

#include <QObject>

#include <chrono>
#include <map>
#include <set>
#include <thread>

namespace plc::editor {

class ComputedScan : public QObject {
    Q_OBJECT
public:
    explicit ComputedScan(RunControl& control, QObject* parent = nullptr);
    ~ComputedScan() override;

    using Values = std::shared_ptr<const inside::PlaceValues>;
    /// Of a file's places in an instance (empty: any). Null: not known, or not yet; asking keeps them coming.
    [[nodiscard]] Values of(const QString& file, const QString& instance);

signals:
    /// The scan that is shown, halted or in the past, is known now; live, one asks again anyway.
    void changed();

private:
    using Key = std::pair<QString, QString>; // file, instance
    struct Job;
    void forget();
    void next();
    [[nodiscard]] std::shared_ptr<Job> makeJob();
    void finish(const Job& job);

    RunControl& m_control;
    std::shared_ptr<inside::Insight> m_insight;
    const history::History* m_insightOf = nullptr;
    std::set<Key> m_wanted; // since the last look at it
    struct Known {
        Values values;
        std::chrono::steady_clock::time_point at;
    };
    std::map<Key, Known> m_known;
    QString m_knownScan; // which scan m_known is of
    bool m_isLive = false;
    bool m_isBusy = false;
    std::thread m_worker;
};

} // namespace plc::editor
