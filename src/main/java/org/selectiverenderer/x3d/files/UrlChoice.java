package org.selectiverenderer.x3d.files;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** The file that a node's {@code url} means: the first of its urls that can be read. */
public sealed interface UrlChoice {
  /** Characters of a url that a message shows. */
  int SHOWN = 80;

  record File(Path path) implements UrlChoice {}

  /**
   * None can be.
   *
   * @param problem why the first cannot, and what is done about it; a node without any url, which
   *     an application may give it one day, is worth a remark only
   */
  record None(Problem problem) implements UrlChoice {}

  /**
   * @param node an Inline or a texture
   * @param consequence what is done when there is none, such as "the Inline is left out"
   */
  static UrlChoice of(NodeView node, ContentRoot root, Path folder, String consequence) {
    @Nullable String reason = null;
    for (String url : node.strings("url")) {
      ContentRoot.Target target = root.resolve(url, folder);
      if (target instanceof ContentRoot.Target.File file) {
        return new File(file.path());
      }
      if (reason == null && target instanceof ContentRoot.Target.Refused refused) {
        reason = "url '%s' %s".formatted(cut(url), refused.reason());
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
  private static String cut(String url) {
    return url.length() <= SHOWN ? url : url.substring(0, SHOWN) + "…";
  }
}
