package org.selectiverenderer.study.headlog;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * Detects fixations by a dispersion threshold (Salvucci and Goldberg 2000, Identifying fixations
 * and saccades in eye-tracking protocols): consecutive samples whose gaze direction in the world
 * stays within {@value #RADIUS} degrees of their mean for at least {@value #SHORTEST} seconds.
 * Movements of head and eyes that compensate each other (vestibulo-ocular reflex) do not end a
 * fixation. A blink ends it if it is longer than {@link DwellSummary#GAP}; a picture that
 * disappears, and a pause, end it at once.
 */
final class FixationDetector {
  /** Dispersion threshold in degrees. */
  static final double RADIUS = 1;

  /** Minimum duration of a fixation in seconds. */
  static final double SHORTEST = 0.1;

  private final List<Fixation> found = new ArrayList<>();
  private final Map<String, Integer> counts = new HashMap<>();
  private final Vector3d sum = new Vector3d();
  private double start;
  private double end;

  private FixationDetector() {}

  static List<Fixation> of(HeadLog log) {
    FixationDetector fixations = new FixationDetector();
    for (int i = 0; i < log.samples().size(); i++) {
      HeadSample sample = log.samples().get(i);
      EyeSample eyes = sample.eyes();
      if (!log.inView(i) || log.pauseBefore(i) > 0) {
        fixations.finish();
      }
      if (log.inView(i) && eyes != null && eyes.tracked()) {
        fixations.add(sample, eyes, log.start(i), log.start(i) + log.shown(i));
      }
    }
    fixations.finish();
    return fixations.found;
  }

  private void add(HeadSample sample, EyeSample eyes, double from, double until) {
    Vector3d direction = direction(sample, eyes);
    boolean rests =
        !counts.isEmpty()
            && from - end <= DwellSummary.GAP
            && sum.angle(direction) <= Math.toRadians(RADIUS);
    if (!rests) {
      finish();
      start = from;
    }
    sum.add(direction);
    counts.merge(eyes.object(), 1, Integer::sum);
    end = until;
  }

  private void finish() {
    if (!counts.isEmpty() && end - start >= SHORTEST) {
      found.add(new Fixation(most(), start, end));
    }
    counts.clear();
    sum.zero();
  }

  private String most() {
    @Nullable String most = null;
    for (Map.Entry<String, Integer> each : counts.entrySet()) {
      if (most == null
          || each.getValue() > counts.get(most)
          || each.getValue().equals(counts.get(most)) && each.getKey().compareTo(most) < 0) {
        most = each.getKey();
      }
    }
    return String.valueOf(most);
  }

  /** Returns the gaze direction in world coordinates, a unit vector. */
  static Vector3d direction(HeadSample sample, EyeSample eyes) {
    return new Quaterniond()
        .rotationYXZ(
            Math.toRadians(sample.yaw()),
            Math.toRadians(sample.pitch()),
            Math.toRadians(sample.roll()))
        .rotateY(Math.toRadians(eyes.yaw()))
        .rotateX(Math.toRadians(eyes.pitch()))
        .transform(new Vector3d(0, 0, -1));
  }
}
