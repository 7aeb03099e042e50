# antinode_plugin (TARGET NAME CERAMICS URI CODE FORMAT ENTRY EDITOR ISSYNTH TAKESMIDI CATEGORIES...): one binary of a plug-in.
function (antinode_plugin target name ceramics uri code format entry editor is_synth takes_midi)
    juce_add_plugin (${target}
        PRODUCT_NAME "${name}" COMPANY_NAME "Antinode" COMPANY_WEBSITE "https://antinode.example"
        COMPANY_EMAIL "mailto:antinode@antinode.example" BUNDLE_ID "example.antinode.${target}"
        PLUGIN_MANUFACTURER_CODE Anti PLUGIN_CODE ${code} FORMATS ${format} LV2URI "${uri}"
        IS_SYNTH ${is_synth} NEEDS_MIDI_INPUT ${takes_midi} NEEDS_MIDI_OUTPUT FALSE IS_MIDI_EFFECT FALSE
        VST3_CATEGORIES ${ARGN} COPY_PLUGIN_AFTER_BUILD FALSE)
    target_sources (${target} PRIVATE ${entry})
    # A Debian patch of JUCE ignores the URI above.
    target_compile_definitions (${target} PUBLIC ANTINODE_LV2_CERAMICS=${ceramics} JucePlugin_LV2URI="${uri}")
    target_link_libraries (${target} PUBLIC ${editor})
    # What its VST3 does not do: Docs/Design/plugins.md.
    get_target_property (folder juce::juce_audio_plugin_client INTERFACE_JUCE_MODULE_PATH)
    set_source_files_properties (${folder}/juce_audio_plugin_client/juce_audio_plugin_client_VST3.cpp PROPERTIES
        COMPILE_OPTIONS "-include;${PROJECT_SOURCE_DIR}/Source/Processor/VST3Controller.h"
        OBJECT_DEPENDS ${PROJECT_SOURCE_DIR}/Source/Processor/VST3Controller.h)
    # Only ours is compiled with our warnings: JUCE 8 does not pass them, and its files are compiled for each plug-in.
    set_source_files_properties (${entry} PROPERTIES COMPILE_OPTIONS "$<TARGET_PROPERTY:antinode_options,INTERFACE_COMPILE_OPTIONS>")
endfunction()

# antinode_plugins (TARGET NAME SLUG CODE ENTRY EDITOR ISSYNTH TAKESMIDI CATEGORIES...): a plug-in as VST3 and as LV2, which freezes its ports when it is
# built: each number of ceramics is a bundle of its own. CODE has three letters; with its number it stays what sessions know.
set (ANTINODE_LV2_CERAMICS 32 CACHE STRING "Numbers of ceramics that LV2 plug-ins are built for, of 8;16;32;64")
function (antinode_plugins target name slug code)
    set (uri "https://antinode.example/plugins/${slug}")
    antinode_plugin (${target}VST3 "${name}" 32 "${uri}-32" ${code}0 VST3 ${ARGN})
    if (WIN32)
        return() # LV2's tables are written by a program that loads the plug-in, which a cross compiler cannot do.
    endif()
    set (lv2_numbers 8 16 32 64)
    foreach (ceramics IN LISTS ANTINODE_LV2_CERAMICS)
        list (FIND lv2_numbers ${ceramics} number)
        math (EXPR number "${number} + 1")
        antinode_plugin (${target}LV2_${ceramics} "${name} ${ceramics}" ${ceramics} "${uri}-${ceramics}" ${code}${number} LV2 ${ARGN})
    endforeach()
endfunction()
