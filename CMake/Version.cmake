# Documents that name the version. It stands in project() of CMakeLists.txt, and the time of its release here: nowhere else.
set (release_time 1795262400) # Seconds since 1970, `date --utc --date @1795262400`.
set (own_time "$ENV{SOURCE_DATE_EPOCH}")
set (ENV{SOURCE_DATE_EPOCH} ${release_time})
string (TIMESTAMP ANTINODE_DATE "%Y-%m-%d" UTC)
string (TIMESTAMP ANTINODE_DEBIAN_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
string (TIMESTAMP ANTINODE_COMPILER_DATE "%b %d %Y" UTC)
if (own_time STREQUAL "")
    unset (ENV{SOURCE_DATE_EPOCH})
else()
    set (ENV{SOURCE_DATE_EPOCH} ${own_time})
endif()

# Each as it is installed, in the folder of documents. To the page of antinode the program adds its options: Source/CMakeLists.txt.
set (ANTINODE_DOCUMENTS ${CMAKE_BINARY_DIR}/documents)
configure_file (Docs/Man/antinode.1 ${CMAKE_BINARY_DIR}/commands.1 @ONLY)
foreach (file Docs/Man/antinode-standalone.1 Resources/Debian/changelog
         Resources/Desktop/example.antinode.Antinode.metainfo.xml)
    get_filename_component (name ${file} NAME)
    configure_file (${file} ${ANTINODE_DOCUMENTS}/${name} @ONLY)
endforeach()
