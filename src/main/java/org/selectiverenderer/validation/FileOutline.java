package org.selectiverenderer.validation;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.x3d.ParsedNode;
import org.selectiverenderer.x3d.X3dFile;

/**
 * What stays of a file after its own checks: the nodes without their coordinates.
 *
 * @param file where it is and how reports name it
 * @param bytes its size on disk
 * @param scene whose nodes have lost their long values
 * @param nodes all of them, each once, parents before what they hold; prototypes expanded
 * @param measures how much each geometry node draws
 */
public record FileOutline(
    SourceFile file,
    long bytes,
    X3dFile scene,
    List<ParsedNode> nodes,
    Map<ParsedNode, Measure> measures) {

  /** How much a geometry node draws; empty for a node that cannot be drawn. */
  public Optional<Measure> measure(ParsedNode geometry) {
    return Optional.ofNullable(measures.get(geometry));
  }
}
