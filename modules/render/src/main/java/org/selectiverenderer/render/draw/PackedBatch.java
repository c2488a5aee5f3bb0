package org.selectiverenderer.render.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.geometry.mesh.MeshTransformer;
import org.selectiverenderer.render.gpu.GpuMesh;
import org.selectiverenderer.render.lighting.CurvatureTolerance;
import org.selectiverenderer.render.mesh.MeshMerger;
import org.selectiverenderer.render.mesh.MeshPacker;
import org.selectiverenderer.render.mesh.PackedMesh;
import org.selectiverenderer.render.mesh.RefinedMesh;
import org.selectiverenderer.render.occlusion.MeshOccluders;

/**
 * A batch whose buffers are ready to be uploaded.
 *
 * @param origin the translation from the coordinates in the buffers to the world
 * @param worlds the shapes' world matrices when they were put there
 * @param tinted whether the vertices store the diffuse colours of the shapes, because these differ
 * @param occluders each shape's flat parts that hide other things, in the coordinates of the
 *     buffers
 */
record PackedBatch(
    List<BatchPlanner.Candidate> shapes,
    Matrix4dc origin,
    List<Matrix4dc> worlds,
    boolean tinted,
    MeshMerger.Merged merged,
    List<MeshOccluders> occluders) {

  /** Puts shapes into one pair of buffers whose origin is the centre of them all; any thread. */
  static PackedBatch pack(List<BatchPlanner.Candidate> shapes) {
    double[] box = BatchPlanner.bounds(shapes);
    double x = (box[0] + box[3]) / 2;
    double y = (box[1] + box[4]) / 2;
    double z = (box[2] + box[5]) / 2;
    Matrix4dc toBatch = new Matrix4d().translation(-x, -y, -z);
    List<Matrix4dc> worlds = shapes.stream().map(candidate -> candidate.shape().world()).toList();
    DrawState first = shapes.get(0).look();
    boolean tinted = shapes.stream().anyMatch(candidate -> candidate.look() != first);
    List<PackedMesh> packed = new ArrayList<>();
    List<MeshOccluders> occluders = new ArrayList<>();
    for (int i = 0; i < shapes.size(); i++) {
      Matrix4d placement = toBatch.mul(worlds.get(i), new Matrix4d());
      Mesh mesh = shapes.get(i).mesh();
      Mesh placed = MeshTransformer.place(mesh, placement);
      Mesh coloured = tinted ? tinted(placed, shapes.get(i).look()) : placed;
      packed.add(
          MeshPacker.pack(new RefinedMesh(coloured, placed(shapes.get(i).staged(), placement))));
      occluders.add(MeshOccluders.placed(mesh, placement, placed.bounds()));
    }
    return new PackedBatch(
        shapes,
        new Matrix4d().translation(x, y, z),
        worlds,
        tinted,
        MeshMerger.merge(packed),
        occluders);
  }

  /** Returns the coarser levels of a mesh with their lengths scaled to its place. */
  private static List<RefinedMesh.Stage> placed(RefinedMesh mesh, Matrix4dc placement) {
    if (mesh.coarser().isEmpty()) {
      return List.of();
    }
    double scale = CurvatureTolerance.scale(placement);
    return mesh.coarser().stream()
        .map(
            stage ->
                new RefinedMesh.Stage(
                    MeshTransformer.triangles(stage.indices(), placement),
                    stage.undivided() * scale))
        .toList();
  }

  /** Returns a mesh with the diffuse colour of its draw state at each vertex. */
  private static Mesh tinted(Mesh mesh, DrawState look) {
    float[] material = look.material().array();
    float[] colors = new float[4 * mesh.vertexCount()];
    for (int i = 0; i < colors.length; i += 4) {
      System.arraycopy(material, 0, colors, i, 3);
      colors[i + 3] = 1; // A batch has one opacity.
    }
    return new Mesh(
        mesh.primitive(),
        mesh.positions(),
        mesh.normals(),
        colors,
        mesh.texCoords(),
        mesh.indices(),
        mesh.solid(),
        mesh.bounds());
  }

  /** Assigns each shape its part of the uploaded buffers. */
  void parts(GpuMesh mesh, Map<ShapeInstance, SubMesh> parts) {
    DrawBatch batch = new DrawBatch(origin, tinted);
    for (int i = 0; i < shapes.size(); i++) {
      MeshMerger.Part part = merged.parts().get(i);
      parts.put(
          shapes.get(i).shape(),
          new SubMesh(
              mesh, part.clusters(), part.coarser(), occluders.get(i), batch, worlds.get(i)));
    }
  }
}
