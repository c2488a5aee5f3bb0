package org.selectiverenderer.experiment.headlog;

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
 * What was looked at: by the head, whose target is in the middle of the view, or by the eyes. Only
 * samples that the participant saw count.
 *
 * @param all in order of time
 * @param objects those looked at, the one looked at longest first
 * @param unseen objects of the scene that were never looked at, by room; walls, floors and ceilings
 *     are not among them
 */
public record LookSummary(
    List<Dwell> all, List<ObjectView> objects, Map<String, List<String>> unseen) {

  /** Shorter gaps in a look are blinks of the log: an edge, a leg of a chair passing. */
  static final double GAP = 0.15;

  /**
   * An object, all looks at it together.
   *
   * @param seconds in all
   * @param looks how often
   * @param first when first, in seconds since the session began
   * @param longest seconds of the longest look
   */
  public record ObjectView(
      String object, double seconds, int looks, double first, double longest) {}

  /** What was in the middle of the view. */
  static LookSummary ofHead(HeadLog log) {
    return of(log, HeadSample::object, HeadSample::version);
  }

  /** What the eyes looked at; nothing while they were not tracked. */
  static LookSummary ofEyes(HeadLog log) {
    return of(log, sample -> eyes(sample).object(), sample -> eyes(sample).version());
  }

  private static EyeSample eyes(HeadSample sample) {
    EyeSample eyes = sample.eyes();
    return eyes == null ? EyeSample.LOST : eyes;
  }

  private static LookSummary of(
      HeadLog log, Function<HeadSample, String> object, ToIntFunction<HeadSample> version) {
    List<Dwell> looks = looks(log, object, version);
    List<ObjectView> objects = objects(looks);
    List<String> seen = objects.stream().map(ObjectView::object).toList();
    return new LookSummary(looks, objects, unseen(log.description().map(), seen));
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
   * Samples of the same object in turn are one look; a short gap does not end it, but a picture
   * that goes does, and a pause.
   */
  private static List<Dwell> looks(
      HeadLog log, Function<HeadSample, String> object, ToIntFunction<HeadSample> version) {
    List<Dwell> looks = new ArrayList<>();
    Map<String, Integer> last = new LinkedHashMap<>();
    for (int i = 0; i < log.samples().size(); i++) {
      HeadSample sample = log.samples().get(i);
      if (!sample.visible() || log.pauseBefore(i) > 0) {
        last.clear();
      }
      String name = object.apply(sample);
      if (!sample.visible() || name.isEmpty()) {
        continue;
      }
      double end = sample.t() + log.shown(i);
      Integer at = last.get(name);
      if (at != null && sample.t() - looks.get(at).end() <= GAP) {
        Dwell before = looks.get(at);
        looks.set(at, new Dwell(before.object(), before.start(), end, before.version()));
      } else {
        last.put(name, looks.size());
        looks.add(new Dwell(name, sample.t(), end, version.applyAsInt(sample)));
      }
    }
    return looks;
  }

  private static List<ObjectView> objects(List<Dwell> looks) {
    Map<String, ObjectView> views = new LinkedHashMap<>();
    for (Dwell look : looks) {
      views.merge(
          look.object(),
          new ObjectView(look.object(), look.duration(), 1, look.start(), look.duration()),
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
