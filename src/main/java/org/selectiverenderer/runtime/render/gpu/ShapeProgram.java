package org.selectiverenderer.runtime.render.gpu;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.List;
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
  private final int lightCount;
  private final int pointSize;
  private float @Nullable [] currentMaterial;
  private float @Nullable [] currentLights;

  ShapeProgram(GL3 gl, ShapeVariant variant) {
    List<String> defines = new ArrayList<>(variant.defines());
    defines.add("MAX_LIGHTS " + MAX_LIGHTS);
    program = new Program(gl, "shape", defines);
    object = program.uniform(gl, "object");
    material = program.uniform(gl, "material");
    textureTransform = program.uniform(gl, "texture_");
    lights = program.uniform(gl, "lights");
    lightCount = program.uniform(gl, "lightCount");
    pointSize = program.uniform(gl, "pointSize");
    program.use(gl);
    gl.glUniform1i(program.uniform(gl, "image"), 0);
  }

  /** Makes it current for a view whose lights are new. */
  public void begin(GL3 gl, float pixels) {
    program.use(gl);
    gl.glUniform1f(pointSize, pixels);
    currentLights = null;
  }

  public void use(GL3 gl) {
    program.use(gl);
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
  public void lights(GL3 gl, float[] numbers, int count) {
    if (currentLights != numbers) {
      currentLights = numbers;
      gl.glUniform1i(lightCount, count);
      if (count > 0) {
        gl.glUniform4fv(lights, 5 * count, numbers, 0);
      }
    }
  }

  void dispose(GL3 gl) {
    program.dispose(gl);
  }
}
