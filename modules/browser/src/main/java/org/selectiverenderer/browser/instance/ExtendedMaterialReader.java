package org.selectiverenderer.browser.instance;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.AppearanceReader.MaterialFields;
import org.selectiverenderer.browser.instance.ExtendedMaterial.AlphaMode;
import org.selectiverenderer.browser.scene.Node;

/** Reads the properties of an Appearance that go beyond one material and one image. */
final class ExtendedMaterialReader {
  private ExtendedMaterialReader() {}

  /** Reads the detail of a surface; null for a surface of one material and at most one image. */
  static @Nullable ExtendedMaterial read(
      Node appearance, @Nullable Node material, TextureUnits units) {
    boolean physical = material != null && material.type().name().equals("PhysicalMaterial");
    SurfaceMaterial back = back(appearance, material, units);
    AlphaMode alpha = alphaMode(appearance.string("alphaMode"));
    if (!physical && back == null && alpha == AlphaMode.AUTO && units.plain()) {
      return null;
    }
    float[] numbers = new float[ExtendedMaterial.NUMBERS];
    numbers[0] = number(material, "metallic", 0);
    numbers[1] = number(material, "roughness", 1);
    numbers[2] = number(material, "normalScale", 1);
    numbers[3] = number(material, "occlusionStrength", 1);
    factor(appearance.node("texture"), numbers);
    numbers[8] = appearance.number("alphaCutoff");
    return new ExtendedMaterial(physical, units.units(), units.stages(), numbers, back, alpha);
  }

  private static AlphaMode alphaMode(String mode) {
    return switch (mode) {
      case "OPAQUE" -> AlphaMode.OPAQUE;
      case "MASK" -> AlphaMode.MASK;
      case "BLEND" -> AlphaMode.BLEND;
      default -> AlphaMode.AUTO;
    };
  }

  private static float number(@Nullable Node node, String field, float otherwise) {
    return node == null || node.type().field(field).isEmpty() ? otherwise : node.number(field);
  }

  private static void factor(@Nullable Node texture, float[] numbers) {
    if (texture != null && texture.type().name().equals("MultiTexture")) {
      System.arraycopy(texture.floats("color"), 0, numbers, 4, 3);
      numbers[7] = texture.number("alpha");
    }
  }

  /**
   * Reads the back of a TwoSidedMaterial, or the Appearance's {@code backMaterial} (X3D 4.0,
   * 12.4.2, 12.4.11).
   */
  private static @Nullable SurfaceMaterial back(
      Node appearance, @Nullable Node material, TextureUnits units) {
    if (material == null) {
      return null;
    }
    if (material.type().name().equals("TwoSidedMaterial")) {
      return material.bool("separateBackColor")
          ? MaterialFields.of(material, "back", false).surface(units)
          : null;
    }
    Node other = appearance.node("backMaterial");
    return other != null && other.type().equals(material.type())
        ? MaterialFields.of(other, "", false).surface(units)
        : null;
  }
}
