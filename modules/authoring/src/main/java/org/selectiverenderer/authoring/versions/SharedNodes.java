package org.selectiverenderer.authoring.versions;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.nodes.Reindenter;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * The nodes of an object that the rest of the scene uses too, by USE, as files from VRML97 share
 * their Appearances. When the object goes to files of its own, which are other scopes of names, the
 * first USE in the scene becomes the node itself; the versions have copies. A USE of the object as
 * a whole becomes a USE of its Switch.
 */
final class SharedNodes {
  private static final String CONTAINER = "containerField";

  private final ElementNodeMapping scene;
  private final List<DocumentElement> elements;
  private final SourceFormatter layout;
  private final Map<String, DocumentElement> given = new HashMap<>();
  private final Set<String> moved = new HashSet<>();

  /**
   * @param elements the elements that the Switch replaces
   */
  SharedNodes(ElementNodeMapping scene, List<DocumentElement> elements) {
    this.scene = scene;
    this.elements = List.copyOf(elements);
    this.layout = scene.snapshot().layout();
    for (DocumentElement element : elements) {
      ElementScope.visitWithin(
          element, inner -> inner.def().ifPresent(def -> given.putIfAbsent(def, inner)));
    }
  }

  /** Returns the elements outside of the object that use nodes in it, in document order. */
  private List<DocumentElement> uses() {
    List<DocumentElement> found = new ArrayList<>();
    if (!given.isEmpty()) {
      ElementScope.visit(
          elements.get(0),
          other -> {
            boolean of = other.use().filter(given::containsKey).isPresent();
            if (of && elements.stream().noneMatch(element -> element.contains(other))) {
              found.add(other);
            }
          });
    }
    return found;
  }

  /**
   * Returns whether an element takes over the object as a whole, so that a Switch may stand there.
   */
  private boolean isWhole(DocumentElement use) {
    DocumentElement node = given.get(use.use().orElse(""));
    boolean child =
        use.parent().filter(parent -> !parent.name().equals("fieldValue")).isPresent()
            && use.text(CONTAINER).orElse("children").equals("children");
    return elements.size() == 1 && node == elements.get(0) && child;
  }

  /**
   * Returns the changes that leave the scene its nodes; for one use.
   *
   * @param choice DEF name of the Switch that replaces the object; empty for one without
   */
  List<TextEdit> changes(String choice) {
    List<TextEdit> changes = new ArrayList<>();
    for (DocumentElement use : uses()) {
      String name = use.use().orElseThrow();
      if (!choice.isEmpty() && isWhole(use)) {
        String tag = "<Switch" + SourceFormatter.written("USE", choice, layout.quote(use)) + "/>";
        changes.add(new TextEdit(use.start(), use.end(), tag));
      } else if (!moved.contains(name)) {
        String text = text(given.get(name), use.text(CONTAINER));
        changes.add(new TextEdit(use.start(), use.end(), indented(text, given.get(name), use)));
      }
    }
    return changes;
  }

  /** Returns the text of a node that is not moved yet, and notes it and what it brings along. */
  private String text(DocumentElement node, Optional<String> container) {
    List<TextEdit> changes = new ArrayList<>();
    contain(node, container).ifPresent(changes::add);
    moved.add(node.def().orElseThrow());
    node.children().forEach(child -> adapt(child, changes));
    List<TextEdit> own =
        changes.stream()
            .map(
                each ->
                    new TextEdit(each.from() - node.start(), each.to() - node.start(), each.text()))
            .toList();
    String whole = scene.snapshot().text().substring(node.start(), node.end());
    return TextEdit.applied(own, whole).toString();
  }

  private Optional<TextEdit> contain(DocumentElement node, Optional<String> container) {
    Optional<SourceAttribute> written = node.tag().attribute(CONTAINER);
    if (container.isPresent()) {
      return Optional.of(layout.attribute(node, CONTAINER, container.get()));
    }
    return written.map(old -> TextEdit.remove(old.from() - 1, old.valueTo() + 1));
  }

  private void adapt(DocumentElement inner, List<TextEdit> changes) {
    String def = inner.def().orElse("");
    String use = inner.use().orElse("");
    if (moved.contains(def)) {
      String container =
          inner
              .text(CONTAINER)
              .map(field -> SourceFormatter.written(CONTAINER, field, layout.quote(inner)))
              .orElse("");
      String tag =
          "<"
              + inner.name()
              + SourceFormatter.written("USE", def, layout.quote(inner))
              + container
              + "/>";
      changes.add(new TextEdit(inner.start(), inner.end(), tag));
    } else if (given.containsKey(use) && !moved.contains(use)) {
      String text = text(given.get(use), inner.text(CONTAINER));
      changes.add(new TextEdit(inner.start(), inner.end(), indented(text, given.get(use), inner)));
    } else {
      if (!def.isEmpty()) {
        moved.add(def);
      }
      inner.children().forEach(child -> adapt(child, changes));
    }
  }

  /** Indents the further lines of a node's text as at another place. */
  private String indented(String text, DocumentElement from, DocumentElement to) {
    String before = layout.indentation(from);
    String now = layout.indentation(to);
    if (now.startsWith(before)) {
      return Reindenter.deeper(text, now.substring(before.length()));
    }
    return before.startsWith(now)
        ? Reindenter.shallower(text, before.substring(now.length()))
        : text;
  }
}
