package org.selectiverenderer.export.study;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.authoring.packaging.PackagedFile;

/** The pictures of a study's questionnaires under names that are unique in the folder. */
final class StudyPictures {
  private static final Path FOLDER = Path.of("pictures");

  private final Map<Path, Path> targets = new LinkedHashMap<>();

  /** Returns the address of a picture, which comes into the folder. */
  String address(Path picture) {
    Path target = targets.computeIfAbsent(picture, file -> FOLDER.resolve(name(file)));
    return FOLDER + "/" + target.getFileName();
  }

  private String name(Path file) {
    String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
    // The file's own name might tell participants what they are not to know.
    return (targets.size() + 1) + (name.endsWith(".png") ? ".png" : ".jpg");
  }

  List<PackagedFile> files() {
    return targets.entrySet().stream()
        .map(entry -> new PackagedFile(entry.getValue(), entry.getKey(), Optional.empty()))
        .toList();
  }
}
