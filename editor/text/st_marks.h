// The numbers of the editor's margins, line marks and indicators, for the files of StEditor. Values.
#pragma once

namespace plc::editor {

/// The margins left of the text.
enum Margin { kLineNumbers = 0, kMarks = 1, kChanges = 2, kFolds = 3, kCoverage = 4 };
/// The marks of a line; QScintilla draws the higher ones above.
enum Marker {
    kBreakpoint = 0,
    kBreakpointOff = 1,
    kExecuted = 2,
    kErrorMark = 3,
    kWarningMark = 4,
    kChangedLine = 5,
    kAddedLine = 6,
    kExecutedArrow = 7,
    kFault = 8,
    kFaultArrow = 9,
    kBookmark = 14,
    kCovered = 11,
    kPartlyCovered = 12,
    kNotCovered = 13,
    kAutomaticEnd = 10 // not seen: the line with the END_… that Enter has put there
};
/// What is drawn beneath and around characters.
enum Indicator {
    kErrorSquiggle = 8,
    kWarningSquiggle = 9,
    kInfoDots = 10,
    kSameWord = 11,
    kBlockWords = 12,
    kFound = 13,
    kUnused = 14,
    kNotRun = 15, // in the scan that is shown
    kHeld = 16,   // a condition, TRUE in it
    kNotHeld = 17
};

/// The list of completions among QScintilla's user lists.
constexpr int kListId = 1;

} // namespace plc::editor
