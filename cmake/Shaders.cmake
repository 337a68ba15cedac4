# Shader compilation is described where the shaders are listed (src/refresh/vkpt).
