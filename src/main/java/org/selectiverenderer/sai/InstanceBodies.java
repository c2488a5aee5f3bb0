package org.selectiverenderer.sai;

import org.web3d.x3d.sai.X3DNode;

/**
 * Shows the bodies of prototypes' instances. By the standard they are closed: of an instance only
 * the fields of its interface can be reached (X3D 4.0, 4.4.4.1). A browser that opens them
 * implements this beside {@link org.web3d.x3d.sai.ExternalBrowser}.
 */
public interface InstanceBodies {
  /**
   * The node that stands in the place of an instance: the first of its body, or of the body of the
   * instance that that is. Its fields lead to the others as those of any node.
   *
   * @return the node itself if it is no instance
   */
  X3DNode bodyOf(X3DNode node);
}
