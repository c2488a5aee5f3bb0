package org.selectiverenderer.runtime.nodes.layout;

import java.util.Map;
import org.selectiverenderer.runtime.scene.NodeMaker;

/** The constructors of the nodes whose layout depends on the picture, by node type name. */
public final class Layouts {
  public static final Map<String, NodeMaker> MAKERS =
      Map.of(
          "LayoutGroup", LayoutGroupNode::new,
          "LayoutLayer", LayoutGroupNode::new,
          "ScreenGroup", ScreenGroupNode::new);

  private Layouts() {}
}
