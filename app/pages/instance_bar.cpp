#include "app/pages/instance_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace plc::app {

InstanceBar::InstanceBar(QWidget* parent) : QWidget(parent), m_label(new QLabel(this)), m_choice(new QComboBox(this)) {
    setObjectName("instanceBar");
    m_choice->setAccessibleName(tr("Instance whose values are shown"));
    m_choice->setFocusPolicy(Qt::ClickFocus);
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 8, 2);
    row->addWidget(m_label);
    row->addWidget(m_choice);
    row->addStretch(1);
    hide();
    connect(m_choice, &QComboBox::textActivated, this,
            [this](const QString& instance) { emit instanceChosen(m_block, instance); });
}

void InstanceBar::show(const QString& block, const QStringList& instances, const QString& chosen) {
    setVisible(!instances.isEmpty());
    if (instances.isEmpty()) return;
    const QSignalBlocker blocker(m_choice);
    if (block != m_block) m_label->setText(tr("Values of the instance of %1:").arg(block));
    m_block = block;
    if (instances != m_instances) {
        m_instances = instances;
        m_choice->clear();
        m_choice->addItems(instances);
    }
    if (m_choice->currentText() != chosen) m_choice->setCurrentText(chosen);
}

QString InstanceBar::shownInstance() const { return isHidden() ? QString() : m_choice->currentText(); }

} // namespace plc::app
