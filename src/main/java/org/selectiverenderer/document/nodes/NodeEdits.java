package org.selectiverenderer.document.nodes;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.EditRefused;
import org.selectiverenderer.document.FreeNames;
import org.selectiverenderer.document.Layout;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextChange;
import org.selectiverenderer.x3d.source.WrittenAttribute;

/**
 * Makes edits that fit every node. Each is for the document as it is now and is made by {@link
 * SceneDocument#perform}. All throw {@link EditRefused} with a sentence for the author where the
 * edit would do harm or the text is not well formed.
 */
public final class NodeEdits {
  /** What every scene has. */
  private static final Set<String> KEPT = Set.of("X3D", "Scene");

  private static final List<String> GROUPS = List.of("Transform", "Group", "StaticGroup");

  private final SceneDocument document;

  public NodeEdits(SceneDocument document) {
    this.document = document;
  }

  private ElementTree tree() {
    return document
        .tree()
        .orElseThrow(
            () ->
                new EditRefused(
                    document
                            .fault()
                            .map(fault -> fault.location() + ": " + fault.message())
                            .orElse(document.name())
                        + "; correct it in the source view first"));
  }

  /** Whether an element may be taken out: all but those that every scene has. */
  public static boolean removable(DocumentElement element) {
    return element.parent().isPresent() && !KEPT.contains(element.name());
  }

  private static void removableOnly(DocumentElement element) {
    if (!removable(element)) {
      throw new EditRefused("Every scene has the element " + element.name());
    }
  }

  /** A name that no node has yet, made of the one wanted. */
  public String free(String wanted) {
    return new FreeNames(tree()).free(wanted);
  }

  /**
   * Whether a node can be given a name.
   *
   * @throws EditRefused if the name is none, or another node has it
   */
  public void check(String name) {
    if (!FreeNames.allowed(name)) {
      throw new EditRefused(
          "'%s' is no name of a node; it begins with a letter and has no spaces or quotes, such as %s"
              .formatted(name, FreeNames.identifier(name.isBlank() ? "Area" : "N" + name.strip())));
    }
    ElementTree tree = tree();
    if (tree.named(name).isPresent()) {
      throw new EditRefused(
          "%s is the name of the %s in line %d already; choose another one"
              .formatted(
                  name,
                  tree.named(name).get().name(),
                  document.location(tree.named(name).get().start()).line()));
    }
  }

  /**
   * Gives a node another name, and all that speak of it: USE, ROUTE, IMPORT. An EXPORT goes on
   * giving it to other files by the name that they know.
   */
  public Edit rename(DocumentElement node, String to) {
    String name = to.strip();
    String from = node.def().orElse("");
    if (name.equals(from)) {
      return new Edit("Rename " + from, List.of());
    }
    check(name);
    node.use()
        .ifPresent(
            other -> {
              throw new EditRefused("this stands for %s (USE); rename that one".formatted(other));
            });
    Layout layout = document.layout();
    NodeReferences references = NodeReferences.to(node);
    List<TextChange> changes = new ArrayList<>();
    changes.add(layout.attribute(node, "DEF", name));
    references.uses().forEach(use -> changes.add(layout.attribute(use, "USE", name)));
    for (DocumentElement route : references.routes()) {
      for (String end : List.of("fromNode", "toNode")) {
        if (route.text(end).filter(from::equals).isPresent()) {
          changes.add(layout.attribute(route, end, name));
        }
      }
    }
    references.imports().forEach(in -> changes.add(layout.attribute(in, "inlineDEF", name)));
    for (DocumentElement export : references.exports()) {
      changes.add(layout.attribute(export, "localDEF", name));
      if (export.text("AS").isEmpty()) {
        changes.add(layout.attribute(export, "AS", from));
      }
    }
    return new Edit(
        from.isEmpty() ? "Name " + name : "Rename %s to %s".formatted(from, name), changes);
  }

  /** Puts a copy of a node behind it, with new names for all that is named in it. */
  public Edit copy(DocumentElement node, String name) {
    return new Edit("Copy " + called(node), List.of(copied(node, name, List.of())));
  }

