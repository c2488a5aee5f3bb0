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
   * Registers a listener for the changes of a node's metadata: another metadata node; of its nodes
   * at every depth the values, and the names except those of sets; another metadata node of the
   * metadata node, and in that values and all names. Which nodes there are is looked up now: a
   * listener that is called registers anew.
   *
   * @param listener is called on the browser's thread, like field listeners, with the time stamp in
   *     seconds
   * @return the registration; empty where the metadata cannot be observed as a whole, as in
   *     prototype instances
   */
  Optional<InlineSceneAccess.Registration> watchMetadata(X3DNode owner, DoubleConsumer listener);
}
