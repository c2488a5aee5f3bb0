package org.selectiverenderer.study.gaze;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.study.headlog.Dwell;
import org.selectiverenderer.study.headlog.DwellSummary;
import org.selectiverenderer.study.headlog.EyeSample;
import org.selectiverenderer.study.headlog.EyeTrackingAnalysis;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadSample;

/**
 * Measures what the viewer of a log looked at in each area: with the eyes where an eye tracker saw
 * them for at least half of the time, else with the head, by what was in the middle of the view.
 */
final class AttentionReader {
  private static final double TRACKED = 0.5;

  /**
   * Seconds below which an object was passed over rather than looked at: the line of sight crosses
   * others on its way to the next, and a fixation takes at least a tenth of a second.
   */
  private static final double SHORTEST = 0.15;

  /** The looks at an object. */
  private record Looks(double seconds, int count, double first) {
    Looks plus(Looks later) {
      return new Looks(seconds + later.seconds, count + later.count, first);
    }
  }

  private final HeadLog log;
  private final ViewingGeometry geometry;

  private AttentionReader(HeadLog log) {
    this.log = log;
    geometry = new ViewingGeometry(log);
  }

  /** Returns what was seen of each object in view, by area. */
  static Map<GazeArea, Map<String, ObjectAttention>> of(HeadLog log) {
    AttentionReader reader = new AttentionReader(log);
    AreaTimeline timeline = new AreaTimeline(log);
    List<List<GazeArea>> where = log.samples().stream().map(timeline::of).toList();
    Set<GazeArea> areas = new LinkedHashSet<>();
    where.forEach(areas::addAll);
    Map<GazeArea, Map<String, ObjectAttention>> all = new LinkedHashMap<>();
    for (GazeArea area : areas) {
      HeadLog there = log.where(i -> where.get(i).contains(area));
      all.put(area, reader.area(there));
    }
    return all;
  }

  private Map<String, ObjectAttention> area(HeadLog there) {
    Optional<EyeTrackingAnalysis> eyes =
        EyeTrackingAnalysis.of(there).filter(found -> found.tracked() >= TRACKED);
    DwellSummary looks =
        eyes.map(EyeTrackingAnalysis::looks).orElseGet(() -> DwellSummary.ofHead(there));
    Map<String, Looks> views = new HashMap<>();
    for (Dwell look : looks.all()) {
      if (look.seconds() >= SHORTEST) {
        views.merge(look.object(), new Looks(look.seconds(), 1, look.start()), Looks::plus);
      }
    }
    Map<String, double[]> times = times(there, eyes.isPresent(), views);
    Map<String, ObjectAttention> seen = new LinkedHashMap<>();
    times.forEach(
        (name, time) -> {
          Looks view = views.get(name);
          seen.put(
              name,
              view == null
                  ? new ObjectAttention(time[0], time[1], time[2], 0, 0, 0, 0)
                  : new ObjectAttention(
                      time[0],
                      time[1],
                      time[2],
                      1,
                      view.seconds(),
                      view.count(),
                      eyes.map(found -> found.fixations(name).size()).orElse(view.count())));
        });
    return seen;
  }

  /**
   * Returns for each object the time in view, its integral of the solid angle, and the time in view
   * until the first look.
   */
  private Map<String, double[]> times(HeadLog there, boolean eyes, Map<String, Looks> views) {
    Map<String, double[]> times = new HashMap<>();
    List<HeadSample> samples = there.samples();
    for (int i = 0; i < samples.size(); i++) {
      if (!there.inView(i)) {
        continue;
      }
      HeadSample sample = samples.get(i);
      double seconds = there.shown(i);
      double start = there.start(i);
      geometry
          .inView(sample, looked(sample, eyes))
          .forEach(
              (name, solidAngle) -> {
                double[] time = times.computeIfAbsent(name, key -> new double[3]);
                time[0] += seconds;
                time[1] += seconds * solidAngle;
                Looks view = views.get(name);
                time[2] += view == null || start < view.first() ? seconds : 0;
              });
    }
    times.keySet().removeIf(name -> !geometry.isObject(name));
    return times;
  }

  private static String looked(HeadSample sample, boolean eyes) {
    EyeSample gaze = sample.eyes();
    return !eyes ? sample.object() : gaze == null ? "" : gaze.object();
  }
}
