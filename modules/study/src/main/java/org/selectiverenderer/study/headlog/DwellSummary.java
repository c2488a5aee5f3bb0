package org.selectiverenderer.study.headlog;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import java.util.stream.Collectors;

/**
 * The dwells of a head log: on objects in the middle of the view (head), or under the gaze (eyes).
 * Only the time in view counts ({@link HeadLogAnalysis}), and each moment of it for at most one
 * object, so that the dwell times of all objects add up to at most the time in view.
 *
 * @param all the dwells in order of time
 * @param objects totals of each object that was looked at, the longest first
 * @param unseen names of the objects that were never looked at, by room; without walls, floors and
 *     ceilings
 */
public record DwellSummary(
    List<Dwell> all, List<ObjectView> objects, Map<String, List<String>> unseen) {

  /**
   * Gap in seconds up to which a dwell continues, as when the line of sight crosses an edge or the
   * leg of a chair. Time of the gap counts for the object only where no other one was looked at.
   */
  static final double GAP = 0.15;

  /**
   * The totals of all dwells on an object.
   *
   * @param seconds total dwell time
   * @param looks number of dwells
   * @param first begin of the first dwell, in seconds since the session began
   * @param longest time on the object in the longest dwell, in seconds
   */
  public record ObjectView(
      String object, double seconds, int looks, double first, double longest) {}

  /** Returns the dwells on objects in the middle of the view. */
  public static DwellSummary ofHead(HeadLog log) {
    return of(log, HeadSample::object, HeadSample::version);
  }

  /** Returns the dwells of the gaze; there is none while the eyes were not tracked. */
  static DwellSummary ofEyes(HeadLog log) {
    return of(log, sample -> eyes(sample).object(), sample -> eyes(sample).version());
  }

  private static EyeSample eyes(HeadSample sample) {
    EyeSample eyes = sample.eyes();
    return eyes == null ? EyeSample.LOST : eyes;
  }

  private static DwellSummary of(
      HeadLog log, Function<HeadSample, String> object, ToIntFunction<HeadSample> version) {
    List<Dwell> looks = looks(log, object, version);
    List<ObjectView> objects = objects(looks);
    List<String> seen = objects.stream().map(ObjectView::object).toList();
    return new DwellSummary(looks, objects, unseen(log.description().map(), seen));
  }

  private static Map<String, List<String>> unseen(SceneMap map, List<String> seen) {
    return map.objects().stream()
        .filter(object -> !seen.contains(object.name()))
        .sorted(Comparator.comparing(SceneMap.Box::name))
        .collect(
            Collectors.groupingBy(
                map::roomOf,
                TreeMap::new,
                Collectors.mapping(SceneMap.Box::name, Collectors.toList())));
  }

  /**
   * Merges consecutive samples of the same object into a dwell. A gap of up to {@link #GAP} does
   * not end it; a picture that disappears, and a pause, do.
   */
  private static List<Dwell> looks(
      HeadLog log, Function<HeadSample, String> object, ToIntFunction<HeadSample> version) {
    List<Dwell> looks = new ArrayList<>();
    Map<String, Integer> last = new LinkedHashMap<>();
    String latest = "";
    for (int i = 0; i < log.samples().size(); i++) {
      HeadSample sample = log.samples().get(i);
      if (!log.inView(i) || log.pauseBefore(i) > 0) {
        last.clear();
      }
      String name = object.apply(sample);
      if (!log.inView(i) || name.isEmpty()) {
        continue;
      }
      double start = log.start(i);
      double seconds = log.shown(i);
      Integer at = last.get(name);
      if (at != null && start - looks.get(at).end() <= GAP) {
        Dwell before = looks.get(at);
        // A blink within the look is a part of it; another object's time is not.
        double since = latest.equals(name) ? before.end() : start;
        looks.set(at, before.until(start + seconds, start + seconds - since));
      } else {
        last.put(name, looks.size());
        looks.add(new Dwell(name, start, start + seconds, version.applyAsInt(sample), seconds));
      }
      latest = name;
    }
    return looks;
  }

  private static List<ObjectView> objects(List<Dwell> looks) {
    Map<String, ObjectView> views = new LinkedHashMap<>();
    for (Dwell look : looks) {
      views.merge(
          look.object(),
          new ObjectView(look.object(), look.seconds(), 1, look.start(), look.seconds()),
          (a, b) ->
              new ObjectView(
                  a.object(),
                  a.seconds() + b.seconds(),
                  a.looks() + 1,
                  a.first(),
                  Math.max(a.longest(), b.longest())));
    }
    return views.values().stream()
        .sorted(Comparator.comparingDouble((ObjectView view) -> -view.seconds()))
        .toList();
  }
}
