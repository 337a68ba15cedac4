# Compiler settings and the two functions every folder uses: vigil_library and vigil_test.

find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(Threads REQUIRED)

add_library(vigil_options INTERFACE)
target_compile_features(vigil_options INTERFACE cxx_std_20)
target_compile_options(vigil_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror
  $<$<CXX_COMPILER_ID:GNU>:-Wno-error=stringop-overflow -Wno-error=array-bounds -Wno-error=maybe-uninitialized>)
# GLM's types only; its experimental extensions and implicit swizzles stay off.
target_compile_definitions(vigil_options INTERFACE GLM_FORCE_XYZW_ONLY GLM_FORCE_SIZE_T_LENGTH)
target_include_directories(vigil_options INTERFACE ${CMAKE_SOURCE_DIR}/src)
target_include_directories(vigil_options INTERFACE ${CMAKE_SOURCE_DIR}/shaders)
target_link_libraries(vigil_options INTERFACE fmt::fmt glm::glm Threads::Threads)

if(VIGIL_SANITIZE)
  target_compile_options(vigil_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -O1)
  target_link_options(vigil_options INTERFACE -fsanitize=address,undefined)
endif()

if(VIGIL_FUZZ)
  target_compile_options(vigil_options INTERFACE
    -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -O1 -g)
  target_link_options(vigil_options INTERFACE -fsanitize=address,undefined)
endif()

# vigil_library(NAME SOURCES ... DEPENDS ...): a static library with the project's settings.
function(vigil_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC vigil_options ${ARG_DEPENDS})
endfunction()

# vigil_test(NAME SOURCES ... LIBS ... [GPU [ASSISTED]]): a GoogleTest binary, registered with ctest.
# GPU tests get the label "gpu", the others "unit". ASSISTED: also "assisted", for those that can run as a whole under
# GPU-assisted validation, whose instrumented shaders take a software driver long to compile and to run.
function(vigil_test name)
  cmake_parse_arguments(ARG "GPU;ASSISTED" "" "SOURCES;LIBS" ${ARGN})
  find_package(GTest REQUIRED)
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE vigil_options ${ARG_LIBS} GTest::gtest GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE VIGIL_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${CMAKE_BINARY_DIR})
  set_property(TEST ${name} PROPERTY ENVIRONMENT
    "LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/lsan.supp:print_suppressions=0")
  if(ARG_GPU AND VIGIL_SANITIZE)
    target_sources(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests/gpu/keep_libraries.cpp)
  endif()
  if(ARG_GPU)
    # Under sanitizers they take up to five times as long.
    set_tests_properties(${name} PROPERTIES LABELS gpu TIMEOUT $<IF:$<BOOL:${VIGIL_SANITIZE}>,6000,1200>)
  else()
    set_tests_properties(${name} PROPERTIES LABELS unit TIMEOUT 300)
  endif()
  if(ARG_ASSISTED)
    set_property(TEST ${name} APPEND PROPERTY LABELS assisted)
  endif()
endfunction()

# vigil_test_assisted(NAME CASE): that case of the test by itself under GPU-assisted validation, where the whole program
# would take too long; cases run beside each other.
function(vigil_test_assisted name case)
  if(VIGIL_SANITIZE)
    return()
  endif()
  add_test(NAME ${name}_${case} COMMAND ${name} "--gtest_filter=*.${case}:*/${case}")
  set_tests_properties(${name}_${case} PROPERTIES LABELS assisted TIMEOUT 3600)
endfunction()

# vigil_test_subgroups(NAME): the test again at each other subgroup size that lavapipe can have. Other drivers ignore the
# variables; the shader cache would hand out code of another size. Not under sanitizers: the host does the same each time.
function(vigil_test_subgroups name)
  if(VIGIL_SANITIZE)
    return()
  endif()
  foreach(width IN ITEMS 128 512)
    add_test(NAME ${name}_${width} COMMAND ${name})
    set_tests_properties(${name}_${width} PROPERTIES LABELS gpu TIMEOUT 1200
      ENVIRONMENT "LP_NATIVE_VECTOR_WIDTH=${width};MESA_SHADER_CACHE_DISABLE=true")
  endforeach()
endfunction()
