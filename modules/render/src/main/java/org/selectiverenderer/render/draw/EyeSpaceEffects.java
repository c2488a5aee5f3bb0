package org.selectiverenderer.render.draw;

import com.jogamp.opengl.GL3;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector4d;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.camera.Camera;
import org.selectiverenderer.browser.instance.CubeTexture;
import org.selectiverenderer.browser.instance.DrawProperties;
import org.selectiverenderer.browser.instance.EnvironmentLight;
import org.selectiverenderer.browser.instance.Fog;
import org.selectiverenderer.browser.instance.ScopedEffectInstance;
import org.selectiverenderer.browser.instance.ScopedEffects;
import org.selectiverenderer.render.gpu.GpuTexture;
import org.selectiverenderer.render.gpu.ShaderEffects;
import org.selectiverenderer.render.gpu.ShapeProgram;
import org.selectiverenderer.render.gpu.StrokeStyle;

/** The uniforms of fog, clip planes, strokes and environment light in one eye's coordinates. */
final class EyeSpaceEffects {
  private static final float[] NOTHING = {};
  private static final Packed PLAIN =
      new Packed(ShaderEffects.NONE, NOTHING, NOTHING, NOTHING, NOTHING, null);

  private final Camera camera;
  private final Fog fog;
  private final float pointSize;
  private final Function<CubeTexture, GpuTexture> images;
  private final Map<Key, Packed> packed = new HashMap<>();

  /**
   * The shader effects of a shape and their uniform values.
   *
   * @param stroke eight numbers; empty for a plain stroke
   * @param fog four numbers; empty without fog
   * @param planes four numbers per clip plane
   * @param around the environment light as {@code environment.glsl} declares it; empty without one
   * @param mirrored the environment map for reflections, or null
   */
  record Packed(
      ShaderEffects scenery,
      float[] stroke,
      float[] fog,
      float[] planes,
      float[] around,
      @Nullable GpuTexture mirrored) {
    void send(GL3 gl, ShapeProgram program) {
      if (stroke.length > 0) {
        program.stroke(gl, stroke);
      }
      if (fog.length > 0) {
        program.fog(gl, fog);
      }
      if (planes.length > 0) {
        program.planes(gl, planes);
      }
      if (around.length > 0) {
        program.environment(gl, around, mirrored);
      }
    }
  }

  private record Key(StrokeStyle form, DrawProperties stroke, ScopedEffects around, int fogDepth) {}

  /**
   * @param fog the bound fog, which counts where no LocalFog reaches
   * @param pointSize the side of a point of the usual size in pixels
   * @param images returns the texture of an environment map on the graphics card
   */
  EyeSpaceEffects(
      Camera camera, Fog fog, float pointSize, Function<CubeTexture, GpuTexture> images) {
    this.camera = camera;
    this.fog = fog;
    this.pointSize = pointSize;
    this.images = images;
  }

  /** Returns the fog that the shape is in. */
  Fog fog(DrawItem item) {
    return item.around().fog().orElse(fog);
  }

  Packed of(DrawItem item) {
    if (item.form() == StrokeStyle.PLAIN && item.around() == ScopedEffects.NONE && fog.isClear()) {
      return PLAIN;
    }
    return packed.computeIfAbsent(
        new Key(item.form(), item.shape().stroke(), item.around(), item.source().fogDepth()),
        this::pack);
  }

  private Packed pack(Key key) {
    Fog here = key.around().fog().orElse(fog);
    float[] planes = planes(key.around());
    EnvironmentLight around = key.around().environment().orElse(null);
    ShaderEffects scenery =
        new ShaderEffects(
            key.form(),
            mist(here),
            here.isClear() ? -1 : key.fogDepth(),
            planes.length / 4,
            kind(around));
    return scenery.equals(ShaderEffects.NONE)
        ? PLAIN
        : new Packed(
            scenery,
            stroke(key),
            here.isClear() ? NOTHING : numbers(here),
            planes,
            around == null ? NOTHING : numbers(around),
            around == null ? null : around.image().map(images).orElse(null));
  }

