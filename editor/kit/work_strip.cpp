#include "editor/kit/work_strip.h"

#include "editor/kit/long_task.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

namespace plc::kit {

namespace {
constexpr int kSteps = 1000, kLookMs = 50;
}

WorkStrip::WorkStrip(QWidget* parent)
    : QWidget(parent), m_label(new QLabel(this)), m_bar(new QProgressBar(this)), m_cancel(new QToolButton(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 0, 6, 0);
    layout->addWidget(m_label);
    layout->addWidget(m_bar);
    layout->addWidget(m_cancel);
    m_bar->setRange(0, kSteps);
    m_bar->setFixedWidth(120);
    m_bar->setMaximumHeight(12);
    m_bar->setTextVisible(false);
    m_cancel->setObjectName("cancelWork");
    m_cancel->setAutoRaise(true);
    m_cancel->setText(tr("Cancel"));
    connect(m_cancel, &QToolButton::clicked, this, [this] {
        if (m_works.empty()) return;
        m_works.back().progress->cancel();
        look();
    });
    connect(&m_timer, &QTimer::timeout, this, &WorkStrip::look);
    hide();
}

void WorkStrip::begin(const QString& label, std::shared_ptr<Progress> progress) {
    m_works.push_back({label, std::move(progress), {}});
    m_works.back().since.start();
    m_timer.start(kLookMs);
    if (LongTask::patience() == 0) look();
}

void WorkStrip::end(const std::shared_ptr<Progress>& progress) {
    std::erase_if(m_works, [&](const Work& each) { return each.progress == progress; });
    look();
}

void WorkStrip::look() {
    if (m_works.empty()) {
        m_timer.stop();
        return hide();
    }
    const Work& shown = m_works.back();
    if (shown.since.elapsed() < LongTask::patience()) return hide();
    m_label->setText(shown.progress->isCancelled() ? tr("%1 is being cancelled…").arg(shown.label) : shown.label);
    m_bar->setValue(static_cast<int>(shown.progress->share() * kSteps));
    m_bar->setAccessibleName(shown.label);
    m_cancel->setAccessibleName(tr("Cancel: %1").arg(shown.label));
    m_cancel->setEnabled(!shown.progress->isCancelled());
    show();
}

} // namespace plc::kit
