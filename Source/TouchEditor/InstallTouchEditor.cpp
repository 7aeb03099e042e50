#include "InstallTouchEditor.h"

#include "TouchEditor.h"

#include <Editor/EditorPreferences.h>

#include <memory>

namespace antinode
{
void installTouchEditor()
{
    TouchProcessor::makeEditor = [] (TouchProcessor& processor)
    {
        auto editor = std::make_unique<TouchEditor> (processor);
        auto& content = editor->content();
        content.setDark (readPreferences().isDark);
        content.onTheme = [&content] { keepPreferences ({ content.isDark() }); };
        return editor.release();
    };
}
} // namespace antinode
