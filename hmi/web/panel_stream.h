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
    /// What changed since the last frame; empty: nothing. The player's values must have been read.
    QByteArray frame(qint64 milliseconds);
    /// Number of the last frame that was not empty.
    uint32_t number() const { return m_number; }
    /// What screen readers read, of those elements whose words changed since it was asked last: JSON, empty if none.
    QByteArray words();

private:
    struct Shown {
        Recording recording;
        QRectF bounds;
        bool isShown = false, isKnown = false;
        QString toldWords;
    };
    void element(size_t index, ElementView& view, PaintBytes& out);
    void overlay(PaintBytes& out);
    void send(size_t index, Recording&& now, const QRectF& bounds, bool isShown, PaintBytes& out);
    /// Letters and pictures that the frame names and the browser does not have.
    QByteArray definitions();
    PaintStore& m_store;
    PanelPlayer& m_player;
    PaintRecorder m_recorder;
    std::vector<Shown> m_shown; // by element; the last one is what lies over the panel
    size_t m_sentGlyphs = 0, m_sentPictures = 0;
    uint32_t m_edition = 0, m_number = 0;
    bool m_needsAll = true, m_isReset = true, m_hadOverlay = false;
};

} // namespace plc::hmi::web
