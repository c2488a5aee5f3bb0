package org.selectiverenderer.study.definition;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.files.InputFileReader;

/**
 * Writes the folder of a new study from a template: the study of the thesis (5.1, 6.1), to be
 * adapted.
 */
public final class StudyTemplate {
  /** The name of the study file. */
  public static final String STUDY = "study.json";

  private static final List<String> FILES =
      List.of(
          STUDY,
          "study.schema.json",
          "questionnaire.schema.json",
          "form.json",
          "welcome.json",
          "mouse.png",
          "apartment.json",
          "lists.json",
          "recognition.csv",
          "presence.json",
          "room.json",
          "closing.json",
          "pilot/study.json",
          "pilot/expectancy.csv",
          "pilot/threshold.json");

  /** A scene outside of the folder of its study. */
  private static final Pattern OUTSIDE = Pattern.compile("\"scene\": \"(\\.\\./[^\"]+)\"");

  private StudyTemplate() {}

  /**
   * Writes the folder.
   *
   * @param folder created if it does not exist
   * @param scene the scene of the study; {@code practice.x3d} is looked for beside it
   * @return the study file
   * @throws IOException if one of the files exists, and then none is written; or if a file cannot
   *     be written
   */
  public static Path write(Path folder, Path scene) throws IOException {
    return write(folder, scene, FileOperations.REAL);
  }

  /** Writes the folder, as {@link #write(Path, Path)}, with a number of participants and a seed. */
  public static Path write(Path folder, Path scene, int participants, long seed)
      throws IOException {
    return write(
        folder,
        scene,
        FileOperations.REAL,
        Map.of(
            "\"participants\": 54,",
            "\"participants\": %d,".formatted(participants),
            "\"seed\": 2009,",
            "\"seed\": %d,".formatted(seed),
            "all groups together: three groups of 18.",
            "all groups together (the thesis: three groups of 18)."));
  }

  /** Writes the folder with other file actions, for tests. */
  static Path write(Path folder, Path scene, FileOperations actions) throws IOException {
    return write(folder, scene, actions, Map.of());
  }

  private static Path write(
      Path folder, Path scene, FileOperations actions, Map<String, String> changes)
      throws IOException {
    Files.createDirectories(folder.resolve("pilot"));
    for (String name : FILES) {
      if (Files.exists(folder.resolve(name))) {
        throw new IOException(folder.resolve(name) + " exists already; nothing was written");
      }
    }
    FileTransaction writing = new FileTransaction(actions);
    for (String name : FILES) {
      byte[] content = content(name, folder, scene);
      writing.addNew(
          folder.resolve(name), name.equals(STUDY) ? changed(content, changes) : content);
    }
    writing.commit();
    return folder.resolve(STUDY);
  }

  /**
   * Copies a study that has no folders, such as an example; scenes outside of its folder stay where
   * they are.
   *
   * @param example folder of the study
   * @param folder created if it does not exist
   * @return the study file
   * @throws IOException if one of the files exists, and then none is written; or if a file cannot
   *     be read or written
   */
  public static Path copy(Path example, Path folder) throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.list(example)) {
      files = all.filter(Files::isRegularFile).sorted().toList();
    }
    Files.createDirectories(folder);
    FileTransaction writing = new FileTransaction(FileOperations.REAL);
    for (Path file : files) {
      Path copy = folder.resolve(file.getFileName().toString());
      if (Files.exists(copy)) {
        throw new IOException(copy + " exists already; nothing was written");
      }
      byte[] bytes = InputFileReader.bytes(file);
      if (file.endsWith(STUDY)) {
        String text = new String(bytes, StandardCharsets.UTF_8);
        Matcher outside = OUTSIDE.matcher(text);
        StringBuilder moved = new StringBuilder();
        while (outside.find()) {
          String scene = from(folder, example.resolve(outside.group(1)));
          outside.appendReplacement(
              moved, Matcher.quoteReplacement("\"scene\": \"" + scene + "\""));
        }
        bytes = outside.appendTail(moved).toString().getBytes(StandardCharsets.UTF_8);
      }
      writing.addNew(copy, bytes);
    }
    writing.commit();
    return folder.resolve(STUDY);
  }

  private static byte[] changed(byte[] content, Map<String, String> changes) {
    String text = new String(content, StandardCharsets.UTF_8);
    for (Map.Entry<String, String> change : changes.entrySet()) {
      if (!text.contains(change.getKey())) {
        throw new IllegalStateException("the template has no " + change.getKey());
      }
      text = text.replace(change.getKey(), change.getValue());
    }
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] content(String name, Path folder, Path scene) throws IOException {
    byte[] bytes = resource(name);
    if (!name.endsWith(".json")) {
      return bytes;
    }
    Path seenFrom = folder.resolve(name).getParent();
    return new String(bytes, StandardCharsets.UTF_8)
        .replace("@scene@", from(seenFrom, scene))
        .replace("@practice@", from(seenFrom, scene.resolveSibling("practice.x3d")))
        .getBytes(StandardCharsets.UTF_8);
  }

  /** Returns the path of a file relative to a folder, with slashes on every system. */
  private static String from(Path folder, Path file) throws IOException {
    Path there = file.toRealPath();
    Path here = folder.toRealPath();
    return Objects.equals(here.getRoot(), there.getRoot())
        ? here.relativize(there).toString().replace('\\', '/')
        : there.toString().replace('\\', '/');
  }

  private static byte[] resource(String name) throws IOException {
    try (InputStream in =
        Objects.requireNonNull(StudyTemplate.class.getResourceAsStream(name), name)) {
      return in.readAllBytes();
    }
  }
}
