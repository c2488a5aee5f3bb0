package org.selectiverenderer.study.headlog;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import org.joml.Vector3d;
import org.selectiverenderer.formats.image.SvgPrecision;
import org.selectiverenderer.formats.image.SvgWriter;

/**
 * A plot of a head log: above, a floor plan with the viewer's path and lines of sight; below it,
 * timelines of the dwells on each object.
 */
public final class HeadLogPlot {
  static final int WIDTH = 1100;

  /** Maximum height of the floor plan; that of a long narrow scene is lower. */
  private static final int PLAN = 620;

  static final int MARGIN = 40;

  /** Colour for surfaces without a name. */
  private static final String UNKNOWN = "#999999";

  static final String INK = "#222222";

  /** Colours that people of any colour vision tell apart (Okabe and Ito 2008). */
  private static final List<String> COLOURS =
      List.of("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9", "#999933");

  private final HeadLogAnalysis analysis;
  private final Map<String, String> colours = new LinkedHashMap<>();
  private final double[] extent;
  private final double plan;

  private HeadLogPlot(HeadLogAnalysis analysis) {
    this.analysis = analysis;
    extent = extent(analysis.log());
    double ratio = (extent[3] - extent[1]) / (extent[2] - extent[0]);
    plan = Math.rint(Math.min(PLAN, (WIDTH - 2.0 * MARGIN) * ratio + 10));
    Stream.concat(
            analysis.head().objects().stream(),
            analysis.eyes().stream().flatMap(eyes -> eyes.looks().objects().stream()))
        .map(DwellSummary.ObjectView::object)
        .forEach(
            object ->
                colours.computeIfAbsent(
                    object, name -> COLOURS.get(colours.size() % COLOURS.size())));
  }

  /** Returns the plot as SVG; the same bytes for the same analysis. */
  public static String svg(HeadLogAnalysis analysis) {
    return new HeadLogPlot(analysis).draw();
  }

  private String draw() {
    List<DwellTimeline> timelines = timelines();
    double below = timelines.stream().mapToDouble(DwellTimeline::height).sum();
    int height = (int) (MARGIN + plan + MARGIN + below + MARGIN / 2);
    HeadLogMetadata shown = analysis.log().description();
    String title =
        "Head log: %s, %s, %s s"
            .formatted(
                shown.scene(),
                shown.condition(),
                String.format(Locale.ROOT, "%.1f", analysis.seconds()));
    String fonts = "DejaVu Sans, Arial, sans-serif";
    SvgWriter svg = new SvgWriter(WIDTH, height, fonts, title, SvgPrecision.TENTHS);
    svg.rectangle(0, 0, WIDTH, height, "#ffffff");
    text(svg, title, MARGIN, 28, 18, INK, "start");
    plan(svg);
    double top = MARGIN + plan + MARGIN;
    for (DwellTimeline timeline : timelines) {
      timeline.draw(svg, top);
      top += timeline.height();
    }
    return svg.finish();
  }

  /** Returns the timeline of the head, and that of the eyes if they were tracked. */
  private List<DwellTimeline> timelines() {
    String left = analysis.unshown().samples() > 0 ? "grey: no picture" : "";
    List<DwellTimeline> timelines = new ArrayList<>();
    timelines.add(
        new DwellTimeline(
            "In the middle of the view" + (left.isEmpty() ? "" : " (" + left + ")"),
            analysis.log(),
            analysis.head(),
            colours));
    analysis
        .eyes()
        .ifPresent(
            eyes ->
                timelines.add(
                    new DwellTimeline(
                        "Looked at by the eyes (rings above"
                            + (left.isEmpty() ? "" : "; " + left)
                            + ")",
                        analysis.log(),
                        eyes.looks(),
                        colours)));
    return timelines;
  }

  /** The transformation from world x and z to the drawing. */
  private record Scale(double x, double z, double pixels, double down) {
    double[] at(double worldX, double worldZ) {
      return new double[] {WIDTH / 2.0 + (worldX - x) * pixels, down + (worldZ - z) * pixels};
    }
  }

  private Scale scale() {
    return new Scale(
        (extent[0] + extent[2]) / 2,
        (extent[1] + extent[3]) / 2,
        Math.min(
            (WIDTH - 2.0 * MARGIN) / (extent[2] - extent[0]),
            (plan - 10) / (extent[3] - extent[1])),
        MARGIN + plan / 2);
  }

  /** Returns the bounds of the floor plan: least x and z, then greatest x and z. */
  private static double[] extent(HeadLog log) {
    double[] box = {
      Double.POSITIVE_INFINITY,
      Double.POSITIVE_INFINITY,
      Double.NEGATIVE_INFINITY,
      Double.NEGATIVE_INFINITY
    };
    for (HeadSample sample : log.samples()) {
      grow(box, sample.x() - 0.5, sample.z() - 0.5, sample.x() + 0.5, sample.z() + 0.5);
    }
    for (SceneMap.Box room : log.description().map().rooms()) {
      double[] b = room.bounds();
      grow(box, b[0], b[2], b[3], b[5]);
    }
    return box;
  }

  private static void grow(double[] box, double x0, double z0, double x1, double z1) {
    box[0] = Math.min(box[0], x0);
    box[1] = Math.min(box[1], z0);
    box[2] = Math.max(box[2], x1);
    box[3] = Math.max(box[3], z1);
  }

