package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Brings a model to an exact number of triangles without changing its form: the longest edge of all
 * is split in its middle, with the triangles on both sides of it, again and again. An edge inside a
 * surface adds two triangles, one on a border adds one; there are no T-junctions. Deterministic.
 */
public final class ExactCount {

  private ExactCount() {}

  /**
   * @param polygons at least as many as the model has
   * @throws IllegalArgumentException if it has more, or if the difference is odd and no part has a
   *     border: the count of a closed surface is even
   */
  public static Model refine(Model model, int polygons) {
    int missing = polygons - model.polygons();
    if (missing < 0) {
      throw new IllegalArgumentException(
          model.name()
              + " has "
              + model.polygons()
              + " polygons, more than the "
              + polygons
              + " asked for");
    }
    List<EdgeSplitter> splitters =
        model.parts().stream().map(p -> new EdgeSplitter(p.mesh())).toList();
    while (missing > 0) {
      int most = missing;
      EdgeSplitter next =
          splitters.stream()
              .filter(s -> s.longest(most).isPresent())
              .reduce((a, b) -> longest(b, most) > longest(a, most) ? b : a)
              .orElseThrow(
                  () ->
                      new IllegalArgumentException(
                          model.name()
                              + " is closed everywhere, so that it cannot have "
                              + polygons
                              + " polygons: an odd count needs a part with a border"));
      missing -= next.split(most);
    }
    List<Part> parts = new ArrayList<>();
    for (int i = 0; i < splitters.size(); i++) {
      parts.add(model.parts().get(i).with(splitters.get(i).mesh()));
    }
    return new Model(model.name(), parts);
  }

  private static double longest(EdgeSplitter splitter, int most) {
    Optional<Double> length = splitter.longest(most);
    return length.orElse(-1.0);
  }
}
