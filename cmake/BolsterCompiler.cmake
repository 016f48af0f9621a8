# Compiler settings that every target of Bolster shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # What one checkout has compiled, another one finds: no path outside of the cache's base counts, and none gets into
    # debug information. (Here and not in the environment, so that it holds for CMake called by hand, too.)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1
        CCACHE_SLOPPINESS=pch_defines,time_macros "${CCACHE_PROGRAM}")
endif()
add_compile_options("-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.")

find_program(LLD_PROGRAM ld.lld)
if(LLD_PROGRAM AND (NOT BOLSTER_SANITIZE OR CMAKE_CXX_COMPILER_ID MATCHES Clang))
    add_link_options(-fuse-ld=lld)
endif()

# What a mistake must not be able to do: write over the tables of functions (all bound at the start, then read-only), run
# from a known address, return to where a buffer has overflowed to.
include(CheckPIESupported)
check_pie_supported()
add_link_options(LINKER:-z,relro,-z,now,-z,noexecstack)

if(BOLSTER_SANITIZE)
    add_compile_options(-fsanitize=${BOLSTER_SANITIZE} -fno-omit-frame-pointer -g1)
    add_link_options(-fsanitize=${BOLSTER_SANITIZE})
    if(BOLSTER_SANITIZE MATCHES undefined)
        # Before every access; more than half of the compile time. AddressSanitizer stops at null and beyond objects, too.
        add_compile_options(-fno-sanitize=null,alignment,pointer-overflow,object-size)
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        # GCC does not see through the checks that it has put in, and warns of what they guard; Release keeps the warning.
        add_compile_options(-Wno-maybe-uninitialized)
    endif()
endif()

# For folders that wait more than they compute (everything but the solver): with a sanitizer they are compiled in half of the
# time.
macro(bolster_compiled_soon)
    if(BOLSTER_SANITIZE)
        add_compile_options(-O0)
        unset(BOLSTER_PRECOMPILED) # those of the folders above are optimised
    endif()
endmacro()

if(BOLSTER_ODR)
    # Only the objects are of use; a program that something else depends on is an empty file.
    add_compile_options(-flto -fno-fat-lto-objects)
    set(CMAKE_CXX_LINK_EXECUTABLE "\"${CMAKE_COMMAND}\" -E touch <TARGET>")
    set(CMAKE_CXX_CREATE_STATIC_LIBRARY "${CMAKE_CXX_LINK_EXECUTABLE}")
endif()

