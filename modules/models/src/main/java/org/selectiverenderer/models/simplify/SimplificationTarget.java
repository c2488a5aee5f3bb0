package org.selectiverenderer.models.simplify;

/** The target of a simplification: the thesis's parameters (2.2.4), and two more. */
public sealed interface SimplificationTarget {
  /** A target number of triangles, at least 1. */
  record Polygons(int count) implements SimplificationTarget {
    public Polygons {
      positive(count);
    }
  }

  /**
   * Exactly that number of triangles, at least 1: where simplification leaves fewer, edges are
   * split without a change of shape. A closed surface can only have an even number.
   */
  record Exactly(int count) implements SimplificationTarget {
    public Exactly {
      positive(count);
    }
  }

  /**
   * A target number of vertices (Vert Count): distinct positions, summed over the parts; at least
   * 1.
   */
  record Vertices(int count) implements SimplificationTarget {
    public Vertices {
      positive(count);
    }
  }

  /**
   * A target number of vertices in percent of the original's (Vert Percent), above 0 and at most
   * 100.
   */
  record VertexPercent(double percent) implements SimplificationTarget {
    public VertexPercent {
      if (!(percent > 0 && percent <= 100)) {
        throw new IllegalArgumentException("not above 0 and at most 100: " + percent);
      }
    }
  }

  /** The largest error allowed, as a share of the model's largest extent; 0 or more. */
  record LargestError(double error) implements SimplificationTarget {
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
