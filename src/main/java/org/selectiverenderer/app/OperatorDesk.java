package org.selectiverenderer.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.experiment.headlog.SceneMap;
import org.selectiverenderer.experiment.headlog.SceneSurvey;
import org.selectiverenderer.runtime.instance.InstanceTree;
import org.selectiverenderer.runtime.render.OperatorPage;
import org.selectiverenderer.runtime.render.sketch.Mark;
import org.selectiverenderer.tracker.PoseSample;
import org.selectiverenderer.tracker.TrackerHealth;

/**
 * What the operator of a session sees: the participant's picture above; below it the areas from
 * above with the viewer, and what is going on. Belongs to the render thread.
 */
final class OperatorDesk {
  static final int INK = 0xffe8e8e8;
  static final int FAINT = 0xff9aa0a6;
  static final int GOOD = 0xff7ec699;
  static final int ALARM = 0xffff6b5e;
  private static final int MOST_LATENCY = 100;
  private static final int MARGIN = 16;
  private static final double LETTERS = 15;
  private static final double LINE = 22;

  private final RunSettings settings;
  private final HeadSession head;
  private @Nullable InstanceTree tree;
  private long structure;
  private SceneMap map = SceneMap.EMPTY;

  OperatorDesk(RunSettings settings, HeadSession head) {
    this.settings = settings;
    this.head = head;
  }

  /**
   * The page of a moment.
   *
   * @param interval seconds from frame to frame
   */
  OperatorPage page(
      Walkthrough walk,
      double interval,
      int width,
      int height,
      int pictureWidth,
      int pictureHeight) {
    survey(walk.world().instances());
    double most = height * 0.56;
    double scale = Math.min((width - 2.0 * MARGIN) / pictureWidth, (most - MARGIN) / pictureHeight);
    int shownWidth = (int) Math.max(1, pictureWidth * scale);
    int shownHeight = (int) Math.max(1, pictureHeight * scale);
    List<Mark> marks = new ArrayList<>();
    double top = MARGIN + shownHeight + MARGIN;
    double side = Math.min(height - top - MARGIN, width * 0.45);
    new AreaMap(map, MARGIN, top, width * 0.5 - 2 * MARGIN, side)
        .draw(walk.world().viewer(), settings.presentation(), walk.enteredAreas(), marks);
    lines(walk, interval, width * 0.5, top, marks);
    alarm(width, marks);
    return new OperatorPage((width - shownWidth) / 2, MARGIN, shownWidth, shownHeight, marks);
  }

  private void survey(InstanceTree now) {
    if (tree != now || structure != now.structureVersion()) {
      tree = now;
      structure = now.structureVersion();
      map = SceneSurvey.of(now);
    }
  }

  private void lines(Walkthrough walk, double interval, double left, double top, List<Mark> marks) {
    double y = top + LETTERS;
    y = line(left, y, INK, "schemas active: " + list(walk.activeSchemas()), marks);
    y = line(left, y, INK, "areas entered: " + list(walk.enteredAreas()), marks);
    y =
        line(
            left,
            y,
            INK,
            text(
                "%,d polygons    %.1f ms per frame    %.0f s",
                walk.polygons(), interval * 1000, walk.world().time()),
            marks);
    Vector3dc eye = walk.world().viewer().position();
    y = line(left, y, FAINT, text("at %.2f  %.2f  %.2f", eye.x(), eye.y(), eye.z()), marks);
    if (settings.head().tracked()) {
      y = tracker(left, y + LINE / 2, marks);
    } else {
      y = line(left, y + LINE / 2, FAINT, "no tracker: the mouse turns the view", marks);
    }
    settings
        .head()
        .log()
        .ifPresent(
            file -> line(left, top + 10 * LINE, FAINT, "head log: " + file.getFileName(), marks));
  }

  private double tracker(double left, double top, List<Mark> marks) {
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
                settings.head().tracker(), health.state().name().toLowerCase(Locale.ROOT)),
            marks);
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
            "record to picture: %s ms, 99 of 100 within %s ms",
            milliseconds(head.latency().percentileMs(0.5)),
            milliseconds(head.latency().percentileMs(0.99))),
        marks);
  }

  /** The meter does not tell what is beyond its end apart. */
  private static String milliseconds(double value) {
    return value >= MOST_LATENCY ? "over " + MOST_LATENCY : text("%.1f", value);
  }

  /** What nobody may overlook. */
  private void alarm(int width, List<Mark> marks) {
    if (!settings.head().tracked()) {
      return;
    }
    TrackerHealth health = head.health();
    if (!health.stale()) {
      return;
    }
    marks.add(Mark.rectangle(0, 0, width, 40, 0xe0901810));
    marks.add(new Mark.Text(alarm(settings, health), MARGIN, 27, 20, 0xffffffff));
  }

  /** That the tracker is silent, and what turns the view instead. */
  static String alarm(RunSettings settings, TrackerHealth health) {
    return text(
        "The tracker is silent for %.1f s: %s",
        health.silentSeconds(),
        switch (settings.head().whenLost()) {
          case FREEZE -> "the view stays as it is";
          case MOUSE -> "the view follows the mouse";
        });
  }

  private static double line(double x, double y, int color, String text, List<Mark> marks) {
    marks.add(new Mark.Text(text, x, y, LETTERS, color));
    return y + LINE;
  }

  private static String list(List<String> names) {
    return names.isEmpty() ? "none" : String.join(", ", names);
  }

  private static String text(String format, Object... arguments) {
    return String.format(Locale.ROOT, format, arguments);
  }
}
