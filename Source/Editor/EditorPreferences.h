#pragma once

#include <antinode_base/WordList.h>
#include <antinode_text/JsonReader.h>

namespace antinode
{
/** The names of the editor's two looks in files. */
inline constexpr WordList<bool, 2> themeWords { { { "dark", true }, { "light", false } } };

/** What a scale in files may be; 0: as large as suits the window. */
inline constexpr NumberRange scaleRange { 0, 8 };

/** Preferences of the plug-in's window, the same in all hosts; not part of a host's state. */
struct EditorPreferences
{
    bool isDark = true;
    double scale = 0; ///< Of what a window shows; 0: as large as suits it.
};

/** The preferences in $XDG_CONFIG_HOME/antinode/editor.json; the defaults if there is no valid file.
   Docs/FileFormats.md [message thread] */
EditorPreferences readPreferences();

/** Keeps them; where the file cannot be written they last as long as the window. [message thread] */
void keepPreferences (const EditorPreferences&);
} // namespace antinode
