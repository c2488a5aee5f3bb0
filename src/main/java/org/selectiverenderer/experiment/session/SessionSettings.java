package org.selectiverenderer.experiment.session;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.json.JsonText;
import org.selectiverenderer.base.json.JsonTree;

/**
 * The settings at the begin of a session: a copy of the study file, the options, and checksums of
 * scenes and questionnaires.
 */
record SessionSettings(StudyMaterial material, SessionFolder folder, SessionOptions options) {
  static final String FILE = "settings.json";

  /** Writes the settings into the session's folder. */
  void write() throws IOException {
    folder.writeOnce("study.json", Files.readString(material.study().file()));
    Map<String, Object> settings = new LinkedHashMap<>(options.recorded());
    settings.put("sha256", checksums());
    folder.writeOnce(FILE, JsonText.of(JsonTree.of(settings)));
  }

  /** Returns the SHA-256 checksums of scenes and questionnaires, by the names of the files. */
  private Map<String, String> checksums() throws IOException {
    Map<String, String> sums = new LinkedHashMap<>();
    if (material.study().scene().isPresent()) {
      sums.putAll(Checksums.ofScene(material.study().scene().get()));
    }
    if (material.study().practice().isPresent()) {
      sums.putAll(Checksums.ofScene(material.study().practice().get().scene()));
    }
    for (Map.Entry<String, Path> file : material.study().questionnaires().files().entrySet()) {
      sums.put(file.getKey(), Checksums.of(file.getValue()));
    }
    return sums;
  }

  /** Returns those of the files that have changed since the session began. */
  List<String> changedFiles() throws IOException {
    JsonNode before = JsonTree.read(folder.path().resolve(FILE)).path("sha256");
    return checksums().entrySet().stream()
        .filter(sum -> !before.path(sum.getKey()).asText().equals(sum.getValue()))
        .map(Map.Entry::getKey)
        .toList();
  }
}
