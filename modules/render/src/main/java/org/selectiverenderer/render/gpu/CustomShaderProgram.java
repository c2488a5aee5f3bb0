package org.selectiverenderer.render.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2ES2;
import com.jogamp.opengl.GL3;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.browser.instance.ShaderProgramSource.Stage;
import org.selectiverenderer.render.glsl.CompilerLog;
import org.selectiverenderer.render.glsl.GlslTranslator;

/** A linked custom shader program with its uniforms and texture samplers. */
public final class CustomShaderProgram {
  /** The most texture units of one program, which every graphics card has. */
  private static final int MOST_TEXTURES = 16;

  private final int id;
  private final List<Uniform> uniforms = new ArrayList<>();
  private final List<Uniform> samplers = new ArrayList<>();
  private final Map<Uniform, float[]> sent = new IdentityHashMap<>();

  /** The initial values of the uniforms from the program's text. */
  private final Map<Uniform, float[]> own = new IdentityHashMap<>();

  /**
   * A uniform or sampler of a program.
   *
   * @param name its name as the author wrote it, without the {@code [0]} of an array
   * @param type its GL type constant
   * @param size the number of elements of an array, else 1
   */
  public record Uniform(String name, int location, int type, int size) {
    /** Returns the number of components of one element. */
    public int components() {
      return switch (type) {
        case GL2ES2.GL_FLOAT_VEC2, GL2ES2.GL_INT_VEC2, GL2ES2.GL_BOOL_VEC2 -> 2;
        case GL2ES2.GL_FLOAT_VEC3, GL2ES2.GL_INT_VEC3, GL2ES2.GL_BOOL_VEC3 -> 3;
        case GL2ES2.GL_FLOAT_VEC4, GL2ES2.GL_INT_VEC4, GL2ES2.GL_BOOL_VEC4, GL2ES2.GL_FLOAT_MAT2 ->
            4;
        case GL2ES2.GL_FLOAT_MAT3 -> 9;
        case GL2ES2.GL_FLOAT_MAT4 -> 16;
        default -> 1;
      };
    }

    private boolean whole() {
      return switch (type) {
        case GL2ES2.GL_INT,
            GL2ES2.GL_INT_VEC2,
            GL2ES2.GL_INT_VEC3,
            GL2ES2.GL_INT_VEC4,
            GL2ES2.GL_BOOL,
            GL2ES2.GL_BOOL_VEC2,
            GL2ES2.GL_BOOL_VEC3,
            GL2ES2.GL_BOOL_VEC4 ->
            true;
        default -> false;
      };
    }

    private boolean number() {
      return whole()
          || switch (type) {
            case GL.GL_FLOAT,
                GL.GL_UNSIGNED_INT,
                GL2ES2.GL_FLOAT_VEC2,
                GL2ES2.GL_FLOAT_VEC3,
                GL2ES2.GL_FLOAT_VEC4,
                GL2ES2.GL_FLOAT_MAT2,
                GL2ES2.GL_FLOAT_MAT3,
                GL2ES2.GL_FLOAT_MAT4 ->
                true;
            default -> false;
          };
    }
  }

  /** The result of compiling: a program, or the compiler's message. */
  public record Outcome(Optional<CustomShaderProgram> program, Optional<Failure> failure) {}

  /**
   * The reason why there is no program.
   *
   * @param unit the stage that does not compile; empty when the stages do not link
   */
  public record Failure(Optional<GlslTranslator.Unit> unit, CompilerLog log) {}

  private CustomShaderProgram(GL3 gl, int id) {
    this.id = id;
    int[] count = new int[1];
    gl.glGetProgramiv(id, GL2ES2.GL_ACTIVE_UNIFORMS, count, 0);
    for (int i = 0; i < count[0]; i++) {
      add(gl, i);
    }
    gl.glUseProgram(id);
    int unit = 0;
    for (Uniform sampler : samplers) {
      int[] units = new int[sampler.size()];
      for (int i = 0; i < units.length; i++) {
        units[i] = unit++;
      }
      gl.glUniform1iv(sampler.location(), units.length, units, 0);
    }
  }

  private void add(GL3 gl, int index) {
    byte[] name = new byte[512];
    int[] length = new int[1];
    int[] size = new int[1];
    int[] type = new int[1];
    gl.glGetActiveUniform(id, index, name.length, length, 0, size, 0, type, 0, name, 0);
    String told = new String(name, 0, length[0], StandardCharsets.UTF_8);
    int location = gl.glGetUniformLocation(id, told);
    if (location < 0) {
      return; // In a uniform block, for which X3D has no fields.
    }
    String plain = told.endsWith("[0]") ? told.substring(0, told.length() - 3) : told;
    Uniform uniform =
        new Uniform(GlslTranslator.fieldName(plain), location, type[0], Math.max(1, size[0]));
    if (uniform.number()) {
      uniforms.add(uniform);
      own.put(uniform, own(gl, uniform, plain));
    } else {
      samplers.add(uniform);
    }
  }

  private float[] own(GL3 gl, Uniform of, String name) {
    int components = of.components();
    float[] values = new float[of.size() * components];
    float[] numbers = new float[components];
    int[] whole = new int[components];
    for (int i = 0; i < of.size(); i++) {
      int at = i == 0 ? of.location() : gl.glGetUniformLocation(id, name + "[" + i + "]");
      if (at < 0) {
        continue; // An element that was optimised away.
      }
      if (of.whole() || of.type() == GL.GL_UNSIGNED_INT) {
        gl.glGetUniformiv(id, at, whole, 0);
        for (int c = 0; c < components; c++) {
          numbers[c] = whole[c];
        }
      } else {
        gl.glGetUniformfv(id, at, numbers, 0);
      }
      System.arraycopy(numbers, 0, values, i * components, components);
    }
    return values;
  }