  /**
   * The change that puts a copy of a node behind it.
   *
   * @param name of the copy
   * @param more changes that only the copy has; offsets are those of the original
   */
  public TextChange copied(DocumentElement node, String name, List<TextChange> more) {
    check(name);
    removableOnly(node);
    Layout layout = document.layout();
    if (node.use().isPresent()) {
      throw new EditRefused("this stands for %s (USE); copy that one".formatted(node.use().get()));
    }
    FreeNames free = new FreeNames(tree());
    free.unused(name);
    Map<String, String> renamed = new HashMap<>();
    node.def().ifPresent(def -> renamed.put(def, name));
    node.visit(each -> each.def().ifPresent(def -> renamed.computeIfAbsent(def, free::unused)));
    List<TextChange> changes = new ArrayList<>(more);
    if (node.def().isEmpty()) {
      changes.add(layout.attribute(node, "DEF", name));
    }
    node.visit(
        each -> {
          for (String attribute : List.of("DEF", "USE", "fromNode", "toNode")) {
            each.tag()
                .attribute(attribute)
                .filter(written -> renamed.containsKey(written.value()))
                .ifPresent(written -> changes.add(replaced(written, renamed.get(written.value()))));
          }
        });
    changes.sort(Comparator.comparingInt(TextChange::from));
    List<TextChange> moved =
        changes.stream()
            .map(
                each ->
                    new TextChange(
                        each.from() - node.start(), each.to() - node.start(), each.text()))
            .toList();
    String text = TextChange.applied(moved, document.text(node)).toString();
    return layout.insertAfter(node, List.of(text));
  }

  private static TextChange replaced(WrittenAttribute attribute, String value) {
    return new TextChange(attribute.valueFrom(), attribute.valueTo(), value);
  }

  /**
   * Takes a node out, with the routes from and to it, and with the groups around it that hold
   * nothing else.
   *
   * @throws EditRefused if something else stands for it or for a part of it by USE
   */
  public Edit remove(DocumentElement node) {
    return new Edit("Delete " + called(node), removal(lonely(node)));
  }

  /** The first element that speaks of a node by its name; empty for none. */
  public Optional<DocumentElement> reference(DocumentElement node) {
    NodeReferences found = NodeReferences.to(node);
    return Stream.of(found.uses(), found.routes(), found.exports(), found.imports())
        .flatMap(List::stream)
        .min(Comparator.comparingInt(DocumentElement::start));
  }

  /**
   * The changes that take out just a node and what speaks of it.
   *
   * @throws EditRefused if something else stands for it by USE, or every scene has it
   */
  public List<TextChange> removal(DocumentElement node) {
    tree();
    removableOnly(node);
    Layout layout = document.layout();
    List<TextChange> changes = new ArrayList<>(released(node));
    changes.add(layout.remove(node));
    return changes;
  }

  /**
   * The changes that take out the routes, imports and exports that speak of a node.
   *
   * @throws EditRefused if something stands for it by USE
   */
  public List<TextChange> released(DocumentElement node) {
    return released(NodeReferences.into(node));
  }

  /** The same for what speaks of just the node, not of what is in it. */
  public List<TextChange> releasedItself(DocumentElement node) {
    return released(NodeReferences.to(node));
  }

  private List<TextChange> released(NodeReferences references) {
    if (!references.uses().isEmpty()) {
      DocumentElement use = references.uses().get(0);
      throw new EditRefused(
          "%s is also shown elsewhere (USE in line %d), which would show nothing then; delete that first"
              .formatted(use.use().orElse(""), document.location(use.start()).line()));
    }
    Layout layout = document.layout();
    Set<DocumentElement> gone = new LinkedHashSet<>(references.routes());
    gone.addAll(references.exports());
    gone.addAll(references.imports());
    return gone.stream().map(layout::remove).toList();
  }

  /** The outermost group around a node that has nothing else in it, or the node itself. */
  private DocumentElement lonely(DocumentElement node) {
    DocumentElement at = node;
    while (at.parent().isPresent() && only(at.parent().get())) {
      at = at.parent().get();
    }
    return at;
  }

  private boolean only(DocumentElement group) {
    if (!GROUPS.contains(group.name()) || group.children().size() != 1) {
      return false;
    }
    NodeReferences references = NodeReferences.to(group);
    boolean spokenOf =
        !references.uses().isEmpty()
            || !references.routes().isEmpty()
            || !references.exports().isEmpty();
    DocumentElement child = group.children().get(0);
    String around =
        document.text(group.tagEnd(), child.start()) + document.text(child.end(), group.end());
    return !spokenOf && !around.contains("<!--");
  }

  static String called(DocumentElement node) {
    return node.def().or(node::use).orElse(node.name());
  }
}
