package org.selectiverenderer.browser.instance;

/**
 * One texture of a surface with its role and the source of its coordinates.
 *
 * @param set the set of the mesh's texture coordinates: 0 for the first, n for the n-th of the
 *     further ones; or {@link #GENERATED} or {@link #BOUNDS}
 * @param mode the mode of a TextureCoordinateGenerator, else ""
 * @param matrix the 4x4 matrix, column by column, that transforms the coordinates s, t, r, q
 */
public record TextureUnit(Role role, TextureSource source, int set, String mode, float[] matrix) {
  /** The coordinates are computed as {@link #mode} says. */
  public static final int GENERATED = -1;

  /** The coordinates go from 0 to 1 through the box around the geometry (X3D 4.0, 33.2.4). */
  public static final int BOUNDS = -2;

  /** The role of a texture; a surface has at most one texture of each role but {@link #STAGE}. */
  public enum Role {
    /** Appearance's {@code texture}. */
    MAIN,
    /** A texture of Appearance's MultiTexture, in their order. */
    STAGE,
    /**
     * The material's {@code diffuseTexture}, {@code baseTexture} or, for UnlitMaterial, {@code
     * emissiveTexture}.
     */
    DIFFUSE,
    AMBIENT,
    SPECULAR,
    SHININESS,
    EMISSIVE,
    NORMAL,
    OCCLUSION,
    METALLIC_ROUGHNESS
  }
}
