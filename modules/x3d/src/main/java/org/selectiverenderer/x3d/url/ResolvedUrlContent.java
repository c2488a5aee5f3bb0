package org.selectiverenderer.x3d.url;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.catalogue.NodeView;

/** The content of a node's {@code url} field: that of the first of its urls that can be read. */
public sealed interface ResolvedUrlContent {
  /** The maximum number of characters of a url in a message. */
  int SHOWN = 80;

  /** The content of a url. */
  record Found(UrlContent content) implements ResolvedUrlContent {}

  /**
   * No url can be read.
   *
   * @param problem the reason for the first url and the consequence; only an information for a node
   *     without any url, as an application may set it later
   */
  record None(Problem problem) implements ResolvedUrlContent {}

  /** Selects as {@link #of(NodeView, UrlResolver, BaseUrl, String)}, relative to a folder. */
  static ResolvedUrlContent of(NodeView node, UrlResolver root, Path folder, String consequence) {
    return of(node, root, BaseUrl.folder(folder), consequence);
  }

  /**
   * Selects the first url that can be read. Blocks for the network if the host is allowed.
   *
   * @param node a node with a field {@code url}, such as an Inline or a texture
   * @param base the base of the node's relative urls
   * @param consequence the consequence if there is none, such as "the Inline is left out"
   */
  static ResolvedUrlContent of(NodeView node, UrlResolver root, BaseUrl base, String consequence) {
    @Nullable String reason = null;
    for (String url : node.strings("url")) {
      UrlResolver.Target target = root.resolve(url, base);
      if (target instanceof UrlResolver.Target.Found found) {
        return new Found(found.content());
      }
      if (reason == null && target instanceof UrlResolver.Target.Refused refused) {
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

  /** Returns a url for messages, truncated if it is long. */
  static String shown(String url) {
    return url.length() <= SHOWN ? url : url.substring(0, SHOWN) + "…";
  }
}
