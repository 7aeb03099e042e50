# Installs into a fresh folder and checks what is there. Usage: cmake -DBINARY=... -DFOLDER=... -DSTANDALONE=... -DCLASSES=...
# -DLV2=... -P Installed.cmake
file (REMOVE_RECURSE ${FOLDER})
execute_process (COMMAND ${CMAKE_COMMAND} --install ${BINARY} --prefix ${FOLDER} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

set (expected
    bin/antinode
    "lib/vst3/Antinode Plate.vst3/Contents/x86_64-linux/Antinode Plate.so"
    "lib/vst3/Antinode Touch.vst3/Contents/x86_64-linux/Antinode Touch.so"
    lib/vst3/Antinode.vst3/Contents/x86_64-linux/Antinode.so
    share/bash-completion/completions/antinode
    share/doc/antinode/CONTRIBUTING.md
    share/doc/antinode/LICENSE
    share/doc/antinode/README.md
    share/doc/antinode/changelog.Debian.gz
    share/doc/antinode/changelog.gz
    share/doc/antinode/copyright
    share/fish/vendor_completions.d/antinode.fish
    share/lintian/overrides/antinode
    share/man/man1/antinode.1.gz
    share/zsh/vendor-completions/_antinode)
if (CLASSES)
    foreach (plugin Antinode "Antinode Plate" "Antinode Touch")
        list (APPEND expected "lib/vst3/${plugin}.vst3/Contents/Resources/moduleinfo.json")
    endforeach()
endif()
foreach (ceramics IN LISTS LV2)
    foreach (plugin "Antinode ${ceramics}" "Antinode Plate ${ceramics}" "Antinode Touch ${ceramics}")
        set (bundle "lib/lv2/${plugin}.lv2")
        list (APPEND expected "${bundle}/dsp.ttl" "${bundle}/lib${plugin}.so" "${bundle}/manifest.ttl")
    endforeach()
endforeach()
if (STANDALONE)
    set (identifier example.antinode.Antinode)
    list (APPEND expected
        bin/antinode-standalone
        share/applications/${identifier}.desktop
        share/bash-completion/completions/antinode-standalone
        share/fish/vendor_completions.d/antinode-standalone.fish
        share/icons/hicolor/scalable/apps/${identifier}.svg
        share/man/man1/antinode-standalone.1.gz
        share/metainfo/${identifier}.metainfo.xml)
    foreach (size 16 22 24 32 48 64 128 256)
        list (APPEND expected share/icons/hicolor/${size}x${size}/apps/${identifier}.png)
    endforeach()
endif()

file (GLOB_RECURSE installed RELATIVE ${FOLDER} ${FOLDER}/*)
list (FILTER installed EXCLUDE REGEX "^share/doc/antinode/Docs/")
# A package of its own, where the same folder was built for Python, too.
list (FILTER installed EXCLUDE REGEX "python3")
# JUCE writes it for plug-ins with an editor.
list (FILTER installed EXCLUDE REGEX "^lib/lv2/Antinode( Plate| Touch)? [0-9]+.lv2/ui.ttl$")
set (missing ${expected})
list (REMOVE_ITEM missing ${installed})
set (unexpected ${installed})
list (REMOVE_ITEM unexpected ${expected})
if (missing OR unexpected)
    message (FATAL_ERROR "missing: ${missing}\nunexpected: ${unexpected}")
endif()

foreach (page Manual/index.md FileFormats.md Theory.md Pictures/focus.png)
    if (NOT EXISTS ${FOLDER}/share/doc/antinode/Docs/${page})
        message (FATAL_ERROR "Docs/${page} is not installed")
    endif()
endforeach()

execute_process (COMMAND ${FOLDER}/bin/antinode version COMMAND_ERROR_IS_FATAL ANY)
list (GET LV2 0 first)
foreach (plugin "Antinode ${first}" "Antinode Plate ${first}" "Antinode Touch ${first}")
    file (SIZE "${FOLDER}/lib/lv2/${plugin}.lv2/dsp.ttl" size)
    if (size LESS 1000)
        message (FATAL_ERROR "dsp.ttl of the LV2 bundle ${plugin} has ${size} bytes: it describes no ports")
    endif()
endforeach()
file (REMOVE_RECURSE ${FOLDER})
