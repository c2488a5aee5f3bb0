package org.selectiverenderer.validation;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * The outline of a file, which the validator keeps after the file's own checks: its nodes without
 * their coordinates.
 *
 * @param file the file, with its name in reports
 * @param bytes size of the file on disk in bytes
 * @param scene the scene, whose nodes have lost their long values
 * @param nodes all nodes, each once, parents before children, with prototypes expanded
 * @param places locations of the attributes that scene checks report, by location of the element
 * @param measures polygons and bounds of each geometry node
 */
public record FileOutline(
    SourceFile file,
    long bytes,
    X3dFile scene,
    List<ParsedNode> nodes,
    Map<SourceLocation, Map<String, SourceLocation>> places,
    Map<ParsedNode, GeometryMeasure> measures) {

  /**
   * Returns the location of a field of a node; that of the node if the field is not given or its
   * location is not kept.
   */
  public SourceLocation place(NodeView node, String field) {
    return places.getOrDefault(node.location(), Map.of()).getOrDefault(field, node.location());
  }

  /** Returns polygons and bounds of a geometry node; empty for a node that cannot be drawn. */
  public Optional<GeometryMeasure> measure(ParsedNode geometry) {
    return Optional.ofNullable(measures.get(geometry));
  }
}
