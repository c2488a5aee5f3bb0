package org.selectiverenderer.validation;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

/**
 * What stays of a file after its own checks: the nodes without their coordinates.
 *
 * @param file where it is and how reports name it
 * @param bytes its size on disk
 * @param scene whose nodes have lost their long values
 * @param nodes all of them, each once, parents before what they hold; prototypes expanded
 * @param places where attributes that scene checks speak of stand, by the place of the element
 * @param measures how much each geometry node draws
 */
public record FileOutline(
    SourceFile file,
    long bytes,
    X3dFile scene,
    List<ParsedNode> nodes,
    Map<Location, Map<String, Location>> places,
    Map<ParsedNode, GeometryMeasure> measures) {

  /** Where a field of a node is given; the node's own place where it is not, or not kept. */
  public Location place(NodeView node, String field) {
    return places.getOrDefault(node.location(), Map.of()).getOrDefault(field, node.location());
  }

  /** How much a geometry node draws; empty for a node that cannot be drawn. */
  public Optional<GeometryMeasure> measure(ParsedNode geometry) {
    return Optional.ofNullable(measures.get(geometry));
  }
}
