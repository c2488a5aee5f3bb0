package org.selectiverenderer.authoring.structure;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.nodes.CopyNaming;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.TextEdit;

/** The texts of elements that go to another place, with the changes that they need there. */
final class Pieces {
  private final SceneDocument source;
  private final List<DocumentElement> elements;
  private final List<TextEdit> changes = new ArrayList<>();

  /**
   * @param source the document that the elements are of
   * @param elements elements none of which contains another
   */
  Pieces(SceneDocument source, List<DocumentElement> elements) {
    this.source = source;
    this.elements = elements;
  }

  /** Changes something within the elements; offsets are those of the source. */
  void change(TextEdit change) {
    changes.add(change);
  }

  /**
   * Renames the nodes whose names are taken, and the references to them within the elements.
   *
   * @param wanted other names for some of the elements, given first
   */
  void rename(UniqueNameGenerator names, Map<DocumentElement, String> wanted) {
    changes.addAll(CopyNaming.changes(source, elements, names, wanted));
  }

  /** Writes the field that takes an element where it is not the one that the element says. */
  void place(DocumentElement element, Containment.Place place, Containment containment) {
    if (place.field().isEmpty()) {
      return;
    }
    String field = place.field().get();
    Optional<String> written = element.text("containerField");
    boolean usual =
        containment
            .type(element)
            .map(
                type ->
                    ContainerFieldRules.isAlwaysDefault(type, field)
                        || field.equals(Containment.CHILDREN)
                            && type.containerField().equals(field))
            .orElse(true);
    if (written.map(now -> !now.equals(field)).orElse(!usual)) {
      change(source.layout().attribute(element, "containerField", field));
    }
  }

  /** Returns the names that the elements refer to by USE without defining them before. */
  Set<String> open() {
    Set<String> open = new HashSet<>();
    Set<String> defined = new HashSet<>();
    elements.forEach(
        element ->
            ElementScope.visitWithin(
                element,
                each -> {
                  each.use().filter(use -> !defined.contains(use)).ifPresent(open::add);
                  each.def().ifPresent(defined::add);
                }));
    return open;
  }

  /** Returns the names that are defined in the elements. */
  Set<String> defined() {
    Set<String> defined = new HashSet<>();
    elements.forEach(
        element -> ElementScope.visitWithin(element, each -> each.def().ifPresent(defined::add)));
    return defined;
  }

  /** Returns the elements' texts as lines that are indented relative to the first. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    elements.forEach(element -> lines.addAll(lines(element)));
    return lines;
  }

  /** Returns an element's text as lines that are indented relative to the first. */
  List<String> lines(DocumentElement element) {
    List<TextEdit> own =
        changes.stream()
            .filter(each -> each.from() >= element.start() && each.to() <= element.end())
            .sorted(Comparator.comparingInt(TextEdit::from))
            .map(
                each ->
                    new TextEdit(
                        each.from() - element.start(), each.to() - element.start(), each.text()))
            .toList();
    return outdented(TextEdit.applied(own, source.text(element)).toString());
  }

  /** Returns the lines without the common indentation of the lines after the first. */
  private static List<String> outdented(String text) {
    String[] lines = text.split("\r\n|\r|\n", -1);
    int common = Integer.MAX_VALUE;
    for (int i = 1; i < lines.length; i++) {
      if (!lines[i].isBlank()) {
        common = Math.min(common, indentation(lines[i]));
      }
    }
    List<String> cut = new ArrayList<>(List.of(lines[0]));
    for (int i = 1; i < lines.length; i++) {
      cut.add(lines[i].substring(Math.min(common, indentation(lines[i]))));
    }
    return cut;
  }

  private static int indentation(String line) {
    int at = 0;
    while (at < line.length() && (line.charAt(at) == ' ' || line.charAt(at) == '\t')) {
      at++;
    }
    return at;
  }

  /** Refuses an element that comes from an entity, since its text is elsewhere. */
  void written() {
    for (DocumentElement element : elements) {
      if (element.isReference()) {
        throw new EditRejectedException(
            element + " comes from an entity of the DOCTYPE; change it in the source");
      }
    }
  }
}
