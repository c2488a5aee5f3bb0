package org.selectiverenderer.validation.geometry;

import java.util.List;
import org.selectiverenderer.validation.FileCheck;
import org.selectiverenderer.validation.FileView;
import org.selectiverenderer.validation.Findings;
import org.selectiverenderer.validation.SceneNodes;
import org.selectiverenderer.x3d.read.ParsedNode;

/** Runs several checks of geometry in one pass over the nodes of a file. */
record GeometryCheck(List<NodeCheck> parts) implements FileCheck {
  @Override
  public void check(FileView file, Findings findings) {
    GeometryFindings found = new GeometryFindings(file, findings);
    for (ParsedNode node : SceneNodes.all(file.scene())) {
      if (node.type().is("X3DGeometryNode") || node.type().is("X3DGeometricPropertyNode")) {
        parts.forEach(part -> part.check(node, found));
      }
    }
  }
}
