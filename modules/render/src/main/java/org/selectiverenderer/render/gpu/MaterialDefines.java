package org.selectiverenderer.render.gpu;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.joml.Matrix4f;
import org.selectiverenderer.browser.instance.ExtendedMaterial;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.instance.TextureStage;
import org.selectiverenderer.browser.instance.TextureUnit;
import org.selectiverenderer.browser.instance.VolumeTexture;

/**
 * Generates the preprocessor defines of the shader for a surface with several textures: the texture
 * look-ups as GLSL code, each for its role, so that the shader computes nothing that the surface
 * does not need.
 */
public final class MaterialDefines {
  private static final Set<String> MODES =
      Set.of(
          "REPLACE",
          "SELECTARG1",
          "SELECTARG2",
          "MODULATE",
          "MODULATE2X",
          "MODULATE4X",
          "ADD",
          "ADDSIGNED",
          "ADDSIGNED2X",
          "SUBTRACT",
          "ADDSMOOTH",
          "BLENDDIFFUSEALPHA",
          "BLENDTEXTUREALPHA",
          "BLENDFACTORALPHA",
          "BLENDCURRENTALPHA",
          "MODULATEALPHA_ADDCOLOR",
          "MODULATEINVALPHA_ADDCOLOR",
          "MODULATEINVCOLOR_ADDALPHA",
          "DOTPRODUCT3");

  private MaterialDefines() {}

  /**
   * @param tints whether the Appearance's image multiplies the colour, else replaces it
   * @param sizes the number of components of each of the mesh's further texture coordinates
   * @param tangents the index of the tangents among the mesh's further texture coordinates; -1
   *     without tangents
   * @param cutOut whether pixels are discarded where its images are transparent
   */
  public static List<String> of(
      ExtendedMaterial detail, boolean tints, List<Integer> sizes, int tangents, boolean cutOut) {
    List<String> defines = new ArrayList<>();
    defines.add("DETAIL");
    defines.add("UNITS " + detail.units().size());
    if (tints) {
      defines.add("TINT");
    }
    if (detail.physical()) {
      defines.add("PHYSICAL");
    }
    if (detail.back() != null) {
      defines.add("BACK_MATERIAL");
    }
    if (detail.alphaMode() == ExtendedMaterial.AlphaMode.MASK) {
      defines.add("MASK");
    } else if (cutOut) {
      defines.add("CUT_OUT");
    }
    sets(detail, sizes, defines);
    StringBuilder samplers = new StringBuilder();
    StringBuilder stages = new StringBuilder();
    int stage = 0;
    boolean turned = false;
    for (int i = 0; i < detail.units().size(); i++) {
      TextureUnit unit = detail.units().get(i);
      turned |= turned(unit);
      samplers.append("uniform ").append(sampler(unit)).append(" image").append(i).append("; ");
      String place = "(unit[%d] * %s)".formatted(i, coordinates(unit));
      String texel =
          unit.source().cube()
              ? "texture(image%d, %s.xyz)".formatted(i, place)
              : straight(unit, sizes)
                  ? "texture(image%d, set%d.st)".formatted(i, unit.set())
                  : "textureProj(image%d, %s)".formatted(i, place);
      if (unit.role() == TextureUnit.Role.STAGE) {
        stages.append(statement(detail.stages().get(stage++), texel));
      } else {
        String name = unit.role().name();
        defines.add(name + "_TEXEL " + texel);
        if (unit.role() == TextureUnit.Role.NORMAL) {
          defines.add("NORMAL_PLACE " + place);
          if (tangents >= 0) {
            defines.add("TANGENTS " + (4 + tangents));
          }
        }
      }
    }
    defines.add("SAMPLERS " + samplers);
    if (!stages.isEmpty()) {
      defines.add("STAGES " + stages);
    }
    if (turned) {
      defines.add("TURNED");
    }
    return List.copyOf(defines);
  }

