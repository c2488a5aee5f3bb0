package org.selectiverenderer.render.gpu;

import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import com.jogamp.opengl.GLException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** A linked shader program, GLSL 3.30. */
public final class ShaderProgram {
  /**
   * Defines that append an underscore to the vertex shader's outputs, because the inputs and
   * outputs of a geometry shader need different names.
   */
  private static final String HANDED_ON =
      Stream.of("eyeNormal", "eyePosition", "vertexColor", "fogPlace", "cutPlace", "along")
          .map(name -> "#define %s %s_\n".formatted(name, name))
          .collect(Collectors.joining());

  private final int id;
  private final Map<String, Integer> uniforms = new HashMap<>();

  /**
   * @param name of the resources {@code name.vert.glsl} and {@code name.frag.glsl}; a line {@code
   *     #include other.glsl} stands for the text of that resource
   * @param defines the preprocessor defines of the program: {@code NAME} or {@code NAME value}
   * @throws GLException if the driver rejects the text; its log is in the message
   */
  public ShaderProgram(GL3 gl, String name, List<String> defines) {
    this(gl, new ShaderSourceLoader(), name, defines, null);
  }

  /**
   * Compiles and links a program with an optional geometry shader.
   *
   * @param texts the loaded source texts, shared by programs of the same resources
   * @param geometry the name of the resource {@code geometry.geom.glsl}, or null for none. With
   *     one, the vertex shader's outputs get an underscore after their names
   */
  ShaderProgram(
      GL3 gl,
      ShaderSourceLoader texts,
      String name,
      List<String> defines,
      @Nullable String geometry) {
    StringBuilder head = new StringBuilder("#version 330 core\n");
    defines.forEach(define -> head.append("#define ").append(define).append('\n'));
    String vertexHead = geometry == null ? head.toString() : head + HANDED_ON;
    int vertex = compile(gl, GL2ES2.GL_VERTEX_SHADER, texts, name + ".vert.glsl", vertexHead);
    int fragment =
        compile(gl, GL2ES2.GL_FRAGMENT_SHADER, texts, name + ".frag.glsl", head.toString());
    id = gl.glCreateProgram();
    gl.glAttachShader(id, vertex);
    gl.glAttachShader(id, fragment);
    if (geometry != null) {
      int middle =
          compile(gl, GL3.GL_GEOMETRY_SHADER, texts, geometry + ".geom.glsl", head.toString());
      gl.glAttachShader(id, middle);
      gl.glDeleteShader(middle);
    }
    gl.glLinkProgram(id);
    gl.glDeleteShader(vertex);
    gl.glDeleteShader(fragment);
    int[] state = new int[1];
    gl.glGetProgramiv(id, GL2ES2.GL_LINK_STATUS, state, 0);
    if (state[0] == 0) {
      byte[] log = new byte[4096];
      int[] length = new int[1];
      gl.glGetProgramInfoLog(id, log.length, length, 0, log, 0);
      throw new GLException("the shader program " + name + " does not link: " + text(log, length));
    }
  }

  private static int compile(
      GL3 gl, int kind, ShaderSourceLoader texts, String resource, String head) {
    int shader = gl.glCreateShader(kind);
    gl.glShaderSource(shader, 2, new String[] {head, texts.of(resource)}, null, 0);
    gl.glCompileShader(shader);
    int[] state = new int[1];
    gl.glGetShaderiv(shader, GL2ES2.GL_COMPILE_STATUS, state, 0);
    if (state[0] == 0) {
      byte[] log = new byte[4096];
      int[] length = new int[1];
      gl.glGetShaderInfoLog(shader, log.length, length, 0, log, 0);
      throw new GLException("the shader " + resource + " does not compile: " + text(log, length));
    }
    return shader;
  }

  private static String text(byte[] log, int[] length) {
    return new String(log, 0, length[0], StandardCharsets.UTF_8).strip();
  }

  public void use(GL3 gl) {
    gl.glUseProgram(id);
  }

  /**
   * Returns the location of a uniform; -1, which GL ignores, for one that this program does not
   * have.
   */
  public int uniform(GL3 gl, String name) {
    return uniforms.computeIfAbsent(name, key -> gl.glGetUniformLocation(id, key));
  }

  public void dispose(GL3 gl) {
    gl.glDeleteProgram(id);
  }
}
