package org.selectiverenderer.render.conformance;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * The actions and expectations in the head of a conformance scene.
 *
 * @param frames the actions of each frame, by its time in seconds
 * @param watched fields whose events are compared, as {@code NODE.field}
 * @param events the expected events, as {@code TIME NODE.field VALUE}
 * @param values the values expected after the last frame, as {@code NODE.field VALUE}
 */
record ConformanceScene(
    Path file,
    Map<Double, List<String>> frames,
    Set<String> watched,
    List<String> events,
    List<String> values,
    List<String> pixels,
    List<String> says) {

  /**
   * Reads what a scene says.
   *
   * @throws IllegalArgumentException when it says something that is unknown, or names no clause
   */
  static ConformanceScene read(Path file) throws IOException {
    ProblemCollector unheard = new ProblemCollector(); // The run hears them.
    X3dFile parsed = new X3dReader(NodeCatalogue.load()).read(file, unheard);
    ConformanceScene scene =
        new ConformanceScene(
            file,
            new TreeMap<>(),
            new LinkedHashSet<>(),
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>(),
            new ArrayList<>());
    boolean clause = false;
    for (X3dFile.Meta meta : parsed.meta()) {
      String content = meta.content().strip();
      switch (meta.name()) {
        case "clause" -> clause = true;
        case "at" -> scene.frame(content);
        case "event" -> {
          scene.events.add(content);
          scene.watched.add(word(content, 1));
        }
        case "silent" -> scene.watched.add(content);
        case "value" -> scene.values.add(content);
        case "pixel" -> scene.pixels.add(content);
        case "says" -> scene.says.add(content);
        default ->
            throw new IllegalArgumentException(
                file + ": a conformance scene has no meta " + meta.name());
      }
    }
    if (!clause) {
      throw new IllegalArgumentException(file + ": no meta names the clause that is checked");
    }
    if (scene.frames.isEmpty()) {
      scene.frames.put(0.0, List.of());
    }
    return scene;
  }

  private void frame(String content) {
    List<String> actions =
        frames.computeIfAbsent(Double.valueOf(word(content, 0)), time -> new ArrayList<>());
    String action = rest(content, 1);
    if (!action.isEmpty()) {
      actions.add(action);
    }
  }

  /** Returns a word of a text, counted from 0. */
  static String word(String text, int index) {
    return text.split("\\s+")[index];
  }

  /** Returns the rest of a text after its first words; empty if there is none. */
  static String rest(String text, int words) {
    String[] parts = text.split("\\s+", words + 1);
    return parts.length > words ? parts[words] : "";
  }
}
