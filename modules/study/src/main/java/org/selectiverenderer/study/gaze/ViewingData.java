package org.selectiverenderer.study.gaze;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.headlog.HeadLog;
import org.selectiverenderer.study.headlog.HeadLogReader;
import org.selectiverenderer.study.headlog.HeadSample;
import org.selectiverenderer.study.headlog.SceneMap;

/** What participants saw of a scene's objects, measured from their head logs. Not thread-safe. */
public final class ViewingData {
  private static final int MOST_PARTICIPANTS = 200;
  private static final int MOST_OBJECTS = 1000;
  private static final int MOST_AREAS = 100;

  /** Objects in areas; the estimate's time grows with their number. */
  private static final int MOST_PAIRS = 2000;

  /** What was seen of each object, by participant and area. */
  private final Map<String, Map<GazeArea, Map<String, ObjectAttention>>> seen =
      new LinkedHashMap<>();

  private record Pair(GazeArea area, String object) {}

  private final Set<Pair> pairs = new HashSet<>();
  private final Set<String> conditions = new TreeSet<>();

  /**
   * Reads the logs of a scene.
   *
   * @param paths files of logs, and folders that hold some; a session's or a study's, for instance
   * @param scene file name of the scene; logs of others are left out, except where the path names
   *     the file of the log itself
   * @param problems receives what is wrong with logs; a row with a fault is left out, or the whole
   *     log where it cannot be read
   * @throws IOException if a path does not exist, cannot be read, or holds no logs
   */
  public static ViewingData read(List<Path> paths, String scene, ProblemCollector problems)
      throws IOException {
    ViewingData data = new ViewingData();
    Set<String> others = new TreeSet<>();
    for (HeadLogFinder.Found found : HeadLogFinder.find(paths)) {
      // Of its own, since a reader does not tell of an empty log where there are problems already.
      ProblemCollector own = new ProblemCollector();
      Optional<HeadLog> log = HeadLogReader.read(found.file(), own);
      own.list().forEach(problems::add);
      if (log.isEmpty()) {
        continue;
      }
      String shown = log.get().description().scene();
      boolean same = shown.isEmpty() || shown.equals(scene);
      if (!same && !found.named()) {
        others.add(shown);
        continue;
      }
      if (!same) {
        problems.info(
            SourceLocation.of(found.file().toString()),
            "the log is of the scene " + shown + "; its objects are matched by their names");
      }
      data.add(found, log.get(), problems);
    }
    if (!others.isEmpty()) {
      problems.info(
          SourceLocation.of(paths.get(0).toString()),
          "left out: logs of other scenes (%s); name their files to use them"
              .formatted(String.join(", ", others)));
    }
    return data;
  }

  private void add(HeadLogFinder.Found found, HeadLog log, ProblemCollector problems) {
    SourceLocation at = SourceLocation.of(found.file().toString());
    SceneMap map = log.description().map();
    if (Math.max(map.objects().size(), map.areas().size() + map.rooms().size()) > MOST_OBJECTS) {
      problems.error(
          at,
          "the description has more than %d objects or areas; not used".formatted(MOST_OBJECTS));
    } else if (!seen.containsKey(found.participant()) && seen.size() == MOST_PARTICIPANTS) {
      problems.error(at, "more than %d participants; not used".formatted(MOST_PARTICIPANTS));
    } else {
      Optional<String> fault = add(found.participant(), log);
      fault.ifPresent(why -> problems.error(at, why + "; not used"));
    }
  }

  /**
   * Adds a log.
   *
   * @param participant who was recorded; two logs of one participant count together
   * @return why the log is not used; empty if it is
   */
  Optional<String> add(String participant, HeadLog log) {
    AreaTimeline timeline = new AreaTimeline(log);
    Set<GazeArea> areas = new HashSet<>();
    for (HeadSample sample : log.samples()) {
      areas.addAll(timeline.of(sample));
      if (areas.size() > MOST_AREAS) {
        return Optional.of("the viewer was in more than %d areas or schemas".formatted(MOST_AREAS));
      }
    }
    Map<GazeArea, Map<String, ObjectAttention>> read = AttentionReader.of(log);
    Set<Pair> more = new HashSet<>(pairs);
    read.forEach(
        (area, objects) -> objects.keySet().forEach(name -> more.add(new Pair(area, name))));
    if (more.size() > MOST_PAIRS) {
      return Optional.of("there would be more than %d objects in areas".formatted(MOST_PAIRS));
    }
    pairs.addAll(more);
    Map<GazeArea, Map<String, ObjectAttention>> all =
        seen.computeIfAbsent(participant, key -> new LinkedHashMap<>());
    read.forEach(
        (area, objects) -> {
          Map<String, ObjectAttention> own =
              all.computeIfAbsent(area, key -> new LinkedHashMap<>());
          objects.forEach((name, one) -> own.merge(name, one, ObjectAttention::plus));
        });
    conditions.add(log.description().condition());
    return Optional.empty();
  }

  /** Returns this data with other areas; what was seen in areas that become one is added up. */
  public ViewingData named(UnaryOperator<GazeArea> area) {
    ViewingData other = new ViewingData();
    other.conditions.addAll(conditions);
    seen.forEach(
        (participant, areas) -> {
          Map<GazeArea, Map<String, ObjectAttention>> all = new LinkedHashMap<>();
          areas.forEach(
              (before, objects) -> {
                Map<String, ObjectAttention> own =
                    all.computeIfAbsent(area.apply(before), key -> new LinkedHashMap<>());
                objects.forEach((name, one) -> own.merge(name, one, ObjectAttention::plus));
              });
          other.seen.put(participant, all);
        });
    return other;
  }

  /** Returns the number of participants. */
  public int participants() {
    return seen.size();
  }

  /**
   * Returns the conditions of rendering under which was recorded, as the logs name them. Under
   * another than {@code high}, what was looked at depends on the versions that were shown.
   */
  public List<String> conditions() {
    return List.copyOf(conditions);
  }

  /** Returns what each participant saw in each area. */
  List<ParticipantAttention> all() {
    List<ParticipantAttention> all = new ArrayList<>();
    seen.forEach(
        (participant, areas) ->
            areas.forEach(
                (area, objects) -> all.add(new ParticipantAttention(participant, area, objects))));
    return all;
  }
}
