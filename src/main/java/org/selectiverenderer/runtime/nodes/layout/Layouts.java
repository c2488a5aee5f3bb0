package org.selectiverenderer.runtime.nodes.layout;

import java.util.Map;
import org.selectiverenderer.runtime.scene.NodeMaker;

/** The makers of the nodes that depend on the picture. */
public final class Layouts {
  public static final Map<String, NodeMaker> MAKERS =
      Map.of(
          "LayoutGroup", LayoutGroupNode::new,
          "LayoutLayer", LayoutGroupNode::new,
          "ScreenGroup", ScreenGroupNode::new);

  private Layouts() {}
}
