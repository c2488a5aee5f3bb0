package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.instance.SurfaceProgram;
import org.selectiverenderer.runtime.render.gpu.AuthorProgram;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * A shape's look where the program of an author makes it.
 *
 * @param source what the author wrote
 * @param numbers where the program's numbers come from
 * @param textures of the program's samplers, one for each element of an array; null for a kind of
 *     sampler that has none
 */
record AuthorLook(
    AuthorProgram program,
    SurfaceProgram source,
    List<Number> numbers,
    List<Optional<GpuTexture>> textures) {

  /**
   * A number of the program.
   *
   * @param field of the shader with its name, else null
   * @param value what browsers give by that name, else null; where both are null it is the
   *     program's own, which a shader beside this one may have set
   */
  record Number(
      AuthorProgram.Uniform uniform,
      SurfaceProgram.@Nullable ProgramField field,
      AuthorValues.@Nullable Value value) {}

  /** Whether the shape may be drawn elsewhere than where its mesh is. */
  boolean moves() {
    return source.parts().stream().anyMatch(part -> part.stage() != SurfaceProgram.Stage.FRAGMENT);
  }

  /** Whether it says how large points are. */
  boolean sizesPoints() {
    return source.parts().stream()
        .anyMatch(
            part ->
                part.stage() != SurfaceProgram.Stage.FRAGMENT
                    && part.text().text().contains("gl_PointSize"));
  }

  /** Makes program and textures current, and sends the numbers that have changed. */
  void send(GL3 gl, AuthorState state) {
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

  /** A field's value as numbers: 1 for TRUE, numbers of double precision as floats. */
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
