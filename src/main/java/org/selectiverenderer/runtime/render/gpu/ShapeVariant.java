package org.selectiverenderer.runtime.render.gpu;

import java.util.ArrayList;
import java.util.List;

/**
 * What a shape needs of its shader. Each variant is a program of its own that computes nothing
 * else: software GL executes both sides of every branch.
 *
 * @param lit whether lights count
 * @param specular whether the material has a highlight
 * @param positional whether a light of the scope has a position
 * @param spot whether a light of the scope has a beam
 * @param colors whether vertices have colours
 * @param texture whether there is an image
 * @param tint whether the image tints the colour, else replaces it
 * @param alphaTest whether pixels of the image are either there or not
 * @param twoSided whether the back is seen
 * @param points whether points are drawn
 * @param blended whether it is blended over what is behind
 */
public record ShapeVariant(
    boolean lit,
    boolean specular,
    boolean positional,
    boolean spot,
    boolean colors,
    boolean texture,
    boolean tint,
    boolean alphaTest,
    boolean twoSided,
    boolean points,
    boolean blended) {

  List<String> defines() {
    List<String> defines = new ArrayList<>();
    add(defines, lit, "LIT");
    add(defines, lit && specular, "SPECULAR");
    add(defines, lit && (positional || spot), "POSITIONAL");
    add(defines, lit && spot, "SPOT");
    add(defines, lit && (specular || positional || spot), "EYE_POSITION");
    add(defines, colors, "COLORS");
    add(defines, texture, "TEXTURE");
    add(defines, texture && tint, "TINT");
    add(defines, texture && alphaTest, "ALPHA_TEST");
    add(defines, twoSided, "TWO_SIDED");
    add(defines, points, "POINTS");
    add(defines, !blended, "OPAQUE");
    return defines;
  }

  private static void add(List<String> defines, boolean wanted, String name) {
    if (wanted) {
      defines.add(name);
    }
  }
}
