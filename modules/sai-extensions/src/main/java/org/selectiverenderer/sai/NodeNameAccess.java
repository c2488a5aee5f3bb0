package org.selectiverenderer.sai;

import java.util.Map;
import java.util.Set;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;

/**
 * Tells the DEF names of nodes. By the standard only the node of a name is accessible, so whoever
 * wants the name of a node has to ask for the nodes of all names. A browser that tells names
 * implements this interface in addition to {@link org.web3d.x3d.sai.ExternalBrowser}.
 */
public interface NodeNameAccess {
  /**
   * Returns the DEF names of some nodes of a scene. The name of a prototype instance is that of the
   * first node of its body, too ({@link ProtoBodyAccess}).
   *
   * @param nodes nodes of the scene or of others
   * @return the names of those that have one in this scene; of several names of a node, the last
   */
  Map<X3DNode, String> namesOf(X3DExecutionContext scene, Set<X3DNode> nodes);
}
