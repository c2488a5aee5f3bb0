package org.selectiverenderer.sai;

import java.util.Optional;
import java.util.function.DoubleConsumer;
import org.web3d.x3d.sai.X3DNode;

/**
 * Tells changes of a node's metadata at every depth. By the standard whoever wants to hear of them
 * adds a listener to each field of each metadata node, of which a scene may have a hundred
 * thousand. A browser that tells them implements this interface in addition to {@link
 * org.web3d.x3d.sai.ExternalBrowser}.
 */
public interface MetadataChangeAccess {
  /**
   * Registers a listener for the changes of a node's metadata. It is called when the node gets
   * another metadata node; when a value below that, at any depth, changes, or the name of a
   * metadata node that is no set; and when the metadata node itself gets other metadata, or a value
   * or name in these changes. The nodes that are there now are observed: a listener that is called
   * registers anew. To be called on the browser's thread.
   *
   * @param listener is called on the browser's thread, like field listeners, with the time stamp in
   *     seconds
   * @return the registration; empty where the metadata cannot be observed as a whole, as in
   *     prototype instances
   */
  Optional<InlineSceneAccess.Registration> watchMetadata(X3DNode owner, DoubleConsumer listener);
}