  /**
   * Compiles and links.
   *
   * @param attributes the locations of vertex attributes by name
   */
  public static Outcome of(
      GL3 gl, List<GlslTranslator.Unit> units, Map<String, Integer> attributes) {
    int id = gl.glCreateProgram();
    try {
      for (GlslTranslator.Unit unit : units) {
        int shader = gl.glCreateShader(kind(unit.stage()));
        gl.glShaderSource(shader, 1, new String[] {unit.text()}, null, 0);
        gl.glCompileShader(shader);
        int[] state = new int[1];
        gl.glGetShaderiv(shader, GL2ES2.GL_COMPILE_STATUS, state, 0);
        if (state[0] == 0) {
          byte[] log = new byte[8192];
          int[] length = new int[1];
          gl.glGetShaderInfoLog(shader, log.length, length, 0, log, 0);
          gl.glDeleteShader(shader);
          return failed(gl, id, Optional.of(unit), text(log, length));
        }
        gl.glAttachShader(id, shader);
        gl.glDeleteShader(shader); // Deleted with the program.
      }
      attributes.forEach((name, location) -> gl.glBindAttribLocation(id, location, name));
      gl.glLinkProgram(id);
      int[] state = new int[1];
      gl.glGetProgramiv(id, GL2ES2.GL_LINK_STATUS, state, 0);
      if (state[0] == 0) {
        byte[] log = new byte[8192];
        int[] length = new int[1];
        gl.glGetProgramInfoLog(id, log.length, length, 0, log, 0);
        return failed(gl, id, Optional.empty(), text(log, length));
      }
      CustomShaderProgram made = new CustomShaderProgram(gl, id);
      if (made.samplers.stream().mapToInt(Uniform::size).sum() > MOST_TEXTURES) {
        return failed(
            gl,
            id,
            Optional.empty(),
            "it uses more than %s texture samplers".formatted(MOST_TEXTURES));
      }
      return new Outcome(Optional.of(made), Optional.empty());
    } finally {
      gl.glUseProgram(0);
    }
  }

  private static Outcome failed(GL3 gl, int id, Optional<GlslTranslator.Unit> unit, String log) {
    gl.glDeleteProgram(id);
    return new Outcome(Optional.empty(), Optional.of(new Failure(unit, CompilerLog.of(log))));
  }

  private static String text(byte[] log, int[] length) {
    return new String(log, 0, length[0], StandardCharsets.UTF_8);
  }

  private static int kind(Stage stage) {
    return switch (stage) {
      case VERTEX -> GL2ES2.GL_VERTEX_SHADER;
      case GEOMETRY -> GL3.GL_GEOMETRY_SHADER;
      case FRAGMENT -> GL2ES2.GL_FRAGMENT_SHADER;
    };
  }

  /** Returns the program's uniforms. */
  public List<Uniform> uniforms() {
    return uniforms;
  }

  /** Returns the program's samplers, which use the texture units in this order. */
  public List<Uniform> samplers() {
    return samplers;
  }

  public void use(GL3 gl) {
    gl.glUseProgram(id);
  }

  /**
   * Sets a uniform while the program is current. Elements of an array that are not given get their
   * initial values, whatever was set before for another shape.
   *
   * @param values not written to afterwards
   */
  public void set(GL3 gl, Uniform to, float[] values) {
    float[] before = sent.put(to, values);
    if (before == values) {
      return;
    }
    int given = values.length - values.length % to.components();
    float[] all = values;
    if (given < to.size() * to.components()) {
      all = own.get(to).clone();
      System.arraycopy(values, 0, all, 0, given);
    }
    send(gl, to, all);
  }

  /** Resets a uniform to its initial value while the program is current. */
  public void unset(GL3 gl, Uniform to) {
    if (sent.remove(to) != null) {
      send(gl, to, own.get(to));
    }
  }

  private static void send(GL3 gl, Uniform to, float[] values) {
    int count = to.size();
    int at = to.location();
    if (to.whole() || to.type() == GL.GL_UNSIGNED_INT) {
      whole(gl, to, count, values);
      return;
    }
    switch (to.type()) {
      case GL2ES2.GL_FLOAT_VEC2 -> gl.glUniform2fv(at, count, values, 0);
      case GL2ES2.GL_FLOAT_VEC3 -> gl.glUniform3fv(at, count, values, 0);
      case GL2ES2.GL_FLOAT_VEC4 -> gl.glUniform4fv(at, count, values, 0);
      case GL2ES2.GL_FLOAT_MAT2 -> gl.glUniformMatrix2fv(at, count, false, values, 0);
      case GL2ES2.GL_FLOAT_MAT3 -> gl.glUniformMatrix3fv(at, count, false, values, 0);
      case GL2ES2.GL_FLOAT_MAT4 -> gl.glUniformMatrix4fv(at, count, false, values, 0);
      default -> gl.glUniform1fv(at, count, values, 0);
    }
  }

  private static void whole(GL3 gl, Uniform to, int count, float[] values) {
    int[] numbers = new int[count * to.components()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = (int) values[i];
    }
    int at = to.location();
    if (to.type() == GL.GL_UNSIGNED_INT) {
      gl.glUniform1uiv(at, count, numbers, 0);
      return;
    }
    switch (to.components()) {
      case 2 -> gl.glUniform2iv(at, count, numbers, 0);
      case 3 -> gl.glUniform3iv(at, count, numbers, 0);
      case 4 -> gl.glUniform4iv(at, count, numbers, 0);
      default -> gl.glUniform1iv(at, count, numbers, 0);
    }
  }

  public void dispose(GL3 gl) {
    gl.glDeleteProgram(id);
  }
}
