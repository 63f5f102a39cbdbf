// What a mouse does in the margin of the text and by resting over it, as commands at the caret: folding, the
// explanation of a name, the passes of a loop. Functions over the editor; GUI thread.
#pragma once

namespace plc::editor {

class StEditor;

/// The block around the caret, which then is on its first line.
void toggleFold(StEditor& editor);
/// What rests under the pointer otherwise: problems and their fixes, declaration, comment and value.
void showInformation(StEditor& editor);
/// Of the loop that begins nearest before the caret, while a recorded scan is shown: 1 the next pass, -1 the one
/// before.
void changePass(StEditor& editor, int by);

} // namespace plc::editor
