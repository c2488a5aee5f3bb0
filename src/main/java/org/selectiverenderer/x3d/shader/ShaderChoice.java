package org.selectiverenderer.x3d.shader;

import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * The selected source text of a ShaderPart or ShaderProgram: the text between its tags, or else the
 * first of its urls that can be used (X3D 4.0, 31.4.7 and 31.4.8).
 */
public sealed interface ShaderChoice {
  /** A source text in the scene. */
  record Text(ShaderText text) implements ShaderChoice {}

  /** A source text in a file of its own. */
  record File(Content content) implements ShaderChoice {}

  /**
   * No usable source text.
   *
   * @param problem the reason
   */
  record None(Problem problem) implements ShaderChoice {}

  /**
   * Selects the source text of a part.
   *
   * @param base the base of the relative urls of the part
   * @param consequence the consequence if there is none, for the message
   */
  static ShaderChoice of(ParsedNode part, ContentRoot root, ContentBase base, String consequence) {
    String own = part.string("sourceCode");
    if (!own.isBlank()) {
      // some authors write a data: url between the tags
      String text = ShaderText.in(own).orElse(own);
      return new Text(new ShaderText(text, part.textLocation()));
    }
    String[] urls = part.strings("url");
    Optional<String> first = urls.length == 0 ? Optional.empty() : ShaderText.in(urls[0]);
    if (first.isPresent()) {
      return new Text(new ShaderText(first.get(), part.textLocation()));
    }
    UrlChoice file = UrlChoice.of(part, root, base, consequence);
    if (file instanceof UrlChoice.Found found) {
      return new File(found.content());
    }
    for (String url : urls) {
      Optional<String> text = ShaderText.in(url);
      if (text.isPresent()) {
        return new Text(new ShaderText(text.get(), part.textLocation()));
      }
    }
    return new None(((UrlChoice.None) file).problem());
  }
}