  private void plan(SvgWriter svg) {
    Scale scale = scale();
    SceneMap map = analysis.log().description().map();
    for (SceneMap.Area area : map.areas()) {
      List<double[]> corners =
          area.outline().stream().map(corner -> scale.at(corner[0], corner[1])).toList();
      path(svg, corners, true, "fill", "#eef4fa", "stroke", "#0072b2", "stroke-dasharray", "6 4");
    }
    for (SceneMap.Box room : map.rooms()) {
      path(svg, outline(room, scale), true, "fill", "none", "stroke", "#555555", "stroke-width", 2);
    }
    for (SceneMap.Box object : map.objects()) {
      String colour = colours.get(object.name());
      path(
          svg,
          outline(object, scale),
          true,
          "fill",
          colour == null ? "none" : colour,
          "stroke",
          colour == null ? "#bbbbbb" : "none");
    }
    way(svg, scale);
    names(svg, scale);
  }

  /** Draws the names of areas and rooms, above everything else. */
  private void names(SvgWriter svg, Scale scale) {
    SceneMap map = analysis.log().description().map();
    for (SceneMap.Area area : map.areas()) {
      double[] corner = scale.at(area.outline().get(0)[0], area.outline().get(0)[1]);
      name(svg, area.name(), corner[0] + 5, corner[1] + 15, 12, "#0072b2");
    }
    for (int i = 0; i < map.rooms().size(); i++) {
      SceneMap.Box room = map.rooms().get(i);
      double[] corner = scale.at(room.bounds()[0], room.bounds()[5]);
      double seen = 100 * analysis.rooms().get(i).seen();
      String name = String.format(Locale.ROOT, "%s: %.0f %% seen", room.name(), seen);
      name(svg, name, corner[0] + 5, corner[1] - 7, 13, INK);
    }
  }

  /** Draws a name with a white outline, so that it can be read over lines of any colour. */
  private static void name(SvgWriter svg, String words, double x, double y, int size, String fill) {
    String white = "#ffffff";
    svg.text(
        words,
        x,
        y,
        "font-size",
        size,
        "fill",
        white,
        "stroke",
        white,
        "stroke-width",
        4,
        "stroke-linejoin",
        "round",
        "aria-hidden",
        "true");
    text(svg, words, x, y, size, fill, "start");
  }

  /** Draws the point that the eyes looked at, as a ring. */
  private void eyes(SvgWriter svg, Scale scale, HeadSample sample) {
    EyeSample eyes = sample.eyes();
    if (eyes != null && eyes.tracked() && !Double.isNaN(eyes.distance())) {
      Vector3d way = FixationDetector.direction(sample, eyes).mul(eyes.distance());
      double[] seen = scale.at(sample.x() + way.x, sample.z() + way.z);
      String colour = colours.getOrDefault(eyes.object(), UNKNOWN);
      circle(svg, seen, 5, "fill", "none", "stroke", colour, "stroke-width", "1.5");
    }
  }

  private static List<double[]> outline(SceneMap.Box box, Scale scale) {
    double[] b = box.bounds();
    return List.of(
        scale.at(b[0], b[2]), scale.at(b[3], b[2]), scale.at(b[3], b[5]), scale.at(b[0], b[5]));
  }

  /**
   * Draws the viewer's path and, at regular intervals, the line of sight in the colour of the
   * object looked at.
   */
  private void way(SvgWriter svg, Scale scale) {
    List<double[]> way = new ArrayList<>();
    double next = Double.NEGATIVE_INFINITY;
    for (HeadSample sample : analysis.log().samples()) {
      if (!sample.visible()) {
        continue;
      }
      double[] at = scale.at(sample.x(), sample.z());
      double[] last = way.isEmpty() ? null : way.get(way.size() - 1);
      if (last == null || Math.hypot(at[0] - last[0], at[1] - last[1]) > 1) {
        way.add(at);
      }
      if (sample.t() >= next) {
        next = sample.t() + Math.max(0.1, analysis.seconds() / 200);
        double reach = Double.isNaN(sample.distance()) ? 1 : sample.distance();
        double level = reach * Math.cos(Math.toRadians(sample.pitch()));
        double yaw = Math.toRadians(sample.yaw());
        double[] seen =
            scale.at(sample.x() - level * Math.sin(yaw), sample.z() - level * Math.cos(yaw));
        String colour = colours.getOrDefault(sample.object(), UNKNOWN);
        path(svg, List.of(at, seen), false, "stroke", colour, "stroke-opacity", "0.45");
        circle(svg, seen, 2.5, "fill", colour);
        eyes(svg, scale, sample);
      }
    }
    if (way.isEmpty()) {
      return; // No sample has a visible picture.
    }
    path(svg, way, false, "fill", "none", "stroke", INK, "stroke-width", "1.5");
    double[] start = way.get(0);
    circle(svg, start, 5, "fill", "#ffffff", "stroke", INK, "stroke-width", 2);
    double[] end = way.get(way.size() - 1);
    circle(svg, end, 5, "fill", INK);
  }

  private static void path(SvgWriter svg, List<double[]> points, boolean closed, Object... style) {
    if (!points.isEmpty()) {
      svg.path(svg.line(points) + (closed ? "Z" : ""), style);
    }
  }

  private static void circle(SvgWriter svg, double[] middle, double radius, Object... style) {
    svg.circle(middle[0], middle[1], radius, style);
  }

  /**
   * Draws a line of text.
   *
   * @param anchor which end of it is at x: start, middle or end
   */
  static void text(
      SvgWriter svg, String words, double x, double y, int size, String fill, String anchor) {
    svg.text(words, x, y, "font-size", size, "fill", fill, "text-anchor", anchor);
  }
}
