package org.selectiverenderer.control;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.sai.InlineSceneAccess;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;

/**
 * The root nodes of the scene in an Inline: the scene may arrive late, be replaced, and be unloaded
 * and loaded again with {@code load}.
 */
final class InlineChildSource extends ChildSource implements InlineSceneAccess.Listener {
  private final X3DNode inline;
  private final InlineSceneAccess browser;
  private final SceneScope outer;
  private final Set<String> wanted;
  private final int number;
  private @Nullable SceneScope inner;

  /** Whether the scene last looked at held nothing to be found, so that nothing was read. */
  private boolean plain;

  private InlineSceneAccess.@Nullable Registration registration;

  /**
   * @param wanted names of node types: a scene that holds none of them is ignored
   */
  InlineChildSource(
      SceneScope outer,
      X3DNode inline,
      InlineSceneAccess browser,
      Set<String> wanted,
      Listener listener) {
    super(listener);
    this.outer = outer;
    this.inline = inline;
    this.browser = browser;
    this.wanted = wanted;
    this.number = outer.nextInline();
  }

  @Override
  SceneScope scope() {
    return inner == null ? outer : inner; // Without an inner scene there are no nodes.
  }

  @Override
  List<X3DNode> look() {
    Optional<X3DScene> content = browser.inlinedScene(inline);
    if (content.isEmpty()) {
      plain = false;
      return List.of();
    }
    if (!plain && !browser.mayHold(inline, wanted)) {
      plain = true; // Most Inlines are plain models, for which nothing is kept.
      return List.of();
    } // What was plain and has changed has other root nodes than its file, or another file.
    if (inner == null || !inner.scene().equals(content.get())) {
      inner = outer.inner(inline, number, content.get());
    }
    return inner.opened(content.get().getRootNodes());
  }

  @Override
  void listen() {
    registration = browser.watchInline(inline, this);
  }

  @Override
  public void inlinedSceneChanged(X3DNode node, double time) {
    changed(time);
  }

  @Override
  void close() {
    if (registration != null) {
      registration.close();
    }
  }
}
