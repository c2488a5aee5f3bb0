package org.selectiverenderer.apartment.versions;

import java.util.List;
import java.util.Locale;
import org.selectiverenderer.modelling.ExactCountRefiner;
import org.selectiverenderer.modelling.GridSnapping;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.X3dModelWriter;

/** Generates the files of objects, in one or two versions. Safe for use by several threads. */
public final class ObjectVersionGenerator {
  private final X3dModelWriter writer = new X3dModelWriter("./selective-renderer apartment");
  private final ModelReducer reducer = new ModelReducer();

  /**
   * Generates an object in two versions: the recipe's model refined to the polygon count of version
   * 1, and that model reduced to the count of version 2.
   *
   * @throws IllegalArgumentException if a count cannot be reached
   */
  public GeneratedObject versions(ParametricModel recipe, int original, int reduced) {
    ParametricModel model = ExactCountRefiner.refine(GridSnapping.toGrid(recipe), original);
    String name = model.name();
    GeneratedFile first =
        file(model, name + "_v1.x3d", "version 1: " + original + " polygons, as modelled");
    String title = name + "_v2.x3d";
    String second =
        reducer.reduce(
            first,
            reduced,
            title,
            words(name) + ", version 2: " + reduced + " polygons, the reduced one");
    return new GeneratedObject(model, List.of(first, new GeneratedFile(title, reduced, second)));
  }

  /** Generates an object that has one version. */
  public GeneratedObject single(ParametricModel recipe) {
    ParametricModel model = GridSnapping.toGrid(recipe);
    String description = model.polygons() + " polygons";
    return new GeneratedObject(model, List.of(file(model, model.name() + ".x3d", description)));
  }

  private GeneratedFile file(ParametricModel model, String name, String description) {
    String text = writer.text(model, name, words(model.name()) + ", " + description);
    return new GeneratedFile(name, model.polygons(), text);
  }

  /** Returns a name as words: {@code trashCan} gives {@code Trash can}. */
  static String words(String name) {
    String spaced =
        name.replaceAll("(?<=[a-z])(?=[A-Z0-9])|(?<=[0-9])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    return Character.toUpperCase(spaced.charAt(0)) + spaced.substring(1);
  }
}
