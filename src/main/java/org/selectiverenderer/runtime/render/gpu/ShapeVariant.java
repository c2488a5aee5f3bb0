package org.selectiverenderer.runtime.render.gpu;

import java.util.ArrayList;
import java.util.List;

/**
 * What a shape needs of its shader. Each variant is a program of its own that computes nothing
 * else: software GL executes both sides of every branch.
 *
 * @param lit whether lights count
 * @param specular whether the material has a highlight
 * @param byVertex whether light is computed at the vertices, else at the pixels
 * @param colors whether vertices have colours
 * @param texture whether there is an image
 * @param tint whether the image tints the colour, else replaces it
 * @param glow whether the image multiplies the emissive colour, and nothing else
 * @param alphaTest whether pixels of the image are either there or not
 * @param twoSided whether the back is seen
 * @param points whether points are drawn
 * @param blended whether it is blended over what is behind
 * @param tinted whether vertices have, instead, the diffuse colours of the materials of shapes that
 *     are drawn together
 * @param detail what {@link DetailDefines} says of a surface that has more; else empty
 */
public record ShapeVariant(
    boolean lit,
    boolean specular,
    boolean byVertex,
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
    // Such a colour is the same all over a triangle: where light is computed, there it is enough.
    boolean atVertices = lit && byVertex && !apart;
    add(defines, lit, "LIT");
    add(defines, lit && specular, "SPECULAR");
    add(defines, lit && (specular || lights.positional()), "EYE_POSITION");
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

  /** The same with its light computed elsewhere. */
  public ShapeVariant lit(boolean atVertices) {
    return new ShapeVariant(
        lit,
        specular,
        atVertices && lit && detail.isEmpty(),
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

  /** The same for where nothing but front sides is seen; differs only in its light. */
  ShapeVariant front() {
    return new ShapeVariant(
        lit,
        specular,
        byVertex,
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

  /** The same for shapes of several diffuse colours, which are drawn together. */
  ShapeVariant tints() {
    return new ShapeVariant(
        lit, specular, byVertex, colors, texture, tint, glow, alphaTest, twoSided, points, blended,
        true, detail);
  }

  private static void add(List<String> defines, boolean wanted, String name) {
    if (wanted) {
      defines.add(name);
    }
  }
}
