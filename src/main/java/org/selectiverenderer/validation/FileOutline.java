package org.selectiverenderer.validation;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.X3dFile;

/**
 * What stays of a file after its own checks: the nodes without their coordinates.
 *
 * @param file where it is and how reports name it
 * @param bytes its size on disk
 * @param scene whose nodes have lost their long values
 * @param nodes all of them, each once, parents before what they hold; prototypes expanded
 * @param urls where the attribute {@code url} of an element stands, by the place of the element
 * @param measures how much each geometry node draws
 */
public record FileOutline(
    SourceFile file,
    long bytes,
    X3dFile scene,
    List<ParsedNode> nodes,
    Map<Location, Location> urls,
    Map<ParsedNode, Measure> measures) {

  /** Where the url of a node stands. */
  public Location url(ParsedNode node) {
    return urls.getOrDefault(node.location(), node.location());
  }

  /** How much a geometry node draws; empty for a node that cannot be drawn. */
  public Optional<Measure> measure(ParsedNode geometry) {
    return Optional.ofNullable(measures.get(geometry));
  }
}
