package org.selectiverenderer.polygon.simplify;

/**
 * A model whose triangles all vanish where corners that are as good as one are joined: specks that
 * are far apart, or nothing at all. The message is a clause that reads after the model's name.
 */
public final class NoPolygons extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  NoPolygons() {
    super(
        "has no polygons that are more than specks beside its extent, so there is nothing to reduce");
  }
}
