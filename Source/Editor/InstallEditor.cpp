#include "InstallEditor.h"

#include "Editor.h"
#include "EditorPreferences.h"

#include <memory>

namespace antinode
{
void installEditor()
{
    AntinodeProcessor::makeEditor = [] (AntinodeProcessor& processor)
    {
        auto editor = std::make_unique<Editor> (processor);
        auto& content = editor->content();
        content.setDark (readPreferences().isDark);
        content.onTheme = [&content] { keepPreferences ({ content.isDark() }); };
        return editor.release();
    };
}
} // namespace antinode
