cmake_minimum_required(VERSION 3.22)
# Every #include <orris/x/...> of a folder must name the folder itself or one of its USES (direct or
# inherited through them is not enough: what is used is listed).
file(GLOB_RECURSE sources ${FOLDER}/*.h ${FOLDER}/*.cpp)
foreach(source IN LISTS sources)
  file(STRINGS ${source} includes REGEX "^#include <orris/[a-z]+/")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE "^#include <orris/([a-z]+)/.*" "\\1" used "${line}")
    if(used IN_LIST ALL AND NOT used IN_LIST USES)
      message(SEND_ERROR "${source}: ${line}: this folder may use only: ${USES}")
    endif()
  endforeach()
endforeach()
