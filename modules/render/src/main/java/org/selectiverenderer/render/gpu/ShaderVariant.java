package org.selectiverenderer.render.gpu;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The features that a shape needs of its shader. Each variant is a program of its own without
 * branches, because software GL executes both sides of every branch.
 *
 * @param lit whether it is lit
 * @param specular whether the material has a highlight
 * @param byVertex whether lighting is per vertex, else per pixel
 * @param flat whether the normal is that of the face, not the interpolated one
 * @param colors whether vertices have colours
 * @param texture whether there is a texture
 * @param tint whether the texture multiplies the colour, else replaces it
 * @param glow whether the texture multiplies the emissive colour only
 * @param alphaTest whether transparent pixels of the texture are discarded
 * @param twoSided whether back faces are drawn
 * @param points whether the primitives are points
 * @param blended whether it is blended over what is behind it
 * @param tinted whether vertices store the diffuse colours of the shapes of a batch instead
 * @param detail the defines of {@link MaterialDefines} for a surface with several textures; else
 *     empty
 */
public record ShaderVariant(
    boolean lit,
    boolean specular,
    boolean byVertex,
    boolean flat,
    boolean colors,
    boolean texture,
    boolean tint,
    boolean glow,
    boolean alphaTest,
    boolean twoSided,
    boolean points,
    boolean blended,
    boolean tinted,
    List<String> detail) {

  List<String> defines(LightCounts lights) {
    List<String> defines = new ArrayList<>(lights.defines());
    boolean apart = colors || (texture && !glow);
    // A diffuse colour is constant over a triangle, so with per-vertex lighting it is only needed
    // there.
    boolean atVertices = lit && byVertex && !apart;
    add(defines, lit, "LIT");
    add(defines, lit && specular, "SPECULAR");
    add(defines, lit && (specular || flat || lights.positional()), "EYE_POSITION");
    add(defines, lit && flat, "FLAT");
    add(defines, lit && byVertex, "LIT_BY_VERTEX");
    add(defines, atVertices, "WHOLE_BY_VERTEX");
    add(defines, atVertices && tinted, "TINTED");
    add(defines, lit && byVertex && apart && specular, "HIGHLIGHT_APART");
    add(defines, colors || (tinted && !atVertices), "COLORS");
    add(defines, texture, "TEXTURE");
    add(defines, texture && glow, "GLOW");
    add(defines, texture && tint && !glow, "TINT");
    add(defines, texture && alphaTest && !glow, "ALPHA_TEST");
    add(defines, twoSided, "TWO_SIDED");
    add(defines, points, "POINTS");
    add(defines, !blended, "OPAQUE");
    defines.addAll(detail);
    return defines;
  }

  /** Returns the same variant with per-vertex or per-pixel lighting. */
  public ShaderVariant lit(boolean atVertices) {
    return new ShaderVariant(
        lit,
        specular,
        atVertices && lit && !flat && detail.isEmpty(),
        flat,
        colors,
        texture,
        tint,
        glow,
        alphaTest,
        twoSided,
        points,
        blended,
        tinted,
        detail);
  }

  /**
   * Returns the same variant for views in which only front faces are seen; differs only if it is
   * lit.
   */
  ShaderVariant front() {
    return new ShaderVariant(
        lit,
        specular,
        byVertex,
        flat,
        colors,
        texture,
        tint,
        glow,
        alphaTest,
        twoSided && !lit,
        points,
        blended,
        tinted,
        detail);
  }

  /** Returns the same variant for batches with a diffuse colour per vertex. */
  ShaderVariant tints() {
    return new ShaderVariant(
        lit, specular, byVertex, flat, colors, texture, tint, glow, alphaTest, twoSided, points,
        blended, true, detail);
  }

  private static void add(List<String> defines, boolean wanted, String name) {
    if (wanted) {
      defines.add(name);
    }
  }

  // Written out, as records link theirs when first called: the first frame would wait for it.
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof ShaderVariant one && parts().equals(one.parts());
  }

  @Override
  public int hashCode() {
    return parts().hashCode();
  }

  private List<@Nullable Object> parts() {
    return Arrays.asList(
        lit, specular, byVertex, flat, colors, texture, tint, glow, alphaTest, twoSided, points,
        blended, tinted, detail);
  }
}
