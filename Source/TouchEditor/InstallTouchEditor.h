#pragma once

namespace antinode
{
/** Gives every touch processor of this program its editor, as dark or light as the last one was left. [message
    thread] */
void installTouchEditor();
} // namespace antinode
