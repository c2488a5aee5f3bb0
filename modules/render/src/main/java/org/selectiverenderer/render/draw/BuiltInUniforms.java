package org.selectiverenderer.render.draw;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.instance.TextureUnit;

/**
 * The built-in uniforms that custom shaders expect from a browser, by name: those of GLSL up to
 * 1.20 (with the prefix {@code sr_} here), X_ITE's, Castle Game Engine's and X3DOM's.
 */
final class BuiltInUniforms {
  /** The number of lights in the arrays that such shaders declare. */
  static final int MOST_LIGHTS = 8;

  private static final Pattern OF_LIGHT =
      Pattern.compile("(sr_LightSource|x3d_LightSource)\\[(\\d+)\\]\\.(\\w+)");
  private static final Pattern PRODUCT =
      Pattern.compile("sr_(Front|Back)LightProduct\\[(\\d+)\\]\\.(\\w+)");
  private static final Pattern PART =
      Pattern.compile(
          "(sr|x3d)_(Front|Back)?(Material|LightModelProduct|Fog)(?:\\[0\\])?\\.(\\w+)");

  /** Computes a uniform's value from the drawing state. */
  interface Value extends Function<UniformContext, float[]> {}

  private static final Map<String, Value> MATRICES =
      Map.ofEntries(
          Map.entry("ModelViewMatrix", state -> floats(state.toEye())),
          Map.entry("ProjectionMatrix", state -> floats(state.projection())),
          Map.entry(
              "ModelViewProjectionMatrix",
              state -> floats(state.projection().mul(state.toEye(), new Matrix4d()))),
          Map.entry("ViewMatrix", state -> floats(state.camera().view())),
          Map.entry(
              "CameraSpaceMatrix",
              state -> floats(state.camera().view().invertAffine(new Matrix4d()))),
          Map.entry("ModelMatrix", state -> floats(state.item().place())),
          Map.entry("NormalMatrix", state -> floats(state.normals().get3x3(new Matrix3d()))));

  private BuiltInUniforms() {}

  /**
   * Returns how the uniform of a name is computed; empty for a name that no browser defines.
   *
   * @param components the components of the uniform, since some programs declare the normal matrix
   *     as a mat4
   */
  static Optional<Value> of(String name, int components) {
    Matcher light = OF_LIGHT.matcher(name);
    if (light.matches()) {
      return light(Integer.parseInt(light.group(2)), light.group(3));
    }
    Matcher product = PRODUCT.matcher(name);
    if (product.matches()) {
      return product(
          product.group(1).equals("Back"), Integer.parseInt(product.group(2)), product.group(3));
    }
    Matcher part = PART.matcher(name);
    if (part.matches()) {
      boolean back = "Back".equals(part.group(2));
      return switch (part.group(3)) {
        case "Fog" -> fog(part.group(4));
        case "LightModelProduct" -> Optional.of(state -> rgba(side(state, back).emissive(), 1));
        default -> material(back, part.group(4), part.group(1).equals("sr"));
      };
    }
    if (components == 16 && name.equals("normalMatrix")) {
      return Optional.of(state -> floats(state.normals()));
    }
    return matrix(name).or(() -> single(name));
  }

  private static Optional<Value> matrix(String name) {
    for (String prefix : List.of("sr_", "x3d_", "castle_", "")) {
      if (name.startsWith(prefix)) {
        String rest = name.substring(prefix.length());
        String word =
            prefix.isEmpty() && !rest.isEmpty()
                ? Character.toUpperCase(rest.charAt(0)) + rest.substring(1)
                : rest;
        for (Map.Entry<String, Value> matrix : MATRICES.entrySet()) {
          if (word.startsWith(matrix.getKey())) {
            Value plain = matrix.getValue();
            switch (word.substring(matrix.getKey().length())) {
              case "" -> {
                return Optional.of(plain);
              }
              case "Inverse" -> {
                return Optional.of(state -> inverted(plain.apply(state), false));
              }
              case "Transpose" -> {
                return Optional.of(state -> transposed(plain.apply(state)));
              }
              case "InverseTranspose" -> {
                return Optional.of(state -> inverted(plain.apply(state), true));
              }
              default -> {
                // Another name that begins alike.
              }
            }
          }
        }
      }
    }
    return Optional.empty();
  }

