#pragma once

namespace antinode
{
/** Gives every plate processor of this program its editor, as dark or light as the last one was left. [message
    thread] */
void installPlateEditor();
} // namespace antinode
