package org.selectiverenderer.study.site;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.study.session.JournalContent;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionFolder;
import org.selectiverenderer.study.session.StudyChecksums;

/**
 * The version of a study, by the SHA-256 checksums of its file and of all files that it names,
 * which each session records when it begins.
 */
final class StudyVersion {
  private final String study;
  private final Map<String, String> files;
  private final JsonNode content;

  private StudyVersion(String study, Map<String, String> files, JsonNode content) {
    this.study = study;
    this.files = files;
    this.content = content;
  }

  /** Returns the present version of a study. */
  static StudyVersion of(LoadedStudy material) throws IOException {
    return new StudyVersion(
        StudyChecksums.ofStudyFile(material),
        StudyChecksums.of(material),
        read(material.study().file()));
  }

  /**
   * Returns in which points a session had another version, in words for people; empty if it had
   * this one.
   */
  List<String> differences(SessionFolder session) throws IOException {
    Set<String> differences = new LinkedHashSet<>();
    JournalContent journal = JournalContent.read(session.journal());
    boolean known = false;
    for (JsonNode event : journal.events()) {
      if (event.has("study_sha256")) {
        known = true;
        if (!event.path("study_sha256").asText().equals(study)) {
          if (event.path("event").asText().equals("session-began")) {
            inStudyFile(session).ifPresent(differences::add);
          } else if (!event.path("study_sha256").equals(begun(journal))) {
            differences.add("the study file was changed while the session was interrupted");
          }
        }
      }
      if (event.path("event").asText().equals("files-changed")) {
        List<String> names = new ArrayList<>();
        event.path("files").forEach(name -> names.add(name.asText()));
        differences.add(
            "these were changed while the session was interrupted: " + String.join(", ", names));
      }
    }
    if (!known) {
      differences.add("the journal does not say of which version it is");
    }
    differences.addAll(inFiles(session));
    return List.copyOf(differences);
  }

  private static JsonNode begun(JournalContent journal) {
    return journal.events().get(0).path("study_sha256");
  }

  /**
   * Tells the keys of the study file that differ, by the copy that the session kept; empty if only
   * its comments, spaces or line ends do.
   */
  private Optional<String> inStudyFile(SessionFolder session) throws IOException {
    JsonNode theirs = read(session.path().resolve("study.json"));
    Set<String> keys = new TreeSet<>();
    content.fieldNames().forEachRemaining(keys::add);
    theirs.fieldNames().forEachRemaining(keys::add);
    keys.removeIf(key -> content.path(key).equals(theirs.path(key)));
    if (theirs.isMissingNode()) {
      return Optional.of("the study file is another one");
    }
    return keys.isEmpty()
        ? Optional.empty()
        : Optional.of("the study file differs in " + String.join(", ", keys));
  }

  private List<String> inFiles(SessionFolder session) throws IOException {
    JsonNode theirs = read(session.path().resolve("settings.json")).path("sha256");
    List<String> other = new ArrayList<>();
    files.forEach(
        (name, sum) -> {
          // An earlier version of the program recorded fewer files.
          if (theirs.has(name) && !theirs.path(name).asText().equals(sum)) {
            other.add(name);
          }
        });
    return other.isEmpty()
        ? List.of()
        : List.of(
            (other.size() == 1 ? "this file differs: " : "these files differ: ")
                + String.join(", ", other));
  }

  private static JsonNode read(Path file) throws IOException {
    if (!Files.isRegularFile(file)) {
      return JsonTree.object().path("missing");
    }
    try {
      return JsonTree.parseSettings(InputFileReader.text(file));
    } catch (JsonProcessingException e) {
      return JsonTree.object().path("damaged");
    }
  }
}
