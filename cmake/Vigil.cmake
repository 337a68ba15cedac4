# Compiler settings and the two functions every folder uses: vigil_library and vigil_test.

find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(Threads REQUIRED)

add_library(vigil_options INTERFACE)
target_compile_features(vigil_options INTERFACE cxx_std_20)
target_compile_options(vigil_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
  # A batch of files shares their constants: only names within a function are told.
  $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
if(VIGIL_WERROR)
  target_compile_options(vigil_options INTERFACE -Werror
    $<$<CXX_COMPILER_ID:GNU>:-Wno-error=stringop-overflow -Wno-error=array-bounds -Wno-error=maybe-uninitialized>)
endif()
if(glm_VERSION VERSION_GREATER_EQUAL 1)
  target_compile_options(vigil_options INTERFACE -Wno-unused-result) # GLM 1.0 wants the result of `a |= b` to be used
endif()
# GLM's types only; its experimental extensions and implicit swizzles stay off.
target_compile_definitions(vigil_options INTERFACE GLM_FORCE_XYZW_ONLY GLM_FORCE_SIZE_T_LENGTH)
target_include_directories(vigil_options INTERFACE ${CMAKE_SOURCE_DIR}/src)
target_include_directories(vigil_options INTERFACE ${CMAKE_SOURCE_DIR}/shaders)
target_link_libraries(vigil_options INTERFACE fmt::fmt glm::glm Threads::Threads)

if(VIGIL_SANITIZE)
  target_compile_options(vigil_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(vigil_options INTERFACE -fsanitize=address,undefined)
  target_compile_definitions(vigil_options INTERFACE VIGIL_SANITIZED)
endif()

# libFuzzer, of Clang: the libraries tell it which of their code ran (vigil_library); tests/fuzz makes its programs.
if(VIGIL_SANITIZE AND CMAKE_CXX_COMPILER_ID MATCHES Clang)
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_FLAGS -fsanitize=fuzzer,address,undefined)
  check_cxx_source_compiles("extern \"C\" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }"
    VIGIL_FUZZERS)
  unset(CMAKE_REQUIRED_FLAGS)
endif()

# vigil_library(NAME [COLD] SOURCES ... DEPENDS ...): a static library with the project's settings. COLD: it computes so
# little that with sanitizers the time to optimise it is not worth it.
function(vigil_library name)
  cmake_parse_arguments(ARG "COLD" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES UNITY_BUILD ${VIGIL_UNITY} UNITY_BUILD_BATCH_SIZE 8)
  target_link_libraries(${name} PUBLIC vigil_options ${ARG_DEPENDS})
  if(VIGIL_FUZZERS)
    target_compile_options(${name} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
  if(VIGIL_SANITIZE AND ARG_COLD)
    target_compile_options(${name} PRIVATE -O0)
  endif()
endfunction()

# vigil_test_headers(WAY OPTIONS ...): a target of headers that nearly every test includes, compiled once for all tests
# compiled in that way.
function(vigil_test_headers way)
  set(target vigil_test_headers_${way})
  if(TARGET ${target})
    return()
  endif()
  find_package(GTest REQUIRED)
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/test_headers.cpp CONTENT "")
  add_library(${target} OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/test_headers.cpp)
  target_link_libraries(${target} PRIVATE vigil_options GTest::gtest)
  target_compile_options(${target} PRIVATE ${ARGN} $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>)
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory>
    <optional> <span> <string> <string_view> <vector> <gtest/gtest.h> <glm/glm.hpp> <fmt/format.h>)
endfunction()

# vigil_test_library(NAME SOURCES ... LIBS ...): what several tests share, optimised.
function(vigil_test_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${ARG_SOURCES})
  vigil_test_headers(optimised)
  target_precompile_headers(${name} REUSE_FROM vigil_test_headers_optimised)
  target_link_libraries(${name} PUBLIC vigil_options ${ARG_LIBS} GTest::gtest)
  target_compile_definitions(${name} PRIVATE VIGIL_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR}/tests)
