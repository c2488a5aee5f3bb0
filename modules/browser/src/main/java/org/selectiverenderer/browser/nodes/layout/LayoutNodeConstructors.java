package org.selectiverenderer.browser.nodes.layout;

import java.util.Map;
import org.selectiverenderer.browser.scene.NodeConstructor;

/** The constructors of the nodes whose layout depends on the picture, by node type name. */
public final class LayoutNodeConstructors {
  public static final Map<String, NodeConstructor> MAKERS =
      Map.of(
          "LayoutGroup", LayoutGroupNode::new,
          "LayoutLayer", LayoutGroupNode::new,
          "ScreenGroup", ScreenGroupNode::new);

  private LayoutNodeConstructors() {}
}
