#include "InstallPlateEditor.h"

#include "PlateEditor.h"

#include <Editor/EditorPreferences.h>

#include <memory>

namespace antinode
{
void installPlateEditor()
{
    PlateProcessor::makeEditor = [] (PlateProcessor& processor)
    {
        auto editor = std::make_unique<PlateEditor> (processor);
        auto& content = editor->content();
        content.setDark (readPreferences().isDark);
        content.onTheme = [&content] { keepPreferences ({ content.isDark() }); };
        return editor.release();
    };
}
} // namespace antinode
