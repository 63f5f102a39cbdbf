#include "editor/debug/computed_scan.h"

#include "editor/kit/post.h"

#include <algorithm>

namespace plc::editor {

namespace {

constexpr auto kMostForOlder = std::chrono::milliseconds(25); // looking for a scan in which a slow task ran
constexpr history::Position kOldest = 500;
constexpr auto kKept = std::chrono::seconds(3); // what a slow task computed last

} // namespace

/// One look, made on the worker's thread.
struct ComputedScan::Job {
    std::shared_ptr<inside::Insight> insight;
    RunControl::Hold hold;
    std::shared_ptr<const void> owner; // of a recording from a file
    std::shared_ptr<const image::CompiledProgram> program;
    std::set<Key> keys;
    QString scan;
    history::Position position = 0, first = 0;
    bool isLive = false;
    std::optional<inside::Standing> standing;
    std::map<Key, Values> found, idle; // idle: nothing of it ran

    void run() {
        if (standing) {
            if (const auto at = inside::lookAtStanding(*insight, *standing)) take(at->look, at->end);
            return;
        }
        const auto begin = std::chrono::steady_clock::now();
        for (history::Position at = position;; --at) {
            if (const auto look = insight->look(at, options())) take(*look, inside::kNone);
            // Live, a task that was not due in the newest scan is shown as it ran last.
            const bool isDone = !isLive || found.size() == keys.size() || at <= first || position - at >= kOldest;
            if (isDone || std::chrono::steady_clock::now() - begin > kMostForOlder) return;
        }
    }

private:
    [[nodiscard]] std::optional<FileId> fileOf(const Key& key) const {
        const auto& files = program->sources.files;
        for (size_t i = 0; i < files.size(); ++i)
            if (files[i].path() == key.first.toStdString()) return FileId(i);
        return std::nullopt;
    }

    [[nodiscard]] inside::LookOptions options() const {
        inside::LookOptions options;
        std::set<size_t> files;
        for (const Key& key : keys)
            if (const auto file = fileOf(key)) files.insert(file->index());
        for (uint32_t f = 1; f < program->functions.size(); ++f) {
            const FileId file = program->functions[f].declaration.file;
            if (file.isValid() && files.count(file.index())) options.functions.push_back(f);
        }
        return options;
    }

    void take(const std::shared_ptr<const inside::Look>& look, inside::EventIndex end) {
        for (const Key& key : keys) {
            const auto file = fileOf(key);
            if (!file || found.count(key)) continue;
            auto values = std::make_shared<inside::PlaceValues>(look, *file, key.second.toStdString(), end);
            (isLive && values->isEmpty() ? idle : found).emplace(key, std::move(values));
        }
    }
};

ComputedScan::ComputedScan(RunControl& control, QObject* parent) : QObject(parent), m_control(control) {
    connect(&control, &RunControl::refreshed, this, &ComputedScan::next);
    connect(&control, &RunControl::sessionChanged, this, &ComputedScan::forget);
    connect(&control, &RunControl::sessionAboutToEnd, this, &ComputedScan::forget);
}

ComputedScan::~ComputedScan() {
    if (m_worker.joinable()) m_worker.join();
}

void ComputedScan::forget() {
    if (m_worker.joinable()) m_worker.join(); // it reads the history that goes
    m_insight.reset();
    m_insightOf = nullptr;
    m_known.clear();
    m_knownScan.clear();
}

ComputedScan::Values ComputedScan::of(const QString& file, const QString& instance) {
    m_wanted.insert({file, instance});
    const auto known = m_known.find({file, instance});
    return known == m_known.end() ? nullptr : known->second.values;
}

/// Which scan is to be shown; null: nothing to look at.
std::shared_ptr<ComputedScan::Job> ComputedScan::makeJob() {
    session::Session* session = m_control.session();
    const auto& recorded = m_control.recorded();
    const history::History* history = m_control.shownHistory();
    if (!history || m_control.isEnding() || m_control.isBuilding()) return nullptr;
    const history::Statistics all = history->statistics();
    auto job = std::make_shared<Job>();
    job->keys = m_wanted;
    job->first = all.first;
    const bool isHalted = !recorded && m_control.status().state == controller::State::Halted;
    if (isHalted && !m_control.viewed()) {
        session::Snapshot now;
        session->latest(now);
        const std::vector<session::FaultFrame> frames = session->haltFrames();
        if (!now.isHalted || frames.empty() || !now.program) return nullptr;
        job->scan = QString("halt %1").arg(m_control.status().halts);
        job->program = now.program;
        job->standing = inside::Standing{now.program, std::move(now.image), frames.front()};
    } else {
        if (all.end == all.first) return nullptr;
        job->position = m_control.viewed().value_or(m_control.sampled());
        job->isLive = !recorded && !m_control.viewed();
        job->scan = QString("%1 %2").arg(job->isLive).arg(job->position);
        job->program = m_control.sharedImageProgram();
    }
    if (!job->program) return nullptr;
    if (m_insightOf != history) {
        m_insight = std::make_shared<inside::Insight>(*history);
        m_insightOf = history;
    }
    job->insight = m_insight;
    job->hold = m_control.hold();
    job->owner = recorded;
    return job;
}

void ComputedScan::next() {
    if (m_isBusy || m_wanted.empty()) return;
    const std::shared_ptr<Job> job = makeJob();
    if (!job) return forget(), void(m_wanted.clear());
    const bool isOther = job->scan != m_knownScan;
    if (isOther && !job->isLive && !m_known.empty()) { // what is known is of another scan
        m_known.clear();
        emit changed();
    }
    const bool isKnown = !isOther && std::all_of(m_wanted.begin(), m_wanted.end(),
                                                 [&](const Key& key) { return m_known.count(key) > 0; });
    m_wanted.clear();
    if (isKnown) return;
    m_isBusy = true;
    if (m_worker.joinable()) m_worker.join();
    m_worker = std::thread([this, job] {
        job->run();
        kit::post(this, [this, job] { finish(*job); });
    });
}

void ComputedScan::finish(const Job& job) {
    m_isBusy = false;
    if (job.insight != m_insight) return; // of a session that is gone
    if (!job.isLive || !m_isLive) m_known.clear();
    const auto now = std::chrono::steady_clock::now();
    for (const auto& [key, values] : job.found) m_known[key] = {values, now};
    for (const Key& key : job.keys) {
        Known& known = m_known.try_emplace(key).first->second;
        if (job.found.count(key) || (known.values && now - known.at < kKept)) continue;
        const auto idle = job.idle.find(key);
        known = {idle == job.idle.end() ? nullptr : idle->second, {}};
    }
    m_knownScan = job.scan;
    m_isLive = job.isLive;
    if (!job.isLive) emit changed();
}

} // namespace plc::editor
