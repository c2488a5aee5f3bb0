package org.selectiverenderer.geometry.tessellate;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
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
  private final Map<String, GeometryKind> kinds = new HashMap<>();

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
    kinds.put("Box", BoxShape::mesh);
    kinds.put("Cone", RoundShapes::cone);
    kinds.put("Cylinder", RoundShapes::cylinder);
    kinds.put("Sphere", RoundShapes::sphere);
    kinds.put("IndexedFaceSet", IndexedFaceSet::mesh);
    kinds.put("ElevationGrid", ElevationGrid::mesh);
    kinds.put("GeoElevationGrid", GeoShapes::grid);
    kinds.put("Extrusion", Extrusion::mesh);
    kinds.put("NurbsCurve", NurbsSweeps::curve);
    kinds.put("NurbsPatchSurface", NurbsSurfaces::patch);
    kinds.put("NurbsTrimmedSurface", NurbsSurfaces::trimmed);
    kinds.put("NurbsSweptSurface", NurbsSweeps::swept);
    kinds.put("NurbsSwungSurface", NurbsSweeps::swung);
    kinds.put("IndexedLineSet", LineSets::indexedLines);
    kinds.put("LineSet", LineSets::lines);
    kinds.put("PointSet", LineSets::points);
    kinds.put("Text", job -> TextShape.mesh(job, mesher));
    kinds.put("Rectangle2D", PlanarShapes::rectangle);
    kinds.put("Disk2D", PlanarShapes::disk);
    kinds.put("TriangleSet2D", PlanarShapes::triangles);
    kinds.put("ArcClose2D", PlanarShapes::arcClose);
    kinds.put("Arc2D", PlanarShapes::arc);
    kinds.put("Circle2D", PlanarShapes::circle);
    kinds.put("Polyline2D", PlanarShapes::polyline);
    kinds.put("Polypoint2D", PlanarShapes::points);
    kinds.put("TriangleSet", TriangleSets::triangles);
    kinds.put("IndexedTriangleSet", TriangleSets::indexedTriangles);
    kinds.put("TriangleStripSet", TriangleSets::strips);
    kinds.put("IndexedTriangleStripSet", TriangleSets::indexedStrips);
    kinds.put("TriangleFanSet", TriangleSets::fans);
    kinds.put("IndexedTriangleFanSet", TriangleSets::indexedFans);
    kinds.put("QuadSet", TriangleSets::quads);
    kinds.put("IndexedQuadSet", TriangleSets::indexedQuads);
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
  public Optional<Mesh> tessellate(NodeView geometry, Problems problems) {
    return examine(geometry, problems).map(Tessellation::mesh);
  }

  /** Tessellates like {@link #tessellate}, and returns the number of degenerate triangles, too. */
  public Optional<Tessellation> examine(NodeView geometry, Problems problems) {
    GeometryKind kind = kinds.get(geometry.type().name());
    if (kind == null) {
      return Optional.empty();
    }
    TessellationJob job = new TessellationJob(geometry, problems);
    Mesh mesh = kind.mesh(job);
    return Optional.of(new Tessellation(mesh, job.degenerate()));
  }
}
