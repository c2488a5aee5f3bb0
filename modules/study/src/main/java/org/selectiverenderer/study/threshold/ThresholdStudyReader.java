package org.selectiverenderer.study.threshold;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.JsonSettingsReader;
import org.selectiverenderer.x3d.url.ContentAccessKeys;
import org.selectiverenderer.x3d.url.NetworkShare;

/** Reads the settings of a threshold pilot; settings with faults are not used, as for a study. */
public final class ThresholdStudyReader {
  private static final JsonSettingsReader JSON =
      new JsonSettingsReader("a threshold pilot", "the pilot is not used");
  private static final int FEWEST_OBJECTS = 2;
  private static final int NAMES = 4;

  private final Path file;

  private ThresholdStudyReader(Path file) {
    this.file = file;
  }

  /**
   * Reads a file.
   *
   * @return empty if the file has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public static Optional<ThresholdStudy> read(Path file, ProblemCollector problems)
      throws IOException {
    return JSON.read(file, problems, new ThresholdStudyReader(file)::study);
  }

  private ThresholdStudy study(JsonObjectReader keys) {
    ThresholdTask task =
        keys.choice(
            "task",
            List.of(ThresholdTask.values()),
            ThresholdTask::spelling,
            ThresholdTask.TELL_APART);
    List<ThresholdStudy.Judged> objects = objects(keys);
    if (task == ThresholdTask.RECOGNISE && objects.size() < NAMES) {
      keys.fault(
          "objects",
          "the task \"recognise\" offers four names and needs at least four \"objects\"");
    }
    return new ThresholdStudy(
        file,
        keys.text("name"),
        scene(keys),
        task,
        objects,
        (int) keys.whole("rungs", 2, 40, 12),
        keys.number("fewest", 0.0001, 0.9, 0.01),
        views(keys),
        (int) keys.whole("picture", 64, 2048, 360),
        rule(keys),
        keys.number("catches", 0, 0.5, 0.1),
        keys.number("attention", 0, 1, 0.75),
        keys.whole("seed", 0, 1L << 53, 0),
        keys.text("language", false).orElse("en"),
        ContentAccessKeys.of(keys, file.toAbsolutePath()));
  }

  private Path scene(JsonObjectReader keys) {
    String name = keys.text("scene");
    if (NetworkShare.is(name)) {
      keys.fault("scene", "'" + name + "' is on another computer; name a file of this one");
      return file;
    }
    Path scene = file.toAbsolutePath().resolveSibling(name).normalize();
    if (!name.isEmpty() && !Files.isRegularFile(scene)) {
      keys.fault("scene", "there is no file '" + name + "' relative to the pilot's file");
    }
    return scene;
  }

  private static List<ThresholdStudy.Judged> objects(JsonObjectReader keys) {
    Set<String> known = new HashSet<>();
    List<ThresholdStudy.Judged> objects =
        keys.objects(
            "objects",
            "an object",
            object -> {
              String def = object.text("object");
              if (!known.add(def)) {
                object.fault("object", "the object " + def + " is named twice");
              }
              return new ThresholdStudy.Judged(def, object.text("name", false).orElse(def));
            });
    if (objects.size() < FEWEST_OBJECTS) {
      keys.fault("objects", "a threshold pilot needs at least two \"objects\"");
    }
    return objects;
  }

  private static List<ThresholdStudy.View> views(JsonObjectReader keys) {
    List<ThresholdStudy.View> views =
        keys.objects(
            "views",
            "a view",
            view ->
                new ThresholdStudy.View(
                    view.number("yaw", -360, 360, 0), view.number("pitch", -90, 90, 0)));
    return views.isEmpty()
        ? List.of(new ThresholdStudy.View(30, 20), new ThresholdStudy.View(-40, 10))
        : views;
  }

  private static StaircaseRule rule(JsonObjectReader keys) {
    int down = (int) keys.whole("down", 1, 5, 2);
    int reversals = (int) keys.whole("reversals", 2, 60, 8);
    int discarded = (int) keys.whole("discarded", 0, 58, 2);
    int most = (int) keys.whole("most_trials", 1, 1000, 60);
    if (reversals - discarded < 2 || (reversals - discarded) % 2 != 0) {
      keys.fault(
          "reversals",
          "\"reversals\" minus \"discarded\" must be an even number, at least 2, but it is %d - %d"
              .formatted(reversals, discarded));
      return new StaircaseRule(down, 2, 0, most);
    }
    return new StaircaseRule(down, reversals, discarded, most);
  }
}
