package org.selectiverenderer.runtime.render.gpu;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** The program of shapes in one variant, with its uniforms, which it remembers between draws. */
public final class ShapeProgram {
  /** Lights that one shape can have; those beyond are left out. */
  public static final int MAX_LIGHTS = 16;

  private final Program program;
  private final int object;
  private final int material;
  private final int textureTransform;
  private final int lights;
  private final int pointSize;
  private float @Nullable [] currentMaterial;
  private float @Nullable [] currentLights;
  private float currentPointSize;

  ShapeProgram(GL3 gl, ShapeVariant variant, int lightCount) {
    List<String> defines = new ArrayList<>(variant.defines());
    defines.add("LIGHTS " + lightCount);
    defines.add(
        "EACH_LIGHT "
            + IntStream.range(0, lightCount)
                .mapToObj(i -> "LIGHT(" + i + ")")
                .collect(Collectors.joining(" ")));
    program = new Program(gl, "shape", defines);
    object = program.uniform(gl, "object");
    material = program.uniform(gl, "material");
    textureTransform = program.uniform(gl, "texture_");
    lights = program.uniform(gl, "lights");
    pointSize = program.uniform(gl, "pointSize");
    program.use(gl);
    gl.glUniform1i(program.uniform(gl, "image"), 0);
  }

  /**
   * Makes it current.
   *
   * @param pixels side of a point
   */
  public void use(GL3 gl, float pixels) {
    program.use(gl);
    if (currentPointSize != pixels) {
      currentPointSize = pixels;
      gl.glUniform1f(pointSize, pixels);
    }
  }

  /**
   * @param transform 40 numbers, as the vertex shader says
   */
  public void object(GL3 gl, float[] transform) {
    gl.glUniform4fv(object, 10, transform, 0);
  }

  /**
   * @param numbers twelve, as the fragment shader says; not written to afterwards
   * @param transform nine numbers of the texture transform
   */
  public void material(GL3 gl, float[] numbers, float[] transform) {
    if (currentMaterial != numbers) {
      currentMaterial = numbers;
      gl.glUniform4fv(material, 3, numbers, 0);
      gl.glUniform3fv(textureTransform, 3, transform, 0);
    }
  }

  /**
   * @param numbers twenty per light, as the fragment shader says
   */
  public void lights(GL3 gl, float[] numbers) {
    if (numbers.length > 0 && currentLights != numbers) {
      currentLights = numbers;
      gl.glUniform4fv(lights, numbers.length / 4, numbers, 0);
    }
  }

  void dispose(GL3 gl) {
    program.dispose(gl);
  }
}
