package org.selectiverenderer.runtime.instance;

/**
 * One texture of a surface: what it is for, and how its coordinates come about.
 *
 * @param set of the mesh's texture coordinates: 0 the first, n the n-th of the further ones; {@link
 *     #GENERATED} or {@link #BOUNDS}
 * @param mode of a TextureCoordinateGenerator, else ""
 * @param matrix sixteen numbers, column by column, by which coordinates s, t, r, q are multiplied
 */
public record TextureUnit(Role role, TextureSource source, int set, String mode, float[] matrix) {
  /** The coordinates are computed as {@link #mode} says. */
  public static final int GENERATED = -1;

  /** The coordinates go from 0 to 1 through the box around the geometry (X3D 4.0, 33.2.4). */
  public static final int BOUNDS = -2;

  /** What a texture is for; of each but {@link #STAGE} a surface has one at most. */
  public enum Role {
    /** Appearance's {@code texture}. */
    MAIN,
    /** A texture of Appearance's MultiTexture, in their order. */
    STAGE,
    /** The material's {@code diffuseTexture}, {@code baseTexture}, or what stands for it. */
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