  private static float[] inverted(float[] m, boolean transposed) {
    Matrix4d matrix = new Matrix4d().set(m).invert();
    return floats(transposed ? matrix.transpose() : matrix);
  }

  private static float[] transposed(float[] m) {
    return floats(new Matrix4d().set(m).transpose());
  }

  private static float[] floats(Matrix4dc matrix) {
    return matrix.get(new float[16]);
  }

  private static float[] floats(Matrix3d matrix) {
    return matrix.get(new float[9]);
  }

  private static Optional<Value> single(String name) {
    Value value =
        switch (name) {
          case "sr_TextureMatrix", "x3d_TextureMatrix" -> BuiltInUniforms::textureMatrices;
          case "x3d_NumLights" -> state -> new float[] {state.lightCount()};
          case "x3d_NumTextures" -> state -> new float[] {textures(state).size()};
          case "x3d_Lighting" -> state -> flag(state.surface().lit());
          case "x3d_ColorMaterial" -> state -> flag(state.item().source().colors() != null);
          case "x3d_SeparateBackColor" -> state -> flag(state.back() != state.surface());
          case "x3d_GeometryType" ->
              state ->
                  new float[] {
                    switch (state.item().source().primitive()) {
                      case POINTS -> 0;
                      case LINES -> 1;
                      case TRIANGLES -> 3;
                    }
                  };
          case "x3d_Viewport" ->
              state ->
                  new float[] {
                    state.camera().x(),
                    state.camera().y(),
                    state.camera().width(),
                    state.camera().height()
                  };
          case "x3d_LinewidthScaleFactor",
              "x3d_LineProperties.linewidthScaleFactor",
              "x3d_PointProperties.pointSizeScaleFactor" ->
              state -> new float[] {1};
          case "castle_MaterialDiffuseAlpha" ->
              state -> rgba(state.surface().diffuse(), opacity(state.surface()));
          case "castle_SceneColor" -> state -> rgba(state.surface().emissive(), 1);
          case "castle_UnlitColor" ->
              state -> rgba(state.surface().emissive(), opacity(state.surface()));
          case "castle_MaterialSpecular", "specularColor" -> state -> state.surface().specular();
          case "castle_MaterialEmissive", "emissiveColor" -> state -> state.surface().emissive();
          case "castle_MaterialShininess" ->
              state -> new float[] {128 * state.surface().shininess()};
          case "diffuseColor" -> state -> state.surface().diffuse();
          case "shininess" -> state -> new float[] {state.surface().shininess()};
          case "transparency" -> state -> new float[] {state.surface().transparency()};
          default -> null;
        };
    if (value != null) {
      return Optional.of(value);
    }
    // The older names of X_ITE and Titania, from before these browsers used structures.
    if (name.startsWith("x3d_Fog")) {
      String word = name.substring("x3d_Fog".length());
      return word.isEmpty() ? Optional.empty() : fog(lower(word));
    }
    return name.startsWith("x3d_Back")
        ? material(true, lower(name.substring("x3d_Back".length())), false)
        : name.startsWith("x3d_")
            ? material(false, lower(name.substring("x3d_".length())), false)
            : Optional.empty();
  }

  private static String lower(String word) {
    return word.isEmpty() ? word : Character.toLowerCase(word.charAt(0)) + word.substring(1);
  }

  private static float[] flag(boolean on) {
    return new float[] {on ? 1 : 0};
  }

