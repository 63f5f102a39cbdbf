// Keeps one browser's picture of a panel up to date: which elements changed, and of those only the drawing commands
// that differ from what the browser has. Each frame is whole in itself and follows the one before. Owned by a WebPanel;
// main thread.
#pragma once
#include "hmi/player/panel_player.h"
#include "hmi/web/paint_recorder.h"

namespace plc::hmi::web {

class PanelStream {
public:
    PanelStream(PaintStore& store, PanelPlayer& player);

    /// The browser has nothing any more (a new panel, a new connection): the next frame is the whole picture.
    void restart();
    void setSharpness(int sharpness);
    /// What changed since the last frame; empty: nothing. The player's values must have been read, unless another
    /// browser has recorded the view of this name for this moment.
    QByteArray frame(qint64 milliseconds, const QString& view = {});
    bool isRecorded(const QString& view, qint64 milliseconds) const;
    /// What goes with the picture of that name.
    void share(const QString& view, const QString& state, bool isBad);
    const SharedView& shared(const QString& view) const { return *m_store.views().constFind(view); }
    /// The player's own scene is as old as the last frame that it recorded itself: before it is touched.
    void catchUp(qint64 milliseconds) { record(milliseconds); }
    /// Number of the last frame that was not empty.
    uint32_t number() const { return m_number; }
    /// What screen readers read, of those elements whose words changed since it was asked last: JSON, empty if none.
    QByteArray words();

private:
    struct Shown : Piece {
        QString toldWords;
    };
    /// Records those elements of the player's scene that changed.
    void record(qint64 milliseconds);
    void overlay(PaintBytes& out);
    /// The commands that differ from what the browser has.
    void send(size_t index, const Piece& now, PaintBytes& out);
    /// Letters and pictures that the frame names and the browser does not have.
    QByteArray definitions();
    PaintStore& m_store;
    PanelPlayer& m_player;
    PaintRecorder m_recorder;
    std::vector<Piece> m_own;   // by element, of the player's scene
    std::vector<Shown> m_shown; // the same in the browser; the last one is what lies over the panel
    size_t m_sentGlyphs = 0, m_sentPictures = 0;
    uint32_t m_edition = 0, m_number = 0;
    bool m_needsAll = true, m_isReset = true, m_hadOverlay = false;
};

} // namespace plc::hmi::web
