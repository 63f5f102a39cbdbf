// What the command line does with panels: pictures in every language at a moment of a run, the check, and playing
// without the studio. Functions for the application's `panel` command; main thread, a QApplication must exist.
#pragma once
#include "hmi/station/panel_project.h"
#include "hmi/station/program_facts.h"
#include "projects/session/session.h"

namespace plc::hmi {

struct PictureOptions {
    QString folder;        // where the PNG files go
    QStringList languages; // empty: all of the project
    QStringList panels;    // empty: all
    double scale = 1;
    QString theme; // another theme than the panel's own; empty: its own
};

/// One PNG per panel and language, as the session stands now: "main.de.png". Returns the paths.
Result<std::vector<QString>> renderPanels(const PanelProject& project, session::Session* session,
                                          const PictureOptions& options);
/// The image that renderPanels writes.
QImage renderPanel(const PanelProject& project, session::Session* session, const QString& panel,
                   const QString& language, double scale = 1, const QString& theme = {});

/// Writes panels, texts and alarms in the canonical order, for files made by hand; files that are canonical stay
/// untouched.
Result<void> formatPanels(const PanelProject& project);

/// All findings, those of the front end included: unknown paths, wrong types.
std::vector<Finding> checkPanels(const PanelProject& project, const driver::Checked& checked,
                                 const QStringList& languages = {});

struct PlayOptions {
    QString panel;    // shown first; empty: the start panel
    QString language; // one of the project to begin with; empty: what the operator chose last
    bool isFullScreen = false;
};

/// Opens a window and plays until it is closed; returns the application's exit code.
int playPanels(const PanelProject& project, session::Session& session, const PlayOptions& options);

} // namespace plc::hmi
