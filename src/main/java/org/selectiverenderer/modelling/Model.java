package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;

/**
 * An object of several parts, in metres; it stands on y = 0 with its front towards +z.
 *
 * @param name as in the thesis's tables: {@code trashCan}
 */
public record Model(String name, List<Part> parts) {

  public Model {
    parts = List.copyOf(parts);
    Set<String> names = new HashSet<>();
    for (Part part : parts) {
      if (!names.add(part.name())) {
        throw new IllegalArgumentException(name + " has two parts named " + part.name());
      }
    }
  }

  public static Model of(String name, Part... parts) {
    return new Model(name, List.of(parts));
  }

  /** The number of triangles of all parts. */
  public int polygons() {
    return parts.stream().mapToInt(p -> p.mesh().triangleCount()).sum();
  }

  /** All parts' triangles as one mesh. */
  public TriangleMesh mesh() {
    return TriangleMesh.of(parts.stream().map(Part::mesh).toList());
  }

  /** The box around all points; the model has some. */
  public Bounds bounds() {
    return parts.stream().map(p -> p.mesh().bounds()).reduce(Bounds::union).orElseThrow();
  }

  /** The same with every part's mesh changed: moved, turned, scaled. */
  public Model map(UnaryOperator<TriangleMesh> change) {
    return new Model(name, parts.stream().map(p -> p.with(change.apply(p.mesh()))).toList());
  }

  public Model named(String other) {
    return new Model(other, parts);
  }

  /** With the other model's parts after its own. */
  public Model plus(Model other) {
    List<Part> all = new ArrayList<>(parts);
    all.addAll(other.parts);
    return new Model(name, all);
  }
}
