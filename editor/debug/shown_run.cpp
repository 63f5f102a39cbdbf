#include "editor/debug/shown_run.h"

#include "editor/kit/message_text.h"
#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

#include <QCoreApplication>

#include <algorithm>

namespace plc::editor {

void ShownRun::setRecorded(std::shared_ptr<const session::RecordedRun> recorded, const QString& name) {
    m_recorded = std::move(recorded);
    m_name = m_recorded ? name : QString();
    clear();
    refresh();
}

const session::Run* ShownRun::run() const { return m_recorded ? m_recorded.get() : m_live; }

bool ShownRun::view(std::optional<history::Position> position) {
    if (m_viewed == position) return false;
    if (const history::History* history = this->history(); position && history) {
        const history::Statistics all = history->statistics();
        if (all.end == all.first) return false;
        position = std::clamp(*position, all.first, all.end - 1);
    }
    m_viewed = position;
    refresh();
    return true;
}

void ShownRun::clear() {
    m_viewed.reset();
    m_now = {};
}

void ShownRun::refresh() {
    const session::Run* run = this->run();
    if (!run) return;
    if (!m_viewed && run->isLive()) {
        session::Snapshot newest;
        newest.image = std::move(m_now.image); // new memory for a large image takes longer than the copy
        run->latest(newest);
        m_now = {std::move(newest.image), newest.program ? std::move(newest.program) : run->program()};
        return;
    }
    const history::Statistics all = run->history().statistics();
    if (all.end > all.first) m_now.image = run->history().seek(m_viewed.value_or(all.end - 1), &m_now.program);
}

void ShownRun::atMoment(Moment& moment, const std::function<void()>& read) {
    std::swap(m_now, moment);
    read();
    std::swap(m_now, moment);
}

ShownRun::Value ShownRun::shown(const types::Value& value) const {
    Value shown;
    const types::TypeTable& types = *m_now.program->layout.types;
    shown.value = value;
    shown.type = value.type;
    shown.text = QString::fromStdString(types::toText(types, value));
    shown.isBool = value.type.isValid() && types.storageKind(value.type) == types::TypeKind::Bool;
    shown.isTrue = shown.isBool && value.isTrue();
    return shown;
}

ShownRun::Value ShownRun::value(const QString& expression, const QString& scope, types::NumberFormat format) const {
    Value shown;
    const session::Run* run = this->run();
    if (!run || m_now.image.empty() || !m_now.program) return shown;
    const std::string text = expression.toStdString(), from = scope.toStdString();
    const auto compiled = run->expression(text, from, *m_now.program);
    if (!compiled) { // of an older version: only what exists now is missed in it
        const bool existsNow = m_now.program != run->program() && run->expression(text, from);
        shown.reason = existsNow ? QCoreApplication::translate("plc::editor::RunControl", "did not exist in this scan")
                                 : kit::messageText(compiled.error().message);
        return shown;
    }
    shown.type = compiled->type();
    const expression::Outcome outcome = compiled->evaluate(m_now.image);
    if (!outcome.hasValue()) {
        shown.reason = kit::messageText(outcome.reason);
        return shown;
    }
    shown.value = outcome.value;
    shown.text = QString::fromStdString(types::toText(compiled->types(), outcome.value, format));
    shown.isBool = compiled->types().storageKind(compiled->type()) == types::TypeKind::Bool;
    shown.isTrue = shown.isBool && outcome.value.isTrue();
    const std::string path = foldCase(from.empty() ? text : from + "." + text);
    shown.isForced = run->isLive() && (m_forced.contains(path) || m_forced.contains(foldCase(text)));
    return shown;
}

void ShownRun::takeSample(bool isRunning) {
    constexpr qint64 kSampleMs = 100;
    if (!m_live || (isRunning && m_sinceSample.isValid() && m_sinceSample.elapsed() < kSampleMs)) return;
    const history::Statistics all = m_live->history().statistics();
    m_sampled = all.end - std::min<history::Position>(all.end, 1);
    m_sinceSample.start();
}

history::Position ShownRun::sampled() const {
    const history::History* history = this->history();
    if (!history) return 0;
    const history::Statistics all = history->statistics();
    const history::Position newest = all.end - std::min<history::Position>(all.end, 1);
    return m_recorded || m_sampled < all.first ? newest : std::min(m_sampled, newest); // of a session before
}

} // namespace plc::editor
