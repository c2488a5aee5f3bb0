package org.selectiverenderer.modelling;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.TriangleMesh;

/**
 * The model of an object: several parts, in metres; it stands on y = 0 with its front towards +z.
 *
 * @param name as in the thesis's tables: {@code trashCan}
 */
public record ParametricModel(String name, List<Part> parts) {

  public ParametricModel {
    parts = List.copyOf(parts);
    Set<String> names = new HashSet<>();
    for (Part part : parts) {
      if (!names.add(part.name())) {
        throw new IllegalArgumentException(name + " has two parts named " + part.name());
      }
    }
  }

  public static ParametricModel of(String name, Part... parts) {
    return new ParametricModel(name, List.of(parts));
  }

  /** Returns the number of triangles of all parts. */
  public int polygons() {
    return parts.stream().mapToInt(p -> p.mesh().triangleCount()).sum();
  }

  /** Returns the files of the textures that cover its parts. */
  public SortedSet<String> pictures() {
    SortedSet<String> files = new TreeSet<>();
    for (Part part : parts) {
      TextureMapping cladding = part.look().cladding();
      if (cladding != null) {
        files.add(cladding.file());
      }
    }
    return files;
  }

  /** Returns the triangles of all parts as one mesh. */
  public TriangleMesh mesh() {
    return TriangleMesh.of(parts.stream().map(Part::mesh).toList());
  }

  /** Returns the bounding box; the model must not be empty. */
  public BoundingBox bounds() {
    return parts.stream().map(p -> p.mesh().bounds()).reduce(BoundingBox::union).orElseThrow();
  }

  /** Returns the model with a transformation applied to every part's mesh. */
  public ParametricModel map(UnaryOperator<TriangleMesh> change) {
    return new ParametricModel(
        name, parts.stream().map(p -> p.with(change.apply(p.mesh()))).toList());
  }

  public ParametricModel named(String other) {
    return new ParametricModel(other, parts);
  }

  /** Returns the model with another model's parts appended. */
  public ParametricModel plus(ParametricModel other) {
    List<Part> all = new ArrayList<>(parts);
    all.addAll(other.parts);
    return new ParametricModel(name, all);
  }
}