  private static ShaderEffects.Around kind(@Nullable EnvironmentLight around) {
    if (around == null) {
      return ShaderEffects.Around.DARK;
    }
    return around.image().isPresent() ? ShaderEffects.Around.IMAGE : ShaderEffects.Around.SMOOTH;
  }

  private float[] numbers(EnvironmentLight around) {
    float[] numbers = new float[52];
    for (int i = 0; i < around.diffuse().length; i++) {
      numbers[4 * (i / 3) + i % 3] = around.diffuse()[i];
    }
    // Rotates directions from the eye's to the environment light's coordinates.
    Matrix3d toLight =
        camera.view().mul(around.place(), new Matrix4d()).get3x3(new Matrix3d()).invert();
    for (int row = 0; row < 3 && toLight.isFinite(); row++) {
      for (int column = 0; column < 3; column++) {
        numbers[36 + 4 * row + column] = (float) toLight.get(column, row);
      }
    }
    System.arraycopy(around.color(), 0, numbers, 48, 3);
    numbers[51] = around.image().map(EyeSpaceEffects::sizes).orElse(0f);
    return numbers;
  }

  /** Returns how many times a cube map can be halved until its faces have four pixels a side. */
  private static float sizes(CubeTexture image) {
    int size = 1;
    for (CubeTexture.Face face : image.faces()) {
      size = Math.max(size, Math.max(face.image().width(), face.image().height()));
    }
    return Math.max(0, 29 - Integer.numberOfLeadingZeros(size));
  }

  private static ShaderEffects.Mist mist(Fog fog) {
    if (fog.isClear()) {
      return ShaderEffects.Mist.CLEAR;
    }
    return fog.exponential() ? ShaderEffects.Mist.EXPONENTIAL : ShaderEffects.Mist.LINEAR;
  }

  private static float[] numbers(Fog fog) {
    return new float[] {fog.red(), fog.green(), fog.blue(), (float) fog.range()};
  }

  private float[] planes(ScopedEffects around) {
    List<Vector4d> found = new ArrayList<>();
    Matrix4d toEye = camera.view().invertAffine(new Matrix4d()).transpose();
    for (ScopedEffectInstance effect : around.planes()) {
      effect.planeNow().map(toEye::transform).ifPresent(found::add);
    }
    int count = Math.min(ShaderEffects.MAX_PLANES, found.size());
    float[] numbers = new float[4 * count];
    for (int i = 0; i < count; i++) {
      Vector4d plane = found.get(i);
      numbers[4 * i] = (float) plane.x;
      numbers[4 * i + 1] = (float) plane.y;
      numbers[4 * i + 2] = (float) plane.z;
      numbers[4 * i + 3] = (float) plane.w;
    }
    return numbers;
  }

  private float[] stroke(Key key) {
    DrawProperties.Line line = key.stroke().line();
    DrawProperties.Dot dot = key.stroke().dot();
    DrawProperties.Fill fill = key.stroke().fill();
    return switch (key.form()) {
      case WIDE, PATTERN, BREAK, ENDED ->
          line == null
              ? NOTHING
              : new float[] {
                line.width(),
                camera.width(),
                camera.height(),
                StrokePatterns.pattern(line),
                0,
                0,
                0,
                0
              };
      case SIZED, ATTENUATED ->
          dot == null
              ? NOTHING
              : new float[] {
                dot.scale() * pointSize,
                dot.least() * pointSize,
                dot.most() * pointSize,
                0,
                dot.a(),
                dot.b(),
                dot.c(),
                0
              };
      case HATCHED, HATCH_ONLY ->
          fill == null
              ? NOTHING
              : new float[] {
                fill.red(), fill.green(), fill.blue(), StrokePatterns.hatch(fill), 0, 0, 0, 0
              };
      case PLAIN, HOLLOW -> NOTHING;
    };
  }
}
