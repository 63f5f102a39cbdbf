// Pictures for translators: where each text of the operators is seen. One file per text and panel: the surroundings of
// the element with a frame around it. Functions; main thread (fonts).
#pragma once
#include "hmi/station/panel_project.h"

namespace plc::hmi {

struct TextPicture {
    QString key, place, file; // "button.start", "main: button1.text", "button.start.1.png"
};
/// Writes the pictures of the texts in one language into the folder and an index.html beside them, sorted by key.
Result<std::vector<TextPicture>> writeTextPictures(const PanelProject& project, const QString& folder,
                                                   const QString& language);

} // namespace plc::hmi
