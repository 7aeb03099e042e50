# Read by cpack once a format: an archive is unpacked anywhere, so it has a folder of its own and no /usr.
if (CPACK_GENERATOR STREQUAL "TGZ")
    set (CPACK_PACKAGING_INSTALL_PREFIX "")
    set (CPACK_INCLUDE_TOPLEVEL_DIRECTORY ON)
endif()
