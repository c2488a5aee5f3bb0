package org.selectiverenderer.render.draw;

import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.DrawProperties;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.render.gpu.StrokeStyle;

/** The patterns of the standard's line types and hatches (X3D 4.0, 12.4.3 and 12.4.5). */
final class StrokePatterns {
  /**
   * The number of hatch styles in the International Register of Graphical Items; others are drawn
   * like the third.
   */
  private static final int HATCHES = 19;

  private static final int SLANTED = 3;
  private static final int ALL = 0xffff;
  private static final int FREEHAND = 14;
  private static final int ZIGZAG = 15;

  /**
   * The pixels by which arrows, dots and breaks reach beside their line, per pixel of its width.
   */
  private static final double BESIDE = 9;

  private StrokePatterns() {}

  /** Returns how the primitives of a mesh with that stroke are rasterised. */
  static StrokeStyle form(DrawProperties stroke, Mesh.Primitive primitive) {
    return switch (primitive) {
      case LINES -> form(stroke.line());
      case POINTS -> form(stroke.dot());
      case TRIANGLES -> form(stroke.fill());
    };
  }

  private static StrokeStyle form(DrawProperties.@Nullable Line line) {
    if (line == null) {
      return StrokeStyle.PLAIN;
    }
    if (line.ended()) {
      return StrokeStyle.ENDED;
    }
    if (line.type() == FREEHAND || line.type() == ZIGZAG) {
      return StrokeStyle.BREAK;
    }
    if (bits(line.type()) != ALL) {
      return StrokeStyle.PATTERN;
    }
    return line.width() > 1 ? StrokeStyle.WIDE : StrokeStyle.PLAIN;
  }

  private static StrokeStyle form(DrawProperties.@Nullable Dot dot) {
    if (dot == null) {
      return StrokeStyle.PLAIN;
    }
    return dot.attenuated() ? StrokeStyle.ATTENUATED : StrokeStyle.SIZED;
  }

  private static StrokeStyle form(DrawProperties.@Nullable Fill fill) {
    if (fill == null || fill.filled() && !fill.hatched()) {
      return StrokeStyle.PLAIN;
    }
    if (!fill.hatched()) {
      return StrokeStyle.HOLLOW;
    }
    return fill.filled() ? StrokeStyle.HATCHED : StrokeStyle.HATCH_ONLY;
  }

  /**
   * Returns the stipple pattern of a line, one bit for each of sixteen dashes, lowest bit first;
   * for a line with arrows, dots or breaks its line type.
   */
  static int pattern(DrawProperties.Line line) {
    return form(line) == StrokeStyle.ENDED || form(line) == StrokeStyle.BREAK
        ? line.type()
        : bits(line.type());
  }

  private static int bits(int type) {
    return switch (type) {
      case 2 -> 0x00ff; // dashed
      case 3 -> 0x3333; // dotted
      case 4 -> 0x18ff; // dash and dot
      case 5 -> 0x333f; // dash and two dots
      case 9 -> 0x7777; // stitch
      case 10 -> 0x0c3f; // chain
      case 11 -> 0x39ff; // centre
      case 12 -> 0x0f0f; // hidden
      case 13 -> 0x36ff; // phantom
      default -> ALL;
    };
  }

  static int hatch(DrawProperties.Fill fill) {
    return fill.style() >= 1 && fill.style() <= HATCHES ? fill.style() : SLANTED;
  }

  private static double width(DrawProperties.Line line) {
    return form(line) == StrokeStyle.ENDED || form(line) == StrokeStyle.BREAK
        ? BESIDE * line.width()
        : line.width();
  }

  /** Returns by how many pixels a shape may reach beyond its bounding box on the screen. */
  static double reach(DrawProperties stroke, Mesh.Primitive primitive, double least) {
    DrawProperties.Line line = stroke.line();
    DrawProperties.Dot dot = stroke.dot();
    return switch (primitive) {
      case TRIANGLES -> 0;
      case LINES -> line == null ? least : Math.max(least, width(line));
      case POINTS -> dot == null ? least : Math.max(least, least * dot.scale());
    };
  }
}
