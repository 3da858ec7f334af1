cmake_minimum_required(VERSION 3.22)
# None of PROGRAMS may link GL, a window system or picture codecs, directly or through a library.
foreach(program IN LISTS PROGRAMS)
  execute_process(COMMAND ldd ${program} OUTPUT_VARIABLE libraries COMMAND_ERROR_IS_FATAL ANY)
  if(libraries MATCHES "lib(GL|EGL|OSMesa|glfw|X11|OpenImageIO)[^ \t]*")
    message(SEND_ERROR "${program} links ${CMAKE_MATCH_0}")
  endif()
endforeach()
