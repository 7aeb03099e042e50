#pragma once

#include "LibraryButton.h"

#include <antinode_session/Documents.h>

#include <functional>
#include <memory>
#include <string>

namespace antinode
{
/** The loaded device's name; a click chooses another one. [message thread] */
class DeviceButton final : public LibraryButton
{
public:
    explicit DeviceButton (const std::function<void (std::shared_ptr<const DeviceDocument>)>& load);

    void setDevice (const DeviceDocument&);

    /** Loads a device of the library, or of a file. */
    void loadDevice (const std::string& nameOrFile) { loadDocument (nameOrFile); }
};
} // namespace antinode
