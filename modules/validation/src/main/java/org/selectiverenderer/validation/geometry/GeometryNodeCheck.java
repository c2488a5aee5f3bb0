package org.selectiverenderer.validation.geometry;

import org.selectiverenderer.x3d.read.ParsedNode;

/** A check of a geometry node, or of a node with its points, normals or colours. */
interface GeometryNodeCheck {
  void check(ParsedNode node, GeometryFindingCollector findings);
}
