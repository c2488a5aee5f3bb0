package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;

/** The files of a lit scene and their names: one for every place of every Inline. */
final class LitFiles {
  private final Path scene;
  private final Path folder;
  private final Map<Path, String> texts = new LinkedHashMap<>();
  private final Map<String, Integer> names = new HashMap<>();

  /**
   * @param scene the file of the scene itself
   * @param folder for what it inlines
   */
  LitFiles(Path scene, Path folder) {
    this.scene = scene;
    this.folder = folder;
  }

  Path scene() {
    return scene;
  }

  /** A new file for a place of an Inline: named as the one inlined, numbered from the second. */
  Path next(String inlined) {
    String name =
        inlined.substring(Math.max(inlined.lastIndexOf('/'), inlined.lastIndexOf('\\')) + 1);
    int point = name.lastIndexOf('.');
    String stem = point > 0 ? name.substring(0, point) : name;
    int number = names.merge(stem, 1, Integer::sum);
    return folder.resolve(stem + (number == 1 ? "" : "-" + number) + ".x3d");
  }

  void put(Path file, String text) {
    texts.put(file, text);
  }

  Map<Path, String> texts() {
    return texts;
  }
}
