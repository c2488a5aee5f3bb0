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
import org.selectiverenderer.apartment.furniture.FurnitureRecipes;
import org.selectiverenderer.apartment.kitchen.KitchenRecipes;
import org.selectiverenderer.apartment.lounge.LoungeRecipes;
import org.selectiverenderer.apartment.office.OfficeRecipes;
import org.selectiverenderer.apartment.scene.StreetScene;
import org.selectiverenderer.apartment.textures.TextureImage;
import org.selectiverenderer.apartment.textures.TextureRegistry;
import org.selectiverenderer.apartment.versions.GeneratedFile;
import org.selectiverenderer.apartment.versions.GeneratedObject;
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
  private final Map<String, Supplier<ParametricModel>> recipes = RecipeRegistry.all();
  private final Map<String, Supplier<TextureImage>> pictures = TextureRegistry.all();
  private final ObjectFileGenerator files = new ObjectFileGenerator(recipes, counts);

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
    List<GeneratedObject> made = files.of(names);
    Map<String, Integer> polygons = new TreeMap<>();
    Map<String, byte[]> contents = new TreeMap<>();
    for (GeneratedObject object : made) {
      for (GeneratedFile file : object.files()) {
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
    return writeAll(folder, List.of(), replace);
  }

  /**
   * Writes the same and, beside the apartment, scenes with many of it.
   *
   * @param folder where {@code scenes} and {@code inlineNodes} are or will be
   * @param streets numbers of apartments, one for each {@link StreetScene}
   * @param replace whether files that differ are replaced
   * @return what has been written
   * @throws IOException if a file cannot be written or differs, with one line that names it
   */
  public Written writeAll(Path folder, List<Integer> streets, boolean replace) throws IOException {
    GeneratedApartment apartment = GeneratedApartment.make(files, counts);
    Map<String, byte[]> contents = new TreeMap<>();
    apartment.texts().forEach((path, text) -> contents.put(path, bytes(text)));
    apartment.pictures().forEach((path, picture) -> contents.put(path, picture.png()));
    for (int apartments : streets) {
      contents.put(
          "scenes/" + StreetScene.fileName(apartments), bytes(StreetScene.text(apartments)));
    }
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

  /** The registry of all recipes by object name. */
  static final class RecipeRegistry {

    private RecipeRegistry() {}

    static Map<String, Supplier<ParametricModel>> all() {
      Map<String, Supplier<ParametricModel>> all = new TreeMap<>(KitchenRecipes.all());
      add(all, LoungeRecipes.all());
      add(all, OfficeRecipes.all());
      add(all, FurnitureRecipes.all());
      return all;
    }

    private static void add(
        Map<String, Supplier<ParametricModel>> all, Map<String, Supplier<ParametricModel>> room) {
      room.forEach(
          (name, recipe) -> {
            if (all.put(name, recipe) != null) {
              throw new IllegalStateException("two recipes are named " + name);
            }
          });
    }
  }
}
