package org.selectiverenderer.x3d.shader;

import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.x3d.files.Content;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.files.UrlChoice;
import org.selectiverenderer.x3d.read.ParsedNode;

/**
 * The text that a ShaderPart or ShaderProgram means: that between its tags, or else the first of
 * its urls that can be used (X3D 4.0, 31.4.7 and 31.4.8).
 */
public sealed interface ShaderChoice {
  /** The text stands in the scene. */
  record Text(ShaderText text) implements ShaderChoice {}

  /** The text is in a file of its own. */
  record File(Content content) implements ShaderChoice {}

  /**
   * There is none that can be used.
   *
   * @param problem why
   */
  record None(Problem problem) implements ShaderChoice {}

  /**
   * @param base where the relative urls of the part start
   * @param consequence what is done when there is none
   */
  static ShaderChoice of(ParsedNode part, ContentRoot root, ContentBase base, String consequence) {
    String own = part.string("sourceCode");
    if (!own.isBlank()) {
      // Some write the text between the tags as they would in a url.
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
