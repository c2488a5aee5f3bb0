package org.selectiverenderer.study.session;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Finds the files of a study: the study file, and whatever it, its questionnaires and its tables
 * name, so that no key that names a file can be forgotten. Scenes are among them; what scenes refer
 * to is not ({@link FileChecksumCalculator#ofScene}).
 */
public final class StudyFiles {
  private static final Pattern NAME =
      Pattern.compile("[^\\p{Cntrl}\"<>|*?]{1,300}\\.[0-9A-Za-z]{1,8}");

  private final Path folder;
  private final UrlResolver own;
  private final Set<Path> found = new LinkedHashSet<>();
  private final Deque<Path> left = new ArrayDeque<>();

  private StudyFiles(Study study) {
    folder = study.folder().toAbsolutePath().normalize();
    own = new UrlResolver(folder, study.access());
  }

  /**
   * Returns the absolute paths of the existing files that a study may read, itself first.
   *
   * @throws IOException if one of them cannot be read
   */
  public static List<Path> of(LoadedStudy material) throws IOException {
    Study study = material.study();
    StudyFiles files = new StudyFiles(study);
    files.add(study.file());
    study.scene().ifPresent(files::add);
    study.practice().map(Study.Practice::scene).ifPresent(files::add);
    study.questionnaires().files().values().forEach(files::add);
    files.add(ParticipantMessages.file(study.language(), study.folder()));
    while (!files.left.isEmpty()) {
      files.read(files.left.remove());
    }
    return List.copyOf(files.found);
  }

  /** Returns whether a file is a scene in X3D's XML encoding, which is searched for other files. */
  public static boolean isScene(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".x3d");
  }

  private void add(Path file) {
    Path path = file.toAbsolutePath().normalize();
    if (Files.isRegularFile(path) && found.add(path)) {
      left.add(path);
    }
  }

  private void read(Path file) throws IOException {
    String name = file.toString().toLowerCase(Locale.ROOT);
    if (name.endsWith(".json")) {
      json(file);
    } else if (name.endsWith(".csv")) {
      for (String cell : text(file).split("[,;\t\r\n\"]+")) {
        named(file, cell.strip());
      }
    }
  }

  private void json(Path file) throws IOException {
    Deque<JsonNode> nodes = new ArrayDeque<>();
    try {
      nodes.add(JsonTree.parseSettings(text(file)));
    } catch (JsonProcessingException e) {
      return; // Its reader has said so, or it is no file of the program.
    }
    while (!nodes.isEmpty()) {
      JsonNode node = nodes.remove();
      if (node.isTextual()) {
        named(file, node.asText());
      }
      node.forEach(nodes::add);
    }
  }

  private static String text(Path file) throws IOException {
    return new String(InputFileReader.bytes(file), StandardCharsets.UTF_8);
  }

  /** Adds the file that a text names, if it is one: beside the naming file, or in the folder. */
  private void named(Path from, String text) {
    if (!NAME.matcher(text).matches()) {
      return;
    }
    try {
      for (Path path : new ArrayList<>(List.of(from.resolveSibling(text), folder.resolve(text)))) {
        if (own.mayBeNamed(path.normalize())) {
          add(path);
        }
      }
    } catch (InvalidPathException e) {
      return; // A text, or a URL.
    }
  }
}
