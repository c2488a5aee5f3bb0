package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.selectiverenderer.study.definition.Study;

/**
 * SHA-256 checksums of the files that a study names, by which sessions of other versions of it are
 * told apart.
 */
public final class StudyChecksums {
  private StudyChecksums() {}

  /** Returns the checksum of a study file itself. */
  public static String ofStudyFile(LoadedStudy material) throws IOException {
    return FileChecksumCalculator.of(material.study().file());
  }

  /**
   * Returns the checksums of scenes, with all that they refer to, of questionnaires, tables and all
   * else that the study names, by the names of the files.
   *
   * @throws IOException if a file cannot be read
   */
  public static Map<String, String> of(LoadedStudy material) throws IOException {
    Study study = material.study();
    Map<String, String> sums = new LinkedHashMap<>();
    Set<Path> told = new HashSet<>();
    List<Path> scenes = new ArrayList<>();
    study.scene().ifPresent(scenes::add);
    study.practice().map(Study.Practice::scene).ifPresent(scenes::add);
    for (Path scene : scenes) {
      if (told.add(scene.toAbsolutePath().normalize())) {
        sums.putAll(FileChecksumCalculator.ofScene(scene, study.access()));
      }
    }
    for (Map.Entry<String, Path> file : study.questionnaires().files().entrySet()) {
      sums.put(file.getKey(), FileChecksumCalculator.of(file.getValue()));
      told.add(file.getValue().toAbsolutePath().normalize());
    }
    Path folder = study.folder().toAbsolutePath().normalize();
    told.add(study.file().toAbsolutePath().normalize());
    for (Path file : StudyFiles.of(material)) {
      if (told.contains(file)) {
        continue;
      }
      if (StudyFiles.isScene(file)) {
        FileChecksumCalculator.ofScene(file, study.access()).forEach(sums::putIfAbsent);
      } else {
        // On Windows a file may be on another drive, to which no relative path leads.
        Path shown =
            Objects.equals(folder.getRoot(), file.toAbsolutePath().getRoot())
                ? folder.relativize(file.toAbsolutePath())
                : file.toAbsolutePath();
        sums.putIfAbsent(shown.toString().replace('\\', '/'), FileChecksumCalculator.of(file));
      }
    }
    return sums;
  }
}
