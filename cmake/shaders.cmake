# Compiles every stage file below shaders/ with glslang, with dependency files, and embeds the SPIR-V in one source file.

function(plume_embed_shaders output)
  file(GLOB_RECURSE stages CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/shaders
       shaders/*.vert shaders/*.frag shaders/*.comp)
  set(headers)
  set(includes "")
  set(entries "")
  foreach(stage ${stages})
    string(MAKE_C_IDENTIFIER ${stage} symbol)
    set(header ${CMAKE_BINARY_DIR}/spirv/${symbol}.h)
    add_custom_command(
      OUTPUT ${header}
      COMMAND ${GLSLANG_VALIDATOR} --quiet -V --target-env vulkan1.3 -I${CMAKE_SOURCE_DIR}/shaders
              --depfile ${header}.d --vn ${symbol} -o ${header} ${CMAKE_SOURCE_DIR}/shaders/${stage}
      DEPENDS ${CMAKE_SOURCE_DIR}/shaders/${stage}
      DEPFILE ${header}.d
      COMMENT "Compiling shader ${stage}"
      VERBATIM)
    list(APPEND headers ${header})
    string(APPEND includes "#include \"spirv/${symbol}.h\"\n")
    string(APPEND entries "    {\"${stage}\", ${symbol}, std::size(${symbol})},\n")
  endforeach()
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/spirv)
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
"// Written by cmake/shaders.cmake.
#include \"renderer/gpu/shaders.h\"

#include <iterator>

@includes@
namespace plume::gpu {
std::span<const EmbeddedShader> embedded_shaders() {
  static const EmbeddedShader kShaders[] = {
@entries@  };
  return kShaders;
}
}  // namespace plume::gpu
")
  set_source_files_properties(${output} PROPERTIES OBJECT_DEPENDS "${headers}" INCLUDE_DIRECTORIES ${CMAKE_BINARY_DIR}
                              SKIP_PRECOMPILE_HEADERS ON)
endfunction()
