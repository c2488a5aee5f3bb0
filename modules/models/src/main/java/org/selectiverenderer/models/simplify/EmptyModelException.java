package org.selectiverenderer.models.simplify;

/**
 * Thrown for a model without triangles, or whose triangles all become empty when nearly coincident
 * vertices are welded, because they are tiny relative to the model's extent. The message is a
 * clause that follows the model's name.
 */
public final class EmptyModelException extends IllegalArgumentException {
  private static final long serialVersionUID = 1;

  EmptyModelException() {
    super(
        "has no polygons larger than rounding error relative to its extent, so there is nothing to"
            + " reduce");
  }
}
