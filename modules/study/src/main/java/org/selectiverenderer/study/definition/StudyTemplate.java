package org.selectiverenderer.study.definition;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;
import org.selectiverenderer.base.files.FileOperations;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.formats.json.JsonValueEditor;

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

  /** How the key of a scene is spelled, and how the path of one outside of a folder begins. */
  private static final String SCENE = "scene";

  private static final String OUTSIDE = "../";

  private static final String SCENE_MARK = "@scene@";
  private static final String PRACTICE_MARK = "@practice@";

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
        Map.of("participants", (long) participants, "seed", seed));
  }

  /** Writes the folder with other file actions, for tests. */
  static Path write(Path folder, Path scene, FileOperations actions) throws IOException {
    return write(folder, scene, actions, Map.of());
  }

  private static Path write(
      Path folder, Path scene, FileOperations actions, Map<String, Long> changes)
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
        bytes = moved(new String(bytes, StandardCharsets.UTF_8), example, folder);
      }
      writing.addNew(copy, bytes);
    }
    writing.commit();
    return folder.resolve(STUDY);
  }

  /** Names scenes outside of a study's folder as they are seen from another. */
  private static byte[] moved(String study, Path from, Path to) throws IOException {
    try {
      return JsonValueEditor.withStrings(
              study,
              (key, value) ->
                  key.equals(SCENE) && value.startsWith(OUTSIDE)
                      ? from(to, from.resolve(value))
                      : value)
          .getBytes(StandardCharsets.UTF_8);
    } catch (UncheckedIOException e) {
      throw e.getCause();
    } catch (IllegalArgumentException e) {
      throw new IOException(from.resolve(STUDY) + ": " + e.getMessage(), e);
    }
  }

  private static byte[] changed(byte[] content, Map<String, Long> changes) {
    String text = new String(content, StandardCharsets.UTF_8);
    for (Map.Entry<String, Long> change : changes.entrySet()) {
      text = JsonValueEditor.withNumber(text, change.getKey(), change.getValue());
    }
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] content(String name, Path folder, Path scene) throws IOException {
    byte[] bytes = resource(name);
    if (!name.endsWith(".json")) {
      return bytes;
    }
    Path seenFrom = folder.resolve(name).getParent();
    try {
      return JsonValueEditor.withStrings(
              new String(bytes, StandardCharsets.UTF_8),
              (key, value) ->
                  switch (value) {
                    case SCENE_MARK -> from(seenFrom, scene);
                    case PRACTICE_MARK -> from(seenFrom, scene.resolveSibling("practice.x3d"));
                    default -> value;
                  })
          .getBytes(StandardCharsets.UTF_8);
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  /** Returns the path of a file relative to a folder, with slashes on every system. */
  private static String from(Path folder, Path file) {
    try {
      Path there = file.toRealPath();
      Path here = folder.toRealPath();
      return Objects.equals(here.getRoot(), there.getRoot())
          ? here.relativize(there).toString().replace('\\', '/')
          : there.toString().replace('\\', '/');
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static byte[] resource(String name) throws IOException {
    try (InputStream in =
        Objects.requireNonNull(StudyTemplate.class.getResourceAsStream(name), name)) {
      return in.readAllBytes();
    }
  }
}
