package org.selectiverenderer.geometry.tessellate;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;

/**
 * Turns geometry nodes into meshes. Safe for use by several threads; glyphs that one call has
 * outlined are kept for the next, so share one tessellator.
 *
 * <p>Whatever a node holds, a mesh comes out, if need be an empty one: what cannot be drawn is left
 * out and reported, once per node and kind of problem.
 */
public final class Tessellator {
  private final Map<String, GeometryKind> kinds = new HashMap<>();

  /** A tessellator with the usual limits. */
  public Tessellator() {
    this(new TextMesher());
  }

  /**
   * @param mesher whose glyphs are used, so that they are made once
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

  /** Whether nodes of that type can be turned into meshes. */
  public boolean handles(NodeType type) {
    return kinds.containsKey(type.name());
  }

  /**
   * The mesh of a geometry node.
   *
   * @param problems hears what is left out or replaced; a value that is fine but draws nothing,
   *     such as an empty coordIndex, is no problem
   * @return nothing if {@link #handles} says no: whose business the node's type is reports it
   */
  public Optional<Mesh> tessellate(NodeView geometry, Problems problems) {
    return examine(geometry, problems).map(Tessellation::mesh);
  }

  /** Like {@link #tessellate}, with the number of degenerate triangles left out. */
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
