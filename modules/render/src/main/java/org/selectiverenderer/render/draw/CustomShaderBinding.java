package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.ShaderProgramSource;
import org.selectiverenderer.render.gpu.CustomShaderProgram;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The custom shader that draws a shape, with the sources of its uniforms and its textures.
 *
 * @param source the shader node's program as the author wrote it
 * @param numbers the program's uniforms, each with the source of its value
 * @param textures the textures of the program's samplers, one for each element of a sampler array;
 *     empty for a sampler type that is not supported
 */
record CustomShaderBinding(
    CustomShaderProgram program,
    ShaderProgramSource source,
    List<Number> numbers,
    List<Optional<GpuTexture>> textures) {

  /**
   * A uniform of the program and the source of its value.
   *
   * @param field the shader node's field of that name, else null
   * @param value the built-in value of that name, else null; where both are null the uniform keeps
   *     the value that the program's text gives it, and is reset if another shape has set it
   */
  record Number(
      CustomShaderProgram.Uniform uniform,
      ShaderProgramSource.@Nullable ProgramField field,
      BuiltInUniforms.@Nullable Value value) {}

  /** Returns whether vertex or geometry stages may move the shape away from its mesh's bounds. */
  boolean moves() {
    return source.parts().stream()
        .anyMatch(part -> part.stage() != ShaderProgramSource.Stage.FRAGMENT);
  }

  /** Returns whether the program writes {@code gl_PointSize}. */
  boolean sizesPoints() {
    return source.parts().stream()
        .anyMatch(
            part ->
                part.stage() != ShaderProgramSource.Stage.FRAGMENT
                    && part.text().text().contains("gl_PointSize"));
  }

  /** Makes program and textures current, and sends the uniforms that have changed. */
  void send(GL3 gl, UniformContext state) {
    program.use(gl);
    for (int unit = 0; unit < textures.size(); unit++) {
      if (textures.get(unit).isPresent()) {
        textures.get(unit).get().bind(gl, unit);
      }
    }
    for (Number number : numbers) {
      if (number.field() != null) {
        program.set(gl, number.uniform(), floats(number.field().type(), number.field().value()));
      } else if (number.value() != null) {
        program.set(gl, number.uniform(), number.value().apply(state));
      } else {
        program.unset(gl, number.uniform());
      }
    }
  }

  /** Converts a field's value to floats: 1 for TRUE, doubles rounded to single precision. */
  static float[] floats(FieldType type, Object value) {
    if (value instanceof float[] floats) {
      return floats;
    }
    if (value instanceof double[] doubles) {
      float[] numbers = new float[doubles.length];
      for (int i = 0; i < numbers.length; i++) {
        numbers[i] = (float) doubles[i];
      }
      return numbers;
    }
    if (value instanceof int[] ints) {
      float[] numbers = new float[ints.length];
      for (int i = 0; i < numbers.length; i++) {
        numbers[i] = ints[i];
      }
      return numbers;
    }
    if (value instanceof boolean[] flags) {
      float[] numbers = new float[flags.length];
      for (int i = 0; i < numbers.length; i++) {
        numbers[i] = flags[i] ? 1 : 0;
      }
      return numbers;
    }
    if (value instanceof java.lang.Number number) {
      return new float[] {number.floatValue()};
    }
    return type == FieldType.SFBool
        ? new float[] {Boolean.TRUE.equals(value) ? 1 : 0}
        : new float[0];
  }
}
