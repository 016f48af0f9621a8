# Every library that Bolster uses, found once. ARCHITECTURE.md says what each is for.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED CONFIG)
find_package(CGAL 5.5 REQUIRED CONFIG)
find_package(OpenMesh REQUIRED CONFIG)
find_package(hwy 1.0 REQUIRED CONFIG)

# SuiteSparse has no CMake config in Debian 12.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
add_library(bolster_cholmod INTERFACE)
target_include_directories(bolster_cholmod SYSTEM INTERFACE "${CHOLMOD_INCLUDE_DIR}")
target_link_libraries(bolster_cholmod INTERFACE "${CHOLMOD_LIBRARY}")
find_library(UMFPACK_LIBRARY umfpack REQUIRED)

# Of FLANN only templates are used; they refer to LZ4 for files that are never written here.
find_path(FLANN_INCLUDE_DIR flann/algorithms/kdtree_single_index.h REQUIRED)
find_library(LZ4_LIBRARY lz4 REQUIRED)
add_library(bolster_flann INTERFACE)
target_include_directories(bolster_flann SYSTEM INTERFACE "${FLANN_INCLUDE_DIR}")
target_link_libraries(bolster_flann INTERFACE "${LZ4_LIBRARY}")

# No CMake config in Debian 12.
find_path(CLIPPER_INCLUDE_DIR polyclipping/clipper.hpp REQUIRED)
find_library(CLIPPER_LIBRARY polyclipping REQUIRED)
add_library(bolster_clipper INTERFACE)
target_include_directories(bolster_clipper SYSTEM INTERFACE "${CLIPPER_INCLUDE_DIR}")
target_link_libraries(bolster_clipper INTERFACE "${CLIPPER_LIBRARY}")

if(NOT BOLSTER_HEADLESS)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Core Gui Widgets OpenGL OpenGLWidgets PrintSupport Svg LinguistTools)
    find_package(SQLite3 3.37 REQUIRED)
    find_package(ZLIB REQUIRED)
    find_package(EXPAT REQUIRED)
    find_library(SECCOMP_LIBRARY seccomp REQUIRED)
    find_package(embree 3 REQUIRED CONFIG)
    find_package(OpenImageIO 2.4 REQUIRED CONFIG)

    # The config of OpenCASCADE wants all of its packages, the one for drawing included.
    find_path(OCCT_INCLUDE_DIR STEPCAFControl_Reader.hxx PATH_SUFFIXES opencascade REQUIRED)
    add_library(bolster_opencascade INTERFACE)
    target_include_directories(bolster_opencascade SYSTEM INTERFACE "${OCCT_INCLUDE_DIR}")
    foreach(toolkit IN ITEMS TKXDESTEP TKXDEIGES TKXCAF TKIGES TKSTEP TKXSBase TKLCAF TKCDF TKMesh TKTopAlgo TKGeomBase
            TKBRep TKG3d TKMath TKernel)
        find_library(OCCT_${toolkit} ${toolkit} REQUIRED)
        target_link_libraries(bolster_opencascade INTERFACE "${OCCT_${toolkit}}")
    endforeach()

    # Assimp's own config wants what only its static library would need.
    find_path(ASSIMP_INCLUDE_DIR assimp/Importer.hpp REQUIRED)
    find_library(ASSIMP_LIBRARY assimp REQUIRED)
    add_library(bolster_assimp INTERFACE)
    target_include_directories(bolster_assimp SYSTEM INTERFACE "${ASSIMP_INCLUDE_DIR}")
    target_link_libraries(bolster_assimp INTERFACE "${ASSIMP_LIBRARY}")

    find_package(meshoptimizer REQUIRED CONFIG)

    # OpenSubdiv's own config wants a static library that Debian does not ship.
    find_path(OSD_INCLUDE_DIR opensubdiv/version.h REQUIRED)
    find_library(OSD_CPU_LIBRARY osdCPU REQUIRED)
    add_library(bolster_opensubdiv INTERFACE)
    target_include_directories(bolster_opensubdiv SYSTEM INTERFACE "${OSD_INCLUDE_DIR}")
    target_link_libraries(bolster_opensubdiv INTERFACE "${OSD_CPU_LIBRARY}")

    # Debian's OpenImageIO target names a folder of OpenCV headers that its package does not bring.
    get_target_property(oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
    set(oiio_present "")
    foreach(dir IN LISTS oiio_includes)
        if(EXISTS "${dir}")
            list(APPEND oiio_present "${dir}")
        endif()
    endforeach()
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${oiio_present}")

    # The viewer of pages for customers.
    find_path(THREE_FOLDER three.min.js PATHS /usr/share/javascript/three REQUIRED)
endif()

if(BOLSTER_TESTS)
    find_package(GTest REQUIRED CONFIG)
    find_package(benchmark REQUIRED CONFIG)
    if(NOT BOLSTER_HEADLESS)
        find_package(Qt6 REQUIRED COMPONENTS Test)
        # Qt would give each test the folders it is built from and in, which nobody asks for, and which would make the
        # same test another one in each checkout.
        set_target_properties(Qt6::Test PROPERTIES INTERFACE_COMPILE_DEFINITIONS QT_TESTLIB_LIB)
    endif()
endif()
