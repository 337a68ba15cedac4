# Compiles GLSL to SPIR-V and embeds it: one table from name to code, refresh/vkpt/gpu/shader_library.h.

find_program(GLSLANG_VALIDATOR NAMES glslangValidator glslang REQUIRED)
set(VIGIL_SHADER_DIR ${CMAKE_SOURCE_DIR}/shaders)
set(VIGIL_SHADER_OUTPUT ${CMAKE_BINARY_DIR}/shaders)

# The light-sampling techniques: the rows of shaders/shared/techniques.h.
file(READ ${VIGIL_SHADER_DIR}/shared/techniques.h table)
string(REGEX MATCHALL "\n *ROW\\([a-z0-9_]+," rows "${table}")
set(VIGIL_TECHNIQUES)
foreach(row IN LISTS rows)
  string(REGEX REPLACE ".*ROW\\(([a-z0-9_]+),.*" "\\1" technique "${row}")
  list(APPEND VIGIL_TECHNIQUES ${technique})
  file(CONFIGURE OUTPUT ${VIGIL_SHADER_OUTPUT}/technique_${technique}/selected_technique.glsl
    CONTENT "#include \"light/${technique}.glsl\"\n")
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  ${VIGIL_SHADER_DIR}/shared/techniques.h)

# vigil_shader(LIST NAME SOURCE [INCLUDE dir] [DEFINES ...]): compiles SOURCE under NAME and appends NAME to LIST.
function(vigil_shader list name source)
  cmake_parse_arguments(ARG "" "INCLUDE" "DEFINES" ${ARGN})
  string(MAKE_C_IDENTIFIER "shader_${name}" identifier)
  set(output ${VIGIL_SHADER_OUTPUT}/${name}.h)
  set(flags --target-env vulkan1.2 -I${VIGIL_SHADER_DIR})
  if(ARG_INCLUDE)
    list(APPEND flags -I${ARG_INCLUDE})
  endif()
  foreach(define IN LISTS ARG_DEFINES)
    list(APPEND flags -D${define})
  endforeach()
  add_custom_command(OUTPUT ${output}
    COMMAND ${GLSLANG_VALIDATOR} --quiet ${flags} --vn ${identifier} --depfile ${output}.d
      -o ${output} ${VIGIL_SHADER_DIR}/${source}
    DEPENDS ${VIGIL_SHADER_DIR}/${source}
    DEPFILE ${output}.d
    COMMENT "Shader ${name}" VERBATIM)
  set(${list} ${${list}} ${name} PARENT_SCOPE)
endfunction()

# vigil_shader_library(TARGET NAMES...): a library that maps the names to the embedded code.
function(vigil_shader_library target)
  set(includes "")
  set(rows "")
  set(outputs)
  foreach(name IN LISTS ARGN)
    string(MAKE_C_IDENTIFIER "shader_${name}" identifier)
    string(APPEND includes "#include \"shaders/${name}.h\"\n")
    string(APPEND rows "    {\"${name}\", ${identifier}},\n")
    list(APPEND outputs ${VIGIL_SHADER_OUTPUT}/${name}.h)
  endforeach()
  file(CONFIGURE OUTPUT ${VIGIL_SHADER_OUTPUT}/${target}_rows.inc CONTENT "${rows}" @ONLY)
  file(CONFIGURE OUTPUT ${VIGIL_SHADER_OUTPUT}/${target}_includes.inc CONTENT "${includes}" @ONLY)
  add_custom_target(${target}_code DEPENDS ${outputs})
  add_dependencies(${target} ${target}_code)
  target_include_directories(${target} PRIVATE ${CMAKE_BINARY_DIR})
endfunction()
