package org.selectiverenderer.render.gpu;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** The styles of lines, points and areas, with the shader defines that draw them. */
public enum StrokeStyle {
  /** Lines one pixel wide, points of the usual size, filled areas. */
  PLAIN(null),
  /** Wide lines with round ends, which meet without a gap. */
  WIDE("line", "LINES", "WIDE"),
  /** Lines with a pattern, of any width. */
  PATTERN("line", "LINES", "PATTERN"),
  /** Lines that deviate from the straight one: freehand, zigzag. */
  BREAK("line", "LINES", "PATTERN", "BREAK"),
  /** Lines with arrows or dots at their ends. */
  ENDED("line", "LINES", "WIDE", "ENDED"),
  /** Points with a size of their own. */
  SIZED(null, "SIZED"),
  /** Points that distance makes smaller. */
  ATTENUATED(null, "SIZED", "ATTENUATED"),
  /** Filled areas with hatching. */
  HATCHED(null, "HATCHED"),
  /** Areas drawn by hatching only. */
  HATCH_ONLY(null, "HATCHED", "HOLLOW"),
  /** Invisible areas. */
  HOLLOW(null, "HOLLOW");

  private final @Nullable String geometry;
  private final List<String> defines;

  StrokeStyle(@Nullable String geometry, String... defines) {
    this.geometry = geometry;
    this.defines = List.of(defines);
  }

  /** Returns the name of its geometry shader, or null for none. */
  @Nullable String geometry() {
    return geometry;
  }

  List<String> defines() {
    return defines;
  }
}
