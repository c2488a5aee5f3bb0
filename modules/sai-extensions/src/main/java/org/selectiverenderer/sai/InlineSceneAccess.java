package org.selectiverenderer.sai;

import java.util.Optional;
import java.util.Set;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;

/**
 * Gives access to the scenes in Inlines. By the standard only the exported nodes of an inlined file
 * are accessible (X3D 4.0, 9.4.2 and 4.4.6). A browser that gives access to all implements this
 * interface in addition to {@link org.web3d.x3d.sai.ExternalBrowser}.
 */
public interface InlineSceneAccess {
  /** Called on the browser's thread when the scene of an Inline changes. */
  @FunctionalInterface
  interface Listener {
    /**
     * The scene of the Inline was loaded, unloaded or replaced, or has other root nodes.
     *
     * @param time stamp in seconds
     */
    void inlinedSceneChanged(X3DNode inline, double time);
  }

  /**
   * Returns the scene that an Inline shows. Each Inline has a scene of its own, even of the same
   * file.
   *
   * @param inline a node of type Inline
   * @return the scene; empty while the file is loading, when it cannot be read, and with {@code
   *     load FALSE}
   */
  Optional<X3DScene> inlinedScene(X3DNode inline);

  /**
   * Returns whether the scene of an Inline holds nodes of some types, or may come to hold them, so
   * that searches can skip other scenes: most inlined files are plain models.
   *
   * @param types names of node types
   * @return false if no such node is in it, and none can be added except as a root node, which a
   *     listener hears of: it has no Script and exports nothing. True for a scene that has Inlines
   *     itself
   */
  boolean mayHold(X3DNode inline, Set<String> types);

  /**
   * Registers a listener for the changes of an Inline.
   *
   * @return the registration; closing it removes the listener, and does nothing when called twice
   *     or after the node was disposed of
   */
  Registration watchInline(X3DNode inline, Listener listener);

  /** The registration of a listener, which lasts until it is closed. */
  interface Registration extends AutoCloseable {
    @Override
    void close();
  }
}
