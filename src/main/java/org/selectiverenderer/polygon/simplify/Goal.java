package org.selectiverenderer.polygon.simplify;

/** How far to reduce a model: the thesis's parameters (2.2.4), and two more. */
public sealed interface Goal {
  /** A number of triangles, at least 1. */
  record Polygons(int count) implements Goal {
    public Polygons {
      positive(count);
    }
  }

  /**
   * Exactly that number of triangles, at least 1: where reducing leaves fewer, edges are split
   * without a change of form. A closed surface can only have an even number.
   */
  record Exactly(int count) implements Goal {
    public Exactly {
      positive(count);
    }
  }

  /** A number of vertices (Vert Count): distinct positions, summed over the parts; at least 1. */
  record Vertices(int count) implements Goal {
    public Vertices {
      positive(count);
    }
  }

  /** A share of the original's vertices (Vert Percent), above 0 and at most 100. */
  record VertexPercent(double percent) implements Goal {
    public VertexPercent {
      if (!(percent > 0 && percent <= 100)) {
        throw new IllegalArgumentException("not above 0 and at most 100: " + percent);
      }
    }
  }

  /** The largest error allowed, as a share of the model's largest extent; 0 or more. */
  record LargestError(double error) implements Goal {
    public LargestError {
      if (!(error >= 0 && error < Double.POSITIVE_INFINITY)) {
        throw new IllegalArgumentException("no error: " + error);
      }
    }
  }

  private static void positive(int count) {
    if (count < 1) {
      throw new IllegalArgumentException("not above 0: " + count);
    }
  }
}
