# Run by CPack on the files that it is about to pack (CPACK_PRE_BUILD_SCRIPTS): what Debian wants in its own form.
set(usr "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr")
set(documents "${usr}/share/doc/bolster")

# Of licences that every system has, packages hold no copies; documents link to it.
file(REMOVE "${documents}/LICENSE")
file(CREATE_LINK ../../common-licenses/GPL-3 "${documents}/LICENSE" SYMBOLIC)
configure_file("${CPACK_BOLSTER_PACKAGING}/debian/copyright" "${documents}/copyright" COPYONLY)
execute_process(COMMAND gzip -9nc "${CPACK_BOLSTER_PACKAGING}/debian/changelog"
    OUTPUT_FILE "${documents}/changelog.gz" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CPACK_BOLSTER_PACKAGING}/sbom" "${usr}" "${CPACK_PACKAGE_VERSION}"
    OUTPUT_FILE "${documents}/bolster.spdx.json" COMMAND_ERROR_IS_FATAL ANY)
file(CHMOD "${documents}/copyright" "${documents}/changelog.gz" "${documents}/bolster.spdx.json"
    PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
