package org.selectiverenderer.validation.geometry;

import org.selectiverenderer.x3d.read.ParsedNode;

/** Looks at a node of geometry, or at one that holds its points, normals or colours. */
interface NodeCheck {
  void check(ParsedNode node, GeometryFindings findings);
}
