package org.selectiverenderer.authoring.structure;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Lists what can be inserted into a document: templates, and all nodes of the catalogue. */
public final class NodePalette {
  private static final int PARENTS = 4;

  private static final Set<String> DRAWN =
      Set.of("Shape", "Inline", "ProtoInstance", "Switch", "LOD");

  private final SceneDocument document;
  private final NodeCatalogue catalogue;
  private final Containment containment;

  /** One element of each type, by which containment is asked. */
  private final SceneFragment samples;

  private final Map<String, NodeTemplate> templates = NodeTemplate.all();

  public NodePalette(SceneDocument document, NodeCatalogue catalogue) {
    this.document = document;
    this.catalogue = catalogue;
    this.containment = new Containment(catalogue);
    StringBuilder all = new StringBuilder();
    catalogue.names().forEach(name -> all.append('<').append(name).append("/>"));
    this.samples = SceneFragment.parse(all.toString(), catalogue);
  }

  /**
   * A node that can be inserted.
   *
   * @param into the element that takes it
   * @param field the field of that element that takes it
   */
  public record Entry(NodeType type, DocumentElement into, String field) {}

  /** Returns a template of the program. */
  public NodeTemplate template(String name) {
    return Optional.ofNullable(templates.get(name)).orElseGet(() -> NodeTemplate.plain(name));
  }

  /**
   * Returns the nodes that may go into the selected element, and then those that may go behind it,
   * each in alphabetical order.
   *
   * @param selected empty for the scene
   */
  public List<Entry> entries(Optional<DocumentElement> selected) {
    List<Entry> entries = new ArrayList<>();
    target(selected)
        .ifPresent(
            at -> {
              add(entries, at);
              at.parent().ifPresent(parent -> add(entries, parent));
            });
    return entries;
  }

  private void add(List<Entry> entries, DocumentElement parent) {
    for (DocumentElement sample : samples.elements()) {
      new FieldOccupancy(containment, parent, List.of())
          .give(sample)
          .filter(
              place -> entries.stream().noneMatch(each -> each.type().name().equals(sample.name())))
          .ifPresent(
              place ->
                  entries.add(
                      new Entry(catalogue.get(sample.name()), parent, place.field().orElse(""))));
    }
  }

  /** Returns the names of the types that take a node, the first ones of the alphabet. */
  List<String> parents(DocumentElement node) {
    return samples.elements().stream()
        .filter(each -> containment.accepts(each, node))
        .map(DocumentElement::name)
        .limit(PARENTS)
        .toList();
  }

  private Optional<DocumentElement> target(Optional<DocumentElement> selected) {
    return selected
        .filter(DocumentElement::attached)
        .filter(element -> !element.name().equals("X3D") && !element.name().equals("head"))
        .or(() -> document.tree().flatMap(tree -> tree.scene()));
  }

  /**
   * Inserts a template where {@link #position} says.
   *
   * @param selected empty for the end of the scene
   * @throws EditRejectedException if it fits nowhere
   */
  public StructureChange insert(Optional<DocumentElement> selected, NodeTemplate template) {
    SceneFragment fragment = SceneFragment.parse(template.text(), catalogue);
    return new StructureEdits(document, catalogue)
        .insert(fragment, position(selected, fragment.elements().get(0)), "Insert ");
  }

  /**
   * Returns the element that a template is inserted into.
   *
   * @param selected empty for the end of the scene
   * @throws EditRejectedException if it fits nowhere
   */
  public DocumentElement parent(Optional<DocumentElement> selected, NodeTemplate template) {
    SceneFragment fragment = SceneFragment.parse(template.text(), catalogue);
    return position(selected, fragment.elements().get(0)).parent();
  }

  /**
   * Returns where a node is inserted: into the selected element if its fields take it, else behind
   * it or behind the nearest element around it where it may stand. An object goes behind a selected
   * object, as things that stand side by side do not belong into one another.
   */
  private ChildPosition position(Optional<DocumentElement> selected, DocumentElement node) {
    DocumentElement at =
        target(selected)
            .orElseThrow(
                () -> new EditRejectedException("The file has no Scene to insert something into"));
    if (suits(at, node)) {
      return ChildPosition.last(at);
    }
    for (DocumentElement each = at; each.parent().isPresent(); each = each.parent().get()) {
      if (suits(each.parent().get(), node)) {
        return ChildPosition.after(each);
      }
    }
    throw new EditRejectedException(
        "%s can go neither into %s nor around it".formatted(node.name(), at));
  }

  private boolean suits(DocumentElement parent, DocumentElement node) {
    return takes(parent, node) && !(isObject(parent) && isObject(node));
  }

  /**
   * Whether an element is a thing with a place of its own: a Transform that holds what is drawn.
   */
  private static boolean isObject(DocumentElement element) {
    return element.name().equals("Transform")
        && element.children().stream().anyMatch(child -> DRAWN.contains(child.name()));
  }

  private boolean takes(DocumentElement parent, DocumentElement node) {
    return new FieldOccupancy(containment, parent, List.of()).give(node).isPresent();
  }
}
