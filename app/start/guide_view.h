// The project's README beside it: what it shows, what to press, what to watch. Pictures are those of the project only,
// links to its files open them. Owned by its dock; GUI thread.
#pragma once
#include <QTextBrowser>

namespace plc::app {

class GuideView : public QTextBrowser {
    Q_OBJECT
public:
    explicit GuideView(QWidget* parent = nullptr);
    /// The file to read: README.<language of the studio>.md ("README.de.md") where there is one, else README.md.
    [[nodiscard]] static QString readmeOf(const QString& folder);
    /// The README of the folder; true if there is one.
    bool showProject(const QString& folder);
    /// The first paragraph without marks, for those who have no time.
    [[nodiscard]] static QString summaryOf(const QString& folder);

signals:
    /// "src/main.st"
    void fileRequested(const QString& file);

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void render();
    QString m_folder, m_text;
};

} // namespace plc::app
