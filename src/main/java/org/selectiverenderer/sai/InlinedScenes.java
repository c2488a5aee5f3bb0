package org.selectiverenderer.sai;

import java.util.Optional;
import java.util.Set;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;

/**
 * Shows the scenes in Inlines. By the standard they are closed: of the nodes of an inlined file
 * only those that it exports can be reached (X3D 4.0, 9.4.2 and 4.4.6). A browser that opens them
 * implements this beside {@link org.web3d.x3d.sai.ExternalBrowser}.
 */
public interface InlinedScenes {
  /** Hears on the thread of the browser that an Inline shows something else. */
  @FunctionalInterface
  interface Listener {
    /**
     * The scene of the Inline has come, gone or been replaced, or has other nodes at its top.
     *
     * @param time stamp in seconds
     */
    void inlinedSceneChanged(X3DNode inline, double time);
  }

  /**
   * The scene that an Inline shows. Each Inline has one of its own, even of the same file.
   *
   * @param inline a node of type Inline
   * @return empty while the file has not arrived, when it cannot be read, and with {@code load
   *     FALSE}
   */
  Optional<X3DScene> inlinedScene(X3DNode inline);

  /**
   * Whether the scene that an Inline shows holds nodes of some types, or can come to hold them. Who
   * looks for nodes need not look into others: most inlined files are models, and many.
   *
   * @param types names of node types
   * @return false if none is in it, and none can come to be in it but at its top, of which a
   *     listener hears: it has no Script and exports nothing. True of a scene that has Inlines
   *     itself
   */
  boolean mayHold(X3DNode inline, Set<String> types);

  /**
   * Tells a listener of the changes of an Inline.
   *
   * @return removes the listener when it is closed; closing it twice, or when the node is gone,
   *     does no harm
   */
  Registration watchInline(X3DNode inline, Listener listener);

  /** A listener that is in place until this is closed. */
  interface Registration extends AutoCloseable {
    @Override
    void close();
  }
}
