package org.selectiverenderer.geometry.tessellate;

import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** Tessellates IndexedFaceSet nodes (X3D 4.0, 13.3.6). */
final class IndexedFaceSet {
  private IndexedFaceSet() {}

  static Mesh mesh(TessellationJob job) {
    NodeView node = job.node();
    Points points = Points.of(job);
    int[] stream = node.ints("coordIndex");
    IndexRuns faces = IndexRuns.separated(stream);
    TriangleList triangles = new TriangleList(stream, stream.length + 1 - 3 * faces.count());
    FaceSplitter splitter = new FaceSplitter(points.xyz(), triangles);
    FaceCorners check = new FaceCorners(stream, points, 3);
    for (int face = 0; face < faces.count(); face++) {
      if (check.accepts(faces.from(face), faces.to(face))) {
        splitter.split(faces.from(face), faces.to(face), face);
      }
    }
    check.report(job, "face");
    splitter.report(job);
    SurfaceMesher.Indices indices =
        new SurfaceMesher.Indices(
            node.ints("colorIndex"), node.ints("normalIndex"), node.ints("texCoordIndex"));
    return new SurfaceMesher(job, points, triangles, faces.count())
        .composed(indices, node.number("creaseAngle"), null);
  }
}
