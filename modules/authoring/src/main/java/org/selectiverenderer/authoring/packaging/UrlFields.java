package org.selectiverenderer.authoring.packaging;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.schema.FieldReference;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Finds the fields of elements that hold urls: those of type MFString named url or so, and the
 * levels of qualities that set such a field.
 */
public final class UrlFields {
  /** Fields that the author of a prototype or script has declared, and their values. */
  private static final Set<String> OWN = Set.of("field", "fieldValue");

  /**
   * A field.
   *
   * @param attribute the attribute that holds the urls
   */
  public record UrlField(DocumentElement element, String attribute, List<String> urls) {}

  private final NodeCatalogue catalogue;
  private final Map<String, List<String>> names = new HashMap<>();

  /** Creates a finder that knows the fields of the nodes in a catalogue. */
  public UrlFields(NodeCatalogue catalogue) {
    this.catalogue = catalogue;
    names.put("ExternProtoDeclare", List.of("url"));
  }

  /** Returns the fields with urls, in document order. */
  public List<UrlField> of(List<DocumentElement> elements) {
    List<UrlField> found = new ArrayList<>();
    for (DocumentElement element : elements) {
      if (OWN.contains(element.name())) {
        if (isUrl(element.text("name").orElse(""))) {
          add(element, "value", found);
        }
        continue;
      }
      if (isLevelOfUrl(element)) {
        add(element, "value", found);
      }
      for (String name : names.computeIfAbsent(element.name(), this::fields)) {
        add(element, name, found);
      }
    }
    return found;
  }

  /** Returns whether a MetadataString is the value of a level that a url may have. */
  private static boolean isLevelOfUrl(DocumentElement element) {
    return named(element, "value")
        && element
            .parent()
            .flatMap(DocumentElement::parent)
            .filter(quality -> quality.children().stream().anyMatch(UrlFields::namesUrl))
            .isPresent();
  }

  private static boolean namesUrl(DocumentElement element) {
    return named(element, "field")
        && MFStringParser.strings(element.text("value").orElse("")).stream()
            .flatMap(text -> FieldReference.of(text).stream())
            .anyMatch(target -> isUrl(target.field()));
  }

  private static boolean named(DocumentElement element, String name) {
    return element.name().equals("MetadataString")
        && element.text("name").filter(text -> text.strip().equals(name)).isPresent();
  }

  private static void add(DocumentElement element, String attribute, List<UrlField> found) {
    String value = element.text(attribute).orElse("");
    if (!value.isBlank()) {
      List<String> urls = MFStringParser.strings(value);
      if (!urls.isEmpty()) {
        found.add(new UrlField(element, attribute, urls));
      }
    }
  }

  private List<String> fields(String node) {
    return catalogue.find(node).map(NodeType::fields).orElse(List.of()).stream()
        .filter(field -> field.type() == FieldType.MFString)
        .map(FieldDefinition::name)
        .filter(UrlFields::isUrl)
        .toList();
  }

  private static boolean isUrl(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith("url");
  }
}
