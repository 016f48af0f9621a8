# The Debian package: `cmake --build build/release --target bolster_deb` builds what is shipped and packs it; `cpack -G DEB`
# in the build folder packs what was built.
set(BOLSTER_MAINTAINER "Bolster maintainers <bolster@users.noreply.github.com>" CACHE STRING
    "Name and address of whoever publishes the package")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME bolster)
set(CPACK_PACKAGE_CONTACT "${BOLSTER_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "design upholstery from sewing pattern to cover, live")
set(CPACK_PACKAGE_DESCRIPTION "Bolster shows the cover of a chair or a car seat before anybody cuts leather.
From a sewing pattern, its seams and the curves along which the cover is fixed
to a frame it makes the sewn cover in 3D, with its folds and its strain, and
follows while a point of the pattern or of a fixation curve is dragged.
.
It draws and imports patterns, aligns and measures against scans, shows
fabrics, stitches and piping, writes patterns for cutters and paper, and lays
given forms flat. Everything works from the command line, too.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# What the programs are linked with, dpkg-shlibdeps finds. The rest is loaded while they run: OpenGL and EGL by Qt's plugins
# for X11 (in libqt6gui6, with the readers of JPEG), icons by the plugin in libqt6svg6, with which the program is linked, too.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1, libegl1")
# Windows under Wayland, words on standard buttons in other languages.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-wayland, qt6-translations-l10n, shared-mime-info, bash-completion")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "fonts-noto-cjk") # for Chinese and Japanese

# In Debian's form, besides what `cmake --install` gives to everybody.
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/BolsterDebian.cmake")
set(CPACK_BOLSTER_PACKAGING "${PROJECT_SOURCE_DIR}/resources/packaging")
include(CPack)

add_custom_target(bolster_deb
    COMMAND "${CMAKE_CPACK_COMMAND}" -G DEB --config "${PROJECT_BINARY_DIR}/CPackConfig.cmake"
    WORKING_DIRECTORY "${PROJECT_BINARY_DIR}"
    COMMENT "Packing the Debian package" VERBATIM)
add_dependencies(bolster_deb bolster_shipped)
