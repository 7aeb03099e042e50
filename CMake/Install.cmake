# Where everything goes with `cmake --install`. Included last: what a build leaves out is not installed.
include (GNUInstallDirs)

# Hosts look for plug-ins below lib itself, not below Debian's lib/x86_64-linux-gnu.
set (ANTINODE_PLUGIN_DIRECTORY lib)
set (resources ${PROJECT_SOURCE_DIR}/Resources)
set (documents ${CMAKE_INSTALL_DATADIR}/doc/antinode)

# antinode_install_compressed (FILE DIRECTORY NAME): FILE as NAME.gz. Without its time stamp: the same input gives the same bytes.
function (antinode_install_compressed file directory name)
    set (compressed ${CMAKE_BINARY_DIR}/compressed/${name}.gz)
    add_custom_command (OUTPUT ${compressed}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/compressed
        COMMAND gzip -9nc ${file} > ${compressed} DEPENDS ${file} VERBATIM)
    add_custom_target (compressed_${name} ALL DEPENDS ${compressed})
    install (FILES ${compressed} DESTINATION ${directory})
endfunction()

# antinode_install_bundle (TARGET DIRECTORY): a plug-in's folder as JUCE has built it.
function (antinode_install_bundle target directory)
    set (bundle "$<GENEX_EVAL:$<TARGET_PROPERTY:${target},JUCE_PLUGIN_ARTEFACT_FILE>>")
    install (DIRECTORY "${bundle}" DESTINATION ${directory}
        FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
    # `cmake --install --strip` knows programs and libraries only.
    install (CODE "
        if (CMAKE_INSTALL_DO_STRIP)
            get_filename_component (name [[${bundle}]] NAME)
            file (GLOB_RECURSE libraries \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${directory}/\${name}/*\")
            list (FILTER libraries INCLUDE REGEX \"[.]so$|-win/[^/]*[.]vst3$\")
            execute_process (COMMAND ${CMAKE_STRIP} --strip-unneeded \${libraries} COMMAND_ERROR_IS_FATAL ANY)
        endif()")
endfunction()

set (plugins Antinode AntinodePlate AntinodeTouch)

# For Windows: one folder with the programs, the plug-ins and the manual.
if (WIN32)
    foreach (plugin IN LISTS plugins)
        if (TARGET ${plugin}VST3_VST3)
            antinode_install_bundle (${plugin}VST3_VST3 VST3)
        endif()
    endforeach()
    if (TARGET antinode)
        install (TARGETS antinode antinode_standalone RUNTIME DESTINATION .)
        install (FILES README.md CONTRIBUTING.md CHANGELOG.md LICENSE DESTINATION .)
        install (FILES ${resources}/Debian/copyright DESTINATION . RENAME COPYRIGHT)
        install (DIRECTORY Docs DESTINATION . PATTERN Man EXCLUDE)
    endif()
    return()
endif()

if (TARGET antinode)
    install (TARGETS antinode RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    antinode_install_compressed (${ANTINODE_DOCUMENTS}/antinode.1 ${CMAKE_INSTALL_MANDIR}/man1 antinode.1)
    if (TARGET antinode_manual_page)
        add_dependencies (compressed_antinode.1 antinode_manual_page)
    endif()
    install (FILES ${resources}/Completion/antinode DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
    install (FILES ${resources}/Completion/_antinode DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
    install (FILES ${resources}/Completion/antinode.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
    install (FILES README.md CONTRIBUTING.md LICENSE DESTINATION ${documents})
    install (DIRECTORY Docs DESTINATION ${documents} PATTERN Man EXCLUDE)
    install (FILES ${resources}/Debian/copyright DESTINATION ${documents})
    antinode_install_compressed (${PROJECT_SOURCE_DIR}/CHANGELOG.md ${documents} changelog)
    antinode_install_compressed (${ANTINODE_DOCUMENTS}/changelog ${documents} changelog.Debian)
    install (FILES ${resources}/Debian/lintian-overrides
        DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME antinode)
endif()

foreach (plugin IN LISTS plugins)
    if (TARGET ${plugin}VST3_VST3)
        antinode_install_bundle (${plugin}VST3_VST3 ${ANTINODE_PLUGIN_DIRECTORY}/vst3)
    endif()
endforeach()

foreach (ceramics IN LISTS ANTINODE_LV2_CERAMICS)
    foreach (plugin IN LISTS plugins)
        if (TARGET ${plugin}LV2_${ceramics}_LV2)
            antinode_install_bundle (${plugin}LV2_${ceramics}_LV2 ${ANTINODE_PLUGIN_DIRECTORY}/lv2)
        endif()
    endforeach()
endforeach()

if (TARGET antinode_standalone)
    install (TARGETS antinode_standalone RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    antinode_install_compressed (${ANTINODE_DOCUMENTS}/antinode-standalone.1 ${CMAKE_INSTALL_MANDIR}/man1
                                 antinode-standalone.1)
    install (FILES ${resources}/Completion/antinode DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME antinode-standalone)
    install (FILES ${resources}/Completion/antinode.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
        RENAME antinode-standalone.fish)
    set (identifier example.antinode.Antinode)
    install (FILES ${resources}/Desktop/${identifier}.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
    install (FILES ${ANTINODE_DOCUMENTS}/${identifier}.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
    set (icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
    install (FILES ${resources}/Desktop/antinode.svg DESTINATION ${icons}/scalable/apps RENAME ${identifier}.svg)

    foreach (size 16 22 24 32 48 64 128 256)
        install (FILES ${resources}/Desktop/antinode-${size}.png DESTINATION ${icons}/${size}x${size}/apps
            RENAME ${identifier}.png)
    endforeach()
endif()

# The package for Python, which needs none of the other files: python3-antinode.
if (TARGET antinode_python)
    set (python_package lib/python3/dist-packages/antinode)
    get_target_property (layer antinode_python ANTINODE_LAYER)
    install (TARGETS antinode_python LIBRARY DESTINATION ${python_package} COMPONENT python)
    install (FILES ${layer} DESTINATION ${python_package} COMPONENT python)
    set (python_documents ${CMAKE_INSTALL_DATADIR}/doc/python3-antinode)
    install (FILES ${resources}/Debian/copyright DESTINATION ${python_documents} COMPONENT python)
    # Scripts/python builds this target alone and packs what it installs.
    add_dependencies (antinode_python compressed_changelog.Debian)
    install (FILES ${CMAKE_BINARY_DIR}/compressed/changelog.Debian.gz DESTINATION ${python_documents} COMPONENT python)
    install (FILES ${resources}/Debian/python-lintian-overrides
        DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME python3-antinode COMPONENT python)
endif()
