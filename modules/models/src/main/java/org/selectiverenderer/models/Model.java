package org.selectiverenderer.models;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * A model: an object as textured meshes, all in one coordinate frame.
 *
 * @param parts the parts, one per shape that has faces
 * @param units the units of the file, in which its numbers are; empty for metres
 */
public record Model(List<ModelPart> parts, List<X3dFile.Unit> units) {
  public Model {
    parts = List.copyOf(parts);
    units = List.copyOf(units);
  }

  public List<Mesh> meshes() {
    return parts.stream().map(ModelPart::mesh).toList();
  }

  public int polygons() {
    return parts.stream().mapToInt(part -> part.mesh().polygons()).sum();
  }

  /** Returns the same parts with other meshes; a part whose mesh is empty is left out. */
  public Model with(List<Mesh> meshes) {
    List<ModelPart> replaced = new ArrayList<>();
    for (int i = 0; i < parts.size(); i++) {
      if (!meshes.get(i).isEmpty()) {
        replaced.add(
            new ModelPart(parts.get(i).appearance(), meshes.get(i), parts.get(i).folder()));
      }
    }
    return new Model(replaced, units);
  }
}
