#include "InstallEditor.h"

#include "Editor.h"

namespace antinode
{
void installEditor()
{
    AntinodeProcessor::makeEditor = [] (AntinodeProcessor& processor) { return new Editor (processor); };
}
} // namespace antinode
