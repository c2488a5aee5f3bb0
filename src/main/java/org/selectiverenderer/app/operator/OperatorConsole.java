package org.selectiverenderer.app.operator;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.head.HeadTrackingSession;
import org.selectiverenderer.app.head.SceneMapBuilder;
import org.selectiverenderer.app.settings.RunSettings;
import org.selectiverenderer.app.settings.TrackerSettings;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.browser.instance.InstanceTree;
import org.selectiverenderer.render.display.OperatorPage;
import org.selectiverenderer.study.headlog.SceneMap;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * The content of the operator's window during a session: the participant's picture; below it a map
 * of the areas with the viewer, and the state of the session, the scene and the tracker. It is
 * confined to the render thread.
 */
public final class OperatorConsole {
  static final int INK = 0xffe8e8e8;
  static final int FAINT = 0xff9aa0a6;
  static final int GOOD = 0xff7ec699;
  static final int ALARM = 0xffff6b5e;
  private static final int MARGIN = 16;
  private static final double LETTERS = 15;
  private static final double LINE = 22;

  private final RunSettings settings;
  private final HeadTrackingSession head;
  private @Nullable InstanceTree tree;
  private long structure;
  private SceneMap map = SceneMap.EMPTY;

  public OperatorConsole(RunSettings settings, HeadTrackingSession head) {
    this.settings = settings;
    this.head = head;
  }

  /**
   * Lays out the page of the current frame.
   *
   * @param interval seconds from frame to frame
   * @param told lines about the state of the session
   * @param blind whether the condition is hidden from the operator, and so the number of polygons
   */
  public OperatorPage page(
      Walkthrough walk,
      double interval,
      List<String> told,
      boolean blind,
      int width,
      int height,
      int pictureWidth,
      int pictureHeight) {
    survey(walk.world().instances());
    double most = height * 0.56;
    double scale = Math.min((width - 2.0 * MARGIN) / pictureWidth, (most - MARGIN) / pictureHeight);
    int shownWidth = (int) Math.max(1, pictureWidth * scale);
    int shownHeight = (int) Math.max(1, pictureHeight * scale);
    List<Primitive2D> marks = new ArrayList<>();
    double top = MARGIN + shownHeight + MARGIN;
    double side = Math.min(height - top - MARGIN, width * 0.45);
    new AreaMap(map, MARGIN, top, width * 0.5 - 2 * MARGIN, side)
        .draw(
            walk.world().viewer(),
            settings
                .display()
                .presentation()
                .seen(walk.world().viewer().fieldOfView(), pictureWidth, pictureHeight),
            walk.enteredAreas(),
            marks);
    double below = told(told, width * 0.5, top, marks);
    lines(walk, interval, blind, width * 0.5, below, marks);
    alarm(width, marks);
    return new OperatorPage((width - shownWidth) / 2, MARGIN, shownWidth, shownHeight, marks);
  }

  /** Returns the page while there is no picture. */
  public static OperatorPage waiting(List<String> told) {
    List<Primitive2D> marks = new ArrayList<>();
    double below = told(told, MARGIN, MARGIN, marks);
    line(MARGIN, below + LETTERS, FAINT, "the participant's picture is black", marks);
    return new OperatorPage(0, 0, 0, 0, marks);
  }

  private static double told(List<String> told, double left, double top, List<Primitive2D> marks) {
    double y = top;
    for (String text : told) {
      y = line(left, y + LETTERS, GOOD, text, marks) - LETTERS;
    }
    return y;
  }

  private void survey(InstanceTree now) {
    if (tree != now || structure != now.structureVersion()) {
      tree = now;
      structure = now.structureVersion();
      map = SceneMapBuilder.of(now);
    }
  }

  private void lines(
      Walkthrough walk,
      double interval,
      boolean blind,
      double left,
      double top,
      List<Primitive2D> marks) {
    double y = top + LETTERS;
    if (!blind) {
      y = line(left, y, INK, "schemas active: " + list(walk.activeSchemas()), marks);
    }
    y = line(left, y, INK, "areas entered: " + list(walk.enteredAreas()), marks);
    y =
        line(
            left,
            y,
            INK,
            (blind ? "" : text("%,d polygons    ", walk.polygons()))
                + text("%.1f ms per frame    %.0f s", interval * 1000, walk.world().time()),
            marks);
    Vector3dc eye = walk.world().viewer().position();
    y = line(left, y, FAINT, text("at %.2f  %.2f  %.2f", eye.x(), eye.y(), eye.z()), marks);
    if (settings.tracker().tracked()) {
      y = tracker(left, y + LINE / 2, marks);
    } else {
      y = line(left, y + LINE / 2, FAINT, "no tracker: the mouse turns the view", marks);
    }
    settings
        .log()
        .ifPresent(
            log ->
                line(left, top + 10 * LINE, FAINT, "head log: " + log.file().getFileName(), marks));
  }

  private double tracker(double left, double top, List<Primitive2D> marks) {
    TrackerHealth health = head.health();
    PoseSample pose = head.pose();
    boolean alarming = health.stale();
    double y =
        line(
            left,
            top,
            alarming ? ALARM : GOOD,
            text(
                "tracker %s: %s",
                settings.tracker().spec(), health.state().name().toLowerCase(Locale.ROOT)),
            marks);
    if (head.described().isPresent()) {
      y = line(left, y, INK, head.described().get(), marks);
    }
    y =
        line(
            left,
            y,
            INK,
            text(
                "yaw %.1f\u00b0  pitch %.1f\u00b0  roll %.1f\u00b0",
                pose.yaw(), pose.pitch(), pose.roll()),
            marks);
    y =
        line(
            left,
            y,
            FAINT,
            text(
                "%.0f records/s  jitter %.1f ms  bad %d  dropped %d",
                health.rateHz(), health.jitterMs(), health.bad(), health.dropped()),
            marks);
    return line(
        left,
        y,
        FAINT,
        text(
            "record to picture: median %.1f ms, 99 of 100 within %.1f ms",
            head.latency().percentileMs(0.5), head.latency().percentileMs(0.99)),
        marks);
  }

  /** Draws the alarm bar when the tracker is silent. */
  private void alarm(int width, List<Primitive2D> marks) {
    if (!settings.tracker().tracked()) {
      return;
    }
    TrackerHealth health = head.health();
    if (!health.stale()) {
      return;
    }
    marks.add(Primitive2D.rectangle(0, 0, width, 40, 0xe0901810));
    marks.add(new Primitive2D.Text(alarm(settings.tracker(), health), MARGIN, 27, 20, 0xffffffff));
  }

  /** Returns the sentence that the tracker is silent and what turns the view instead. */
  public static String alarm(TrackerSettings tracker, TrackerHealth health) {
    return text(
        "The tracker is silent for %.1f s: %s",
        health.silentSeconds(),
        switch (tracker.whenLost()) {
          case FREEZE -> "the view stays as it is";
          case MOUSE -> "the view follows the mouse";
        });
  }

  private static double line(double x, double y, int color, String text, List<Primitive2D> marks) {
    marks.add(new Primitive2D.Text(text, x, y, LETTERS, color));
    return y + LINE;
  }

  private static String list(List<String> names) {
    return names.isEmpty() ? "none" : String.join(", ", names);
  }

  private static String text(String format, Object... arguments) {
    return String.format(Locale.ROOT, format, arguments);
  }
}
