package org.selectiverenderer.authoring.qualities;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;

/** Finds the nodes that belong to an object alone, and gives them names by which fields are set. */
final class NodeNaming {
  private final SceneDocument document;
  private final ElementTree tree;
  private final UniqueNameGenerator free;
  private final ProblemCollector problems;

  NodeNaming(SceneDocument document, ElementTree tree, ProblemCollector problems) {
    this.document = document;
    this.tree = tree;
    this.free = new UniqueNameGenerator(tree);
    this.problems = problems;
  }

  /**
   * Returns the nodes of a type in an object that no other object uses; one that is shared is
   * reported, since setting its field would change the others.
   */
  List<DocumentElement> own(DocumentElement object, String type) {
    List<DocumentElement> found = new ArrayList<>();
    object.visit(
        element -> {
          if (element.name().equals(type)) {
            if (shared(element, object)) {
              problems.warning(
                  element.location(),
                  "this %s is used outside of %s too, and stays as it is"
                      .formatted(type, object.def().orElse("the object")));
            } else if (element.use().isEmpty()) {
              found.add(element);
            }
          }
        });
    return found;
  }

  private boolean shared(DocumentElement element, DocumentElement object) {
    if (element.use().isPresent()) {
      return tree.named(element.use().get(), element).filter(object::contains).isEmpty();
    }
    boolean[] outside = {false};
    // What is around it may be used as well.
    for (DocumentElement at = element;
        at != object && at.parent().isPresent() && !outside[0];
        at = at.parent().get()) {
      at.def().ifPresent(def -> outside[0] |= usedOutside(def, object));
    }
    return outside[0];
  }

  private boolean usedOutside(String def, DocumentElement object) {
    boolean[] found = {false};
    if (tree.used(def)) {
      tree.root()
          .visit(
              element ->
                  found[0] |=
                      element.use().filter(def::equals).isPresent() && !object.contains(element));
    }
    return found[0];
  }

  /** Returns the name of a node; one without gets a name by a change. */
  String of(DocumentElement element, String wanted, List<TextEdit> changes) {
    if (element.def().isPresent()) {
      return element.def().get();
    }
    String name = free.free(wanted);
    changes.add(document.layout().attribute(element, "DEF", name));
    return name;
  }

  /** Returns a name that no node has. */
  String unused(String wanted) {
    return free.free(wanted);
  }
}
