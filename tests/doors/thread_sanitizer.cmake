# The library under ThreadSanitizer, linked with the program of several threads. Of the library all is instrumented but the
# kernel, which has no state; drivers are not.
set(sources)
foreach(part truequad truequad_capture truequad_config)
  get_target_property(names ${part} SOURCES)
  get_target_property(directory ${part} SOURCE_DIR)
  list(TRANSFORM names PREPEND ${directory}/)
  list(APPEND sources ${names})
endforeach()
add_library(truequad_tsan SHARED ${sources})
target_include_directories(truequad_tsan PRIVATE $<TARGET_PROPERTY:truequad_capture,INCLUDE_DIRECTORIES>)
target_link_libraries(truequad_tsan PRIVATE truequad_driver truequad::kernel ${CMAKE_DL_LIBS})
target_compile_options(truequad_tsan PRIVATE -fsanitize=thread -O0 -g1 -fno-exceptions)
# The sanitizer itself calls dlsym before anything of ours may run.
file(READ ${PROJECT_SOURCE_DIR}/shim/doors/exports.map exports)
string(REPLACE " dlsym; dlopen;" "" exports "${exports}")
file(CONFIGURE OUTPUT thread_sanitizer.map CONTENT "${exports}" @ONLY)
target_link_options(truequad_tsan PRIVATE -fsanitize=thread -Wl,--version-script=${CMAKE_CURRENT_BINARY_DIR}/thread_sanitizer.map)

add_executable(threads_tsan threads_program.cc)
target_include_directories(threads_tsan PRIVATE ${PROJECT_SOURCE_DIR}/include)
target_compile_options(threads_tsan PRIVATE -fsanitize=thread -O1 -g1)
target_link_options(threads_tsan PRIVATE -fsanitize=thread -Wl,--no-as-needed)
target_link_libraries(threads_tsan PRIVATE truequad_tsan ${thread_drivers})

# Each in a process of its own: after the others in one process, Mesa 22.3 crashes in OSMesaDestroyContext at the end of
# `shared` about one time in three, without truequad just as often.
foreach(word own egl-own turns handed again shared settings)
  add_test(NAME doors.thread_sanitizer.${word} COMMAND threads_tsan ${word})
  set_tests_properties(doors.thread_sanitizer.${word} PROPERTIES TIMEOUT 300 ENVIRONMENT
    "LIBGL_ALWAYS_SOFTWARE=1;TSAN_OPTIONS=halt_on_error=0:exitcode=66:suppressions=${CMAKE_CURRENT_SOURCE_DIR}/thread_sanitizer.supp")
endforeach()
