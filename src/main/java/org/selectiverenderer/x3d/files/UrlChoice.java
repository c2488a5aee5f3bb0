package org.selectiverenderer.x3d.files;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** What a node's {@code url} means: the first of its urls that is allowed and there. */
public sealed interface UrlChoice {
  /** Characters of a url that a message shows. */
  int SHOWN = 80;

  /** What a url means. */
  record Found(Content content) implements UrlChoice {}

  /**
   * None can be read.
   *
   * @param problem why the first cannot, and what is done about it; a node without any url, which
   *     an application may give it one day, is worth a remark only
   */
  record None(Problem problem) implements UrlChoice {}

  /** As {@link #of(NodeView, ContentRoot, ContentBase, String)}, for a file in a folder. */
  static UrlChoice of(NodeView node, ContentRoot root, Path folder, String consequence) {
    return of(node, root, ContentBase.folder(folder), consequence);
  }

  /**
   * Waits for the network where the user allows it.
   *
   * @param node with a field {@code url}, such as an Inline or a texture
   * @param base where the relative urls of the node start
   * @param consequence what is done when there is none, such as "the Inline is left out"
   */
  static UrlChoice of(NodeView node, ContentRoot root, ContentBase base, String consequence) {
    @Nullable String reason = null;
    for (String url : node.strings("url")) {
      ContentRoot.Target target = root.resolve(url, base);
      if (target instanceof ContentRoot.Target.Found found) {
        return new Found(found.content());
      }
      if (reason == null && target instanceof ContentRoot.Target.Refused refused) {
        reason = "url '%s' %s".formatted(shown(url), refused.reason());
      }
    }
    return new None(
        new Problem(
            reason == null ? Problem.Severity.INFO : Problem.Severity.ERROR,
            node.location(),
            "%s %s; %s"
                .formatted(
                    node.type().name(), reason == null ? "has no url" : reason, consequence)));
  }

  /** A url, or the beginning of a long one, for messages. */
  static String shown(String url) {
    return url.length() <= SHOWN ? url : url.substring(0, SHOWN) + "…";
  }
}
