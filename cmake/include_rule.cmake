cmake_minimum_required(VERSION 3.25) # IN_LIST
# Fails when a file of FOLDER includes a floor that is not in ALLOWED (targets, as io_scene for io/scene, app_play for app/play),
# or a library from outside that belongs to another floor.
set(rooms "app/play" "app/sound") # libraries of their own inside a floor
string(REPLACE "," ";" allowed "${ALLOWED}")
set(folders "")
foreach(target IN LISTS allowed)
    if(target MATCHES "^(io|app)_(.+)$")
        list(APPEND folders "${CMAKE_MATCH_1}/${CMAKE_MATCH_2}")
    elseif(target)
        list(APPEND folders "${target}")
    endif()
endforeach()

# Header (as a regular expression) -> the folders that may include it.
set(owned
    "tiny_gltf|OpenImageIO/|simdjson|nlohmann/|meshoptimizer|png.h|jpeglib.h=io/files"
    "epoxy/gl=renderer"
    "epoxy/egl|GLFW/|CLI/|imgui_impl_=app"
    "AL/=app/sound"
    "sndfile=app/sound,projects/make"
    "embree[34]/=editor"
    "btBullet|BulletCollision/|BulletDynamics/|LinearMath/=app/play"
    "imgui=editor,app")

set(faults "")
file(GLOB_RECURSE sources ${ROOT}/${FOLDER}/*.h ${ROOT}/${FOLDER}/*.cpp)
foreach(room IN LISTS rooms)
    if(NOT room STREQUAL FOLDER)
        list(FILTER sources EXCLUDE REGEX "^${ROOT}/${room}/")
    endif()
endforeach()
list(JOIN rooms "|" rooms)
foreach(source IN LISTS sources)
    file(STRINGS ${source} lines REGEX "^#include ")
    foreach(line IN LISTS lines)
        if(line MATCHES "\"((io/[a-z]+|${rooms}|renderer|editor|app)/[^\"]*)\"")
            if(NOT CMAKE_MATCH_2 IN_LIST folders)
                string(APPEND faults "\n${source}: includes ${CMAKE_MATCH_1}")
            endif()
        else()
            foreach(rule IN LISTS owned)
                string(REGEX MATCH "^(.*)=(.*)$" unused "${rule}")
                set(pattern "${CMAKE_MATCH_1}")
                string(REPLACE "," ";" owners "${CMAKE_MATCH_2}")
                if(line MATCHES "<(${pattern})" AND NOT FOLDER IN_LIST owners)
                    string(APPEND faults "\n${source}: ${line} belongs to ${owners}")
                endif()
            endforeach()
        endif()
    endforeach()
endforeach()
if(faults)
    message(FATAL_ERROR "arrows that run up a floor:${faults}")
endif()
