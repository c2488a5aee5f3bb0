package org.selectiverenderer.authoring.nodes;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates edits that apply to every node: rename, copy, remove. Each edit is for the document's
 * present state and is performed by {@link SceneDocument#perform}. All throw {@link
 * EditRejectedException} with a sentence for the author where the edit would break the scene or the
 * text is not well-formed.
 */
public final class NodeEdits {
  /** The mandatory elements of a scene. */
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
                new EditRejectedException(
                    document
                            .fault()
                            .map(fault -> fault.location() + ": " + fault.message())
                            .orElse(document.name())
                        + "; correct it in the source view first"));
  }

  /** Returns whether an element may be removed: all but the mandatory ones. */
  public static boolean removable(DocumentElement element) {
    return element.parent().isPresent() && !KEPT.contains(element.name());
  }

  private static void removableOnly(DocumentElement element) {
    if (!removable(element)) {
      throw new EditRejectedException(
          "Every scene needs its element " + element.name() + "; it stays");
    }
  }

  /** Returns a DEF name for the scene that is derived from the wanted one and unused there. */
  public String free(String wanted) {
    return free(wanted, tree().root());
  }

  /** Returns a DEF name that is derived from the wanted one and unused in the scope of a node. */
  public String free(String wanted, DocumentElement at) {
    return new UniqueNameGenerator(tree(), at).free(wanted);
  }

  /**
   * Checks that a name is valid and unused in the scene.
   *
   * @throws EditRejectedException if the name is invalid, or another node has it
   */
  public void check(String name) {
    check(name, tree().root());
  }

  /**
   * Checks that a name is valid and unused in the scope of a node.
   *
   * @throws EditRejectedException if the name is invalid, or another node has it
   */
  public void check(String name, DocumentElement at) {
    if (!UniqueNameGenerator.allowed(name)) {
      throw new EditRejectedException(
          "'%s' is not a valid DEF name; use a letter first and no spaces or quotes, such as %s"
              .formatted(name, proposal(name.strip())));
    }
    Optional<DocumentElement> other = tree().named(name, at);
    if (other.isPresent()) {
      throw new EditRejectedException(
          "%s is the name of the %s in line %d already; choose another one"
              .formatted(name, other.get().name(), document.location(other.get().start()).line()));
    }
  }

  private static String proposal(String name) {
    String close = UniqueNameGenerator.identifier(name.isEmpty() ? "Area" : name);
    return UniqueNameGenerator.allowed(close) ? close : "N" + close;
  }

  /**
   * Renames a node and all references to it: USE, ROUTE, IMPORT. An EXPORT keeps the name under
   * which other files know the node. Metadata that is called after the node follows ({@link
   * MetadataNaming}).
   */
  public Edit rename(DocumentElement node, String to) {
    String name = to.strip();
    String from = node.def().orElse("");
    if (name.equals(from)) {
      return new Edit("Rename " + from, List.of());
    }
    check(name, node);
    node.use()
        .ifPresent(
            other -> {
              throw new EditRejectedException(
                  "this is a USE of %s; rename the original".formatted(other));
            });
    List<TextEdit> changes =
        NodeRenaming.changes(document.layout(), new UniqueNameGenerator(tree(), node), node, name);
    return new Edit(
        from.isEmpty() ? "Name " + name : "Rename %s to %s".formatted(from, name), changes);
  }

  /** Inserts a copy of a node after it, with new DEF names for all named nodes in it. */
  public Edit copy(DocumentElement node, String name) {
    return new Edit("Copy " + called(node), List.of(copied(node, name, List.of())));
  }

  /**
   * Returns the change that inserts a copy of a node after it.
   *
   * @param name name of the copy
   * @param more changes to be made in the copy only; offsets are those of the original
   */
  public TextEdit copied(DocumentElement node, String name, List<TextEdit> more) {
    check(name, node);
    removableOnly(node);
    SourceFormatter layout = document.layout();
    if (node.use().isPresent()) {
      throw new EditRejectedException(
          "this is a USE of %s; copy the original".formatted(node.use().get()));
    }
    UniqueNameGenerator free = new UniqueNameGenerator(tree(), node);
    free.unused(name);
    List<TextEdit> changes = new ArrayList<>(more);
    changes.addAll(CopyNaming.changes(document, List.of(node), free, Map.of(node, name)));
    changes.sort(Comparator.comparingInt(TextEdit::from));
    List<TextEdit> moved =
        changes.stream()
            .map(
                each ->
                    new TextEdit(each.from() - node.start(), each.to() - node.start(), each.text()))
            .toList();
    String text = TextEdit.applied(moved, document.text(node)).toString();
    return layout.insertAfter(node, List.of(text));
  }

  /**
   * Removes a node, its routes, and the enclosing groups that contain nothing else.
   *
   * @throws EditRejectedException if it or a node in it is referenced by USE
   */
  public Edit remove(DocumentElement node) {
    return new Edit("Delete " + called(node), removal(lonely(node)));
  }

  /** Returns the first element that refers to a node by its name; empty for none. */
  public Optional<DocumentElement> reference(DocumentElement node) {
    NodeReferences found = NodeReferences.to(node);
    return Stream.of(found.uses(), found.routes(), found.exports(), found.imports())
        .flatMap(List::stream)
        .min(Comparator.comparingInt(DocumentElement::start));
  }

  /**
   * Returns the changes that remove a node and the references to it.
   *
   * @throws EditRejectedException if it is referenced by USE, or is mandatory
   */
  public List<TextEdit> removal(DocumentElement node) {
    removableOnly(node);
    withoutInstances(List.of(node));
    SourceFormatter layout = document.layout();
    List<TextEdit> changes = new ArrayList<>(released(node));
    changes.add(layout.remove(node));
    return changes;
  }

  /** Refuses to remove prototypes that would leave instances without one. */
  private void withoutInstances(List<DocumentElement> nodes) {
    ElementTree tree = tree();
    for (DocumentElement instance : tree.instances()) {
      Optional<DocumentElement> declaration =
          inside(nodes, instance)
              ? Optional.empty()
              : instance.text("name").flatMap(name -> tree.prototype(name.strip(), instance));
      if (declaration.filter(found -> inside(nodes, found)).isPresent()) {
        throw new EditRejectedException(
            "the prototype %s has an instance in line %d; delete it first"
                .formatted(
                    declaration.get().text("name").orElse(""),
                    document.location(instance.start()).line()));
      }
    }
  }

  /**
   * Returns the changes that remove several nodes and the references to them.
   *
   * @param nodes nodes none of which contains another
   * @throws EditRejectedException if one is mandatory, or referenced by USE from outside of them
   */
  public List<TextEdit> removal(List<DocumentElement> nodes) {
    tree();
    nodes.forEach(NodeEdits::removableOnly);
    withoutInstances(nodes);
    SourceFormatter layout = document.layout();
    List<TextEdit> changes = new ArrayList<>();
    references(nodes).forEach(each -> changes.add(layout.remove(each)));
    nodes.forEach(each -> changes.add(layout.remove(each)));
    return changes;
  }

  /**
   * Returns the ROUTE, IMPORT and EXPORT statements outside of nodes that name one of them or their
   * descendants.
   *
   * @throws EditRejectedException if a node is referenced by USE from outside of them
   */
  public Set<DocumentElement> references(List<DocumentElement> nodes) {
    Predicate<DocumentElement> outside = each -> !inside(nodes, each);
    Set<DocumentElement> found = new LinkedHashSet<>();
    for (DocumentElement node : nodes) {
      NodeReferences references = NodeReferences.into(node);
      references.uses().stream().filter(outside).findFirst().ifPresent(this::usedElsewhere);
      Stream.of(references.routes(), references.exports(), references.imports())
          .flatMap(List::stream)
          .filter(outside)
          .forEach(found::add);
    }
    return found;
  }

  /**
   * Returns the changes that remove the routes, imports and exports of a node and its descendants.
   *
   * @throws EditRejectedException if it is referenced by USE
   */
  public List<TextEdit> released(DocumentElement node) {
    return released(NodeReferences.into(node));
  }

  /**
   * Returns the changes that remove the routes, imports and exports of a node itself, not of its
   * descendants.
   */
  public List<TextEdit> releasedItself(DocumentElement node) {
    return released(NodeReferences.to(node));
  }

  private List<TextEdit> released(NodeReferences references) {
    references.uses().stream().findFirst().ifPresent(this::usedElsewhere);
    SourceFormatter layout = document.layout();
    Set<DocumentElement> gone = new LinkedHashSet<>(references.routes());
    gone.addAll(references.exports());
    gone.addAll(references.imports());
    return gone.stream().map(layout::remove).toList();
  }

  private static boolean inside(List<DocumentElement> nodes, DocumentElement element) {
    return nodes.stream().anyMatch(node -> node.contains(element));
  }

  private void usedElsewhere(DocumentElement use) {
    throw new EditRejectedException(
        "%s is used elsewhere (USE in line %d), and this reference would break; delete it first"
            .formatted(use.use().orElse(""), document.location(use.start()).line()));
  }

  /** Returns the outermost enclosing group that contains only the node, or the node itself. */
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