  private static List<TextureUnit> textures(UniformContext state) {
    CustomShaderBinding look = state.item().author();
    return look == null ? List.of() : look.source().textures();
  }

  private static float[] textureMatrices(UniformContext state) {
    float[] all = new float[16 * 8];
    for (int i = 0; i < 8; i++) {
      List<TextureUnit> units = textures(state);
      if (i < units.size()) {
        System.arraycopy(units.get(i).matrix(), 0, all, 16 * i, 16);
      } else {
        new Matrix4d().get(all, 16 * i);
      }
    }
    return all;
  }

  private static SurfaceMaterial side(UniformContext state, boolean back) {
    return back ? state.back() : state.surface();
  }

  private static float opacity(SurfaceMaterial surface) {
    return 1 - surface.transparency();
  }

  private static float[] rgba(float[] rgb, float alpha) {
    return new float[] {rgb[0], rgb[1], rgb[2], alpha};
  }

  private static float[] ambient(SurfaceMaterial surface) {
    float[] d = surface.diffuse();
    float a = surface.ambientIntensity();
    return new float[] {d[0] * a, d[1] * a, d[2] * a, opacity(surface)};
  }

  /**
   * @param old whether the member belongs to OpenGL's structure, whose shininess is 0..128 instead
   *     of 0..1
   */
  private static Optional<Value> material(boolean back, String member, boolean old) {
    return Optional.ofNullable(
        switch (member) {
          case "diffuseColor" -> state -> side(state, back).diffuse();
          case "specularColor" -> state -> side(state, back).specular();
          case "emissiveColor" -> state -> side(state, back).emissive();
          case "ambientIntensity" -> state -> new float[] {side(state, back).ambientIntensity()};
          case "transparency" -> state -> new float[] {side(state, back).transparency()};
          case "alphaCutoff" -> state -> new float[] {0};
          case "ambient" -> state -> ambient(side(state, back));
          case "diffuse" -> state -> rgba(side(state, back).diffuse(), opacity(side(state, back)));
          case "specular" -> state -> rgba(side(state, back).specular(), 1);
          case "emission" -> state -> rgba(side(state, back).emissive(), 1);
          case "shininess" ->
              state -> new float[] {(old ? 128 : 1) * side(state, back).shininess()};
          default -> null;
        });
  }

  private static Optional<Value> fog(String member) {
    return Optional.ofNullable(
        switch (member) {
          case "type" ->
              state -> new float[] {state.fog().isClear() ? 0 : state.fog().exponential() ? 2 : 1};
          case "color" ->
              state -> new float[] {state.fog().red(), state.fog().green(), state.fog().blue(), 1};
          case "visibilityRange", "end" -> state -> new float[] {(float) state.fog().range()};
          case "start", "fogCoord" -> state -> new float[] {0};
          case "density", "scale" ->
              state -> new float[] {state.fog().isClear() ? 0 : (float) (1 / state.fog().range())};
          case "matrix" -> state -> floats(new Matrix3d());
          default -> null;
        });
  }

  private static Optional<Value> light(int index, String member) {
    return BuiltInLightUniforms.member(member)
        .map(value -> state -> value.of(state.lights(), index, state.lightCount()));
  }

  private static Optional<Value> product(boolean back, int index, String member) {
    return BuiltInLightUniforms.member(member)
        .filter(
            known ->
                member.equals("ambient") || member.equals("diffuse") || member.equals("specular"))
        .map(
            value ->
                state -> {
                  float[] light = value.of(state.lights(), index, state.lightCount());
                  SurfaceMaterial surface = side(state, back);
                  float[] own =
                      switch (member) {
                        case "ambient" -> ambient(surface);
                        case "diffuse" -> rgba(surface.diffuse(), opacity(surface));
                        default -> rgba(surface.specular(), 1);
                      };
                  for (int i = 0; i < 4; i++) {
                    own[i] *= light[i];
                  }
                  return own;
                });
  }
}
