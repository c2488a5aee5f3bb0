package org.selectiverenderer.x3d.tessellate;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Tessellates geometry nodes into meshes. Thread-safe; glyphs are cached, so that one tessellator
 * should be shared.
 *
 * <p>The result is always a mesh, possibly an empty one: invalid parts are left out and reported
 * once per node and kind of problem.
 */
public final class Tessellator {
  private final Map<String, NodeTessellator> kinds = new HashMap<>();

  /** Creates a tessellator with a glyph cache of its own. */
  public Tessellator() {
    this(new TextMesher());
  }

  /**
   * Creates a tessellator that shares the glyph cache of a mesher.
   *
   * @param mesher the mesher whose glyphs are used
   */
  public Tessellator(TextMesher mesher) {
    kinds.put("Box", BoxTessellator::mesh);
    kinds.put("Cone", RoundPrimitiveTessellator::cone);
    kinds.put("Cylinder", RoundPrimitiveTessellator::cylinder);
    kinds.put("Sphere", RoundPrimitiveTessellator::sphere);
    kinds.put("IndexedFaceSet", IndexedFaceSetTessellator::mesh);
    kinds.put("ElevationGrid", ElevationGridTessellator::mesh);
    kinds.put("GeoElevationGrid", GeospatialTessellator::grid);
    kinds.put("Extrusion", ExtrusionTessellator::mesh);
    kinds.put("NurbsCurve", NurbsSweepTessellator::curve);
    kinds.put("NurbsPatchSurface", NurbsSurfaceTessellator::patch);
    kinds.put("NurbsTrimmedSurface", NurbsSurfaceTessellator::trimmed);
    kinds.put("NurbsSweptSurface", NurbsSweepTessellator::swept);
    kinds.put("NurbsSwungSurface", NurbsSweepTessellator::swung);
    kinds.put("IndexedLineSet", LineSetTessellator::indexedLines);
    kinds.put("LineSet", LineSetTessellator::lines);
    kinds.put("PointSet", LineSetTessellator::points);
    kinds.put("Text", job -> TextTessellator.mesh(job, mesher));
    kinds.put("Rectangle2D", Geometry2DTessellator::rectangle);
    kinds.put("Disk2D", Geometry2DTessellator::disk);
    kinds.put("TriangleSet2D", Geometry2DTessellator::triangles);
    kinds.put("ArcClose2D", Geometry2DTessellator::arcClose);
    kinds.put("Arc2D", Geometry2DTessellator::arc);
    kinds.put("Circle2D", Geometry2DTessellator::circle);
    kinds.put("Polyline2D", Geometry2DTessellator::polyline);
    kinds.put("Polypoint2D", Geometry2DTessellator::points);
    kinds.put("TriangleSet", TriangleSetTessellator::triangles);
    kinds.put("IndexedTriangleSet", TriangleSetTessellator::indexedTriangles);
    kinds.put("TriangleStripSet", TriangleSetTessellator::strips);
    kinds.put("IndexedTriangleStripSet", TriangleSetTessellator::indexedStrips);
    kinds.put("TriangleFanSet", TriangleSetTessellator::fans);
    kinds.put("IndexedTriangleFanSet", TriangleSetTessellator::indexedFans);
    kinds.put("QuadSet", TriangleSetTessellator::quads);
    kinds.put("IndexedQuadSet", TriangleSetTessellator::indexedQuads);
  }

  /** Returns whether nodes of a type can be tessellated. */
  public boolean handles(NodeType type) {
    return kinds.containsKey(type.name());
  }

  /**
   * Returns the mesh of a geometry node.
   *
   * @param problems receives what is left out or replaced; a valid value that draws nothing, such
   *     as an empty coordIndex, is not a problem
   * @return empty for a node type that is not supported ({@link #handles}), which the caller
   *     reports
   */
  public Optional<Mesh> tessellate(NodeView geometry, ProblemCollector problems) {
    return examine(geometry, problems).map(Tessellation::mesh);
  }

  /** Tessellates like {@link #tessellate}, and returns the number of degenerate triangles, too. */
  public Optional<Tessellation> examine(NodeView geometry, ProblemCollector problems) {
    NodeTessellator kind = kinds.get(geometry.type().name());
    if (kind == null) {
      return Optional.empty();
    }
    TessellationContext job = new TessellationContext(geometry, problems);
    Mesh mesh = kind.mesh(job);
    return Optional.of(new Tessellation(mesh, job.degenerate()));
  }

  /** Tessellates one type of geometry node. */
  @FunctionalInterface
  private interface NodeTessellator {
    /** Returns the mesh of the job's node; empty if nothing of it can be drawn. */
    Mesh mesh(TessellationContext job);
  }

  /**
   * The result of tessellating a geometry node.
   *
   * @param mesh the mesh
   * @param degenerateFaces the number of triangles without area that were left out; they are not
   *     reported as problems, because exporters write thousands of them and they are invisible
   */
  record Tessellation(Mesh mesh, int degenerateFaces) {}

  /** Tessellates IndexedFaceSetTessellator nodes (X3D 4.0, 13.3.6). */
  private static final class IndexedFaceSetTessellator {
    private IndexedFaceSetTessellator() {}

    static Mesh mesh(TessellationContext job) {
      NodeView node = job.node();
      CoordinatePoints points = CoordinatePoints.of(job);
      int[] stream = node.ints("coordIndex");
      IndexStreamRanges faces = IndexStreamRanges.separated(stream);
      TriangleListBuilder triangles =
          new TriangleListBuilder(stream, stream.length + 1 - 3 * faces.count());
      PolygonTriangulator splitter = new PolygonTriangulator(points.xyz(), triangles);
      FaceValidator check = new FaceValidator(stream, points, 3);
      for (int face = 0; face < faces.count(); face++) {
        if (check.accepts(faces.from(face), faces.to(face))) {
          splitter.split(faces.from(face), faces.to(face), face);
        }
      }
      check.report(job, "face");
      splitter.report(job);
      ComposedGeometryMesher.Indices indices =
          new ComposedGeometryMesher.Indices(
              node.ints("colorIndex"), node.ints("normalIndex"), node.ints("texCoordIndex"));
      return new ComposedGeometryMesher(job, points, triangles, faces.count())
          .composed(indices, node.number("creaseAngle"), null);
    }
  }
}
