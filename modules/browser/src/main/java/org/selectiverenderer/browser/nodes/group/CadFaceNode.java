package org.selectiverenderer.browser.nodes.group;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** CADFace: holds one shape of a CAD part in its field {@code shape} (X3D 4.0, 32.4.2). */
public final class CadFaceNode extends GroupingNode {
  private final int shape;

  public CadFaceNode(NodeType type, @Nullable String name, SourceLocation location) {
    super(type, name, location);
    shape = type.indexOf("shape");
  }

  @Override
  public List<Node> children() {
    return value(shape) instanceof Node node ? List.of(node) : List.of();
  }

  @Override
  public Effect effectOf(int field) {
    return field == shape ? Effect.STRUCTURE : super.effectOf(field);
  }
}
