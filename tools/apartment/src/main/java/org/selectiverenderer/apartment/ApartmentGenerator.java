package org.selectiverenderer.apartment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.pictures.Pictures;
import org.selectiverenderer.apartment.pictures.SurfacePicture;
import org.selectiverenderer.apartment.versions.MadeObject;
import org.selectiverenderer.apartment.versions.RecipeFile;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.modelling.ParametricModel;

/**
 * Writes the apartment's files: the same bytes every time, all files or none. Existing files that
 * differ may hold somebody's work and are replaced only on request.
 */
public final class ApartmentGenerator {
  /** Number of files that a message names before it counts the others. */
  private static final int NAMED = 5;

  private static final String FOLDER = "inlineNodes/";

  private final PolygonCounts counts = PolygonCounts.load();
  private final Map<String, Supplier<ParametricModel>> recipes = Recipes.all();
  private final Map<String, Supplier<SurfacePicture>> pictures = Pictures.all();
  private final ObjectFiles files = new ObjectFiles(recipes, counts);

  /**
   * The result of writing.
   *
   * @param polygons polygons by file name, if objects were asked for
   * @param files number of files, unchanged ones included
   * @param left see {@link FileTransaction#commit}
   */
  public record Written(Map<String, Integer> polygons, int files, List<Path> left) {}

  /** Returns the names of the objects that have recipes. */
  public Set<String> objects() {
    return Set.copyOf(recipes.keySet());
  }

  /**
   * Writes the files of some objects into {@code inlineNodes}.
   *
   * @param folder where {@code inlineNodes} is or will be
   * @param replace whether files that differ are replaced
   * @return what has been written
   * @throws IOException if a file cannot be written or differs, with one line that names it
   * @throws IllegalArgumentException if there is no such object, or its polygon count cannot be
   *     reached
   */
  public Written writeObjects(Path folder, Collection<String> names, boolean replace)
      throws IOException {
    List<MadeObject> made = files.of(names);
    Map<String, Integer> polygons = new TreeMap<>();
    Map<String, byte[]> contents = new TreeMap<>();
    for (MadeObject object : made) {
      for (RecipeFile file : object.files()) {
        contents.put(FOLDER + file.name(), bytes(file.text()));
        polygons.put(file.name(), file.polygons());
      }
      for (String picture : object.model().pictures()) {
        contents.put(FOLDER + picture, pictures.get(picture).get().png());
      }
    }
    return new Written(polygons, contents.size(), write(folder, contents, replace));
  }

  /**
   * Writes the scenes, their objects and the recorded walk.
   *
   * @param folder where {@code scenes} and {@code inlineNodes} are or will be
   * @param replace whether files that differ are replaced
   * @return what has been written
   * @throws IOException if a file cannot be written or differs, with one line that names it
   * @throws IllegalArgumentException if the recipes do not fit the plan or the polygon counts
   */
  public Written writeAll(Path folder, boolean replace) throws IOException {
    Apartment apartment = Apartment.make(files, counts);
    Map<String, byte[]> contents = new TreeMap<>();
    apartment.texts().forEach((path, text) -> contents.put(path, bytes(text)));
    apartment.pictures().forEach((path, picture) -> contents.put(path, picture.png()));
    return new Written(Map.of(), contents.size(), write(folder, contents, replace));
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static List<Path> write(Path folder, Map<String, byte[]> contents, boolean replace)
      throws IOException {
    FileTransaction writing = new FileTransaction();
    List<String> differing = new ArrayList<>();
    for (Map.Entry<String, byte[]> made : contents.entrySet()) {
      Path file = folder.resolve(made.getKey());
      byte[] content = made.getValue();
      boolean there = Files.isRegularFile(file);
      if (there && Arrays.equals(Files.readAllBytes(file), content)) {
        continue;
      }
      if (there) {
        differing.add(file.toString());
      }
      writing.add(file, content);
    }
    if (!replace && !differing.isEmpty()) {
      int more = differing.size() - NAMED;
      throw new DifferingFilesException(
          "%s%s different from what would be written; nothing has been changed"
              .formatted(
                  String.join(", ", differing.subList(0, Math.min(NAMED, differing.size()))),
                  (more > 0 ? " and %s more".formatted(more) : "")
                      + (differing.size() == 1 ? " is" : " are")));
    }
    return writing.commit();
  }
}
