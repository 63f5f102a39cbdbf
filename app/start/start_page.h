// What the window shows without a project: recent projects and the shipped examples, a picture each. Owned by the main
// window; GUI thread.
#pragma once
#include <QListWidget>
#include <QWidget>

namespace plc::app {

class Settings;

class StartPage : public QWidget {
    Q_OBJECT
public:
    StartPage(Settings& settings, QWidget* parent = nullptr);
    void reload();
    [[nodiscard]] static QString examplesFolder(); // "" when there is none
    [[nodiscard]] QListWidget& examples() { return *m_examples; }

signals:
    void projectRequested(const QString& folder);
    /// A shipped example: the user works on a copy, the one made earlier or a fresh one.
    void exampleRequested(const QString& folder, bool fresh);
    void newRequested();
    void openRequested();
    void tourRequested();

private:
    Settings& m_settings;
    QListWidget* m_recent;
    QListWidget* m_examples;
};

} // namespace plc::app