endfunction()

# vigil_test(NAME SOURCES ... LIBS ... [COMPUTES] [GPU [ASSISTED]]): a GoogleTest binary, registered with ctest.
# GPU tests get the label "gpu", the others "unit". Its own sources are not optimised, which halves the time to compile
# them; those that COMPUTE much (shared shader headers, checks in loops) are. ASSISTED: also "assisted", for those that
# can run as a whole under GPU-assisted validation, whose instrumented shaders take a software driver long.
function(vigil_test name)
  cmake_parse_arguments(ARG "COMPUTES;GPU;ASSISTED" "" "SOURCES;LIBS" ${ARGN})
  find_package(GTest REQUIRED)
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE vigil_options ${ARG_LIBS} GTest::gtest GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE VIGIL_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  target_include_directories(${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  if(ARG_COMPUTES)
    vigil_test_headers(optimised)
    target_precompile_headers(${name} REUSE_FROM vigil_test_headers_optimised)
  else()
    vigil_test_headers(plain -O0)
    target_compile_options(${name} PRIVATE -O0)
    target_precompile_headers(${name} REUSE_FROM vigil_test_headers_plain)
  endif()
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

# vigil_test_long(NAME CASES): these cases of a GPU test (GoogleTest's filter) run by `./run test long` only, as the test
# NAME_long. The program itself, started by hand, runs all.
function(vigil_test_long name cases)
  set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT "GTEST_FILTER=-${cases}")
  add_test(NAME ${name}_long COMMAND ${name} "--gtest_filter=${cases}" WORKING_DIRECTORY ${CMAKE_BINARY_DIR})
  get_test_property(${name} TIMEOUT timeout)
  set_tests_properties(${name}_long PROPERTIES LABELS long TIMEOUT ${timeout})
endfunction()

# vigil_test_narrow(NAMES): these tests with vectors of 128 bits, subgroups of 4. lavapipe compiles shaders for them in
# half the time that it needs for 256 bits, and runs them a fifth slower: right for tests that mostly compile. Mesa's
# shader cache does not tell widths apart, so they have one of their own (tests/vkpt/render_test.cpp). Other drivers
# ignore it. Under sanitizers, by `./run test long`, the driver chooses the width.
function(vigil_test_narrow)
  if(VIGIL_SANITIZE)
    return()
  endif()
  set_property(TEST ${ARGV} APPEND PROPERTY ENVIRONMENT
    "LP_NATIVE_VECTOR_WIDTH=128" "XDG_CACHE_HOME=${CMAKE_BINARY_DIR}/test-cache128")
endfunction()

# vigil_test_all_features(NAMES): these tests again, as NAME_all, with shaders for everything that a scene may have, by
# `./run test long` only. In all other runs a level's shaders have what it has.
function(vigil_test_all_features)
  if(VIGIL_SANITIZE)
    return()
  endif()
  foreach(name IN LISTS ARGV)
    add_test(NAME ${name}_all COMMAND ${name} WORKING_DIRECTORY ${CMAKE_BINARY_DIR})
    set_tests_properties(${name}_all PROPERTIES LABELS long TIMEOUT 3600 ENVIRONMENT "VIGIL_TEST_FEATURES=all")
  endforeach()
endfunction()

# vigil_test_subgroups(NAME): the test again at each other subgroup size that lavapipe can have, by `./run test long` only.
# Other drivers ignore the variables; the shader cache would hand out code of another size. Not under sanitizers: the
# host does the same each time.
function(vigil_test_subgroups name)
  if(VIGIL_SANITIZE)
    return()
  endif()
  foreach(width IN ITEMS 128 512)
    add_test(NAME ${name}_${width} COMMAND ${name})
    set_tests_properties(${name}_${width} PROPERTIES LABELS long TIMEOUT 1200
      ENVIRONMENT "LP_NATIVE_VECTOR_WIDTH=${width};MESA_SHADER_CACHE_DISABLE=true")
  endforeach()
endfunction()
