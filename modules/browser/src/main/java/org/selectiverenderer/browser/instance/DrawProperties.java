package org.selectiverenderer.browser.instance;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/**
 * The LineProperties, PointProperties and FillProperties of an Appearance: how lines, points and
 * areas are drawn, apart from their colour (X3D 4.0, 12.4.3, 12.4.5, 12.4.8). Immutable and
 * compared by value; each part applies to geometry of its kind and is null if the Appearance lacks
 * that node.
 */
public record DrawProperties(@Nullable Line line, @Nullable Dot dot, @Nullable Fill fill) {
  /** The defaults: lines one pixel wide, points of the default size, areas filled. */
  public static final DrawProperties PLAIN = new DrawProperties(null, null, null);

  /**
   * A LineProperties node that is applied.
   *
   * @param type the {@code linetype}, 1 for solid
   * @param width the {@code linewidthScaleFactor}: the line width in pixels, at least 1
   */
  public record Line(int type, float width) {
    /** Returns whether the line type has end symbols: an arrow (6), a dot (7) or two arrows (8). */
    public boolean ended() {
      return type >= 6 && type <= 8;
    }
  }

  /**
   * A PointProperties node. A point at the distance {@code r} from the eye is {@code scale / (a + b
   * * r + c * r * r)} times the default size, the divisor being at least 1 and the result between
   * {@code least} and {@code most}.
   *
   * @param least the lower limit, for points that are attenuated by distance only; otherwise the
   *     default size would always be limited to 1
   */
  public record Dot(float scale, float least, float most, float a, float b, float c) {
    /** Returns whether the size of points is attenuated by distance. */
    public boolean attenuated() {
      return b > 0 || c > 0 || a > 1;
    }
  }

  /**
   * A FillProperties node.
   *
   * @param filled whether the area itself is drawn
   * @param hatched whether a hatch pattern is drawn over it
   * @param style the {@code hatchStyle}, 1 (horizontal) to 19 (dots in rows)
   */
  public record Fill(
      boolean filled, boolean hatched, int style, float red, float green, float blue) {}

  /** Returns whether an area may be drawn with gaps. */
  public boolean hollow() {
    return fill != null && !fill.filled();
  }

  // Written out, as records link theirs when first called: the first frame would wait for it.
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof DrawProperties one
        && Objects.equals(line, one.line)
        && Objects.equals(dot, one.dot)
        && Objects.equals(fill, one.fill);
  }

  @Override
  public int hashCode() {
    return 31 * (31 * Objects.hashCode(line) + Objects.hashCode(dot)) + Objects.hashCode(fill);
  }
}
