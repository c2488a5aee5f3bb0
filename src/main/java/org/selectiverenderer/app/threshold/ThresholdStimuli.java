package org.selectiverenderer.app.threshold;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.selectiverenderer.base.files.AtomicFileWriter;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.session.FileChecksumCalculator;
import org.selectiverenderer.study.threshold.StimulusLevels;
import org.selectiverenderer.study.threshold.ThresholdStudy;

/**
 * The stimulus pictures of a threshold pilot: PNG files of each object's versions from each view,
 * and the polygon counts of the versions. They are kept in {@code threshold/pictures}. The file
 * {@code pictures.json} is written last and holds a checksum of the inputs: complete pictures of
 * the same inputs are reused, all others are made again.
 */
public final class ThresholdStimuli {
  private final ThresholdStudy study;
  private final Path folder;
  private final Map<String, StimulusLevels> ladders;
  private final String checksum;

  private ThresholdStimuli(
      ThresholdStudy study, Path folder, Map<String, StimulusLevels> ladders, String list)
      throws IOException {
    this.study = study;
    this.folder = folder;
    this.ladders = ladders;
    checksum =
        Sha256.of(
            (list + Files.readString(study.file(), StandardCharsets.UTF_8))
                .getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Reuses or makes the pictures on the calling thread; making them takes some seconds for each
   * object.
   *
   * @param hears receives a message for each object that is made
   * @return empty when versions of an object cannot be made, which is reported to {@code problems}
   * @throws IOException if a file cannot be read or written
   * @throws org.selectiverenderer.render.context.GlUnavailableException if pictures must be made
   *     and there is no display
   */
  public static Optional<ThresholdStimuli> of(
      ThresholdStudy study, Consumer<String> hears, ProblemCollector problems) throws IOException {
    Path folder = study.folder().resolve("pictures");
    Path list = folder.resolve("pictures.json");
    String key = key(study);
    if (Files.isRegularFile(list)) {
      JsonNode known = JsonTree.read(list);
      if (known.path("made_from").asText().equals(key)) {
        return Optional.of(
            new ThresholdStimuli(study, folder, ladders(known), Files.readString(list)));
      }
      Files.delete(list);
    }
    Files.createDirectories(folder);
    Map<String, StimulusLevels> ladders = new LinkedHashMap<>();
    try (StimulusRenderer camera = new StimulusRenderer(study)) {
      for (ThresholdStudy.Judged judged : study.objects()) {
        hears.accept("making the versions of " + judged.object());
        Optional<StimulusLevels> ladder =
            camera.take(
                judged.object(),
                (rung, view) -> file(study, folder, judged.object(), rung, view),
                problems);
        if (ladder.isEmpty()) {
          return Optional.empty();
        }
        ladders.put(judged.object(), ladder.get());
      }
    }
    String text = JsonWriter.of(tree(key, ladders));
    AtomicFileWriter.replace(list, text.getBytes(StandardCharsets.UTF_8));
    return Optional.of(new ThresholdStimuli(study, folder, ladders, text));
  }

  /** Returns the SHA-256 of all inputs of the pictures. */
  private static String key(ThresholdStudy study) throws IOException {
    StringBuilder all = new StringBuilder();
    FileChecksumCalculator.ofScene(study.scene(), study.access())
        .forEach((name, sum) -> all.append(name).append(sum));
    study.objects().forEach(judged -> all.append('/').append(judged.object()));
    all.append('/').append(study.rungs()).append('/').append(study.fewest());
    all.append('/').append(study.picture()).append('/').append(study.views());
    return Sha256.of(all.toString().getBytes(StandardCharsets.UTF_8));
  }

  private static ObjectNode tree(String key, Map<String, StimulusLevels> ladders) {
    ObjectNode tree = JsonTree.object();
    tree.put("made_from", key);
    ObjectNode objects = tree.putObject("polygons");
    ladders.forEach(
        (object, ladder) -> {
          ArrayNode polygons = objects.putArray(object);
          ladder.polygons().forEach(polygons::add);
        });
    return tree;
  }

  private static Map<String, StimulusLevels> ladders(JsonNode tree) {
    Map<String, StimulusLevels> ladders = new LinkedHashMap<>();
    tree.path("polygons")
        .properties()
        .forEach(
            entry -> {
              List<Integer> polygons = new ArrayList<>();
              entry.getValue().forEach(count -> polygons.add(count.asInt()));
              ladders.put(entry.getKey(), new StimulusLevels(polygons));
            });
    return ladders;
  }

  private static Path file(ThresholdStudy study, Path folder, String object, int rung, int view) {
    int number = 0;
    for (int i = 0; i < study.objects().size(); i++) {
      number = study.objects().get(i).object().equals(object) ? i + 1 : number;
    }
    return folder.resolve(
        String.format(
            Locale.ROOT,
            "%02d-%s_version-%02d_view-%d.png",
            number,
            object.replaceAll("[^0-9A-Za-z]", ""),
            rung + 1,
            view + 1));
  }

  /** Returns the polygon counts of each object's versions. */
  public Map<String, StimulusLevels> ladders() {
    return ladders;
  }

  /** Returns the SHA-256 of the settings and of the list of pictures. */
  public String checksum() {
    return checksum;
  }

  /** Returns the picture of a version. */
  Path file(String object, int rung, int view) {
    return file(study, folder, object, rung, view);
  }

  /** Returns the picture of the original. */
  Path original(String object, int view) {
    StimulusLevels ladder = ladders.get(object);
    if (ladder == null) {
      throw new IllegalArgumentException("no versions of " + object);
    }
    return file(object, ladder.original(), view);
  }
}
