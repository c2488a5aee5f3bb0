package org.selectiverenderer.authoring.nodes;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * The text of a scene of one node, as it is drawn in its document: with the declarations of the
 * prototypes that it has instances of, and with the nodes that it takes over by USE. For one use.
 */
public final class SceneExcerpt {
  private static final String CONTAINER = "containerField";

  private final SceneDocument document;
  private final ElementTree tree;
  private final Set<DocumentElement> declarations =
      new TreeSet<>(Comparator.comparingInt(DocumentElement::start));
  private final Set<String> known = new HashSet<>();

  private SceneExcerpt(SceneDocument document, ElementTree tree) {
    this.document = document;
    this.tree = tree;
  }

  /** Returns the scene of a node; empty while the document's text is not well-formed. */
  public static Optional<String> of(SceneDocument document, DocumentElement node) {
    return document.tree().map(tree -> new SceneExcerpt(document, tree).text(node));
  }

  private String text(DocumentElement node) {
    ElementScope.visitWithin(node, inner -> inner.def().ifPresent(known::add));
    String body = expanded(node);
    StringBuilder scene = new StringBuilder("<X3D profile='Full' version='4.0'><Scene>");
    for (DocumentElement declaration : declarations) {
      if (declarations.stream().noneMatch(o -> o != declaration && o.contains(declaration))) {
        scene.append(document.text(declaration));
      }
    }
    return scene.append(body).append("</Scene></X3D>").toString();
  }

  /** Returns the text of an element with what it takes over written out where it is first used. */
  private String expanded(DocumentElement element) {
    List<TextEdit> changes = new ArrayList<>();
    Optional<DocumentElement> own = used(element);
    if (own.isPresent()) {
      return taken(own.get(), element);
    }
    gather(element, changes);
    List<TextEdit> moved =
        changes.stream()
            .map(
                each ->
                    new TextEdit(
                        each.from() - element.start(), each.to() - element.start(), each.text()))
            .toList();
    return TextEdit.applied(moved, document.text(element)).toString();
  }

  private void gather(DocumentElement element, List<TextEdit> changes) {
    declare(element);
    for (DocumentElement child : element.children()) {
      Optional<DocumentElement> used = used(child);
      if (used.isPresent()) {
        changes.add(new TextEdit(child.start(), child.end(), taken(used.get(), child)));
      } else {
        gather(child, changes);
      }
    }
  }

  /** Returns the node that an element takes over, unless the scene has it already. */
  private Optional<DocumentElement> used(DocumentElement element) {
    return element
        .use()
        .filter(name -> !known.contains(name))
        .flatMap(name -> tree.named(name, element))
        .filter(node -> !node.contains(element));
  }

  private String taken(DocumentElement node, DocumentElement use) {
    ElementScope.visitWithin(node, inner -> inner.def().ifPresent(known::add));
    String text = expanded(node);
    Optional<String> container = use.text(CONTAINER);
    if (container.isEmpty() || container.equals(node.text(CONTAINER))) {
      return text;
    }
    try {
      TextEdit change = document.layout().attribute(node, CONTAINER, container.get());
      TextEdit own =
          new TextEdit(change.from() - node.start(), change.to() - node.start(), change.text());
      return TextEdit.applied(List.of(own), text).toString();
    } catch (EditRejectedException e) { // from an entity, which says the field as it is
      return text;
    }
  }

  /** Adds the declaration of an instance, and those of the instances in its body. */
  private void declare(DocumentElement element) {
    if (!element.name().equals("ProtoInstance")) {
      return;
    }
    element
        .text("name")
        .flatMap(name -> tree.prototype(name.strip(), element))
        .filter(declaration -> declaration.parent().isPresent() && declarations.add(declaration))
        .ifPresent(declaration -> declaration.visit(this::declare));
  }
}