# Makes a library of Bolster of a folder and, where it has such, its rooms: warnings, its include roots, and a check that
# every header compiles alone: one with a source is its first include (structure.rooms) and shows it in the preset dev, the
# others by the target NAME_verify_interface_header_sets.
#   bolster_library(NAME [INNER_LOOPS] UNITS [room/]name... PUBLIC lib... PRIVATE lib...)
# A unit is a header, a source, or both of one name. Each folder that units are in is an include root. INNER_LOOPS: indices
# are not checked as it runs, which cost a cushioned car seat a sixth of its time.
function(bolster_library name)
    cmake_parse_arguments(ARG "INNER_LOOPS" "" "UNITS;PUBLIC;PRIVATE" ${ARGN})
    add_library(${name} STATIC)
    set(rooms "")
    foreach(unit IN LISTS ARG_UNITS)
        cmake_path(ABSOLUTE_PATH unit)
        if(NOT EXISTS "${unit}.h" AND NOT EXISTS "${unit}.cpp")
            message(FATAL_ERROR "${name}: there is neither ${unit}.h nor ${unit}.cpp")
        endif()
        if(EXISTS "${unit}.cpp")
            target_sources(${name} PRIVATE "${unit}.cpp")
        endif()
        if(EXISTS "${unit}.h")
            cmake_path(GET unit PARENT_PATH room)
            list(APPEND rooms "${room}")
            if(EXISTS "${unit}.cpp")
                list(APPEND "headers_${room}" "${unit}.h")
            else()
                list(APPEND "alone_${room}" "${unit}.h")
            endif()
        endif()
    endforeach()
    list(REMOVE_DUPLICATES rooms)
    set(verified "")
    foreach(room IN LISTS rooms)
        cmake_path(RELATIVE_PATH room BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" OUTPUT_VARIABLE set)
        string(MAKE_C_IDENTIFIER "rooms/${set}" set)
        target_sources(${name} PUBLIC FILE_SET ${set} TYPE HEADERS BASE_DIRS "${room}" FILES ${headers_${room}})
        if(alone_${room})
            target_sources(${name} PUBLIC FILE_SET alone_${set} TYPE HEADERS BASE_DIRS "${room}" FILES ${alone_${room}})
            list(APPEND verified alone_${set})
        endif()
    endforeach()
    if(verified)
        set_target_properties(${name} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON INTERFACE_HEADER_SETS_TO_VERIFY "${verified}")
    endif()
    target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    bolster_warnings(${name})
    bolster_hardened(${name})
    if(ARG_INNER_LOOPS)
        target_compile_options(${name} PRIVATE -U_GLIBCXX_ASSERTIONS)
    elseif(BOLSTER_PRECOMPILED)
        target_precompile_headers(${name} REUSE_FROM ${BOLSTER_PRECOMPILED})
    endif()
endfunction()

# bolster_precompiled(NAME [HARDENED] HEADERS header... LIBS lib...): what many units of this folder, and of those below it,
# begin with is read once for all of them. Only in unity builds: what is compiled alone (preset dev) shows that each file
# includes what it needs.
function(bolster_precompiled name)
    cmake_parse_arguments(ARG "HARDENED" "" "HEADERS;LIBS" ${ARGN})
    if(NOT CMAKE_UNITY_BUILD OR BOLSTER_ODR)
        return()
    endif()
    add_library(${name} OBJECT "${PROJECT_SOURCE_DIR}/cmake/Precompiled.cpp")
    set_target_properties(${name} PROPERTIES AUTOMOC OFF)
    target_link_libraries(${name} PRIVATE ${ARG_LIBS})
    list(TRANSFORM ARG_HEADERS REPLACE "(.+)" "<\\1>")
    target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
    if(ARG_HARDENED)
        bolster_hardened(${name})
    endif()
    if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
        # What the cache gives back is older or younger than what it was made from.
        target_compile_options(${name} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
    endif()
    set(BOLSTER_PRECOMPILED ${name} PARENT_SCOPE)
endfunction()

# The headers that the standard library, Eigen and Qt have for all that a folder does.
set(BOLSTER_STANDARD_HEADERS algorithm array atomic charconv chrono cmath cstdint functional limits map memory mutex numbers
    numeric optional set span stop_token string string_view utility vector Eigen/Core Eigen/Geometry)
set(BOLSTER_WINDOW_HEADERS QAction QApplication QBoxLayout QComboBox QDialogButtonBox QDir QFile QFileInfo QFormLayout QImage
    QKeyEvent QLabel QLineEdit QListWidget QLocale QMainWindow QMenu QPainter QPainterPath QPointer QPushButton QSettings QTimer
    QToolButton QTreeWidget)

# For all that is shipped: a buffer that overflows ends the program, and so do functions of the C library that would write
# beyond their target, and an index beyond the end of a container.
function(bolster_hardened name)
    if(NOT BOLSTER_SANITIZE)
        target_compile_options(${name} PRIVATE -fstack-protector-strong
                                               $<$<CONFIG:Release>:-U_FORTIFY_SOURCE> $<$<CONFIG:Release>:-D_FORTIFY_SOURCE=2>
                                               $<$<CONFIG:Release>:-D_GLIBCXX_ASSERTIONS>)
    endif()
endfunction()

# In a unity build a file sees the names of those before it, which no local name shadows in earnest: there only
# locals are compared. The ordinary build (dev) compares all.
function(bolster_warnings name)
    if(NOT CMAKE_UNITY_BUILD)
        set(shadow -Wshadow)
    elseif(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        set(shadow -Wshadow=local)
    else()
        set(shadow "")
    endif()
    target_compile_options(${name} PRIVATE -Wall -Wextra ${shadow} -Wnon-virtual-dtor -Woverloaded-virtual
                                           $<$<BOOL:${BOLSTER_WERROR}>:-Werror>)
endfunction()
