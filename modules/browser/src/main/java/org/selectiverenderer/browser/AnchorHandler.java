package org.selectiverenderer.browser;

import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.GroupInstance;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.loading.RunningSceneLoader;
import org.selectiverenderer.browser.nodes.group.InlineNode;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;

/**
 * Follows the link of an activated Anchor (X3D 4.0, 9.4.1): {@code #Name} binds a viewpoint of the
 * Anchor's own file; any other url names a scene that replaces the present one; {@code file#Name}
 * shows that scene from the named viewpoint.
 */
final class AnchorHandler {
  /** The changes that an Anchor can make to the world. */
  interface Target {
    /** Binds a viewpoint of the scene that the world shows. */
    void bind(Node viewpoint);

    /** Shows another scene in place of the present one. */
    void show(LoadedScene scene);
  }

  private final Scene scene;
  private final RunningSceneLoader files;
  private final ProblemCollector problems;
  private final Target target;

  AnchorHandler(Scene scene, RunningSceneLoader files, ProblemCollector problems, Target target) {
    this.scene = scene;
    this.files = files;
    this.problems = problems;
    this.target = target;
  }

  /** Follows the link of an Anchor that the user activated. */
  void follow(GroupInstance anchor) {
    follow(anchor.node(), anchor.node().strings("url"), fileOf(anchor));
  }

  /**
   * Follows a link with the given urls.
   *
   * @param node the Anchor, or the Script that follows the link
   * @param file the scene of the file that contains {@code node}
   */
  void follow(Node node, String[] urls, Scene file) {
    if (urls.length > 0 && urls[0].strip().startsWith("#")) {
      bind(file, urls[0].strip().substring(1), node);
    } else {
      files.open(
          node,
          urls,
          loaded -> {
            target.show(loaded);
            viewpointName(urls).ifPresent(name -> bind(loaded.scene(), name, node));
          });
    }
  }

  private void bind(Scene in, String name, Node anchor) {
    Optional<Node> viewpoint = in.find(name).filter(found -> found.type().is("X3DViewpointNode"));
    if (viewpoint.isPresent()) {
      target.bind(viewpoint.get());
    } else {
      problems.error(
          anchor.location(),
          "%s url '#%s' names no viewpoint of %s; the viewer stays"
              .formatted(anchor.type().name(), name, in.url()));
    }
  }

  /** Returns the scene of the file that contains an Anchor. */
  private Scene fileOf(GroupInstance anchor) {
    for (GroupInstance above = anchor.parent(); above != null; above = above.parent()) {
      if (above.node() instanceof InlineNode inline && inline.content().isPresent()) {
        return inline.content().get();
      }
    }
    return scene;
  }

  private static Optional<String> viewpointName(String[] urls) {
    for (String url : urls) {
      int fragment = url.indexOf('#');
      if (fragment >= 0 && fragment + 1 < url.length()) {
        return Optional.of(url.substring(fragment + 1).strip());
      }
    }
    return Optional.empty();
  }
}
