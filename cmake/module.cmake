# module(io_scene USES io_base HIDES glm::glm SOURCES scene.cpp …): one folder, one static library.
# USES are the floors it may include; HIDES are libraries from outside that no header of it may show;
# SHOWS are the few (GLM, fmt) that its headers need.
function(module name)
    cmake_parse_arguments(M "" "" "SOURCES;USES;HIDES;SHOWS" ${ARGN})
    add_library(${name} STATIC ${M_SOURCES})
    target_link_libraries(${name} PUBLIC project_options ${M_USES} ${M_SHOWS} PRIVATE ${M_HIDES})
    if(BUILD_TESTING)
        file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
        list(JOIN M_USES "," uses)
        add_test(NAME include_rule.${name} COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR}
                 -DFOLDER=${folder} -DALLOWED=${name},${uses} -P ${PROJECT_SOURCE_DIR}/cmake/include_rule.cmake)
    endif()
endfunction()
