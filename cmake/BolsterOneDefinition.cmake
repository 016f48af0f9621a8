# The target "one_definition" (preset odr): two classes of the same name with different members are one class to the linker,
# and the program does whatever it likes. No compiler sees both; GCC's link-time optimiser does. So everything that there is,
# tests too, is compiled for it, and put together once without making a program of it.
function(bolster_targets_below folder result)
    get_property(found DIRECTORY "${folder}" PROPERTY BUILDSYSTEM_TARGETS)
    get_property(below DIRECTORY "${folder}" PROPERTY SUBDIRECTORIES)
    foreach(sub IN LISTS below)
        bolster_targets_below("${sub}" more)
        list(APPEND found ${more})
    endforeach()
    set(${result} ${found} PARENT_SCOPE)
endfunction()

function(bolster_one_definition)
    bolster_targets_below("${PROJECT_SOURCE_DIR}" targets)
    set(objects "")
    foreach(target IN LISTS targets)
        get_target_property(type ${target} TYPE)
        if(type MATCHES "^(EXECUTABLE|STATIC_LIBRARY|OBJECT_LIBRARY)$" AND NOT target MATCHES "_verify_interface_header_sets$")
            list(APPEND objects "$<TARGET_OBJECTS:${target}>")
        endif()
    endforeach()
    set(list "${PROJECT_BINARY_DIR}/one_definition.objects")
    set(together "${PROJECT_BINARY_DIR}/one_definition.o")
    file(GENERATE OUTPUT "${list}" CONTENT "$<JOIN:${objects},\n>\n")
    # Each program has a main() of its own.
    add_custom_command(OUTPUT "${together}"
        COMMAND "${CMAKE_CXX_COMPILER}" -O0 -flto=auto -r -flinker-output=rel -Wl,-z,muldefs
                -Wno-lto-type-mismatch -Werror=odr "@${list}" -o "${together}"
        DEPENDS ${objects} "${list}" VERBATIM COMMENT "Comparing the definitions of all classes")
    add_custom_target(one_definition DEPENDS "${together}")
endfunction()
