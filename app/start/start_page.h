// What the window shows without a project: recent projects and the shipped examples, a picture each. A picture is read
// when its card is first seen, one in each turn of the event loop. Owned by the main window; GUI thread.
#pragma once
#include <QListWidget>
#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace plc::app {

class Settings;

class StartPage : public QWidget {
    Q_OBJECT
public:
    StartPage(Settings& settings, QWidget* parent = nullptr);
    void reload();
    [[nodiscard]] static QString examplesFolder(); // "" when there is none
    /// The folders of those that can be opened, the one to begin with first.
    [[nodiscard]] static QStringList examplesInstalled();
    /// Where they were looked for in vain, and what to do.
    [[nodiscard]] static QString whyNoExamples();
    [[nodiscard]] QListWidget& examples() { return *m_examples; }
    /// Of an item of examples(): a QPixmap, null where the example has none; absent until its card has been seen.
    static constexpr int kPictureRole = Qt::UserRole + 1;

signals:
    void projectRequested(const QString& folder);
    /// A shipped example: the user works on a copy, the one made earlier or a fresh one.
    void exampleRequested(const QString& folder, bool fresh);
    void newRequested();
    void openRequested();
    void tourRequested();

private:
    void wantPicture(int row);
    void readNextPicture();

    Settings& m_settings;
    QList<int> m_wanted; // rows of cards that were seen without their picture
    QTimer m_reading;
    QListWidget* m_recent;
    QListWidget* m_examples;
    QLabel* m_examplesHeading;
    QLabel* m_noExamples;
    QPushButton* m_tour;
};

} // namespace plc::app
