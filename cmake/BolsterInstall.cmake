# Where an installed Bolster and its files go.
include(GNUInstallDirs)

set(bolster_helpers
    bolster_image_decoder bolster_cad_reader bolster_scene_reader bolster_salvager bolster_bench_program)
install(TARGETS bolster RUNTIME)
install(TARGETS ${bolster_helpers} RUNTIME DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/bolster")
install(TARGETS bolster_imaging_module LIBRARY DESTINATION "${CMAKE_INSTALL_LIBEXECDIR}/bolster")

# On the desktop: menu, kind of file, icons, pictures of projects in file managers, the entry of software centres.
install(FILES resources/bolster.desktop DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
install(FILES resources/bolster-mime.xml DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages" RENAME bolster.xml)
install(FILES resources/icons/bolster.svg DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
foreach(kind IN ITEMS project design)
    install(FILES resources/packaging/document.svg DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/mimetypes"
        RENAME application-x-bolster-${kind}.svg)
endforeach()
install(FILES resources/packaging/bolster.thumbnailer DESTINATION "${CMAKE_INSTALL_DATADIR}/thumbnailers")
install(FILES resources/packaging/org.bolster.Bolster.metainfo.xml DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo")

# In the shell. The page is what the program says of itself.
install(FILES resources/packaging/bolster.bash-completion
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME bolster)
set(bolster_man_page "${PROJECT_BINARY_DIR}/bolster.1.gz")
add_custom_command(OUTPUT "${bolster_man_page}"
    COMMAND "${PROJECT_SOURCE_DIR}/resources/packaging/man-page" "$<TARGET_FILE:bolster>" "${bolster_man_page}"
    DEPENDS bolster resources/packaging/man-page
    COMMENT "Writing the manual page" VERBATIM)
install(FILES "${bolster_man_page}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
# All that is installed, without tests.
add_custom_target(bolster_shipped ALL
    DEPENDS "${bolster_man_page}" bolster ${bolster_helpers} bolster_imaging_module)

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
install(DIRECTORY docs DESTINATION "${bolster_documents}" COMPONENT documents
    PATTERN manual EXCLUDE
    PATTERN "make-*" EXCLUDE)
# The manual as HTML pages and a PDF, for who asks for it; what it needs is not needed to build the program.
add_custom_target(manual_book
    COMMAND "${PROJECT_SOURCE_DIR}/docs/manual/make-book" "${PROJECT_BINARY_DIR}/book"
    COMMENT "Writing the manual as a book" VERBATIM)
install(DIRECTORY "${PROJECT_BINARY_DIR}/book/" DESTINATION "${bolster_documents}/book" COMPONENT documents OPTIONAL)
# The program opens the manual, so it does not lie among documents, which may be left out; links lead there.
install(DIRECTORY docs/manual/ DESTINATION "${CMAKE_INSTALL_DATADIR}/bolster/manual" COMPONENT samples
    PATTERN "make-*" EXCLUDE)
install(CODE "
    set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${bolster_documents}\")
    file(CREATE_LINK ../../bolster/manual \"\${folder}/manual\" SYMBOLIC)
    file(CREATE_LINK ../../../bolster/manual \"\${folder}/docs/manual\" SYMBOLIC)"
    COMPONENT documents)
install(CODE "
    set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${bolster_documents}/resources\")
    file(MAKE_DIRECTORY \"\${folder}\")
    file(CREATE_LINK ../../../bolster/samples \"\${folder}/samples\" SYMBOLIC)"
    COMPONENT documents)
