package org.selectiverenderer.runtime.render.gpu;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** How the primitives of a shape become pixels: what the texts of its program are compiled with. */
public enum StrokeForm {
  /** Lines one pixel wide, points of the usual size, areas filled. */
  PLAIN(null),
  /** Wide lines with round ends, which meet without a gap. */
  WIDE("line", "LINES", "WIDE"),
  /** Lines with a pattern, of any width. */
  PATTERN("line", "LINES", "PATTERN"),
  /** Lines that lie beside the straight one: freehand, zigzag. */
  BREAK("line", "LINES", "PATTERN", "BREAK"),
  /** Lines with arrows or dots at their ends. */
  ENDED("line", "LINES", "WIDE", "ENDED"),
  /** Points with a size of their own. */
  SIZED(null, "SIZED"),
  /** Points that distance makes smaller. */
  ATTENUATED(null, "SIZED", "ATTENUATED"),
  /** Areas with lines over them. */
  HATCHED(null, "HATCHED"),
  /** Lines over areas that are not seen themselves. */
  HATCH_ONLY(null, "HATCHED", "HOLLOW"),
  /** Areas of which nothing is seen. */
  HOLLOW(null, "HOLLOW");

  private final @Nullable String geometry;
  private final List<String> defines;

  StrokeForm(@Nullable String geometry, String... defines) {
    this.geometry = geometry;
    this.defines = List.of(defines);
  }

  /** The name of its geometry shader, or null for none. */
  @Nullable String geometry() {
    return geometry;
  }

  List<String> defines() {
    return defines;
  }
}
