package org.selectiverenderer.experiment.headlog;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * What a head log says about a session. Only samples that the participant saw count: what lies in
 * the middle of a view that is black is not looked at.
 *
 * @param seconds in which there was a picture
 * @param unshown what is left out
 * @param idle share of the time in which the head did not move, 0 to 1
 * @param looks in order of time
 * @param objects those looked at, the one looked at longest first
 * @param unseen objects of the scene that were never in the middle of the view, by room; walls,
 *     floors and ceilings are not among them
 */
public record HeadLogAnalysis(
    HeadLog log,
    double seconds,
    Unshown unshown,
    double idle,
    List<Dwell> looks,
    List<ObjectView> objects,
    Map<String, List<String>> unseen,
    List<RoomView> rooms) {

  /** Shorter gaps in a look are blinks of the log: an edge, a leg of a chair passing. */
  static final double GAP = 0.15;

  /**
   * What a log has beside what the participant saw.
   *
   * @param samples without a picture
   * @param seconds that these last
   * @param pauses how often time stood still for the session
   * @param paused seconds that these pauses last together, which the log's time does not count
   */
  public record Unshown(int samples, double seconds, int pauses, double paused) {}

  /**
   * What was in the middle of the view, all looks together.
   *
   * @param seconds in all
   * @param looks how often
   * @param first when first, in seconds since the session began
   * @param longest seconds of the longest look
   */
  public record ObjectView(
      String object, double seconds, int looks, double first, double longest) {}

  /** Looks at a log. */
  public static HeadLogAnalysis of(HeadLog log) {
    List<Dwell> looks = looks(log);
    double idle = 0;
    double all = 0;
    for (int i = 0; i < log.samples().size(); i++) {
      if (log.samples().get(i).visible()) {
        all += log.shown(i);
        idle += log.samples().get(i).moved() ? 0 : log.shown(i);
      }
    }
    List<ObjectView> objects = objects(looks);
    List<String> seen = objects.stream().map(ObjectView::object).toList();
    return new HeadLogAnalysis(
        log,
        all,
        unshown(log),
        all > 0 ? idle / all : 0,
        looks,
        objects,
        unseen(log.description().map(), seen),
        log.description().map().rooms().stream().map(room -> RoomView.of(room, log)).toList());
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

  private static Unshown unshown(HeadLog log) {
    int samples = 0;
    double seconds = 0;
    int pauses = 0;
    double paused = 0;
    for (int i = 0; i < log.samples().size(); i++) {
      if (!log.samples().get(i).visible()) {
        samples++;
        seconds += log.shown(i);
      }
      double pause = log.pauseBefore(i);
      if (pause > 0) {
        pauses++;
        paused += pause;
      }
    }
    return new Unshown(samples, seconds, pauses, paused);
  }

  /**
   * Samples of the same object in turn are one look; a short gap does not end it, but a picture
   * that goes does, and a pause.
   */
  private static List<Dwell> looks(HeadLog log) {
    List<Dwell> looks = new ArrayList<>();
    Map<String, Integer> last = new LinkedHashMap<>();
    for (int i = 0; i < log.samples().size(); i++) {
      HeadSample sample = log.samples().get(i);
      if (!sample.visible() || log.pauseBefore(i) > 0) {
        last.clear();
      }
      if (!sample.visible() || sample.object().isEmpty()) {
        continue;
      }
      double end = sample.t() + log.shown(i);
      Integer at = last.get(sample.object());
      if (at != null && sample.t() - looks.get(at).end() <= GAP) {
        Dwell before = looks.get(at);
        looks.set(at, new Dwell(before.object(), before.start(), end, before.version()));
      } else {
        last.put(sample.object(), looks.size());
        looks.add(new Dwell(sample.object(), sample.t(), end, sample.version()));
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
