#pragma once

#include <antinode_base/WordList.h>

namespace antinode
{
/** The names of the editor's two looks in files. */
inline constexpr WordList<bool, 2> themeWords { { { "dark", true }, { "light", false } } };

/** Preferences of the plug-in's window, the same in all hosts; not part of a host's state. */
struct EditorPreferences
{
    bool isDark = true;
};

/** The preferences in $XDG_CONFIG_HOME/antinode/editor.json; the defaults if there is no valid file.
   Docs/FileFormats.md [message thread] */
EditorPreferences readPreferences();

/** Keeps them; where the file cannot be written they last as long as the window. [message thread] */
void keepPreferences (const EditorPreferences&);
} // namespace antinode
