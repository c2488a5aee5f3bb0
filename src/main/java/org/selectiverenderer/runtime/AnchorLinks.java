package org.selectiverenderer.runtime;

import java.util.Optional;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.runtime.instance.GroupInstance;
import org.selectiverenderer.runtime.loading.LiveFiles;
import org.selectiverenderer.runtime.loading.LoadedScene;
import org.selectiverenderer.runtime.nodes.group.InlineNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Scene;

/**
 * Follows Anchors (X3D 4.0, 9.4.1): {@code #Name} binds a viewpoint of the Anchor's own file, any
 * other url is a scene to go to, {@code file#Name} from that viewpoint of it.
 */
final class AnchorLinks {
  /** What an Anchor can do to the world. */
  interface Target {
    /** Binds a viewpoint of the scene that is shown. */
    void bind(Node viewpoint);

    /** Shows another scene. */
    void show(LoadedScene scene);
  }

  private final Scene scene;
  private final LiveFiles files;
  private final Problems problems;
  private final Target target;

  AnchorLinks(Scene scene, LiveFiles files, Problems problems, Target target) {
    this.scene = scene;
    this.files = files;
    this.problems = problems;
    this.target = target;
  }

  /** The user activated an Anchor. */
  void follow(GroupInstance anchor) {
    follow(anchor.node(), anchor.node().strings("url"), fileOf(anchor));
  }

  /**
   * Goes where an Anchor with some urls leads.
   *
   * @param node the Anchor, or the Script that asks for it
   * @param file the scene of the file in which it stands
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

  /** The scene of the file in which an Anchor stands. */
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
