package org.selectiverenderer.runtime.instance;

import org.jspecify.annotations.Nullable;

/**
 * What an Appearance says about how lines, points and areas are drawn, beside their colour (X3D
 * 4.0, 12.4.3, 12.4.5, 12.4.8). One immutable value, compared by what is in it; each part holds for
 * geometry of its kind and is null where the Appearance says nothing.
 */
public record Stroke(@Nullable Line line, @Nullable Dot dot, @Nullable Fill fill) {
  /** Lines one pixel wide, points of the usual size, areas filled. */
  public static final Stroke PLAIN = new Stroke(null, null, null);

  /**
   * A LineProperties node that is applied.
   *
   * @param type its {@code linetype}, 1 for solid
   * @param width its {@code linewidthScaleFactor}: lines are so many pixels wide, at least one
   */
  public record Line(int type, float width) {
    /** Whether there is something at its ends: an arrow (6), a dot (7), two arrows (8). */
    public boolean ended() {
      return type >= 6 && type <= 8;
    }
  }

  /**
   * A PointProperties node. A point at the distance {@code r} from the eye is {@code scale / (a + b
   * * r + c * r * r)} times as large as usual, the divisor being at least 1 and the result between
   * {@code least} and {@code most}.
   *
   * @param least holds for points that distance makes smaller, else every default would be 1
   */
  public record Dot(float scale, float least, float most, float a, float b, float c) {
    /** Whether distance makes points smaller. */
    public boolean attenuated() {
      return b > 0 || c > 0 || a > 1;
    }
  }

  /**
   * A FillProperties node.
   *
   * @param filled whether the area itself is seen
   * @param hatched whether lines are drawn over it
   * @param style of these lines, 1 horizontal .. 19 dots in rows
   */
  public record Fill(
      boolean filled, boolean hatched, int style, float red, float green, float blue) {}

  /** Whether what is drawn of an area may leave gaps. */
  public boolean hollow() {
    return fill != null && !fill.filled();
  }
}
