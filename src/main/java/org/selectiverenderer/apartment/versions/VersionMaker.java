package org.selectiverenderer.apartment.versions;

import java.util.Locale;
import org.selectiverenderer.modelling.ExactCount;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Rounding;
import org.selectiverenderer.modelling.X3dModelWriter;

/** Makes objects' files. Safe for use by several threads. */
public final class VersionMaker {
  private final X3dModelWriter writer = new X3dModelWriter("./selective-renderer apartment");
  private final Reducer reducer = new Reducer();

  /** Version 1: the recipe's model with exactly so many polygons. */
  public ObjectFile original(Model recipe, int polygons) {
    Model model = ExactCount.refine(Rounding.toGrid(recipe), polygons);
    return file(model, "_v1", "version 1: " + polygons + " polygons, as modelled");
  }

  /** Version 2: version 1 reduced to exactly so many polygons. */
  public ObjectFile reduced(ObjectFile original, int polygons) {
    Model model = reducer.reduce(original, polygons);
    return file(model, "_v2", "version 2: " + polygons + " polygons, the reduced one");
  }

  /** The file of an object that has one version. */
  public ObjectFile single(Model model) {
    Model rounded = Rounding.toGrid(model);
    return file(rounded, "", rounded.polygons() + " polygons");
  }

  private ObjectFile file(Model model, String suffix, String description) {
    String name = model.name() + suffix + ".x3d";
    return new ObjectFile(
        name, model, writer.text(model, name, words(model.name()) + ", " + description));
  }

  /** {@code trashCan} as {@code Trash can}. */
  static String words(String name) {
    String spaced =
        name.replaceAll("(?<=[a-z])(?=[A-Z0-9])|(?<=[0-9])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    return Character.toUpperCase(spaced.charAt(0)) + spaced.substring(1);
  }
}
