# Libraries that systems ship in different ways, each behind one target of ours: vigil_stb, vigil_imgui, vigil_tinyexr and,
# for tests, vigil_tinygltf. Debian and Ubuntu have them built. Fedora and Arch have single headers, whose bodies
# src/third_party/ compiles, and no Dear ImGui, which is compiled from a folder of its sources.

option(VIGIL_HEADER_LIBRARIES "Compile stb, tinyexr and tinygltf from their headers even where the system has them built" OFF)
set(VIGIL_IMGUI_SOURCE "" CACHE PATH "Folder of Dear ImGui's sources (1.86 or newer), where the system has no package of it")

find_package(PkgConfig REQUIRED)

# vigil_header_library(NAME HEADER): a static library of src/third_party/NAME.cpp, the body of a header found on the system.
# Its warnings are not ours.
function(vigil_header_library name header)
  find_path(VIGIL_${name}_INCLUDE ${header} PATH_SUFFIXES ${name} REQUIRED)
  add_library(vigil_${name} STATIC ${CMAKE_SOURCE_DIR}/src/third_party/${name}.cpp)
  target_compile_features(vigil_${name} PRIVATE cxx_std_20)
  target_compile_options(vigil_${name} PRIVATE -w)
  target_include_directories(vigil_${name} SYSTEM PUBLIC ${VIGIL_${name}_INCLUDE})
endfunction()

# stb_image_write; the body of stb_image is in src/formats/.
find_library(VIGIL_STB_LIBRARY stb)
if(VIGIL_STB_LIBRARY AND NOT VIGIL_HEADER_LIBRARIES)
  add_library(vigil_stb INTERFACE)
  target_link_libraries(vigil_stb INTERFACE ${VIGIL_STB_LIBRARY})
else()
  vigil_header_library(stb stb/stb_image_write.h)
endif()

if(NOT VIGIL_HEADER_LIBRARIES)
  find_package(tinyexr QUIET)
endif()
if(TARGET tinyexr::tinyexr)
  add_library(vigil_tinyexr INTERFACE)
  target_link_libraries(vigil_tinyexr INTERFACE tinyexr::tinyexr)
else()
  find_package(ZLIB REQUIRED)
  vigil_header_library(tinyexr tinyexr.h)
  target_link_libraries(vigil_tinyexr PRIVATE ZLIB::ZLIB)
endif()

pkg_check_modules(IMGUI QUIET IMPORTED_TARGET imgui)
if(VIGIL_IMGUI_SOURCE)
  find_package(Vulkan REQUIRED)
  add_library(vigil_imgui STATIC
    ${VIGIL_IMGUI_SOURCE}/imgui.cpp ${VIGIL_IMGUI_SOURCE}/imgui_draw.cpp ${VIGIL_IMGUI_SOURCE}/imgui_tables.cpp
    ${VIGIL_IMGUI_SOURCE}/imgui_widgets.cpp ${VIGIL_IMGUI_SOURCE}/backends/imgui_impl_vulkan.cpp)
  target_compile_features(vigil_imgui PRIVATE cxx_std_20)
  target_compile_options(vigil_imgui PRIVATE -w)
  target_compile_definitions(vigil_imgui PRIVATE IMGUI_DISABLE_DEMO_WINDOWS)
  target_include_directories(vigil_imgui SYSTEM PUBLIC ${VIGIL_IMGUI_SOURCE})
  target_link_libraries(vigil_imgui PUBLIC Vulkan::Vulkan)
elseif(IMGUI_FOUND)
  add_library(vigil_imgui INTERFACE)
  target_link_libraries(vigil_imgui INTERFACE PkgConfig::IMGUI)
else()
  message(FATAL_ERROR "Dear ImGui is missing. Debian and Ubuntu: libimgui-dev. Elsewhere: -DVIGIL_IMGUI_SOURCE=FOLDER, "
    "a folder of its sources; docs/play/systems.md tells where they come from.")
endif()

# For measurements, tools and tests alone. Of Boost only what is in headers (Boost.Math).
find_package(CLI11 QUIET)
find_path(VIGIL_BOOST_INCLUDE boost/math/distributions/students_t.hpp)
if(CLI11_FOUND AND VIGIL_BOOST_INCLUDE)
  set(VIGIL_MEASURES ON)
  add_library(vigil_boost INTERFACE)
  target_include_directories(vigil_boost SYSTEM INTERFACE ${VIGIL_BOOST_INCLUDE})
else()
  message(STATUS "CLI11 or Boost not found: measurements, tools and tests are not built")
endif()

# For the tests of exported scenes alone: without it they are not built.
find_library(VIGIL_TINYGLTF_LIBRARY tinygltf)
find_path(VIGIL_tinygltf_INCLUDE tiny_gltf.h PATH_SUFFIXES tinygltf)
if(VIGIL_TINYGLTF_LIBRARY AND VIGIL_tinygltf_INCLUDE AND NOT VIGIL_HEADER_LIBRARIES)
  add_library(vigil_tinygltf INTERFACE)
  target_link_libraries(vigil_tinygltf INTERFACE ${VIGIL_TINYGLTF_LIBRARY})
  target_include_directories(vigil_tinygltf SYSTEM INTERFACE ${VIGIL_tinygltf_INCLUDE})
elseif(VIGIL_tinygltf_INCLUDE)
  find_package(nlohmann_json REQUIRED)
  vigil_header_library(tinygltf tiny_gltf.h)
  # Its class differs by this, so that users must know it too.
  target_compile_definitions(vigil_tinygltf PUBLIC TINYGLTF_NO_STB_IMAGE_WRITE)
  target_link_libraries(vigil_tinygltf PUBLIC nlohmann_json::nlohmann_json)
else()
  message(STATUS "tinygltf not found: the tests of exported scenes are left out")
endif()
