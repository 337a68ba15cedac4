# Compiles GLSL to SPIR-V and embeds it: one table from name to code, refresh/vkpt/gpu/shader_library.h.

find_program(GLSLANG_VALIDATOR NAMES glslangValidator glslang REQUIRED)
set(VIGIL_SHADER_DIR ${CMAKE_SOURCE_DIR}/shaders)
set(VIGIL_SHADER_OUTPUT ${CMAKE_BINARY_DIR}/shaders)

# vigil_shader_rows(LIST FILE KIND FOLDER): the rows of a table in shaders/shared. For each there is a folder KIND_ROW with
# a file selected_KIND.glsl that includes FOLDER/ROW.glsl: shaders are compiled once per row.
function(vigil_shader_rows list file kind folder)
  file(READ ${VIGIL_SHADER_DIR}/shared/${file} table)
  string(REGEX MATCHALL "\n *ROW\\([a-z0-9_]+," rows "${table}")
  set(names)
  foreach(row IN LISTS rows)
    string(REGEX REPLACE ".*ROW\\(([a-z0-9_]+),.*" "\\1" name "${row}")
    list(APPEND names ${name})
    file(CONFIGURE OUTPUT ${VIGIL_SHADER_OUTPUT}/${kind}_${name}/selected_${kind}.glsl
      CONTENT "#include \"${folder}/${name}.glsl\"\n")
  endforeach()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${VIGIL_SHADER_DIR}/shared/${file})
  set(${list} ${names} PARENT_SCOPE)
endfunction()
vigil_shader_rows(VIGIL_TECHNIQUES techniques.h technique light)
vigil_shader_rows(VIGIL_GUIDERS guiders.h guider guiding)

# vigil_shader(LIST NAME SOURCE [TECHNIQUE row] [GUIDER row] [DEFINES ...]): compiles SOURCE under NAME and appends NAME to
# LIST.
function(vigil_shader list name source)
  cmake_parse_arguments(ARG "" "TECHNIQUE;GUIDER" "DEFINES" ${ARGN})
  set(output ${VIGIL_SHADER_OUTPUT}/${name}.spv)
  set(flags --target-env vulkan1.2 -I${VIGIL_SHADER_DIR})
  if(ARG_TECHNIQUE)
    list(APPEND flags -I${VIGIL_SHADER_OUTPUT}/technique_${ARG_TECHNIQUE})
  endif()
  if(ARG_GUIDER)
    list(APPEND flags -I${VIGIL_SHADER_OUTPUT}/guider_${ARG_GUIDER})
  endif()
  foreach(define IN LISTS ARG_DEFINES)
    list(APPEND flags -D${define})
  endforeach()
  add_custom_command(OUTPUT ${output}
    COMMAND ${GLSLANG_VALIDATOR} --quiet ${flags} --depfile ${output}.d -o ${output} ${VIGIL_SHADER_DIR}/${source}
    DEPENDS ${VIGIL_SHADER_DIR}/${source}
    DEPFILE ${output}.d
    COMMENT "Shader ${name}" VERBATIM)
  set(${list} ${${list}} ${name} PARENT_SCOPE)
endfunction()

# vigil_shader_library(TARGET NAMES...): embeds the code. TARGET_shaders.inc declares it, TARGET_rows.inc has a row {"NAME",
# {begin, end}} for each. The assembler copies it: as text it would take the compiler half a minute.
function(vigil_shader_library target)
  set(declarations "")
  set(rows "")
  set(code ".section .note.GNU-stack,\"\",%progbits\n.section .rodata\n")
  set(files)
  foreach(name IN LISTS ARGN)
    string(MAKE_C_IDENTIFIER "shader_${name}" identifier)
    set(file ${VIGIL_SHADER_OUTPUT}/${name}.spv)
    string(APPEND declarations "extern \"C\" const std::uint32_t ${identifier}[], ${identifier}_end[];\n")
    string(APPEND rows "    {\"${name}\", {${identifier}, ${identifier}_end}},\n")
    string(APPEND code ".balign 4\n.global ${identifier}\n${identifier}:\n.incbin \"${file}\"\n"
      ".global ${identifier}_end\n${identifier}_end:\n")
    list(APPEND files ${file})
  endforeach()
  file(CONFIGURE OUTPUT ${VIGIL_SHADER_OUTPUT}/${target}_rows.inc CONTENT "${rows}" @ONLY)
  file(CONFIGURE OUTPUT ${VIGIL_SHADER_OUTPUT}/${target}_shaders.inc CONTENT "${declarations}" @ONLY)
  set(source ${VIGIL_SHADER_OUTPUT}/${target}.S)
  file(CONFIGURE OUTPUT ${source} CONTENT "${code}" @ONLY)
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS "${files}")
  add_library(${target}_code OBJECT ${source})
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_code>)
  target_include_directories(${target} PRIVATE ${CMAKE_BINARY_DIR})
endfunction()
