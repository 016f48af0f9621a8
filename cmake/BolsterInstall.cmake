# Where an installed Bolster and its files go.
include(GNUInstallDirs)

install(TARGETS bolster RUNTIME)
install(TARGETS bolster_image_decoder bolster_salvager RUNTIME DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/bolster")
install(FILES resources/bolster.desktop DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES resources/bolster-mime.xml DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" RENAME bolster.xml)
install(FILES resources/icons/bolster.svg DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
install(DIRECTORY resources/samples/ DESTINATION "${CMAKE_INSTALL_DATADIR}/bolster/samples"
    PATTERN tools EXCLUDE
    PATTERN README.md EXCLUDE)
install(FILES LICENSE README.md DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/bolster")
