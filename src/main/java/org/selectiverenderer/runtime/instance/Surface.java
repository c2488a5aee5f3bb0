package org.selectiverenderer.runtime.instance;

import org.jspecify.annotations.Nullable;

/**
 * How a shape's surface looks: Appearance, its material and texture, as one immutable value.
 * Colours are r, g, b in 0..1 as X3D gives them (no transfer function is applied, X3D 4.0, 17.2.2).
 *
 * @param lit false for no material and for UnlitMaterial: the colour is drawn as it is
 * @param diffuse diffuse colour; for an unlit surface the emissive colour stands in {@code
 *     emissive}
 * @param shininess 0..1; the specular exponent is shininess * 128
 * @param transparency 0 opaque .. 1 invisible
 * @param texture the image that modulates the diffuse colour, or null
 * @param tints whether the image's colour multiplies the diffuse colour, else replaces it
 * @param glow the image that multiplies the emissive colour, or null; a surface has one or the
 *     other image, and those with both have them in the detail
 * @param textureTransform the texture coordinates' 3x3 matrix, column by column, or null for none
 * @param detail what goes beyond that, or null; the texture is then one of its units, for those who
 *     look at no other
 */
public record Surface(
    boolean lit,
    float[] diffuse,
    float[] specular,
    float[] emissive,
    float ambientIntensity,
    float shininess,
    float transparency,
    @Nullable Texture texture,
    boolean tints,
    @Nullable Texture glow,
    float @Nullable [] textureTransform,
    @Nullable SurfaceDetail detail) {

  /** The look of a shape without an Appearance: unlit white (X3D 4.0, 12.4.5). */
  public static final Surface UNLIT_WHITE =
      new Surface(
          false,
          new float[] {1, 1, 1},
          new float[] {0, 0, 0},
          new float[] {1, 1, 1},
          0,
          0,
          0,
          null,
          false,
          null,
          null,
          null);

  /** The same with what goes beyond the others. */
  Surface with(@Nullable SurfaceDetail more) {
    return new Surface(
        lit,
        diffuse,
        specular,
        emissive,
        ambientIntensity,
        shininess,
        transparency,
        texture,
        tints,
        glow,
        textureTransform,
        more);
  }
}
