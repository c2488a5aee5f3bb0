package org.selectiverenderer.radiosity.output;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * The texts of a lit scene's files by their paths, with unique names: one file for every instance
 * of every Inline.
 */
final class LitFileSet {
  private final Path scene;
  private final Path folder;
  private final Map<Path, String> texts = new LinkedHashMap<>();

  private final Map<String, Integer> numbers = new HashMap<>();

  /**
   * Used paths without extension, with names in lower case, since some file systems ignore case.
   */
  private final Set<Path> taken = new HashSet<>();

  /**
   * @param scene the file of the scene itself
   * @param folder the folder for the files that the scene inlines
   */
  LitFileSet(Path scene, Path folder) {
    this.scene = scene;
    this.folder = folder;
    String own = stem(String.valueOf(scene.getFileName())).toLowerCase(Locale.ROOT);
    taken.add(scene.resolveSibling(own));
  }

  Path scene() {
    return scene;
  }

  /**
   * Returns a new file for an instance of an Inline: named as the file inlined, with a number from
   * the second instance on.
   */
  Path next(String inlined) {
    String name =
        inlined.substring(Math.max(inlined.lastIndexOf('/'), inlined.lastIndexOf('\\')) + 1);
    String stem = stem(name);
    int number = numbers.merge(stem, 1, Integer::sum);
    String file = number == 1 ? stem : stem + "-" + number;
    while (!taken.add(folder.resolve(file.toLowerCase(Locale.ROOT)))) {
      file = stem + "-" + numbers.merge(stem, 1, Integer::sum);
    }
    return folder.resolve(file + ".x3d");
  }

  static String stem(String name) {
    int point = name.lastIndexOf('.');
    return point > 0 ? name.substring(0, point) : name;
  }

  void put(Path file, String text) {
    texts.put(file, text);
  }

  Map<Path, String> texts() {
    return texts;
  }
}
