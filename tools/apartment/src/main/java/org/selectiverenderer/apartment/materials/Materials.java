package org.selectiverenderer.apartment.materials;

import org.selectiverenderer.modelling.ModelColour;
import org.selectiverenderer.modelling.ModelMaterial;

/** Materials that several objects of a room share, so that they match. */
public final class Materials {
  // Wood.
  public static final ModelMaterial OAK = ModelMaterial.satin(ModelColour.of(0.66, 0.45, 0.27));
  public static final ModelMaterial DARK_OAK =
      ModelMaterial.satin(ModelColour.of(0.44, 0.28, 0.16));
  public static final ModelMaterial LIGHT_OAK = ModelMaterial.satin(ModelColour.hex(0xB98A58));
  public static final ModelMaterial DARK_WOOD = ModelMaterial.satin(ModelColour.hex(0x7A4F30));
  public static final ModelMaterial WALNUT = ModelMaterial.satin(ModelColour.of(0.36, 0.23, 0.14));

  // Metal.
  public static final ModelMaterial CHROME = ModelMaterial.metal(ModelColour.grey(0.85));
  public static final ModelMaterial STEEL = ModelMaterial.metal(ModelColour.of(0.8, 0.82, 0.85));
  public static final ModelMaterial POLISHED_STEEL = polished(0xB4B8BC);
  public static final ModelMaterial DARK_STEEL = polished(0x6A6E72);
  public static final ModelMaterial BRASS = ModelMaterial.metal(ModelColour.of(0.88, 0.7, 0.32));
  public static final ModelMaterial PALE_BRASS =
      ModelMaterial.metal(ModelColour.of(0.86, 0.68, 0.36));

  // Plastic and lacquer.
  public static final ModelMaterial BLACK = ModelMaterial.satin(ModelColour.of(0.09, 0.09, 0.1));
  public static final ModelMaterial SOFT_BLACK = ModelMaterial.satin(ModelColour.hex(0x24262A));
  public static final ModelMaterial BLACK_PLASTIC =
      ModelMaterial.satin(ModelColour.of(0.06, 0.06, 0.065));
  public static final ModelMaterial CHARCOAL =
      ModelMaterial.satin(ModelColour.of(0.21, 0.22, 0.24));
  public static final ModelMaterial GREY = ModelMaterial.satin(ModelColour.of(0.5, 0.51, 0.53));
  public static final ModelMaterial SILVER = ModelMaterial.satin(ModelColour.of(0.74, 0.75, 0.76));
  public static final ModelMaterial WHITE = ModelMaterial.satin(ModelColour.of(0.9, 0.9, 0.87));
  public static final ModelMaterial CREAM_LACQUER =
      ModelMaterial.satin(ModelColour.of(0.88, 0.85, 0.77));
  public static final ModelMaterial RED = ModelMaterial.glossy(ModelColour.of(0.72, 0.09, 0.07));
  public static final ModelMaterial BRICK_RED = ModelMaterial.glossy(ModelColour.hex(0xA83A34));
  public static final ModelMaterial GREEN = ModelMaterial.satin(ModelColour.of(0.16, 0.34, 0.25));
  public static final ModelMaterial BLUE = ModelMaterial.satin(ModelColour.of(0.16, 0.28, 0.44));
  public static final ModelMaterial RUBBER = ModelMaterial.matt(ModelColour.of(0.07, 0.07, 0.075));

  // China and glass.
  public static final ModelMaterial CHINA = ModelMaterial.glossy(ModelColour.hex(0xEDEAE2));
  public static final ModelMaterial BLUE_CHINA = ModelMaterial.glossy(ModelColour.hex(0x7F9FB3));
  public static final ModelMaterial GLASS =
      ModelMaterial.glossy(ModelColour.hex(0xC4D6D8)).transparent(0.58);

  // Paper, cloth and food.
  public static final ModelMaterial PAPER = ModelMaterial.matt(ModelColour.of(0.93, 0.92, 0.87));
  public static final ModelMaterial CREAM_PAPER =
      ModelMaterial.matt(ModelColour.of(0.93, 0.91, 0.85));
  public static final ModelMaterial LINEN = ModelMaterial.matt(ModelColour.of(0.66, 0.6, 0.5));
  public static final ModelMaterial TEAL_CLOTH =
      ModelMaterial.matt(ModelColour.of(0.16, 0.4, 0.42));
  public static final ModelMaterial RUST_CLOTH = ModelMaterial.matt(ModelColour.of(0.7, 0.34, 0.2));
  public static final ModelMaterial CREAM_CLOTH =
      ModelMaterial.matt(ModelColour.of(0.86, 0.81, 0.7));

  private Materials() {}

  /** Returns the material of a part of a lit screen. */
  public static ModelMaterial lit(double red, double green, double blue) {
    return ModelMaterial.glossy(ModelColour.grey(0.02)).glowing(ModelColour.of(red, green, blue));
  }

  /**
   * Returns metal for a bright room: lighter than {@link ModelMaterial#metal}, which reflects lamps
   * only.
   */
  private static ModelMaterial polished(int rgb) {
    return new ModelMaterial(
        ModelColour.hex(rgb), ModelColour.grey(0.75), 0.5, 0, ModelColour.grey(0));
  }
}
