package org.selectiverenderer.authoring.images;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;

/** Looks for files by their names in a folder and the folders in it. */
public final class ImageSearch {
  private static final int DEEPEST = 16;
  private static final int MOST = 200_000;

  private ImageSearch() {}

  /**
   * Finds files by name, whatever the case of its letters. Of several the one nearest to the folder
   * is taken. Links are not followed, and what cannot be read is passed over.
   *
   * @param cancelled asked while it looks; true ends the search
   * @return the found files by the names asked for
   */
  public static Map<String, Path> find(
      Path folder, Collection<String> names, BooleanSupplier cancelled) throws IOException {
    Set<String> wanted = new HashSet<>();
    names.forEach(name -> wanted.add(key(name)));
    Map<String, Path> nearest = new HashMap<>();
    int[] seen = {0};
    Files.walkFileTree(
        folder,
        Set.of(),
        DEEPEST,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            String name = key(String.valueOf(file.getFileName()));
            if (attributes.isRegularFile() && wanted.contains(name)) {
              nearest.merge(name, file, ImageSearch::nearer);
            }
            return ++seen[0] > MOST || cancelled.getAsBoolean()
                ? FileVisitResult.TERMINATE
                : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path file, IOException why) {
            return FileVisitResult.CONTINUE;
          }
        });
    Map<String, Path> found = new HashMap<>();
    for (String name : names) {
      Path file = nearest.get(key(name));
      if (file != null) {
        found.put(name, file);
      }
    }
    return found;
  }

  private static String key(String name) {
    return name.toLowerCase(Locale.ROOT);
  }

  private static Path nearer(Path one, Path other) {
    int by = Integer.compare(one.getNameCount(), other.getNameCount());
    return by < 0 || by == 0 && one.compareTo(other) <= 0 ? one : other;
  }
}