  /**
   * Returns whether an image is looked up at the mesh's texture coordinates unchanged: without a
   * texture transform and without a fourth component to divide by. For a software renderer the
   * transform costs as much as a look-up.
   */
  private static boolean straight(TextureUnit unit, List<Integer> sizes) {
    return unit.source() instanceof Texture
        && unit.set() >= 0
        && (unit.set() == 0 || unit.set() > sizes.size() || sizes.get(unit.set() - 1) < 4)
        && Arrays.equals(unit.matrix(), new Matrix4f().get(new float[16]));
  }

  /**
   * Adds the declarations that pass the further texture coordinates in use from the vertex to the
   * fragment shader.
   */
  private static void sets(ExtendedMaterial detail, List<Integer> sizes, List<String> defines) {
    Set<Integer> used = new TreeSet<>();
    for (TextureUnit unit : detail.units()) {
      if (unit.set() > 0) {
        used.add(unit.set());
      }
    }
    StringBuilder inputs = new StringBuilder();
    StringBuilder passed = new StringBuilder();
    StringBuilder varyings = new StringBuilder();
    for (int set : used) {
      // A mesh without these coordinates gets 0, 0, 0, 1.
      if (set <= sizes.size()) {
        inputs.append("layout(location = %d) in vec4 given%d; ".formatted(3 + set, set));
        passed.append("set%d = given%d; ".formatted(set, set));
      } else {
        passed.append("set%d = vec4(0.0, 0.0, 0.0, 1.0); ".formatted(set));
      }
      inputs.append("out vec4 set%d; ".formatted(set));
      varyings.append("in vec4 set%d; ".formatted(set));
    }
    defines.add("MORE_INPUTS " + inputs);
    defines.add("MORE_PASSED " + passed);
    defines.add("MORE_VARYINGS " + varyings);
  }

  private static String sampler(TextureUnit unit) {
    return unit.source().cube()
        ? "samplerCube"
        : unit.source() instanceof VolumeTexture ? "sampler3D" : "sampler2D";
  }

  private static boolean turned(TextureUnit unit) {
    return unit.mode().startsWith("WORLDSPACE")
        || (unit.source().cube() && unit.mode().startsWith("CAMERASPACE"));
  }

  private static String coordinates(TextureUnit unit) {
    if (unit.set() == TextureUnit.BOUNDS) {
      return "vec4(localAt, 1.0)";
    }
    if (unit.set() >= 0) {
      return "set" + unit.set();
    }
    String direction =
        switch (unit.mode()) {
          case "CAMERASPACENORMAL", "WORLDSPACENORMAL" -> "normalize(seenNormal)";
          case "CAMERASPACEPOSITION", "COORD-EYE" -> "seenAt";
          case "CAMERASPACEREFLECTIONVECTOR", "SPHERE-REFLECT", "WORLDSPACEREFLECTIONVECTOR" ->
              "mirrored()";
          case "SPHERE-LOCAL" -> "sphereOf(normalize(localNormal))";
          case "COORD" -> "localAt";
          default -> "sphereOf(normalize(seenNormal))";
        };
    if (direction.startsWith("sphereOf")) {
      return direction;
    }
    return turned(unit) ? "vec4(toWorld * " + direction + ", 1.0)" : "vec4(" + direction + ", 1.0)";
  }

  private static String statement(TextureStage stage, String texel) {
    String source =
        switch (stage.source()) {
          case "DIFFUSE" -> "plain";
          case "SPECULAR" -> "vec4(shineHere.rgb, plain.a)";
          case "FACTOR" -> "detail[1]";
          default -> "baseHere";
        };
    String call = "%s(" + texel + ", " + source + ", plain, detail[1])";
    // One expression for both modes, so that the texture is looked up once.
    String result =
        mode(stage.mode()).equals(mode(stage.alphaMode()))
            ? "clamp(" + call.formatted(mode(stage.mode())) + ", 0.0, 1.0)"
            : "staged("
                + call.formatted(mode(stage.mode()))
                + ", "
                + call.formatted(mode(stage.alphaMode()))
                + ")";
    return "baseHere = "
        + switch (stage.function()) {
          case "COMPLEMENT" -> "complement(" + result + ")";
          case "ALPHAREPLICATE" -> result + ".aaaa";
          default -> result;
        }
        + "; ";
  }

  private static String mode(String given) {
    return MODES.contains(given) ? given : "MODULATE";
  }
}
