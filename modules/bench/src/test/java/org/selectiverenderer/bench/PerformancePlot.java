package org.selectiverenderer.bench;

import java.util.Locale;

/** The plots of docs/performance.md and docs/budget.md: what each shows, and how. */
enum PerformancePlot {
  FRAMES(
      Form.GROUPS,
      "Frames per second",
      "1024x768, no anti-aliasing, software OpenGL; more is better",
      ""),
  MEMORY(
      Form.GROUPS, "Resident memory", "at most, while the scene is shown; less is better", " MB"),
  FRAME(Form.PARTS, "A frame", "what its time goes into", " ms"),
  GROWTH_OBJECTS(
      Form.CURVES, "More objects", "of as many triangles together", "objects", "milliseconds"),
  GROWTH_SENSORS(
      Form.CURVES, "More sensors", "of which few are near the viewer", "sensors", "milliseconds"),
  GROWTH_SWITCHES(
      Form.CURVES, "More switches", "of which ten change at a time", "switches", "milliseconds"),
  GROWTH_INLINES(Form.CURVES, "More inlined files", "of equal size", "files", "milliseconds"),
  STREET_FRAME(
      Form.CURVES,
      "A frame in a street",
      "the first apartment's walls hide the others; less is better",
      "apartments",
      "milliseconds"),
  STREET_LOAD(
      Form.CURVES,
      "Until a street is drawn",
      "from the start of the process",
      "apartments",
      "seconds"),
  STREET_MEMORY(
      Form.CURVES,
      "Resident memory in a street",
      "at most, while it is shown",
      "apartments",
      "megabytes"),
  BUDGET_APARTMENT(
      Form.CURVES,
      "What pictures of the apartment lose",
      "1 - SSIM to all objects high, mean of ten places of the tour; less is better",
      "triangles",
      "1 - SSIM"),
  BUDGET_STREET(
      Form.CURVES,
      "What pictures of a street lose",
      "1 - SSIM to all objects high, mean of ten places of the tour; less is better",
      "triangles",
      "1 - SSIM"),
  SELECTIVE(
      Form.PARTS,
      "What selective rendering saves",
      "processor time of a frame, heavy scene with two versions of each object",
      " ms");

  /** How the figures are drawn. */
  enum Form {
    /** Bars of several series beside each other. */
    GROUPS,
    /** Bars made of parts. */
    PARTS,
    /** Curves over logarithmic axes. */
    CURVES
  }

  private final Form form;
  private final String title;
  private final String subtitle;

  /** Behind the numbers of bars; else what the curves' axes are. */
  private final String[] units;

  PerformancePlot(Form form, String title, String subtitle, String... units) {
    this.form = form;
    this.title = title;
    this.subtitle = subtitle;
    this.units = units;
  }

  Form form() {
    return form;
  }

  String title() {
    return title;
  }

  String subtitle() {
    return subtitle;
  }

  /** From 0; bars have one, curves have two, across and up. */
  String unit(int index) {
    return units[index];
  }

  /** Of its files, without the ending. */
  String fileName() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
