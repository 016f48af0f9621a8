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
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

find_program(LLD_PROGRAM ld.lld)
if(LLD_PROGRAM AND NOT BOLSTER_SANITIZE)
    add_link_options(-fuse-ld=lld)
endif()

if(BOLSTER_SANITIZE)
    add_compile_options(-fsanitize=${BOLSTER_SANITIZE} -fno-omit-frame-pointer -g1)
    add_link_options(-fsanitize=${BOLSTER_SANITIZE})
endif()

# Makes a library of Bolster: warnings, its include root, and a check that every public header
# compiles alone (target NAME_verify_interface_header_sets).
#   bolster_library(NAME ROOTS dir... HEADERS file... SOURCES file... PUBLIC lib... PRIVATE lib...)
function(bolster_library name)
    cmake_parse_arguments(ARG "" "" "ROOTS;HEADERS;SOURCES;PUBLIC;PRIVATE" ${ARGN})
    add_library(${name} STATIC ${ARG_SOURCES})
    target_sources(${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${ARG_ROOTS} FILES ${ARG_HEADERS})
    set_target_properties(${name} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ON)
    target_link_libraries(${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
    bolster_warnings(${name})
endfunction()

function(bolster_warnings name)
    target_compile_options(${name} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                                           $<$<BOOL:${BOLSTER_WERROR}>:-Werror>)
endfunction()
