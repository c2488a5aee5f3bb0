package org.selectiverenderer.apartment.versions;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.NodeView;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.Problems;
import org.selectiverenderer.x3d.X3dReader;
import org.selectiverenderer.x3d.geometry.Mesh;
import org.selectiverenderer.x3d.geometry.Tessellator;

/** The meshes of an object's file as any reader of it sees them: rounded, with normals. */
final class FileMeshes {
  private final X3dReader reader = new X3dReader(NodeCatalogue.load());
  private final Tessellator tessellator = new Tessellator();

  /** One mesh per part of the model. */
  List<Mesh> of(ObjectFile file) {
    Problems problems = new Problems();
    List<Mesh> meshes = new ArrayList<>();
    byte[] bytes = file.text().getBytes(StandardCharsets.UTF_8);
    for (ParsedNode shape : reader.read(file.name(), bytes, problems).nodes()) {
      NodeView geometry = shape.node("geometry");
      if (geometry != null) {
        tessellator.tessellate(geometry, problems).ifPresent(meshes::add);
      }
    }
    if (problems.any()) {
      throw new IllegalArgumentException(problems.list().get(0).toString());
    }
    return meshes;
  }
}
