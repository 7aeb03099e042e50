#pragma once

namespace antinode
{
/** Gives every processor of this program its editor. [message thread] */
void installEditor();
} // namespace antinode
