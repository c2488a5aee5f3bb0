package org.selectiverenderer.render.gpu;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.List;
import org.joml.Matrix3d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.ExtendedMaterial;

/** A variant of the shape shader. It remembers the uniforms sent last, and sends only changes. */
public final class ShapeProgram {
  /** The most lights of one shape; further ones are left out. */
  public static final int MAX_LIGHTS = 16;

  /** The texture unit of the environment map, beyond those of the surface. */
  private static final int ENVIRONMENT_UNIT = ExtendedMaterial.MOST_UNITS;

  private final ShaderProgram program;
  private final int object;
  private final int material;
  private final int textureTransform;
  private final int lights;
  private final int pointSize;
  private final int stroke;
  private final int fog;
  private final int planes;
  private final int environment;
  private final @Nullable Details details;
  private float @Nullable [] currentMaterial;
  private float @Nullable [] currentLights;
  private float @Nullable [] currentStroke;
  private float @Nullable [] currentFog;
  private float @Nullable [] currentPlanes;
  private float @Nullable [] currentEnvironment;
  private float currentPointSize;

  /**
   * @param texts the shader sources, shared by all such programs
   */
  ShapeProgram(
      GL3 gl,
      ShaderSourceLoader texts,
      ShaderVariant variant,
      LightCounts counts,
      ShaderEffects scenery) {
    List<String> defines = new ArrayList<>(variant.defines(counts));
    defines.addAll(scenery.defines());
    program = new ShaderProgram(gl, texts, "shape", defines, scenery.stroke().geometry());
    object = program.uniform(gl, "object");
    material = program.uniform(gl, "material");
    textureTransform = program.uniform(gl, "texture_");
    lights = program.uniform(gl, "lights");
    pointSize = program.uniform(gl, "pointSize");
    stroke = program.uniform(gl, "stroke");
    fog = program.uniform(gl, "fog");
    planes = program.uniform(gl, "planes");
    environment = program.uniform(gl, "environment");
    program.use(gl);
    gl.glUniform1i(program.uniform(gl, "environmentImage"), ENVIRONMENT_UNIT);
    gl.glUniform1i(program.uniform(gl, "image"), 0);
    details = variant.detail().isEmpty() ? null : new Details(gl, program);
  }

  /** The uniforms of surfaces with several textures. */
  private static final class Details {
    private final int unit;
    private final int detail;
    private final int back;
    private final int toWorld;
    private @Nullable MaterialBinding current;

    Details(GL3 gl, ShaderProgram program) {
      unit = program.uniform(gl, "unit");
      detail = program.uniform(gl, "detail");
      back = program.uniform(gl, "backMaterial");
      toWorld = program.uniform(gl, "toWorld");
      for (int i = 0; i < ExtendedMaterial.MOST_UNITS; i++) {
        gl.glUniform1i(program.uniform(gl, "image" + i), i); // GL ignores missing ones.
      }
    }

    void set(GL3 gl, MaterialBinding detailed, Matrix4dc view) {
      if (current != detailed) {
        current = detailed;
        int units = detailed.matrices().length / 16;
        if (units > 0) {
          gl.glUniformMatrix4fv(unit, units, false, detailed.matrices(), 0);
        }
        gl.glUniform4fv(detail, detailed.numbers().length / 4, detailed.numbers(), 0);
        if (detailed.back() != null) {
          gl.glUniform4fv(back, 3, detailed.back(), 0);
        }
      }
      if (toWorld >= 0) {
        float[] turned = view.get3x3(new Matrix3d()).transpose().get(new float[9]);
        gl.glUniformMatrix3fv(toWorld, 1, false, turned, 0);
      }
      detailed.bind(gl);
    }
  }

  /**
   * Sets the further uniforms of a surface with several textures, and binds the textures.
   *
   * @param view the view matrix, from the world to the eye
   */
  public void detail(GL3 gl, MaterialBinding detailed, Matrix4dc view) {
    if (details != null) {
      details.set(gl, detailed, view);
    }
  }

  /**
   * Makes the program current.
   *
   * @param pixels the side of a point in pixels
   */
  public void use(GL3 gl, float pixels) {
    program.use(gl);
    if (currentPointSize != pixels) {
      currentPointSize = pixels;
      gl.glUniform1f(pointSize, pixels);
    }
  }

  /**
   * @param transform 40 numbers, as the vertex shader declares them
   */
  public void object(GL3 gl, float[] transform) {
    gl.glUniform4fv(object, 10, transform, 0);
  }

  /**
   * @param numbers twelve material values, as the lighting shader declares them; not written to
   *     afterwards
   * @param transform the texture transform, nine numbers
   */
  public void material(GL3 gl, float[] numbers, float[] transform) {
    if (currentMaterial != numbers) {
      currentMaterial = numbers;
      gl.glUniform4fv(material, 3, numbers, 0);
      gl.glUniform3fv(textureTransform, 3, transform, 0);
    }
  }

  /**
   * @param numbers twenty per light, as the lighting shader declares them
   */
  public void lights(GL3 gl, float[] numbers) {
    if (numbers.length > 0 && currentLights != numbers) {
      currentLights = numbers;
      gl.glUniform4fv(lights, numbers.length / 4, numbers, 0);
    }
  }

  /**
   * @param numbers eight, as the shader of the stroke declares them; not written to afterwards
   */
  public void stroke(GL3 gl, float[] numbers) {
    if (currentStroke != numbers) {
      currentStroke = numbers;
      gl.glUniform4fv(stroke, 2, numbers, 0);
    }
  }

  /**
   * @param numbers the fog's colour and visibility range; not written to afterwards
   */
  public void fog(GL3 gl, float[] numbers) {
    if (currentFog != numbers) {
      currentFog = numbers;
      gl.glUniform4fv(fog, 1, numbers, 0);
    }
  }

  /**
   * @param numbers four per clip plane, in the eye's coordinates; not written to afterwards
   */
  public void planes(GL3 gl, float[] numbers) {
    if (currentPlanes != numbers) {
      currentPlanes = numbers;
      gl.glUniform4fv(planes, numbers.length / 4, numbers, 0);
    }
  }

  /**
   * @param numbers 52, as {@code environment.glsl} declares them; not written to afterwards
   * @param image the environment map for reflections, or null
   */
  public void environment(GL3 gl, float[] numbers, @Nullable GpuTexture image) {
    if (currentEnvironment != numbers) {
      currentEnvironment = numbers;
      gl.glUniform4fv(environment, numbers.length / 4, numbers, 0);
    }
    if (image != null) {
      image.bind(gl, ENVIRONMENT_UNIT);
      gl.glActiveTexture(GL.GL_TEXTURE0);
    }
  }

  void dispose(GL3 gl) {
    program.dispose(gl);
  }
}
