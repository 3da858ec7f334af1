cmake_minimum_required(VERSION 3.22)
function(step)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
if(SANITIZE)
  set(flags -DCMAKE_CXX_FLAGS=-fsanitize=${SANITIZE})
  set(sanitize -fsanitize=${SANITIZE})
endif()
step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
step(${CMAKE_COMMAND} -S ${HOST} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
     -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_PREFIX_PATH=${WORK}/prefix ${flags})
step(${CMAKE_COMMAND} --build ${WORK}/build)
step(${WORK}/build/host ${SOURCE}/shaderpack ${SOURCE}/worlds/cornell)

# The C interface needs neither CMake nor C++: what pkg-config says is enough.
file(GLOB_RECURSE pc ${WORK}/prefix/*/orris.pc)
get_filename_component(pc_dir ${pc} DIRECTORY)
get_filename_component(lib_dir ${pc_dir} DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${pc_dir})
execute_process(COMMAND pkg-config --cflags --libs orris OUTPUT_VARIABLE words
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(words)
step(${CC} -std=c99 -Wall -Wextra -Werror -pedantic ${sanitize} ${SOURCE}/tests/embed/quick_start.c
     -o ${WORK}/quick_start ${words} -Wl,-rpath,${lib_dir})
step(${WORK}/quick_start ${SOURCE}/tests/packs/engine ${SOURCE}/worlds/lamps ${WORK}/picture.ppm)
file(SIZE ${WORK}/picture.ppm size)
if(NOT size EQUAL 43214)  # 160x90 with the head
  message(FATAL_ERROR "picture.ppm has ${size} bytes")
endif()
