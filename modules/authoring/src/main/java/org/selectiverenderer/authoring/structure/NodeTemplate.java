package org.selectiverenderer.authoring.structure;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * The X3D source of something that can be inserted: a node with what it needs to be seen.
 *
 * @param name the template's name in {@code templates.xml}, or the name of a node type
 * @param text X3D source
 */
public record NodeTemplate(String name, String text) {
  private static final String FILE = "templates.xml";

  /**
   * Reads the templates that the program brings along.
   *
   * @throws IllegalStateException if they are missing, which is an error of the build
   */
  static Map<String, NodeTemplate> all() {
    try (InputStream in = NodeTemplate.class.getResourceAsStream(FILE)) {
      if (in == null) {
        throw new IllegalStateException("the program's resource " + FILE + " is missing");
      }
      SceneDocument document = SceneDocument.of(FILE, in.readAllBytes());
      Map<String, NodeTemplate> all = new LinkedHashMap<>();
      document
          .tree()
          .orElseThrow(() -> new IllegalStateException(FILE + " is not well formed"))
          .root()
          .children()
          .forEach(
              each -> {
                String name = each.text("name").orElseThrow();
                all.put(name, new NodeTemplate(name, text(document, each)));
              });
      return all;
    } catch (IOException e) {
      throw new IllegalStateException(FILE + " cannot be read", e);
    }
  }

  private static String text(SceneDocument document, DocumentElement template) {
    return document.text(template.children().get(0));
  }

  /** Returns the template of a node type that has none of its own: the node with its defaults. */
  static NodeTemplate plain(String type) {
    return new NodeTemplate(type, "<" + type + "/>");
  }

  /**
   * Returns the template with another value of an attribute.
   *
   * @param element the element of the template that has it
   */
  public NodeTemplate with(String element, String attribute, String value) {
    try {
      SceneDocument document = SceneDocument.of(FILE, text.getBytes(StandardCharsets.UTF_8));
      Optional<TextEdit> change =
          document.tree().stream()
              .flatMap(tree -> find(tree.root(), element).stream())
              .map(found -> document.layout().attribute(found, attribute, value))
              .findFirst();
      return change
          .map(edit -> new NodeTemplate(name, TextEdit.applied(List.of(edit), text).toString()))
          .orElse(this);
    } catch (IOException e) {
      throw new IllegalStateException(name + " cannot be read", e);
    }
  }

  /**
   * Returns the template at another place: the numbers of a position that an element has are
   * shifted; without the element it stays as it is.
   *
   * @param decimals to which the sums are rounded
   */
  public NodeTemplate shifted(String element, String attribute, double[] shift, int decimals) {
    Matcher position =
        Pattern.compile("<%s [^>]*\\b%s='([^']*)'".formatted(element, attribute)).matcher(text);
    String[] old = position.find() ? position.group(1).strip().split("\\s+") : new String[0];
    if (old.length != shift.length) {
      return this;
    }
    StringBuilder now = new StringBuilder();
    for (int i = 0; i < old.length; i++) {
      now.append(i == 0 ? "" : " ")
          .append(DecimalFormatter.rounded(Double.parseDouble(old[i]) + shift[i], decimals));
    }
    return with(element, attribute, now.toString());
  }

  private static Optional<DocumentElement> find(DocumentElement in, String element) {
    return in.name().equals(element)
        ? Optional.of(in)
        : in.children().stream().flatMap(each -> find(each, element).stream()).findFirst();
  }
}
