package org.selectiverenderer.sai;

import org.web3d.x3d.sai.X3DNode;

/**
 * Gives access to the bodies of prototype instances. By the standard only the fields of an
 * instance's interface are accessible (X3D 4.0, 4.4.4.1). A browser that gives access to bodies
 * implements this interface in addition to {@link org.web3d.x3d.sai.ExternalBrowser}.
 */
public interface ProtoBodyAccess {
  /**
   * Returns the node that represents an instance in the scene graph: the first node of its body or,
   * if that is an instance too, the first node of that one's body. Its fields lead to the other
   * nodes as those of any node.
   *
   * @return the first node of the body; the node itself if it is no instance
   */
  X3DNode bodyOf(X3DNode node);
}
