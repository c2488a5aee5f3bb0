package org.selectiverenderer.x3d.shader;

import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ResolvedUrlContent;
import org.selectiverenderer.x3d.url.UrlContent;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * The selected source text of a ShaderPart or ShaderProgram: the text between its tags, or else the
 * first of its urls that can be used (X3D 4.0, 31.4.7 and 31.4.8).
 */
public sealed interface ShaderSourceSelection {
  /** A source text in the scene. */
  record Text(ShaderSource text) implements ShaderSourceSelection {}

  /** A source text in a file of its own. */
  record File(UrlContent content) implements ShaderSourceSelection {}

  /**
   * No usable source text.
   *
   * @param problem the reason
   */
  record None(Problem problem) implements ShaderSourceSelection {}

  /**
   * Selects the source text of a part.
   *
   * @param base the base of the relative urls of the part
   * @param consequence the consequence if there is none, for the message
   */
  static ShaderSourceSelection of(
      ParsedNode part, UrlResolver root, BaseUrl base, String consequence) {
    String own = part.string("sourceCode");
    if (!own.isBlank()) {
      // some authors write a data: url between the tags
      String text = ShaderSource.in(own).orElse(own);
      return new Text(new ShaderSource(text, part.textLocation()));
    }
    String[] urls = part.strings("url");
    Optional<String> first = urls.length == 0 ? Optional.empty() : ShaderSource.in(urls[0]);
    if (first.isPresent()) {
      return new Text(new ShaderSource(first.get(), part.textLocation()));
    }
    ResolvedUrlContent file = ResolvedUrlContent.of(part, root, base, consequence);
    if (file instanceof ResolvedUrlContent.Found found) {
      return new File(found.content());
    }
    for (String url : urls) {
      Optional<String> text = ShaderSource.in(url);
      if (text.isPresent()) {
        return new Text(new ShaderSource(text.get(), part.textLocation()));
      }
    }
    return new None(((ResolvedUrlContent.None) file).problem());
  }
}
