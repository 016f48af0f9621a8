# Where an installed Bolster and its files go.
include(GNUInstallDirs)

install(TARGETS bolster RUNTIME)
install(TARGETS bolster_image_decoder bolster_cad_reader bolster_scene_reader bolster_salvager bolster_bench_program RUNTIME DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/bolster")
install(TARGETS bolster_imaging_module LIBRARY DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/bolster")
install(FILES resources/bolster.desktop DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES resources/bolster-mime.xml DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" RENAME bolster.xml)
install(FILES resources/icons/bolster.svg DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
install(DIRECTORY resources/samples/ DESTINATION "${CMAKE_INSTALL_DATADIR}/bolster/samples" COMPONENT samples
    PATTERN tools EXCLUDE
    PATTERN README.md EXCLUDE)
install(DIRECTORY resources/templates/ DESTINATION "${CMAKE_INSTALL_DATADIR}/bolster/templates" COMPONENT samples
    PATTERN tools EXCLUDE
    PATTERN make EXCLUDE
    PATTERN README.md EXCLUDE)

# As in the sources, so that links between the documents hold.
set(bolster_documents "${CMAKE_INSTALL_DATADIR}/doc/bolster")
install(FILES LICENSE README.md ARCHITECTURE.md CONTRIBUTING.md DESTINATION "${bolster_documents}"
    COMPONENT documents)
install(DIRECTORY docs DESTINATION "${bolster_documents}" COMPONENT documents)
install(CODE "
    set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${bolster_documents}/resources\")
    file(MAKE_DIRECTORY \"\${folder}\")
    file(CREATE_LINK ../../../bolster/samples \"\${folder}/samples\" SYMBOLIC)"
    COMPONENT documents)
