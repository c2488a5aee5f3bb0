package org.selectiverenderer.browser.instance;

import org.jspecify.annotations.Nullable;

/**
 * The material of a shape's surface: the Appearance with its material and texture as one immutable
 * value. Colours are r, g, b in 0..1 as X3D gives them (no transfer function is applied, X3D 4.0,
 * 17.2.2).
 *
 * @param lit false without a material and for UnlitMaterial: the colour is drawn without lighting
 * @param diffuse the diffuse colour; the colour of an unlit surface is in {@code emissive}
 * @param shininess the shininess, 0..1; the specular exponent is shininess * 128
 * @param transparency the transparency, from 0 (opaque) to 1 (invisible)
 * @param texture the image that modulates the diffuse colour, or null
 * @param tints whether the texture's colour multiplies the diffuse colour; otherwise it replaces it
 * @param glow the image that multiplies the emissive colour, or null; a surface has either {@code
 *     texture} or {@code glow}, and those with both have them in {@code detail}
 * @param textureTransform the texture coordinates' 3x3 matrix, column by column, or null for none
 * @param detail the properties beyond these, or null; if present, {@code texture} is also one of
 *     its units, for users that need only one texture
 * @param shading where its light is computed
 */
public record SurfaceMaterial(
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
    @Nullable ExtendedMaterial detail,
    SurfaceShading shading) {

  /** The material of a shape without an Appearance: unlit white (X3D 4.0, 12.4.5). */
  public static final SurfaceMaterial UNLIT_WHITE =
      new SurfaceMaterial(
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
          null,
          SurfaceShading.UNSPECIFIED);

  /** Returns the same material with further properties. */
  SurfaceMaterial with(@Nullable ExtendedMaterial more, SurfaceShading wanted) {
    return new SurfaceMaterial(
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
        more,
        wanted);
  }
}
